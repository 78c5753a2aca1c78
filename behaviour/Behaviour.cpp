// SPDX-License-Identifier: Apache-2.0
#include "behaviour/Behaviour.h"

#include <string_view>

#include "behaviour/PlayerMark.h"
#include "behaviour/PythonHost.h"
#include "robot/core/fields/Emptied.h"
#include "robot/core/fields/FieldCheck.h"

namespace kelpie::behaviour {
namespace {

// Stands and looks left and right: nothing can go wrong, and the ball may come into view.
Command standAndScan(const FrameInput& input, const BehaviourParams& params, Fallback reason) {
  const double phase = 2.0 * maths::kPi * input.time.seconds() / params.scanPeriod;
  Command command;
  command.head.neckTilt = params.scanTilt;
  command.head.headPan = params.scanPan * maths::sin(phase);
  command.fallback = reason;
  return command;
}

// What came by network may hold anything.
Command driven(const BehaviourIn& in, const BehaviourParams& params) {
  const Command& command = in.input.drive.command;
  if (verify(command, nullptr)) return command;
  return standAndScan(in.input, params, Fallback::badCommand);
}

// With the mark in one piece, for tools/stick/Player.h.
constexpr char kPlayer[] = "kelpie player: python";
static_assert(std::string_view(kPlayer).rfind(kPlayerMark, 0) == 0);

}  // namespace

void fill(WorldFrame& frame, const BehaviourIn& in) {
  const FrameInput& input = in.input;
  const WorldModel& world = in.world;
  frame.time = input.time;
  frame.frame = input.frame;
  frame.elapsed = input.elapsed;
  const JointAngles& joints = input.sensors.joints;
  frame.head = {joints[Joint::neckTilt], joints[Joint::headPan], joints[Joint::headNod]};
  static_cast<SensorFrame&>(frame.sensors) = input.sensors;
  frame.sensors.headNearDistance = in.infrared.asBase(input.sensors.headNearDistance);
  frame.sensors.headNearThreshold = in.infrared.threshold;
  frame.stance = input.stance;
  frame.odometry = input.odometry;
  frame.motion = input.motion;
  frame.battery = input.battery;
  frame.game = input.game;
  frame.lastCommand = input.lastCommand;
  forEachFieldOf<Percepts>(
      [&](const auto& f) { copyUsed(frame.percepts.*(f.member), in.percepts.*(f.member)); });
  frame.pose = world.pose;
  frame.positionSd = world.positionSd;
  frame.headingSd = world.headingSd;
  frame.secondsSinceLandmark = world.secondsSinceLandmark;
  frame.secondsSinceLines = world.secondsSinceLines;
  frame.covariance = world.covariance;
  frame.stuck = world.stuck;
  copyUsed(frame.modes, world.modes);
  frame.second = world.second;
  frame.ball = world.ball;
  frame.teamBall = world.teamBall;
  copyUsed(frame.opponents, world.opponents);
  copyUsed(frame.teammates, world.teammates);
  copyUsed(frame.obstacles, world.obstacles);
  copyUsed(frame.pinkMap, world.pinkMap);
  frame.field = in.field;
}

BehaviourState::BehaviourState(const std::string& scripts, const Constants& constants,
                               const BehaviourState* beside)
    : host_(std::make_unique<PythonHost>(scripts, constants,
                                         beside ? beside->host_.get() : nullptr)) {}

BehaviourState::~BehaviourState() = default;

const std::string& BehaviourState::lastError() const { return host_->lastError(); }

const RecentReports& BehaviourState::reports() const { return host_->reports(); }

Expected<Rows> BehaviourState::ask(const std::string& function) { return host_->ask(function); }

Command step(const BehaviourIn& in, const BehaviourParams& params, BehaviourState& state) {
  if (in.input.drive.present) return driven(in, params);
  Command command;
  const Fallback reason = state.host().decide(in, params, command);
  return reason == Fallback::none ? command : standAndScan(in.input, params, reason);
}

const char* playerName() { return kPlayer + sizeof kPlayerMark - 1; }

}  // namespace kelpie::behaviour
