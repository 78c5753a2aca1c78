// SPDX-License-Identifier: Apache-2.0
// From a guess to the pose at which the seen lines match best: the thesis' gradient ascent (and the
// one with the heading's gradient as printed) beside the damped Gauss-Newton steps that the robot
// uses. Views of random poses; success is within 10 cm and 5 deg of the truth (checklist E7).
#include <array>
#include <cmath>
#include <memory>

#include "gps/MatchTable.h"
#include "tools/experiments/Experiment.h"
#include "tools/experiments/SimulatedRobot.h"

namespace kelpie::experiments {
namespace {

constexpr double kGood = 10.0;    // cm
constexpr double kGoodDeg = 5.0;  // deg
struct Start {
  double sd;     // cm
  double sdDeg;  // deg
};
constexpr std::array<Start, 3> kStarts{{{10, 5}, {20, 10}, {40, 20}}};

struct View {
  gps::Truth truth;
  gps::SeenLines seen;
};

// Looks to the left, ahead and to the right: lines 90 deg to each side.
View viewOf(const gps::LineParams& params, std::uint64_t seed) {
  Random random(seed);
  View view;
  view.truth = {random.uniform(20.0, 340.0), random.uniform(20.0, 520.0),
                random.uniform(-maths::kPi, maths::kPi)};
  gps::SimulatedRobot robot(view.truth, seed);
  FixedVector<LinePoint, 256> all;
  for (const double pan : {-0.98, 0.0, 0.98}) {
    robot.lookAtLines(pan);
    for (const LinePoint& p : robot.percepts.linePoints) all.push_back(p);
  }
  view.seen = gps::seenLines(all, params);
  return view;
}

struct Result {
  int good = 0;
  int views = 0;
  double steps = 0.0;
  double error2 = 0.0;  // cm2 of the good ones

  void add(const Pose2& pose, std::uint32_t used, const gps::Truth& truth) {
    const double off = std::hypot(pose.position.x - truth.x, pose.position.y - truth.y);
    const double turned = (pose.heading - Angle::rad(truth.heading)).abs().deg();
    ++views;
    steps += used;
    if (off > kGood || turned > kGoodDeg) return;
    ++good;
    error2 += off * off;
  }
  Json json() const {
    return {{"success", views > 0 ? static_cast<double>(good) / views : 0.0},
            {"steps", views > 0 ? steps / views : 0.0},
            {"rms_cm", good > 0 ? std::sqrt(error2 / good) : 0.0}};
  }
};

}  // namespace

Expected<Json> maximiser(const ExperimentOptions& options) {
  const auto field = body::fieldDescription("2006");
  if (!field) return Error{field.error()};
  const gps::LineParams params;
  const auto features = std::make_unique<gps::FieldFeatures>();
  features->build(*field);
  const gps::MatchTables tables(*field, *features, params.sharpness);
  gps::AscentParams printed;
  printed.headingScale = 1.0;
  Json json{{"experiment", "maximiser"}, {"trials", options.trials}, {"seed", options.seed}};
  json["table_bytes"] = tables.lines.bytes();
  Json starts = Json::array();
  for (const Start& start : kStarts) {
    Result ours, ascent, asPrinted;
    for (int i = 0; i < options.trials; ++i) {
      const auto seed = options.seed + static_cast<std::uint64_t>(i);
      const View view = viewOf(params, seed);
      if (view.seen.lines.size() < params.minPoints) continue;
      Random random(seed + 77);
      const Pose2 guess{
          {view.truth.x + random.gaussian(0.0, start.sd),
           view.truth.y + random.gaussian(0.0, start.sd)},
          Angle::rad(view.truth.heading) + Angle::deg(random.gaussian(0.0, start.sdDeg))};
      const gps::LineFit fit =
          gps::fitLines(view.seen, guess, *features, params, start.sd > params.coarseAbove);
      ours.add(fit.pose, fit.steps, view.truth);
      const gps::Ascent thesis = gps::ascend(view.seen, guess, tables, {});
      ascent.add(thesis.pose, thesis.steps, view.truth);
      const gps::Ascent raw = gps::ascend(view.seen, guess, tables, printed);
      asPrinted.add(raw.pose, raw.steps, view.truth);
    }
    starts.push_back({{"start_cm", start.sd},
                      {"start_deg", start.sdDeg},
                      {"ours", ours.json()},
                      {"ascent", ascent.json()},
                      {"ascent_as_printed", asPrinted.json()}});
  }
  json["starts"] = starts;
  return json;
}

}  // namespace kelpie::experiments
