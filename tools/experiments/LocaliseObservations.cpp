// SPDX-License-Identifier: Apache-2.0
// The localiser on made observations: 6 % of distance noise and 2 deg of bearing noise, a walk of
// 120 frames with a panning head from an unknown start. Errors are means over the last 60 frames of
// all runs; the four headings must not differ, or an angle is treated as a plain number somewhere.
#include <algorithm>
#include <array>
#include <cmath>

#include "tools/experiments/Experiment.h"
#include "tools/experiments/SimulatedRobot.h"

namespace kelpie::experiments {
namespace {

constexpr int kFrames = 120;
constexpr int kJudged = 60;
constexpr std::array<double, 4> kHeadings{0.0, 90.0, 180.0, 270.0};

struct Conditions {
  double heading = 90.0;  // deg
  double falseShare = 0.0;
  bool lines = false;
  bool landmarks = true;
  gps::LineCombine combine = gps::LineCombine::separate;
};

struct Errors {
  double cm = 0.0;
  double deg = 0.0;
};

void see(gps::SimulatedRobot& robot, const Conditions& conditions, int frame, Random& random) {
  const double pan = gps::panAt(frame);
  if (conditions.landmarks) robot.lookAround(pan);
  robot.falsify(conditions.falseShare, random);
  if (conditions.lines) robot.lookAtLines(pan);
}

Errors walk(const Conditions& conditions, std::uint64_t seed) {
  Random random(seed + 1000003);
  // The same starts for every heading, so that only the heading differs.
  const gps::Truth start{random.uniform(110.0, 250.0), random.uniform(150.0, 390.0),
                         conditions.heading * maths::kPi / 180.0};
  gps::SimulatedRobot robot(start, seed);
  robot.params.line.combine = conditions.combine;
  if (!conditions.landmarks) {
    robot.params.initialPose.present = true;
    robot.params.initialPose.pose = {
        {start.x + random.gaussian(0.0, 20.0), start.y + random.gaussian(0.0, 20.0)},
        Angle::deg(conditions.heading + random.gaussian(0.0, 10.0))};
  }
  Errors errors;
  for (int frame = 0; frame < kFrames; ++frame) {
    robot.walk(0.7, 0.0, 0.008 * std::sin(frame / 20.0));
    see(robot, conditions, frame, random);
    const WorldModel world = robot.step();
    if (frame < kFrames - kJudged) continue;
    errors.cm += robot.error(world) / kJudged;
    errors.deg += robot.headingError(world) / kJudged;
  }
  return errors;
}

Errors mean(const ExperimentOptions& options, const Conditions& conditions) {
  Errors sum;
  for (int run = 0; run < options.trials; ++run) {
    const Errors one = walk(conditions, options.seed + static_cast<std::uint64_t>(run));
    sum.cm += one.cm / options.trials;
    sum.deg += one.deg / options.trials;
  }
  return sum;
}

}  // namespace

Expected<Json> localiseObservations(const ExperimentOptions& options) {
  Json json{
      {"experiment", "localise-observations"}, {"trials", options.trials}, {"seed", options.seed}};
  Errors all;
  Json headings = Json::array();
  double least = 1e9;
  double most = 0.0;
  for (const double heading : kHeadings) {
    const Errors e = mean(options, {heading, 0.0, false, true});
    headings.push_back({{"heading_deg", heading}, {"mean_cm", e.cm}, {"mean_deg", e.deg}});
    all.cm += e.cm / 4.0;
    all.deg += e.deg / 4.0;
    least = std::min(least, e.cm);
    most = std::max(most, e.cm);
  }
  json["mean_cm"] = all.cm;
  json["mean_deg"] = all.deg;
  json["headings"] = headings;
  json["headings_ratio"] = most / least;
  json["false_mean_cm"] = mean(options, {90.0, 0.05, false, true}).cm;
  const Errors both = mean(options, {90.0, 0.0, true, true});
  json["with_lines_cm"] = both.cm;
  json["with_lines_deg"] = both.deg;
  const Errors lines = mean(options, {90.0, 0.0, true, false});
  json["lines_only_cm"] = lines.cm;
  json["lines_only_deg"] = lines.deg;
  constexpr auto kJoint = gps::LineCombine::joint;
  const Errors joint = mean(options, {90.0, 0.0, true, true, kJoint});
  json["joint_with_lines_cm"] = joint.cm;
  json["joint_with_lines_deg"] = joint.deg;
  json["false_with_lines_cm"] = mean(options, {90.0, 0.05, true, true}).cm;
  json["joint_false_with_lines_cm"] = mean(options, {90.0, 0.05, true, true, kJoint}).cm;
  return json;
}

}  // namespace kelpie::experiments
