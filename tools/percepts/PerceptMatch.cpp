// SPDX-License-Identifier: Apache-2.0
#include "tools/percepts/PerceptMatch.h"

#include <algorithm>
#include <utility>

#include "robot/body/Ers7.h"
#include "robot/host/primitives/Orders.h"
#include "robot/net/GameControlData.h"

namespace kelpie::percepts {
namespace {

constexpr std::int64_t kMessageUs = kTickUs * kTicksPerMessage;

// Of a part of the match, so that no two share a stream.
std::uint64_t eyeSeed(std::uint64_t seed, std::size_t robot) {
  return Random(seed ^ (0x657965ULL + (static_cast<std::uint64_t>(robot) << 32U))).next();
}

std::uint32_t heldBy(const agent::MotorOrder& order) {
  std::uint32_t joints = 0;
  for (std::size_t i = 0; i < kJointCount; ++i) joints |= order.strength[i] > 0.0 ? 1U << i : 0U;
  return order.power ? joints : 0U;
}

// Of the legs, over the standard one.
double meanStrength(const agent::MotorOrder& order) {
  constexpr std::size_t kFirst = index(Joint::leftFrontRotator);
  constexpr std::size_t kLast = index(Joint::rightHindKnee);
  double sum = 0.0;
  for (std::size_t i = kFirst; i <= kLast; ++i) sum += order.strength[i];
  return sum / (kLast - kFirst + 1);
}

}  // namespace

struct PerceptMatch::Robot {
  Robot(const MatchRobot& robot, agent::LogSink& log, const Robot* beside, const Eye& sees)
      : loops(robot.config, robot.scripts, log, beside != nullptr ? &beside->loops : nullptr),
        eye(sees) {}

  agent::AgentLoops loops;
  Eye eye;
  MotionInput motion;
  agent::PowerReport power;
};

PerceptMatch::PerceptMatch(sim::World& world, const std::vector<MatchRobot>& robots,
                           std::uint64_t seed, LogWriter* log, sim::ServerHooks hooks)
    : world_(world), log_(log), hooks_(std::move(hooks)) {
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const MatchRobot& robot = robots[i];
    agent::LogSink& sink = robot.log != nullptr ? *robot.log : silent_;
    const Eye eye(robot.config.field, i, eyeSeed(seed, i));
    robots_.push_back(
        std::make_unique<Robot>(robot, sink, i > 0 ? robots_[0].get() : nullptr, eye));
    robots_.back()->loops.power({});
    moment_.teams.push_back(robot.config.team);
  }
}

// The interpreter is the first robot's last.
PerceptMatch::~PerceptMatch() = default;

Status PerceptMatch::loaded() const {
  for (const auto& robot : robots_)
    if (!robot->loops.scriptError().empty()) return Error{robot->loops.scriptError()};
  return Done{};
}

Status PerceptMatch::moveTo(TimeUs now) {
  while (world_.time() < now) {
    const Status ticked = world_.tick();
    if (!ticked) return ticked;
  }
  return Done{};
}

Status PerceptMatch::run() {
  const Status ready = loaded();
  if (!ready) return ready;
  std::int64_t messages = 1, images = 1;
  const auto stopped = [this] { return hooks_.stopped && hooks_.stopped(); };
  while (!world_.finished() && !stopped()) {
    const TimeUs sensorsAt{messages * kMessageUs};
    const TimeUs imageAt{images * 1000000 / 30};
    const TimeUs now = std::min(sensorsAt, imageAt);
    const Status moved = moveTo(now);
    if (!moved) return moved;
    writeTruth(now, now == imageAt);
    if (hooks_.beforeStep) hooks_.beforeStep(now);
    talk(now);
    if (now == sensorsAt) {
      for (std::size_t i = 0; i < robots_.size(); ++i) sense(i);
      ++messages;
    }
    if (now == imageAt) {
      look(now);
      ++images;
    }
  }
  writeTruth(world_.time(), false);
  return Done{};
}

void PerceptMatch::writeTruth(TimeUs now, bool image) {
  const std::vector<sim::MatchEvent> events = world_.takeEvents();
  if (hooks_.onEvent)
    for (const sim::MatchEvent& event : events) hooks_.onEvent(event);
  if (log_ == nullptr) return;
  for (const sim::MatchEvent& event : events) log_->write(sim::kEventTopic, event.time, event);
  if (image) log_->write(sim::kTruthTopic, now, world_.truth(now));
}

// What has come by the air.
void PerceptMatch::talk(TimeUs now) {
  const ControlPacket control = net::packetOf(world_.control());
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    robots_[i]->loops.hear(control, now);
    if (!world_.expectsPackets(i)) continue;
    for (const RadioPacket& packet : world_.takePackets(i)) robots_[i]->loops.hear(packet, now);
  }
}

void PerceptMatch::sense(std::size_t i) {
  Robot& robot = *robots_[i];
  robot.motion.time = world_.time();
  robot.motion.sensors = world_.sensors(i);
  robot.motion.batteryCurrent = world_.batteryCurrent(i);
  robot.power.current = robot.motion.batteryCurrent;
  robot.loops.power(robot.power);
  const MotionOutput& output = robot.loops.motion(robot.motion);
  const agent::MotorOrder& order = robot.loops.motors().order;
  const double legs = body::meanOf({output.status.lowGain, output.status.legGain});
  constexpr double kWeakest = 0.05;
  host::AgentReply reply =
      host::ordersOf(output.joints, std::max(kWeakest, legs * meanStrength(order)));
  reply.motorPower = order.power;
  reply.gains = heldBy(order);
  robot.power.motorPower = order.power;
  robot.motion.held = reply.gains;
  // At the start a second vector ahead, as the OPEN-R object sends.
  if (world_.bodies().vectorsWaiting(i) == 0) {
    host::AgentReply ahead = reply;
    for (auto& target : ahead.vectors[0].targets) target = reply.vectors[0].targets[0];
    world_.bodies().command(i, ahead);
  }
  world_.bodies().command(i, reply);
}

void PerceptMatch::expose(TimeUs now) {
  constexpr double kExposureTicks = 1e6 / 30.0 / kTickUs;
  const double middle = static_cast<double>(now.us) / kTickUs - 0.5 * kExposureTicks;
  const double ticks = std::max(0.0, middle);
  moment_.robots.clear();
  for (std::size_t i = 0; i < robots_.size(); ++i)
    moment_.robots.push_back(world_.past().place(i, ticks));
  moment_.ball = world_.past().ball(ticks);
}

void PerceptMatch::look(TimeUs now) {
  expose(now);
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Robot& robot = *robots_[i];
    robot.eye.show(moment_);
    robot.loops.look(robot.eye, {now.us - kExposureUs / 2}, images_);
    RadioPacket packet;
    if (robot.loops.takePacket(packet)) world_.send(i, packet);
  }
  ++images_;
}

}  // namespace kelpie::percepts
