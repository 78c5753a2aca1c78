// SPDX-License-Identifier: Apache-2.0
// From a guess to the pose at which the seen lines match best: the thesis' gradient ascent (the one
// with the heading's gradient as printed, and the one on the first match function, too) beside the
// damped Gauss-Newton steps that the robot uses. Views of random poses; and the tables for the
// field in Lisbon on a field like that one (LisbonTables.h).
#include <array>
#include <memory>

#include "tools/experiments/baselines/MatchTable.h"
#include "tools/experiments/harness/Trials.h"
#include "tools/experiments/pose/FromAGuess.h"
#include "tools/experiments/pose/LisbonTables.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::experiments {
namespace {

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

// The four ways from the same guesses.
struct Results {
  FoundPoses fit;
  FoundPoses ascent;
  FoundPoses asPrinted;
  FoundPoses onBells;  // the ascent by thesis 2004 equation 3.3
};

Expected<Json> maximiser(const Request& request) {
  const auto field = body::fieldDescription("2006");
  if (!field) return Error{field.error()};
  const gps::LineUpdateParams params;
  const auto features = std::make_unique<gps::FieldFeatures>();
  features->build(*field);
  const gps::MatchTables tables(*field, *features, {});
  const gps::MatchTables bells(*field, *features, {gps::MatchDecay::bell, gps::kBellSharpness});
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
      const gps::Ascent before = gps::ascend(view.seen, guess, bells, {});
      results[i].onBells.add(before.pose, before.steps, view.truth);
    }
  });
  Json json{{"table_bytes", tables.lines.bytes()}};
  for (std::size_t i = 0; i < kStarts.size(); ++i)
    json["starts"].push_back({{"start_cm", kStarts[i].sd},
                              {"start_deg", kStarts[i].sdDeg},
                              {"ours", results[i].fit.json()},
                              {"ascent", results[i].ascent.json()},
                              {"ascent_as_printed", results[i].asPrinted.json()},
                              {"ascent_equation_3_3", results[i].onBells.json()}});
  json["lisbon"] = lisbonTables(request);
  return json;
}

const Registration kMaximiser(
    "maximiser", "from a guess to the best match: Gauss-Newton beside the thesis' ascent",
    {Option::trials, Option::seed}, 500, maximiser);

}  // namespace
}  // namespace kelpie::experiments
