// SPDX-License-Identifier: Apache-2.0
// A program's command line as the commands describe it: subcommands, options, flags and what their
// values must be. CLI11 does the work behind it, in CommandLine.cpp and Usage.cpp alone, since it
// is dear to compile. A mistake in what is typed is found by parseOptions() (Usage.h), a mistake in
// the description when the program starts.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
class Validator;
}  // namespace CLI

namespace kelpie::cli {

// What a value must be: a complaint when it is not, and its words in the help.
class ValueCheck {
 public:
  explicit ValueCheck(const CLI::Validator& validator);
  const CLI::Validator& validator() const { return *validator_; }

 private:
  std::shared_ptr<const CLI::Validator> validator_;
};

// A number in [min, max]; what is not a number is refused, "nan" included.
ValueCheck inRange(double min, double max);
ValueCheck integerInRange(int min, int max);
ValueCheck oneOf(const std::vector<std::string>& words);
// A word that says something.
ValueCheck notEmpty();
ValueCheck existingPath();
ValueCheck existingFile();
ValueCheck existingFolder();

// One option or flag. It belongs to its command line; this only points to it.
class CommandOption {
 public:
  explicit CommandOption(CLI::Option* option) : option_(option) {}

  CommandOption& check(const ValueCheck& check);
  // A folder that is there: the user's, or the one of that name, such as teams/thesis, below
  // `data`.
  CommandOption& checkTeam(const std::string& data);
  CommandOption& required();
  CommandOption& showDefault();  // the value that the variable has now, in the help
  CommandOption& needs(const CommandOption& other);
  CommandOption& excludes(const CommandOption& other);
  CommandOption& excludes(const std::string& name);  // of one described before

 private:
  CLI::Option* option_;
};

// A program's command line, a subcommand's or a group of options. Only points to it, as above.
class CommandLine {
 public:
  explicit CommandLine(CLI::App* app) : app_(app) {}

  // T: std::string, a vector of them, int, double, or an unsigned number of 16, 32 or 64 bits.
  template <class T>
  CommandOption option(const std::string& name, T& value, const std::string& help = "");
  // With "--name,!--other" the second sets it to false.
  CommandOption flag(const std::string& name, bool& value, const std::string& help);
  CommandLine subcommand(const std::string& name, const std::string& help);
  // Options of which exactly one must be given.
  CommandLine oneOfGroup(const std::string& name, const std::string& help);
  void requireSubcommand();
  // Every word behind the command is left to unread(), --help too.
  void readNothing();

  void footer(const std::string& text);
  void callback(const std::function<void()>& run);

  std::size_t count(const std::string& option) const;  // how often it was given
  std::vector<std::string> unread() const;
  CLI::App& app() const { return *app_; }

 private:
  CLI::App* app_;
};

// The command line of a whole program, which owns all that is described.
class ProgramLine : public CommandLine {
 public:
  ProgramLine(const std::string& help, const std::string& name);

 private:
  explicit ProgramLine(std::shared_ptr<CLI::App> app);
  std::shared_ptr<CLI::App> app_;
};

}  // namespace kelpie::cli
