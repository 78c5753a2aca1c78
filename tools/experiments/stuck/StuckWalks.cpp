// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/stuck/StuckWalks.h"

#include <cmath>

#include "gps/Localiser.h"
#include "gps/pose/Stuck.h"
#include "robot/body/Camera.h"
#include "robot/core/Random.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/harness/Trials.h"
#include "tools/sim/bodies/WalkingBody.h"

namespace kelpie::experiments {
namespace {

constexpr double kMessage = kTickSeconds * kTicksPerMessage;
constexpr int kStarting = 22;  // messages: two steps, until speed and effort are steady

// The localiser fed with nothing but what the actuator tells.
class OdometryFilter {
 public:
  OdometryFilter(const Pose2& start, bool aware) : start_(start) {
    params_.field = *body::fieldDescription("2006");
    params_.initialPose.present = true;
    params_.initialPose.pose = start;
    params_.initialPose.positionSd = 1.0;
    params_.initialPose.headingSd = Angle::deg(1.0);  // so that the sd is of the walk
    params_.stuck.use = aware;
  }
  void step(const MotionOutput& output, const Command& command) {
    input_->elapsed = kMessage;
    input_->odometry = output.odometry;
    input_->motion = output.status;
    input_->lastCommand = command;
    *world_ = gps::step({*input_, *percepts_, body::step(*input_, {}).camera}, params_, *state_);
  }
  double way() const { return distance(world_->pose.position, start_.position); }
  double sd() const { return world_->positionSd; }

