// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/players/Player.h"

#include <algorithm>

#include "robot/body/Camera.h"

namespace kelpie::experiments {
namespace {

sim::ObserverNoise walkingNoise() {
  sim::ObserverNoise noise;
  noise.halfView = 26.0;
  noise.walk = {0.02, 0.03, 6e-4};
  return noise;
}

sim::TruePose truePose(const Pose2& pose) {
  return {pose.position.x, pose.position.y, pose.heading.rad()};
}

}  // namespace

Player::Player(const Pose2& start, std::uint8_t player, std::uint64_t seed)
    : LocalisingRobot(truePose(start), seed, walkingNoise()) {
  input.game.player = player;
  input.sensors.joints[Joint::neckTilt] = Angle::deg(-10.0);
}

void Player::walk(const WalkSpeed& speed) {
  Observer::walk(speed.forward * kFrameSeconds, speed.left * kFrameSeconds,
                 speed.turn * kFrameSeconds);
}

void Player::turnHead(double pan) {
  pan_ = pan;
  percepts = Percepts{};
  input.sensors.joints[Joint::headPan] = Angle::rad(pan);
}

WorldModel Player::stepAlone() {
  const FixedVector<TeamMessage, kTeammates> team = input.team;
  input.team.clear();
  const WorldModel world =
      gps::step({input, percepts, body::step(input, {}).camera}, params, *alone_);
  input.team = team;
  return world;
}

void Wanderer::step(double speed, const std::vector<Point2<Field>>& others) {
  constexpr double kRobotLength = 30.0;
  timeLeft_ -= kFrameSeconds;
  if (timeLeft_ <= 0.0 || distance(target_, position) < 10.0) {
    target_ = {random_.uniform(20, 340), random_.uniform(20, 520)};
    timeLeft_ = random_.uniform(2.0, 12.0);
  }
  const Point2<Field> way = target_ - position;
  const double length = std::max(way.norm(), 1e-6);
  const Point2<Field> next = position + way * (speed * kFrameSeconds / length);
  for (const Point2<Field>& other : others) {
    if (distance(other, position) < 1e-9) continue;  // itself
    if (distance(other, next) < kRobotLength && distance(other, next) < distance(other, position)) {
      timeLeft_ = 0.0;  // it chooses another place
      return;
    }
  }
  position = next;
}

void Radio::send(std::size_t from, const TeamMessage& message) {
  if (message.number == 0 || message.number == lastNumber_[from]) return;
  lastNumber_[from] = message.number;
  if (random_.chance(0.1)) return;
  underWay_.push_back({from, 1 + static_cast<int>(random_.index(3)), message});
}

void Radio::pass() {
  underWay_.erase(std::remove_if(underWay_.begin(), underWay_.end(),
                                 [](const Letter& letter) { return letter.frames <= 0; }),
                  underWay_.end());
  for (Letter& letter : underWay_) {
    --letter.frames;
    letter.message.age += kFrameSeconds;
  }
}

FixedVector<TeamMessage, kTeammates> Radio::receive(std::size_t to) {
  FixedVector<TeamMessage, kTeammates> list;
  for (const Letter& letter : underWay_) {
    if (letter.frames <= 0 && letter.from != to) list.push_back(letter.message);
  }
  return list;
}

}  // namespace kelpie::experiments
