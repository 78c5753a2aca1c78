// SPDX-License-Identifier: Apache-2.0
// The localiser on made observations: 6 % of distance noise and 2 deg of bearing noise, a walk of
// 120 frames with a panning head from an unknown start. Errors are means over the last 60 frames of
// all runs; the four headings must not differ, or an angle is treated as a plain number somewhere.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "tools/experiments/baselines/PoseVariants.h"
#include "tools/experiments/harness/Trials.h"
#include "tools/experiments/pose/LocaliseFilters.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::experiments {
namespace {

constexpr int kFrames = 120;
constexpr int kCounted = 60;      // the last of them
constexpr int kFirst = 30;        // frames of the first second
constexpr double kSure = 15.0;    // cm, a standard deviation below which
constexpr double kWrong = 100.0;  // an error beyond this must not be
constexpr std::array<double, 4> kHeadings{0.0, 90.0, 180.0, 270.0};

struct Conditions {
  double heading = 90.0;  // deg
  double falseShare = 0.0;
  bool lines = false;
  bool landmarks = true;
  gps::Localise localise = gps::step;
  gps::LineUse use = gps::LineUse::position;
  double reported = 1.0;  // by the odometry, of the way walked
};

struct Errors {
  double cm = 0.0;
  double deg = 0.0;
  double nees = 0.0;     // over its three degrees of freedom: 1 if the covariance is true
  double worstCm = 0.0;  // of any frame that counts
  double firstCm = 0.0;  // of the first second
  int sureAndWrong = 0;  // frames, all of the walk
};

void see(sim::LocalisingRobot& robot, const Conditions& conditions, int frame, Random& random) {
  const double pan = sim::panAt(frame);
  if (conditions.landmarks) robot.lookAround(pan);
  robot.falsify(conditions.falseShare, random);
  if (conditions.lines) robot.lookAtLines(pan);
}

Errors walk(const Conditions& conditions, std::uint64_t seed) {
  Random random(seed + 1000003);
  // The same starts for every heading, so that only the heading differs.
  const sim::TruePose start{random.uniform(110.0, 250.0), random.uniform(150.0, 390.0),
                            conditions.heading * maths::kPi / 180.0};
  sim::LocalisingRobot robot(start, seed);
  robot.localise = conditions.localise;
  robot.params.lines.update.use = conditions.use;
  if (!conditions.landmarks) {
    robot.params.initialPose.present = true;
    robot.params.initialPose.pose = {
        {start.x + random.gaussian(0.0, 20.0), start.y + random.gaussian(0.0, 20.0)},
        Angle::deg(conditions.heading + random.gaussian(0.0, 10.0))};
  }
  Errors errors;
  for (int frame = 0; frame < kFrames; ++frame) {
    robot.walk(0.7, 0.0, 0.008 * std::sin(frame / 20.0));
    robot.input.odometry.forward *= conditions.reported;
    see(robot, conditions, frame, random);
    const WorldModel world = robot.step();
    const PoseError error = poseError(world, robot.truth.pose());
    if (frame < kFirst) errors.firstCm += error.cm / kFirst;
    errors.sureAndWrong += world.positionSd < kSure && error.cm > kWrong ? 1 : 0;
    if (frame < kFrames - kCounted) continue;
    errors.worstCm = std::max(errors.worstCm, error.cm);
    errors.cm += error.cm / kCounted;
    errors.deg += error.deg / kCounted;
    errors.nees += error.nees / 3.0 / kCounted;
  }
  return errors;
}

// One kind of walk, with the errors over all trials.
struct Walks {
  Conditions conditions;
  Errors mean;
};

// The four headings first.
std::vector<Walks> allWalks() {
  constexpr gps::Localise kJoint = gps::stepJointly;
  std::vector<Walks> all;
  all.reserve(kHeadings.size());
  for (const double heading : kHeadings) all.push_back({{heading, 0.0, false, true}, {}});
  const auto reporting = [](double share, bool lines) {
    Conditions conditions;
    conditions.lines = lines;
    conditions.reported = share;
    return conditions;
  };
  for (const Conditions& conditions :
       std::array<Conditions, 13>{{{90.0, 0.05, false, true},
                                   {90.0, 0.0, true, true},
                                   {90.0, 0.0, true, false},
                                   {90.0, 0.0, true, true, kJoint},
                                   {90.0, 0.05, true, true},
                                   {90.0, 0.05, true, true, kJoint},
                                   {90.0, 0.0, true, true, gps::stepWithSymmetry},
                                   {90.0, 0.0, true, true, gps::stepByDeterminant},
                                   {90.0, 0.0, true, true, gps::step, gps::LineUse::sanity},
                                   reporting(1.08, false),
                                   reporting(0.92, false),
                                   reporting(1.08, true),
                                   reporting(0.92, true)}})
    all.push_back({conditions, {}});
  return all;
}

void addHeadings(const std::vector<Walks>& walks, Json& json) {
  Errors all;
  Json headings = Json::array();
  double best = 1e9;
  double worst = 0.0;
  for (std::size_t i = 0; i < kHeadings.size(); ++i) {
    const Errors& e = walks[i].mean;
    headings.push_back({{"heading_deg", kHeadings[i]}, {"mean_cm", e.cm}, {"mean_deg", e.deg}});
    all.cm += e.cm / 4.0;
    all.deg += e.deg / 4.0;
    all.nees += e.nees / 4.0;
    best = std::min(best, e.cm);
    worst = std::max(worst, e.cm);
  }
  json["mean_cm"] = all.cm;
  json["mean_deg"] = all.deg;
  json["nees_mean"] = all.nees;
  json["headings"] = headings;
  json["headings_ratio"] = worst / best;
}

// Of all rows: the worst, and how often a belief was narrow and far off.
void addAll(const std::vector<Walks>& walks, Json& json) {
  double worst = 0.0;
  int sureAndWrong = 0;
  for (const Walks& one : walks) {
    worst = std::max(worst, one.mean.worstCm);
    sureAndWrong += one.mean.sureAndWrong;
  }
  json["worst_cm"] = worst;
  json["sure_and_wrong_frames"] = sureAndWrong;
  json["first_second_cm"] = walks[1].mean.firstCm;
  json["first_second_with_lines_cm"] = walks[kHeadings.size() + 1].mean.firstCm;
}

// Odometry that reports 8 % too much of the way or too little, with landmarks and with lines too.
void addOdometry(const Walks* walks, Json& json) {
  for (const char* prefix :
       {"odometry_8_percent_long_", "odometry_8_percent_short_",
        "odometry_8_percent_long_with_lines_", "odometry_8_percent_short_with_lines_"}) {
    json[std::string(prefix) + "mean_cm"] = walks->mean.cm;
    json[std::string(prefix) + "nees_mean"] = walks->mean.nees;
    ++walks;
  }
}

Expected<Json> localiseObservations(const Request& request) {
  std::vector<Walks> walks = allWalks();
  eachTrial(request, [&](const Trial& trial) {
    for (Walks& one : walks) {
      const Errors errors = walk(one.conditions, trial.seed);
      one.mean.cm += errors.cm / request.trials;
      one.mean.deg += errors.deg / request.trials;
      one.mean.nees += errors.nees / request.trials;
      one.mean.firstCm += errors.firstCm / request.trials;
      one.mean.worstCm = std::max(one.mean.worstCm, errors.worstCm);
      one.mean.sureAndWrong += errors.sureAndWrong;
    }
  });
  Json json;
  addHeadings(walks, json);
  const Walks* other = &walks[kHeadings.size()];
  addAll(walks, json);
  json["false_mean_cm"] = other[0].mean.cm;
  json["with_lines_cm"] = other[1].mean.cm;
  json["with_lines_deg"] = other[1].mean.deg;
  json["with_lines_nees_mean"] = other[1].mean.nees;
  json["lines_only_cm"] = other[2].mean.cm;
  json["lines_only_deg"] = other[2].mean.deg;
  json["joint_with_lines_cm"] = other[3].mean.cm;
  json["joint_with_lines_deg"] = other[3].mean.deg;
  json["false_with_lines_cm"] = other[4].mean.cm;
  json["joint_false_with_lines_cm"] = other[5].mean.cm;
  json["symmetry_with_lines_cm"] = other[6].mean.cm;
  json["determinant_with_lines_cm"] = other[7].mean.cm;
  json["lines_judge_cm"] = other[8].mean.cm;
  addOdometry(other + 9, json);
  return json;
}

const Registration kLocaliseObservations(
    "localise-observations",
    "made sightings (6 %, 2 deg, some false) and line points on walks: errors",
    {Option::trials, Option::seed}, 20, localiseObservations);

}  // namespace
}  // namespace kelpie::experiments
