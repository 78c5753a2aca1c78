// SPDX-License-Identifier: Apache-2.0
// A body that leans by a constant angle that the robot does not know: the walk of
// localise-observations from pixels, through body, vision and gps, for several such angles. Errors
// are means over the last two seconds of each walk; recall is of beacons and goals that show. The
// walk is kinematic, as there: no legs move, and the accelerometer feels no steps.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "tools/experiments/harness/ChildProcesses.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/pose/LocaliseMatch.h"
#include "tools/experiments/pose/PixelWalk.h"

namespace kelpie::experiments {
namespace {

constexpr std::array<double, 9> kTilts{-3.0, -2.0, -1.5, -1.0, 0.0, 1.0, 1.5, 2.0, 3.0};  // deg
constexpr std::size_t kLevel = 4;
constexpr int kFrames = PixelWalk::kFrames;
constexpr int kCounted = 60;    // the last of them
constexpr int kKnown = 150;     // from here on the tilt should be known
constexpr int kLookedAt = 3;    // every so many frames what shows is compared with what is seen
constexpr double kLost = 20.0;  // cm

// What one walk showed.
struct Walked {
  double cm = 0.0;       // over the last two seconds
  double tiltDeg = 0.0;  // error of the believed tilt, mean after five seconds
  Recognised recognised;
  int looked = 0;  // frames

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("cm", &Walked::cm, "cm"), field("tiltDeg", &Walked::tiltDeg, "deg"),
                     field("recognised", &Walked::recognised), field("looked", &Walked::looked));
  }
};

// The robot's tilt lifts the nose, the world's lowers it.
double tiltError(const WorldModel& world, const sim::Lean& lean) {
  return (world.cameraTilt.tilt + lean.tilt).abs().deg();
}

Walked walk(const agent::AgentConfig& config, const sim::RandomisationParams& randomised,
            std::uint64_t seed) {
  const auto walking = std::make_unique<PixelWalk>(config, randomised, seed);
  Visibility visibility;
  Walked walked;
  walkThrough(config, *walking, [&](int frame, const View& view, const Believer& robot) {
    if (frame % kLookedAt == 0) {
      ++walked.looked;
      walked.recognised.compare(trueObjects(view, config.field, visibility), robot.seen());
    }
    if (frame >= kKnown)
      walked.tiltDeg += tiltError(robot.world(), view.real.body.lean) / (kFrames - kKnown);
    if (frame >= kFrames - kCounted)
      walked.cm += distance(robot.world().pose.position, view.pose.position) / kCounted;
  });
  return walked;
}

struct Walks {
  std::vector<Walked> tilts;  // in the order of kTilts

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("tilts", &Walks::tilts));
  }
};

// One robot with each of the tilts.
Expected<Walks> walkAtAllTilts(const Request& request, const agent::AgentConfig& config,
                               std::uint64_t seed) {
  Walks walks;
  for (const double tilt : kTilts) {
    sim::RandomisationParams randomised = cli::paramsOf(request.randomised);
    randomised.lean.tilt = Angle::deg(tilt);
    walks.tilts.push_back(walk(config, randomised, seed));
  }
  return walks;
}

// All walks of one tilt.
struct Tally {
  Values cm;
  Values tiltDeg;
  Share seen;
  int falsePercepts = 0;
  int looked = 0;

  void add(const Walked& one) {
    cm.push_back(one.cm);
    tiltDeg.push_back(one.tiltDeg);
    seen.add(one.recognised.seen);
    falsePercepts += one.recognised.falsePercepts;
    looked += one.looked;
  }
  double falsePer1000() const { return 1000.0 * ratio(falsePercepts, looked); }
  Json figures(double tilt) const {
    return {
        {"tilt_deg", tilt},
        {"mean_cm", mean(cm)},
        {"worst_cm", percentile(cm, 1.0)},
        {"over_20_cm_walks", std::lround(shareAbove(cm, kLost) * static_cast<double>(cm.size()))},
        {"tilt_error_deg", mean(tiltDeg)},
        {"tilt_error_worst_deg", percentile(tiltDeg, 1.0)},
        {"recall", seen.value()},
        {"false_per_1000", falsePer1000()}};
  }
};

// Recall at 2 deg over that at 0, the smaller of both sides.
double recallRatio(const std::array<Tally, kTilts.size()>& tallies) {
  double min = 1.0;
  for (std::size_t i = 0; i < kTilts.size(); ++i)
    if (std::fabs(kTilts[i]) == 2.0)
      min = std::min(min, ratio(tallies[i].seen.value(), tallies[kLevel].seen.value()));
  return min;
}

Expected<Json> tilt(const Request& request) {
  const auto config = agentConfig(request);
  if (!config) return Error{config.error()};
  const auto walks = trialsInChildProcesses(
      request, [&](const Trial& trial) { return walkAtAllTilts(request, *config, trial.seed); });
  if (!walks) return Error{walks.error()};
  std::array<Tally, kTilts.size()> tallies;
  for (const Walks& robot : *walks)
    for (std::size_t i = 0; i < kTilts.size(); ++i) tallies[i].add(robot.tilts[i]);
  Values means, worst, wrong, tilts;
  Json each = Json::array();
  for (std::size_t i = 0; i < kTilts.size(); ++i) {
    means.push_back(mean(tallies[i].cm));
    worst.push_back(percentile(tallies[i].cm, 1.0));
    wrong.push_back(tallies[i].falsePer1000());
    tilts.push_back(mean(tallies[i].tiltDeg));
    each.push_back(tallies[i].figures(kTilts[i]));
  }
  return Json{
      {"worst_mean_cm", percentile(means, 1.0)},  {"worst_cm", percentile(worst, 1.0)},
      {"recall_ratio", recallRatio(tallies)},     {"false_per_1000", percentile(wrong, 1.0)},
      {"tilt_error_deg", percentile(tilts, 1.0)}, {"by_tilt", each}};
}

const Registration kTilt(
    "tilt", "walks from pixels with an unknown constant tilt: pose, recall, false ones",
    {Option::trials, Option::seed, Option::randomised, Option::params}, 12, tilt);

}  // namespace
}  // namespace kelpie::experiments
