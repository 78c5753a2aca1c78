// SPDX-License-Identifier: Apache-2.0
#include "robot/agent/log/Replay.h"

#include <fmt/core.h>

#include <memory>

#include "tools/cli/Commands.h"
#include "tools/cli/JsonText.h"
#include "tools/cli/Process.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/log/ThinLog.h"
#include "tools/cli/options/Config.h"
#include "tools/cli/options/ServeOptions.h"
#include "tools/cli/show/FieldJson.h"
#include "tools/cli/show/Jsonl.h"
#include "tools/match/Match.h"
#include "tools/studio/Studio.h"

namespace kelpie::cli {
namespace {

struct ReplayCommand {
  std::string log;
  bool check = false;
  std::string jsonl;
  std::string pycode = defaultScripts();
  ConfigOptions config;
  bool live = false;
  web::ServerParams web;
};

// What was recorded, by the clock, from the moment when somebody watches.
int serveLog(const ReplayCommand& command) {
  catchInterrupts();
  studio::StudioOptions options;
  options.web = command.web;
  options.logs = {command.log};
  options.byTheClock = true;
  const auto studio = studio::Studio::open(options);
  if (!studio) return fail(studio.error(), kExitBadInput);
  const std::string url = (*studio)->url();
  fmt::print("live: ws{}  (Foxglove, Lichtblick); begins when somebody watches\n",
             url.substr(url.find(':')));
  std::fflush(stdout);
  (*studio)->run([&] { return interrupted() || (*studio)->played(); });
  return interrupted() ? kExitInterrupted : kExitDone;
}

int report(const ReplayCommand& command, const agent::ReplayResult& result) {
  // With --jsonl - the figures must not mix with the objects.
  std::FILE* const to = command.jsonl == "-" ? stderr : stdout;
  if (!result.scriptError.empty()) fmt::print(stderr, "kelpie: {}\n", result.scriptError);
  for (const auto& note : result.notes) fmt::print(stderr, "kelpie: {}\n", note);
  for (const auto& line : result.differences) fmt::print(stderr, "{}\n", line);
  fmt::print(to, "replayed {} frames and {} motion steps", result.frames, result.motionSteps);
  if (command.check)
    fmt::print(to, ": {} outputs compared, {} differ", result.compared, result.differing);
  fmt::print(to, "\n");
  if (result.framesFromPercepts > 0)
    fmt::print(to, "vision ran again on {} frames; the images of the other {} were not kept\n",
               result.frames - result.framesFromPercepts, result.framesFromPercepts);
  if (!result.lacks.empty())
    return fail(command.log + ": " + result.lacks + "; all whole frames were replayed",
                kExitBadInput);
  if (command.check && result.compared == 0)
    return fail(command.log + ": holds no outputs to compare with", kExitCheckFailed);
  return command.check && result.differing > 0 ? kExitCheckFailed : kExitDone;
}

// What a log holds that does not replay.
int tellRecorded(const ReplayCommand& command) {
  if (command.check || command.jsonl.empty())
    return fail(command.log +
                    ": keeps class planes and shortened numbers, which do not replay; --jsonl and "
                    "show tell what was recorded",
                kExitBadInput);
  const auto match = match::Match::open(command.log);
  if (!match) return fail(match.error(), kExitBadInput);
  std::string objects;
  match->forEachMoment([&](const match::Moment& moment) {
    auto object = frameObject(moment.input, moment.output);
    if (const match::TrueRobot* own = moment.truth.own())
      object["truth"] = {{"x_cm", own->pose.position.x},
                         {"y_cm", own->pose.position.y},
                         {"heading_deg", degreesOf(own->pose.heading)}};
    objects += jsonText(object) + "\n";
    return true;
  });
  if (!writeWhole(command.jsonl, objects))
    return fail(command.jsonl + ": cannot be written", kExitBadInput);
  return match->lacks().empty() ? kExitDone : fail(match->lacks(), kExitBadInput);
}

int replayLog(const ReplayCommand& command) {
  if (sameFile(command.log, command.jsonl))
    return fail(command.jsonl + ": is the log itself", kExitBadInput);
  if (!command.jsonl.empty() && !canWrite(command.jsonl))
    return fail(command.jsonl + ": cannot be written", kExitBadInput);
  if (isThinned(command.log)) return tellRecorded(command);
  std::string objects;
  agent::ReplayOptions options;
  options.scripts = command.pycode;
  options.adjust = [&](agent::AgentConfig& config) {
    static_cast<void>(applyConfig(command.config, config));  // tried on a spare before
  };
  if (!command.jsonl.empty())
    options.onFrame = [&](const FrameInput& input, const FrameOutput& output) {
      objects += jsonText(frameObject(input, output)) + "\n";
    };
  const Status scripts = checkScripts(command.pycode);
  if (!scripts) return fail(scripts.error(), kExitBadInput);
  agent::AgentConfig trial;  // options are checked before a long replay, not after it
  const Status applied = applyConfig(command.config, trial);
  if (!applied) return fail(applied.error(), kExitBadInput);
  agent::StageObserver silent;
  const auto result = agent::replay(command.log, options, silent);
  if (!result) return fail(result.error(), kExitBadInput);
  if (!command.jsonl.empty() && !writeWhole(command.jsonl, objects))
    return fail(command.jsonl + ": cannot be written", kExitBadInput);
  return report(command, *result);
}

}  // namespace

void addReplay(CommandLine& app, int& code) {
  auto sub = app.subcommand("replay", "Run the stages again on the inputs of a log");
  auto command = std::make_shared<ReplayCommand>();
  sub.option("LOG", command->log, "The log").required();
  sub.flag("--check", command->check,
           "Compare every output with the recorded one, bit for bit; exit code 1 if any differs");
  sub.option("--jsonl", command->jsonl, "One JSON object a frame; - for standard output");
  sub.option("--pycode", command->pycode, "Behaviours (default: pycode/)").check(existingPath());
  addConfigOptions(sub, command->config);
  sub.flag("--live", command->live,
           "Runs nothing again, but serves what was recorded to Foxglove and Lichtblick, by the "
           "clock, from when somebody watches")
      .excludes("--check")
      .excludes("--jsonl");
  addServeOptions(sub, command->web);
  sub.callback(
      [command, &code] { code = command->live ? serveLog(*command) : replayLog(*command); });
}

}  // namespace kelpie::cli
