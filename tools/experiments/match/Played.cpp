// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/match/Played.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "robot/agent/log/FrameMessages.h"
#include "robot/core/types/FrameOutput.h"
#include "tools/experiments/match/AgentFrames.h"

namespace kelpie::experiments {
namespace {

constexpr std::int64_t kHalfExposureUs = 1000000 / 60;
constexpr std::int64_t kSameImageUs = 8000;  // an image's stamps in two logs differ by less

constexpr double kShotSpeed = 60.0;          // cm/s
constexpr double kNear = 40.0;               // cm from the neck base, the longest reach of a kick
constexpr std::size_t kDirectionFrames = 8;  // 0.27 s, in which the direction is taken

constexpr double kRightDeg = 10.0;   // a percept that is off by less is the ball
constexpr double kRightShare = 0.3;  // of the distance
constexpr double kClose = 40.0;      // cm; nearer, where a few cm are many degrees, more may be off

Status readWorld(const std::string& path, Played& played) {
  auto reader = LogReader::open(path);
  if (!reader) return Error{reader.error()};
  LogMessage message;
  while (reader->next(message)) {
    PlayedMoment moment;
    sim::MatchEvent event;
    if (message.topic() == sim::kTruthTopic && decodeAs(message, moment.truth))
      played.moments.push_back(moment);
    if (message.topic() == sim::kEventTopic && decodeAs(message, event))
      played.events.push_back(event);
  }
  return reader->status();
}

// The moment whose image that is; null when the world's log has none.
PlayedMoment* momentOf(const FrameInput& input, Played& played) {
  const std::int64_t end = input.time.us + kHalfExposureUs;
  const auto first = std::lower_bound(
      played.moments.begin(), played.moments.end(), end - kSameImageUs,
      [](const PlayedMoment& moment, std::int64_t us) { return moment.truth.time.us < us; });
  if (first == played.moments.end() || first->truth.time.us > end + kSameImageUs) return nullptr;
  return &*first;
}

Status readAgent(const std::string& path, Played& played) {
  return eachAgentFrame(path, [&](const FrameInput& input, const FrameOutput& output) {
    PlayedMoment* moment = momentOf(input, played);
    if (moment == nullptr) return;
    moment->seen = true;
    moment->ball = output.percepts.ball;
    moment->motion = input.motion;
    moment->command = output.command;
  });
}

}  // namespace

Pose2 PlayedMoment::robot(TeamColour team) const {
  for (const sim::RobotTruth& one : truth.robots)
    if (one.team == team) return one.pose;
  return {};
}

std::optional<double> Played::outAfter(double from) const {
  for (const sim::MatchEvent& event : events)
    if ((event.kind == sim::EventKind::out || event.kind == sim::EventKind::goal) &&
        event.time.seconds() >= from)
      return event.time.seconds();
  return std::nullopt;
}

Expected<Played> readPlayed(const std::string& agentLog, const std::string& worldLog) {
  Played played;
  Status read = readWorld(worldLog, played);
  if (read) read = readAgent(agentLog, played);
  if (!read) return Error{read.error()};
  return played;
}

bool isBall(const BallPercept& seen, const Pose2& robot, Point2<Field> ball) {
  if (!seen.present) return false;
  const Point2<Robot> place = robotFromField(robot, ball);
  const double off = std::fabs((seen.heading - bearing(place)).deg());
  const double close = std::fmin(1.0, place.norm() / kClose);
  return off * close < kRightDeg &&
         std::fabs(seen.distance - place.norm()) < 5.0 + kRightShare * place.norm();
}

std::vector<sim::Hold> holdsOf(const Played& played, TeamColour team) {
  sim::HoldWatch watch;
  for (const PlayedMoment& moment : played.moments)
    watch.see(moment.seconds(), moment.robot(team), moment.truth.ball);
  watch.finish();
  return watch.ended();
}

std::vector<Shot> shotsOf(const Played& played, TeamColour team) {
  std::vector<Shot> shots;
  const auto& all = played.moments;
  for (std::size_t i = 1; i + kDirectionFrames < all.size(); ++i) {
    const double speed = all[i].truth.ballVelocity.norm();
    if (speed < kShotSpeed || all[i - 1].truth.ballVelocity.norm() >= kShotSpeed) continue;
    if (distance(all[i].robot(team).position, all[i].truth.ball) > kNear) continue;
    const Point2<Field> way = all[i + kDirectionFrames].truth.ball - all[i + 1].truth.ball;
    shots.push_back(
        {all[i].seconds(), all[i].truth.ball, Angle::rad(maths::atan2(way.y, way.x)), speed, i});
    i += kDirectionFrames;  // one blow, not each of its bounces
  }
  return shots;
}

const Pose2* redPose(const sim::TruthFrame& truth, std::uint8_t player) {
  for (const sim::RobotTruth& robot : truth.robots)
    if (robot.team == TeamColour::red && robot.player == player) return &robot.pose;
  return nullptr;
}

const sim::RobotTruth& nearestToBall(const sim::TruthFrame& truth) {
  return *std::min_element(truth.robots.begin(), truth.robots.end(),
                           [&](const sim::RobotTruth& a, const sim::RobotTruth& b) {
                             return distance(a.pose.position, truth.ball) <
                                    distance(b.pose.position, truth.ball);
                           });
}

}  // namespace kelpie::experiments
