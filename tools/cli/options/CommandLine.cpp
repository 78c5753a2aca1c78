// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/options/CommandLine.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <filesystem>

namespace kelpie::cli {

ValueCheck::ValueCheck(const CLI::Validator& validator)
    : validator_(std::make_shared<CLI::Validator>(validator)) {}

ValueCheck inRange(double min, double max) {
  const std::string range = fmt::format("[{:g} - {:g}]", min, max);
  return ValueCheck(CLI::Validator(
      [=](std::string& text) -> std::string {
        double value = 0.0;
        const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool whole = error == std::errc() && rest == text.data() + text.size();
        if (whole && value >= min && value <= max) return {};
        return fmt::format("{} is not a number in {}", text, range);
      },
      range));
}

ValueCheck integerInRange(int min, int max) { return ValueCheck(CLI::Range(min, max)); }

ValueCheck oneOf(const std::vector<std::string>& words) { return ValueCheck(CLI::IsMember(words)); }

ValueCheck notEmpty() {
  return ValueCheck(CLI::Validator(
      [](std::string& text) -> std::string { return text.empty() ? "an empty word" : ""; }, ""));
}

ValueCheck existingPath() { return ValueCheck(CLI::ExistingPath); }
ValueCheck existingFile() { return ValueCheck(CLI::ExistingFile); }
ValueCheck existingFolder() { return ValueCheck(CLI::ExistingDirectory); }

CommandOption& CommandOption::check(const ValueCheck& check) {
  option_->check(check.validator());
  return *this;
}

CommandOption& CommandOption::checkTeam(const std::string& data) {
  const auto oursToo = [data](std::string& team) -> std::string {
    const std::string ours = data + "/" + team;
    if (team.rfind("teams/", 0) == 0 && !std::filesystem::exists(team) &&
        std::filesystem::is_directory(ours))
      team = ours;
    return "";
  };
  option_->check(CLI::ExistingDirectory);
  option_->transform(CLI::Validator(oursToo, ""));
  return *this;
}

CommandOption& CommandOption::required() {
  option_->required();
  return *this;
}

CommandOption& CommandOption::showDefault() {
  option_->capture_default_str();
  return *this;
}

CommandOption& CommandOption::needs(const CommandOption& other) {
  option_->needs(other.option_);
  return *this;
}

CommandOption& CommandOption::excludes(const CommandOption& other) {
  option_->excludes(other.option_);
  return *this;
}

CommandOption& CommandOption::excludes(const std::string& name) {
  option_->excludes(name);
  return *this;
}

template <class T>
CommandOption CommandLine::option(const std::string& name, T& value, const std::string& help) {
  return CommandOption(app_->add_option(name, value, help));
}

template CommandOption CommandLine::option(const std::string&, std::string&, const std::string&);
template CommandOption CommandLine::option(const std::string&, int&, const std::string&);
template CommandOption CommandLine::option(const std::string&, double&, const std::string&);
template CommandOption CommandLine::option(const std::string&, std::uint16_t&, const std::string&);
template CommandOption CommandLine::option(const std::string&, std::uint32_t&, const std::string&);
template CommandOption CommandLine::option(const std::string&, std::uint64_t&, const std::string&);
template CommandOption CommandLine::option(const std::string&, std::vector<std::string>&,
                                           const std::string&);

CommandOption CommandLine::flag(const std::string& name, bool& value, const std::string& help) {
  return CommandOption(app_->add_flag(name, value, help));
}

CommandLine CommandLine::subcommand(const std::string& name, const std::string& help) {
  return CommandLine(app_->add_subcommand(name, help));
}

CommandLine CommandLine::oneOfGroup(const std::string& name, const std::string& help) {
  auto* group = app_->add_option_group(name, help);
  group->require_option(1);
  return CommandLine(group);
}

void CommandLine::requireSubcommand() { app_->require_subcommand(1); }
void CommandLine::readNothing() { app_->prefix_command()->set_help_flag(); }
void CommandLine::footer(const std::string& text) { app_->footer(text); }
void CommandLine::callback(const std::function<void()>& run) { app_->callback(run); }
std::size_t CommandLine::count(const std::string& option) const { return app_->count(option); }
std::vector<std::string> CommandLine::unread() const { return app_->remaining(); }

ProgramLine::ProgramLine(const std::string& help, const std::string& name)
    : ProgramLine(std::make_shared<CLI::App>(help, name)) {}

ProgramLine::ProgramLine(std::shared_ptr<CLI::App> app)
    : CommandLine(app.get()), app_(std::move(app)) {}

}  // namespace kelpie::cli