 private:
  Pose2 start_;
  gps::GpsParams params_;
  std::unique_ptr<gps::GpsState> state_ = std::make_unique<gps::GpsState>();
  std::unique_ptr<FrameInput> input_ = std::make_unique<FrameInput>();
  std::unique_ptr<Percepts> percepts_ = std::make_unique<Percepts>();
  std::unique_ptr<WorldModel> world_ = std::make_unique<WorldModel>();
};

// The figure's columns for one way of holding.
Json heldWalk(const Request& request, double held) {
  constexpr int kMessages = 171;  // at 20 cm/s 97 cm of odometry, the way in the figure
  Values way[2];
  Values sd[2];
  Values truth;
  Command command;
  command.walk.forward = 20.0;
  for (int trial = 0; trial < request.trials; ++trial) {
    sim::WalkingBody body(trialOf(request, trial).seed);
    (void)body.world().hold(0, held);
    const Pose2 start = body.pose();
    OdometryFilter filters[] = {OdometryFilter(start, false), OdometryFilter(start, true)};
    for (int i = 0; i < kMessages; ++i) {
      const MotionOutput output = body.step(command);
      for (OdometryFilter& filter : filters) filter.step(output, command);
    }
    for (std::size_t aware = 0; aware < 2; ++aware) {
      way[aware].push_back(filters[aware].way());
      sd[aware].push_back(filters[aware].sd());
    }
    truth.push_back(distance(body.pose().position, start.position));
  }
  return {{"with_distance_cm", mean(way[1])},
          {"with_sd_cm", mean(sd[1])},
          {"without_distance_cm", mean(way[0])},
          {"without_sd_cm", mean(sd[0])},
          {"distance_ratio", mean(way[1]) / mean(way[0])},
          {"sd_ratio", mean(sd[1]) / mean(sd[0])},
          {"true_distance_cm", mean(truth)}};
}

WalkRequest randomWalk(Random& random) {
  switch (random.index(4)) {
    case 0: return {random.uniform(10.0, 33.0), 0.0, random.uniform(-0.5, 0.5)};
    case 1: return {random.uniform(-25.0, -8.0), 0.0, random.uniform(-0.5, 0.5)};
    case 2:
      return {random.uniform(-5.0, 5.0), random.uniform(6.0, 18.0), random.uniform(-0.5, 0.5)};
    default: return {random.uniform(-3.0, 10.0), 0.0, random.uniform(0.6, 1.8)};
  }
}

// One message of a steady walk: its effort, and how far the robot really went.
struct WalkMessage {
  double effort;    // beyond that of walking freely
  double reported;  // cm, a turn counted on a lever of 12 cm
  double real;      // along what was reported
};

void walkHeld(double held, std::uint64_t seed, std::vector<WalkMessage>& messages) {
  constexpr int kMessages = 90;
  constexpr double kLever = 12.0;  // cm from the turn's middle to the feet
  Random random(seed ^ 0xfe17ULL);
  Command command;
  command.walk = randomWalk(random);
  sim::WalkingBody body(seed);
  (void)body.world().hold(0, held);
  for (int i = 0; i < kMessages; ++i) {
    const Pose2 before = body.pose();
    const MotionOutput output = body.step(command);
    if (i < kStarting) continue;
    const Angle turn = body.pose().heading - before.heading;
    const Point2<Robot> moved =
        robotFromField({before.position, before.heading + turn * 0.5}, body.pose().position);
    const Odometry& o = output.odometry;
    const double spin = kLever * o.turn.rad();
    const double reported = std::sqrt(o.forward * o.forward + o.left * o.left + spin * spin);
    const double real = moved.y * o.forward - moved.x * o.left + kLever * turn.rad() * spin;
    const gps::StuckParams params;
    const double side = params.sidewaysFactor * o.left;
    const double swing = params.turnLever * o.turn.rad();
    const double speed = std::sqrt(o.forward * o.forward + side * side + swing * swing) / kMessage;
    messages.push_back(
        {output.status.effort - gps::freeEffort(speed, params), reported, real / reported});
  }
}

std::vector<WalkMessage> walkMessages(const Request& request, double minHeld, double maxHeld) {
  constexpr int kPerTrial = 5;
  std::vector<WalkMessage> messages;
  for (int walk = 0; walk < kPerTrial * request.trials; ++walk) {
    const std::uint64_t seed = trialOf(request, walk).seed * 31 + (maxHeld > 0.0 ? 7 : 0);
    Random random(seed);
    walkHeld(random.uniform(minHeld, maxHeld), seed, messages);
  }
  return messages;
}

Values effortsOf(const std::vector<WalkMessage>& messages) {
  Values efforts;
  for (const WalkMessage& one : messages) efforts.push_back(one.effort);
  return efforts;
}

// Squared error of the believed ways.
double misfit(const std::vector<WalkMessage>& messages, double margin, double slowing) {
  double sum = 0.0;
  for (const WalkMessage& one : messages) {
    const double believed = one.reported / (1.0 + slowing * std::fmax(0.0, one.effort - margin));
    sum += (believed - one.real) * (believed - one.real);
  }
  return sum;
}

double bestSlowing(const std::vector<WalkMessage>& messages, double margin) {
  double best = 0.0;
  for (double k = 0.0; k < 200.0; k += 0.5)
    if (misfit(messages, margin, k) < misfit(messages, margin, best)) best = k;
  return best;
}

Json turned(const Request& request, const actuator::ActuatorParams& params) {
  constexpr double kTurns = 10.0 * 2.0 * maths::kPi;
  Values drift;
  Command command;
  command.walk.turn = 1.2;
  for (int trial = 0; trial < request.trials; ++trial) {
    sim::WalkingBody body(trialOf(request, trial).seed, params);
    body.wearOut();
    for (int i = 0; i < 200; ++i) body.step(command);  // until the legs are spared
    double reported = 0.0;
    double real = 0.0;
    while (real < kTurns) {
      const Angle before = body.pose().heading;
      reported += body.step(command).odometry.turn.rad();
      real += (body.pose().heading - before).rad();
    }
    drift.push_back(100.0 * (reported - real) / reported);
  }
  return mean(drift);
}

}  // namespace

Json heldWalks(const Request& request) {
  return {{"free", heldWalk(request, 0.0)},
          {"half_held", heldWalk(request, 0.5)},
          {"held", heldWalk(request, 1.0)}};
}

Json effortCalibration(const Request& request) {
  const gps::StuckParams used;
  const std::vector<WalkMessage> free = walkMessages(request, 0.0, 0.0);
  const std::vector<WalkMessage> half = walkMessages(request, 0.3, 0.7);
  const std::vector<WalkMessage> held = walkMessages(request, 0.7, 1.0);
  std::vector<WalkMessage> all = free;
  for (const auto* some : {&half, &held}) all.insert(all.end(), some->begin(), some->end());
  return {{"false_rate", shareAbove(effortsOf(free), used.margin)},
          {"half_held_hit_rate", shareAbove(effortsOf(half), used.margin)},
          {"held_hit_rate", shareAbove(effortsOf(held), used.margin)},
          {"margin", percentile(effortsOf(free), 0.995)},
          {"slowing", bestSlowing(all, used.margin)},
          {"used_margin", used.margin},
          {"used_slowing", used.slowing}};
}

Json weakTurns(const Request& request) {
  actuator::ActuatorParams one;
  sim::makeFast({}, one);
  one.walks.weak.odometry = one.walks.normal.odometry;
  return {{"turns", 10},
          {"two_sets_drift_percent", turned(request, {})},
          {"one_set_drift_percent", turned(request, one)}};
}

}  // namespace kelpie::experiments
