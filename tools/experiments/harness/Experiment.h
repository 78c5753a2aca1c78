// SPDX-License-Identifier: Apache-2.0
// An experiment measures the whole or a part of the robot and answers with plain numbers under
// snake_case keys that end in their unit. The same trials and seed give the same figures. It
// registers itself, so that a new one is one .cpp file:
//
//   Expected<Json> ballFilter(const Request& request) { ... }
//   const Registration kBall("ball", "one line for --help", {Option::trials, Option::seed}, 200,
//                            ballFilter);
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "tools/cli/Figures.h"
#include "tools/cli/options/RandomisationOptions.h"

namespace kelpie::experiments {

using cli::Json;

// What a user may ask for beside the experiment's name and --json.
enum class Option : std::uint8_t {
  trials,
  seed,
  randomised,
  params,
  field,
  traces,
  pictures,
  fast,
  minutes,
  side,
  opponents
};
constexpr std::initializer_list<Option> kAllOptions = {
    Option::trials,  Option::seed,   Option::randomised, Option::params,
    Option::field,   Option::traces, Option::pictures,   Option::fast,
    Option::minutes, Option::side,   Option::opponents};
const char* nameOf(Option option);  // "--trials"

class Options {
 public:
  constexpr Options() = default;
  constexpr Options(std::initializer_list<Option> some) {
    for (const Option option : some) add(option);
  }
  constexpr void add(Option option) { bits_ |= 1U << static_cast<unsigned>(option); }
  constexpr bool has(Option option) const {
    return (bits_ >> static_cast<unsigned>(option) & 1U) != 0;
  }

 private:
  unsigned bits_ = 0;
};

struct Request {
  int trials = 1;
  std::uint64_t seed = 1;
  cli::RandomisationOptions
      randomised;                   // every trial draws a world of its own from it and its seed
  std::vector<std::string> params;  // the agent's TOML files
  std::string field;                // its name; empty: 2006
  std::string traces;               // folder for tables (Trace.h); empty: none
  std::string pictures;             // folder for pictures of what went wrong; empty: none
  bool fast = false;                // kinematic bodies, and in a few experiments percepts
  double minutes = 0.0;             // of play in each match; 0: the experiment's own
  std::string sideA, sideB;         // folders of two teams; empty: the experiment's own
  std::function<void(int done, int all)> progress;

  // Where the table of that name goes; empty without --traces.
  std::string tracePath(const std::string& name) const {
    return traces.empty() ? "" : traces + "/" + name + ".csv";
  }
};

struct Experiment {
  const char* name = "";
  const char* measures = "";  // one line
  Options uses;               // any other option is refused
  int trials = 1;             // without --trials
  Expected<Json> (*run)(const Request& request) = nullptr;
};

// Which option was given that the experiment does not use, in one line with those that it does.
Status checkOptions(const Experiment& experiment, Options given);

// Runs it; before its figures stand its name, the trials and the seed.
Expected<Json> measure(const Experiment& experiment, const Request& request);

// Adds an experiment to those that registered() gives. An object at namespace scope in the
// experiment's own file; the objects are linked to one another, so that nothing is allocated before
// main().
class Registration {
 public:
  // As the members of Experiment.
  Registration(const char* name, const char* measures, Options uses, int trials,
               Expected<Json> (*run)(const Request& request))
      : experiment_{name, measures, uses, trials, run}, next_(last()) {
    last() = this;
  }
  Registration(const Registration&) = delete;
  Registration& operator=(const Registration&) = delete;

  // Every experiment of the program.
  static std::vector<Experiment> all();

 private:
  static const Registration*& last();

  Experiment experiment_;
  const Registration* next_;
};

// Sorted by name; an error when two have the same.
Expected<std::vector<Experiment>> sortedByName(std::vector<Experiment> experiments);

}  // namespace kelpie::experiments
