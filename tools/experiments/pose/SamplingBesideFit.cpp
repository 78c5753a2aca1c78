// SPDX-License-Identifier: Apache-2.0
// The thesis' mode sampling (2004 section 3.3.4) beside the fit, on the same walks of 120 frames:
// lines alone from a known start, and lines with landmarks. The thesis saw the estimate jump almost
// at random; a jump is how far the estimate moves in a frame beyond the robot's own motion. To find
// the cause, a third filter bounds the peaks' standard deviations from below as the fit's are.
#include <array>
#include <cmath>

#include "gps/Extract.h"
#include "gps/pose/Modes.h"
#include "tools/experiments/baselines/ModeSampling.h"
#include "tools/experiments/harness/Trials.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::experiments {
namespace {

constexpr int kFrames = 120;
constexpr int kCounted = 60;   // the last of them
constexpr double kJump = 5.0;  // cm a frame

enum class Method { fit, sampling, samplingFloored };
constexpr std::array<const char*, 3> kNames{"fit", "sampling", "sampling_floored"};

struct Outcome {
  double cm = 0.0;
  double deg = 0.0;
  double jump = 0.0;  // cm a frame
  double jumps = 0.0;
  double sd = 0.0;

  void add(const Outcome& other, double share) {
    cm += share * other.cm;
    deg += share * other.deg;
    jump += share * other.jump;
    jumps += share * other.jumps;
    sd += share * other.sd;
  }
  Json json() const {
    return {{"mean_cm", cm},
            {"mean_deg", deg},
            {"jump_cm", jump},
            {"jumps_rate", jumps},
            {"claimed_sd_cm", sd}};
  }
};

sim::LocalisingRobot robotOf(Method method, bool landmarks, std::uint64_t seed) {
  Random random(seed + 1000003);
  const sim::TruePose start{random.uniform(110.0, 250.0), random.uniform(150.0, 390.0),
                            random.uniform(-maths::kPi, maths::kPi)};
  sim::LocalisingRobot robot(start, seed);
  if (method != Method::fit) robot.params.lines.update.use = gps::LineUse::off;
  robot.params.lines.map.use = false;
  if (landmarks) return robot;
  const double x = start.x + random.gaussian(0.0, 20.0);
  const double y = start.y + random.gaussian(0.0, 20.0);
  const Angle heading = Angle::rad(start.heading) + Angle::deg(random.gaussian(0.0, 10.0));
  robot.params.initialPose = {true, {{x, y}, heading}, 20.0, Angle::deg(10)};
  return robot;
}

WorldModel stepOf(Method method, sim::LocalisingRobot& robot) {
  const WorldModel world = robot.step();
  if (method == Method::fit || robot.state.pose.lost) return world;
  gps::SamplingFloor floor;
  if (method == Method::samplingFloored) floor = {4.0, Angle::deg(2)};
  const auto seen = gps::seenLines(robot.percepts.linePoints, robot.params.lines.update);
  gps::GpsState& state = robot.state;
  if (!gps::updateBySampling(seen, floor, state.lines.features, robot.params.lines.update,
                             state.pose.modes))
    return world;
  gps::mergeAndPrune(robot.params.field, robot.params.modes, state.pose, state.counts);
  return gps::extract(state, robot.params);
}

Outcome walk(Method method, bool landmarks, std::uint64_t seed) {
  sim::LocalisingRobot robot = robotOf(method, landmarks, seed);
  Outcome outcome;
  double offX = 0.0;
  double offY = 0.0;
  for (int frame = 0; frame < kFrames; ++frame) {
    robot.walk(0.7, 0.0, 0.008 * std::sin(frame / 20.0));
    if (landmarks) robot.lookAround(sim::panAt(frame));
    robot.lookAtLines(sim::panAt(frame));
    const WorldModel world = stepOf(method, robot);
    const double x = world.pose.position.x - robot.truth.x;
    const double y = world.pose.position.y - robot.truth.y;
    const double jump = std::hypot(x - offX, y - offY);
    offX = x;
    offY = y;
    if (frame < kFrames - kCounted) continue;
    outcome.add({robot.error(world), robot.headingError(world), jump, jump > kJump ? 1.0 : 0.0,
                 world.positionSd},
                1.0 / kCounted);
  }
  return outcome;
}

Expected<Json> modeSampling(const Request& request) {
  std::array<std::array<Outcome, kNames.size()>, 2> outcomes{};  // without landmarks, with
  eachTrial(request, [&](const Trial& trial) {
    for (const bool landmarks : {false, true})
      for (std::size_t m = 0; m < kNames.size(); ++m)
        outcomes[landmarks ? 1 : 0][m].add(walk(static_cast<Method>(m), landmarks, trial.seed),
                                           1.0 / request.trials);
  });
  Json json;
  for (const bool landmarks : {false, true}) {
    Json methods;
    for (std::size_t m = 0; m < kNames.size(); ++m)
      methods[kNames[m]] = outcomes[landmarks ? 1 : 0][m].json();
    json[landmarks ? "with_landmarks" : "lines_alone"] = methods;
  }
  return json;
}

const Registration kModeSampling(
    "mode-sampling", "the thesis' sampling of the match beside the fit: errors and jumps",
    {Option::trials, Option::seed}, 50, modeSampling);

}  // namespace
}  // namespace kelpie::experiments
