// SPDX-License-Identifier: Apache-2.0
#include "tools/match/Match.h"

#include <memory>

#include "robot/agent/log/FrameMessages.h"
#include "robot/agent/log/Replay.h"
#include "tools/cli/log/Logs.h"
#include "tools/sim/world/Truth.h"

namespace kelpie::match {
namespace {

// The world's field is the red team's; the blue team's is the same turned by half a turn.
Point2<Field> inTeamFrame(Point2<Field> p, const body::FieldDescription& field, TeamColour team) {
  if (team == TeamColour::red) return p;
  return {field.width - p.x, field.length - p.y};
}

TrueRobot placeOf(const sim::RobotTruth& truth, const Match& match) {
  TrueRobot robot;
  robot.team = truth.team;
  robot.player = truth.player;
  robot.own = truth.team == match.team() && truth.player == match.player();
  robot.pose.position = inTeamFrame(truth.pose.position, match.field(), match.team());
  robot.pose.heading =
      match.team() == TeamColour::red ? truth.pose.heading : truth.pose.heading + Angle::deg(180.0);
  return robot;
}

TruePlaces placesOf(const sim::TruthFrame& truth, const Match& match) {
  TruePlaces places;
  places.present = !truth.robots.empty();
  places.ball = inTeamFrame(truth.ball, match.field(), match.team());
  places.ballThere = distance(truth.ball, sim::kAwayBall) > 1.0;
  for (const sim::RobotTruth& robot : truth.robots) places.robots.push_back(placeOf(robot, match));
  return places;
}

}  // namespace

Expected<Match> Match::open(const std::string& path) {
  auto reader = LogReader::open(path);
  if (!reader) return Error{reader.error()};
  Match match;
  match.path_ = path;
  bool configured = false;
  const auto output = std::make_unique<FrameOutput>();
  LogMessage message;
  while (reader->next(message)) {
    if (message.topic() == kFrameOutputTopic && match.frames_++ == 0)
      static_cast<void>(
          decodeAs(message, *output));  // for the notes; the film passes damaged ones over
    match.takeEvent(message);
    if (message.topic() != kConfigTopic) continue;
    const auto config = std::make_unique<agent::AgentConfig>();
    const Status read = decodeAs(message, *config);
    if (!read) return Error{path + ": " + read.error()};
    match.field_ = config->field;
    match.team_ = config->team;
    match.player_ = config->player;
    configured = true;
  }
  if (!reader->status()) return Error{reader->status().error()};
  cli::tellNotes(*reader);
  for (const LogMetadata& metadata : reader->metadata())
    if (metadata.name == sim::kMatchNotes) match.notes_ = metadata.entries;
  if (const std::string lacks = reader->lacks(); !lacks.empty()) match.lacks_ = path + ": " + lacks;
  if (!configured || match.frames_ == 0)
    return Error{path + ": holds no frames with outputs to show"};
  return match;
}

void Match::takeEvent(const LogMessage& message) {
  sim::MatchEvent event;
  if (message.topic() == sim::kEventTopic && decodeAs(message, event)) events_.push_back(event);
}

void Match::forEachMoment(const std::function<bool(const Moment&)>& show) const {
  auto reader = LogReader::open(path_);
  if (!reader) return;
  const auto input = std::make_unique<FrameInput>();
  const auto output = std::make_unique<FrameOutput>();
  sim::TruthFrame truth;
  TruePlaces places;
  bool inputKnown = false;
  bool fresh = true, imaged = false;
  LogMessage message;
  while (reader->next(message)) {
    if (message.topic() == sim::kTruthTopic && decodeAs(message, truth))
      places = placesOf(truth, *this);
    if (agent::isFrameInput(message.topic())) {
      inputKnown = cli::decodeForPeople(message, *input).ok();
      fresh = cli::hasImage(message);
      imaged = imaged || fresh;
    }
    if (message.topic() == kFrameOutputTopic && inputKnown && decodeAs(message, *output) &&
        !show({*input, *output, places, fresh, imaged}))
      return;
  }
}

}  // namespace kelpie::match
