// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/team/TeamMatch.h"

#include <algorithm>
#include <memory>

#include "robot/agent/log/FrameMessages.h"
#include "robot/core/types/FrameOutput.h"
#include "tools/cli/Process.h"
#include "tools/experiments/match/AgentFrames.h"

namespace kelpie::experiments {
namespace {

TeamFrame frameOf(const FrameInput& input, const FrameOutput& output) {
  TeamFrame frame;
  frame.seconds = input.time.seconds();
  frame.state = input.game.state;
  frame.penalised = input.game.penalised;
  frame.note = output.command.team;
  frame.pose = output.world.pose;
  frame.seen = output.percepts.ball;
  frame.ball = output.world.ball.present;
  frame.ballAt = output.world.ball.position;
  frame.teamBall = output.world.teamBall.present;
  frame.teamBallAt = output.world.teamBall.position;
  return frame;
}

Status readRobot(const std::string& path, TeamMatch& match) {
  TeamRobot robot;
  Status read = eachAgentFrame(path, [&](const FrameInput& input, const FrameOutput& output) {
    robot.team = input.game.team;
    robot.player = input.game.player;
    robot.frames.push_back(frameOf(input, output));
  });
  match.robots.push_back(std::move(robot));
  return read;
}

Status readWorld(const std::string& path, TeamMatch& match) {
  auto reader = LogReader::open(path);
  if (!reader) return Error{reader.error()};
  LogMessage message;
  while (reader->next(message)) {
    sim::TruthFrame truth;
    sim::MatchEvent event;
    if (message.topic() == sim::kTruthTopic && decodeAs(message, truth))
      match.truth.push_back(truth);
    if (message.topic() == sim::kEventTopic && decodeAs(message, event))
      match.events.push_back(event);
  }
  return reader->status();
}

Status read(const std::vector<std::string>& logs, const std::string& worldLog, TeamMatch& match) {
  for (const std::string& log : logs) {
    const Status robot = readRobot(log, match);
    if (!robot) return robot;
  }
  const Status world = readWorld(worldLog, match);
  if (world && match.truth.empty()) return Error{"the world's log is empty"};
  return world;
}

}  // namespace

const sim::TruthFrame& TeamMatch::at(double seconds) const {
  const auto after = std::upper_bound(
      truth.begin(), truth.end(), seconds,
      [](double s, const sim::TruthFrame& frame) { return s < frame.time.seconds(); });
  return after == truth.begin() ? *after : *(after - 1);
}

bool isOwnGoal(const sim::MatchEvent& event) {
  return event.kind == sim::EventKind::goal && event.reason.view() == "own goal";
}

Expected<cli::SessionOptions> teamSession(const Request& request, const Trial& trial,
                                          const std::string& robots, double seconds) {
  const auto plan = cli::teamPlan(robots);
  if (!plan) return Error{plan.error()};
  cli::SessionOptions session = sessionOf(request, trial);
  session.seconds = seconds;
  session.keepFrames = session.keepAll = true;
  const Status used = cli::useTeams(*plan, session);
  if (!used) return Error{used.error()};
  return session;
}

Status playTeams(const Request& request, const TeamMatches& matches) {
  cli::catchInterrupts();
  for (int i = 0; i < matches.count; ++i) {
    const cli::SessionOptions session = matches.session(i);
    TeamMatch match;
    Status readBack = Done{};
    cli::SessionTalk talk;
    talk.all = [&](const std::vector<std::string>& logs, const std::string& worldLog) {
      readBack = read(logs, worldLog, match);
    };
    if (!session.keepAll)
      talk.frames = [&](const std::string&, const std::string& worldLog) {
        readBack = read({}, worldLog, match);
      };
    const cli::SessionResult result = cli::runSession(session, talk);
    if (cli::interrupted()) return Error{"interrupted"};
    const std::string seed = "seed " + std::to_string(session.seed) + ": ";
    if (!result.trouble.empty()) return Error{seed + result.trouble};
    if (!readBack) return Error{seed + readBack.error()};
    matches.judge(i, result, match);
    if (request.progress) request.progress(i + 1, matches.count);
  }
  return Done{};
}

Status playFours(const Request& request, const Fours& fours, const JudgeMatch& judge) {
  TeamMatches matches;
  matches.count = request.trials;
  matches.session = [&](int number) {
    const Trial trial = trialOf(request, number);
    cli::SessionOptions session = *teamSession(request, trial, "4v4", fours.seconds);
    session.keepAll = fours.kept == Kept::robots;
    if (fours.staging) session.staging = fours.staging(trial.seed);
    return session;
  };
  matches.judge = [&](int, const cli::SessionResult& result, const TeamMatch& match) {
    judge(result, match);
  };
  return playTeams(request, matches);
}

}  // namespace kelpie::experiments
