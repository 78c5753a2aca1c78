// SPDX-License-Identifier: Apache-2.0
// Why the robot did what it did, in sentences, from the traces that a log holds.
#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "tools/cli/Commands.h"
#include "tools/cli/options/Usage.h"
#include "tools/match/BeliefWords.h"
#include "tools/match/DecisionChanges.h"
#include "tools/match/Decisions.h"
#include "tools/match/TraceWords.h"

namespace kelpie::cli {
namespace {

using namespace match;

constexpr double kNear = 0.25;    // s: a frame as near as this is the one that was asked for
constexpr double kLongest = 1e6;  // s

struct WhyOptions {
  std::string log;
  double at = std::nan("");
  double from = std::nan("");
  double to = std::nan("");
};

// One decision, kept.
struct Kept {
  bool known = false;
  double seconds = 0.0;
  std::uint32_t frame = 0;
  bool driven = false;
  Command command;
  MovedLandmarks movedLandmarks;
};

Kept kept(const Decision& d) {
  return {true, d.seconds, d.frame, d.driven, d.command, d.world.movedLandmarks};
}

std::string whoIn(const DecisionLog& log) {
  return fmt::format("{} player {}", log.team == TeamColour::red ? "red" : "blue", log.player);
}

int ended(const DecisionLog& log) {
  return log.lacks.empty() ? kExitDone : fail(log.lacks, kExitBadInput);
}

int noFrame(const WhyOptions& options, const DecisionLog& log, const std::string& when) {
  return fail(
      fmt::format("{}: no frame {}; there are frames from {:.2f} to {:.2f} s{}", options.log, when,
                  log.first, log.last, log.lacks.empty() ? "" : ", as far as it could be read"),
      kExitBadInput);
}

int noTrace(const WhyOptions& options, const std::string& when) {
  return fail(fmt::format("{}: no reasons {}: the behaviours gave none, or the log is of a version "
                          "that did not ask for them",
                          options.log, when),
              kExitBadInput);
}

int whyAt(const WhyOptions& options) {
  Kept best;
  const auto away = [&](double seconds) { return std::fabs(seconds - options.at); };
  const auto log = readDecisions(options.log, {options.at - kNear, options.at + kNear},
                                 [&](const Decision& decision) {
                                   if (!best.known || away(decision.seconds) < away(best.seconds))
                                     best = kept(decision);
                                 });
  if (!log) return fail(log.error(), kExitBadInput);
  if (!best.known) return noFrame(options, *log, fmt::format("at {:g} s", options.at));
  const std::string instead = insteadOf(best.driven, best.command);
  if (best.command.trace.empty() && instead.empty())
    return noTrace(options, fmt::format("at {:.2f} s", best.seconds));
  fmt::print("At {:.2f} s (frame {}) {} asks its body to {}.\n", best.seconds, best.frame,
             whoIn(*log), requestOf(best.command));
  fmt::print("Why:\n");
  if (!instead.empty()) fmt::print("  It is so because {}.\n", instead);
  for (const TraceStep& step : best.command.trace) fmt::print("  {}\n", sentenceOf(step));
  for (const MovedLandmark& moved : best.movedLandmarks) fmt::print("{}\n", sentenceOf(moved));
  return ended(*log);
}

int whyBetween(const WhyOptions& options) {
  const double from = std::isnan(options.from) ? 0.0 : options.from;
  const double to = std::isnan(options.to) ? kLongest : options.to;
  const std::string when = fmt::format("from {:g} to {:g} s", from, to);
  if (from > to)
    return fail(fmt::format("--from {:g} is after --to {:g}", from, to), kExitBadInput);
  DecisionChanges changes;
  std::string lines;
  const auto log = readDecisions(options.log, {from, to}, [&](const Decision& d) {
    const std::string words = changes.take(d.driven, d.command);
    if (!words.empty()) lines += fmt::format("{:8.2f} s  {}\n", d.seconds, words);
  });
  if (!log) return fail(log.error(), kExitBadInput);
  if (!changes.any()) return noFrame(options, *log, when);
  if (!changes.reported()) return noTrace(options, when);
  fmt::print("{}", lines);
  return ended(*log);
}

int why(const WhyOptions& options) {
  const bool between = !std::isnan(options.from) || !std::isnan(options.to);
  if (!std::isnan(options.at) && !between) return whyAt(options);
  if (std::isnan(options.at) && between) return whyBetween(options);
  return fail("why: takes --at, or --from and --to; `kelpie why --help` tells more", kExitBadInput);
}

}  // namespace

void addWhy(CommandLine& app, int& code) {
  auto command = app.subcommand("why", "Why the robot did what it did, in sentences");
  auto options = std::make_shared<WhyOptions>();
  command.option("LOG", options->log, "The log").required();
  command.option("--at", options->at, "One frame's decision, s, with all of its reasons")
      .check(inRange(0.0, kLongest));
  command.option("--from", options->from, "Every change of what was decided, from here, s")
      .check(inRange(0.0, kLongest));
  command.option("--to", options->to, "and up to here, s").check(inRange(0.0, kLongest));
  command.callback([options, &code] { code = why(*options); });
}

}  // namespace kelpie::cli
