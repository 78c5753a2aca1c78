// SPDX-License-Identifier: Apache-2.0
// From a guess to the pose at which the seen lines match best: the thesis' gradient ascent (and the
// one with the heading's gradient as printed) beside the damped Gauss-Newton steps that the robot
// uses. Views of random poses; success is within 10 cm and 5 deg of the truth (checklist E7).
#include <array>
#include <cmath>
#include <memory>

#include "tools/experiments/baselines/MatchTable.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/harness/Trials.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::experiments {
namespace {

constexpr double kSuccessCm = 10.0;
constexpr double kSuccessDeg = 5.0;

struct Start {
  double sd;     // cm
  double sdDeg;  // deg
};
constexpr std::array<Start, 3> kStarts{{{10, 5}, {20, 10}, {40, 20}}};

struct SeenPose {
  sim::TruePose truth;
  gps::SeenLines seen;
};

// Looks to the left, ahead and to the right: lines 90 deg to each side.
SeenPose seenFrom(const gps::LineUpdateParams& params, std::uint64_t seed) {
  Random random(seed);
  SeenPose view;
  view.truth = {random.uniform(20.0, 340.0), random.uniform(20.0, 520.0),
                random.uniform(-maths::kPi, maths::kPi)};
  sim::LocalisingRobot robot(view.truth, seed);
  FixedVector<LinePoint, 256> all;
  for (const double pan : {-0.98, 0.0, 0.98}) {
    robot.lookAtLines(pan);
    for (const LinePoint& p : robot.percepts.linePoints) all.push_back(p);
  }
  view.seen = gps::seenLines(all, params);
  return view;
}

struct Result {
  int successes = 0;
  int views = 0;
  double steps = 0.0;
  double error2 = 0.0;  // cm2, of the successes

  void add(const Pose2& pose, std::uint32_t used, const sim::TruePose& truth) {
    const double off = std::hypot(pose.position.x - truth.x, pose.position.y - truth.y);
    const double turned = (pose.heading - Angle::rad(truth.heading)).abs().deg();
    ++views;
    steps += used;
    if (off > kSuccessCm || turned > kSuccessDeg) return;
    ++successes;
    error2 += off * off;
  }
  Json json() const {
    return {{"success", ratio(successes, views)},
            {"steps", ratio(steps, views)},
            {"rms_cm", std::sqrt(ratio(error2, successes))}};
  }
};

// The three ways from the same guesses.
struct Results {
  Result fit;
  Result ascent;
  Result asPrinted;
};

Pose2 guessBeside(const sim::TruePose& truth, const Start& start, std::uint64_t seed) {
  Random random(seed + 77);
  return {{truth.x + random.gaussian(0.0, start.sd), truth.y + random.gaussian(0.0, start.sd)},
          Angle::rad(truth.heading) + Angle::deg(random.gaussian(0.0, start.sdDeg))};
}

Expected<Json> maximiser(const Request& request) {
  const auto field = body::fieldDescription("2006");
  if (!field) return Error{field.error()};
  const gps::LineUpdateParams params;
  const auto features = std::make_unique<gps::FieldFeatures>();
  features->build(*field);
  const gps::MatchTables tables(*field, *features, {});
  gps::AscentParams printed;
  printed.headingScale = 1.0;
  std::array<Results, kStarts.size()> results;
  eachTrial(request, [&](const Trial& trial) {
    const SeenPose view = seenFrom(params, trial.seed);
    if (view.seen.lines.size() < params.minPoints) return;
    for (std::size_t i = 0; i < kStarts.size(); ++i) {
      const Pose2 guess = guessBeside(view.truth, kStarts[i], trial.seed);
      const gps::LineFit fit =
          gps::fitLines(view.seen, guess, *features, params, kStarts[i].sd > params.coarseAbove);
      results[i].fit.add(fit.pose, fit.steps, view.truth);
      const gps::Ascent thesis = gps::ascend(view.seen, guess, tables, {});
      results[i].ascent.add(thesis.pose, thesis.steps, view.truth);
      const gps::Ascent raw = gps::ascend(view.seen, guess, tables, printed);
      results[i].asPrinted.add(raw.pose, raw.steps, view.truth);
    }
  });
  Json json{{"table_bytes", tables.lines.bytes()}};
  for (std::size_t i = 0; i < kStarts.size(); ++i)
    json["starts"].push_back({{"start_cm", kStarts[i].sd},
                              {"start_deg", kStarts[i].sdDeg},
                              {"ours", results[i].fit.json()},
                              {"ascent", results[i].ascent.json()},
                              {"ascent_as_printed", results[i].asPrinted.json()}});
  return json;
}

const Registration kMaximiser(
    "maximiser", "from a guess to the best match: Gauss-Newton beside the thesis' ascent",
    {Option::trials, Option::seed}, 500, maximiser);

}  // namespace
}  // namespace kelpie::experiments
