// SPDX-License-Identifier: Apache-2.0
// Walks from pixels that are spoilt in ways that the robot is not told of: times, odometry, light,
// colours, noise, a landmark off its place, a body that sways, a pan that is wrong. Errors are of
// the last two seconds of each walk, where nothing new is to be learnt any more; what is believed
// of them is compared with them. The walk is kinematic (PixelWalk.h).
#include <array>
#include <cmath>
#include <memory>

#include "tools/experiments/harness/ChildProcesses.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/pose/LocaliseMatch.h"
#include "tools/experiments/pose/PixelWalk.h"

namespace kelpie::experiments {
namespace {

constexpr int kCounted = 60;    // frames, the last of each walk
constexpr int kLookedAt = 6;    // every so many frames what shows is compared with what is seen
constexpr double kLost = 50.0;  // cm

struct Row {
  const char* name;
  Spoil spoil;
  double tiltDeg = 0.0;  // that the nose is lower than the body knows
};

Row row(const char* name, void (*make)(Spoil&), double tiltDeg = 0.0) {
  Row made{name, {}, tiltDeg};
  make(made.spoil);
  return made;
}

const std::vector<Row>& rows() {
  static const std::vector<Row> all{
      row("unspoilt", [](Spoil&) {}),
      row("joints_1_frame_old", [](Spoil& s) { s.jointsLate = 1.0; }),
      row("joints_2_frames_old", [](Spoil& s) { s.jointsLate = 2.0; }),
      row("images_1_frame_old", [](Spoil& s) { s.imageLate = 1.0; }),
      row("images_2_frames_old", [](Spoil& s) { s.imageLate = 2.0; }),
      row("images_3_frames_old", [](Spoil& s) { s.imageLate = 3.0; }),
      row("odometry_1.35", [](Spoil& s) { s.odometryScale = 1.35; }),
      row("odometry_0.86", [](Spoil& s) { s.odometryScale = 0.86; }),
      row("odometry_turns_0.5_deg", [](Spoil& s) { s.odometryTurn = 0.5; }),
      row("light_0.75", [](Spoil& s) { s.light = 0.75; }),
      row("light_0.55_less_colour", [](Spoil& s) { s.light = 0.55, s.colour = 0.8; }),
      row("light_1.35", [](Spoil& s) { s.light = 1.35; }),
      row("landmarks_saturated", [](Spoil& s) { s.landmarkColour = 0.5; }),
      row("noise_6", [](Spoil& s) { s.noiseSd = 6.0; }),
      row("noise_12", [](Spoil& s) { s.noiseSd = 12.0; }),
      row("beacon_15_cm_aside", [](Spoil& s) { s.beaconAside = 15.0; }),
      row("beacon_absent", [](Spoil& s) { s.beaconAbsent = true; }),
      row("body_sways", [](Spoil& s) { s.swayTilt = 1.5, s.swayRoll = 2.3; }),
      row("pan_4_deg_off", [](Spoil& s) { s.pan = 4.0; }),
      row(
          "tilt_4_deg", [](Spoil&) {}, 4.0),
      row(
          "tilt_5_deg", [](Spoil&) {}, 5.0)};
  return all;
}

// What one walk showed, over the last two seconds but for what is recognised.
struct Walked {
  double cm = 0.0;         // mean error of the position
  double cm2 = 0.0;        // mean of its square
  double believed2 = 0.0;  // cm2, what is believed of that: both variances together
  double headingDeg = 0.0;
  Recognised recognised;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("cm", &Walked::cm, "cm"), field("cm2", &Walked::cm2, "cm2"),
                     field("believed2", &Walked::believed2, "cm2"),
                     field("headingDeg", &Walked::headingDeg, "deg"),
                     field("recognised", &Walked::recognised));
  }
};

void judge(const WorldModel& world, const Pose2& truth, Walked& walked) {
  const double error = distance(world.pose.position, truth.position);
  walked.cm += error / kCounted;
  walked.cm2 += error * error / kCounted;
  walked.believed2 += (world.covariance[0] + world.covariance[4]) / kCounted;
  walked.headingDeg += (world.pose.heading - truth.heading).abs().deg() / kCounted;
}

Walked walk(const agent::AgentConfig& config, const sim::RandomisationParams& randomised,
            const Spoil& spoil, std::uint64_t seed) {
  const auto walking = std::make_unique<PixelWalk>(config, randomised, seed, spoil);
  Visibility visibility;
  Walked walked;
  walkThrough(config, *walking, [&](int frame, const View& view, const Believer& robot) {
    if (frame % kLookedAt == 0)
      walked.recognised.compare(trueObjects(view, walking->field(), visibility), robot.seen());
    if (frame >= PixelWalk::kFrames - kCounted) judge(robot.world(), view.pose, walked);
  });
  return walked;
}

struct Walks {
  std::vector<Walked> rows;  // in the order of rows()

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("rows", &Walks::rows));
  }
};

// One robot, spoilt in each of the ways.
Expected<Walks> walkAllRows(const Request& request, const agent::AgentConfig& config,
                            std::uint64_t seed) {
  Walks walks;
  for (const Row& one : rows()) {
    sim::RandomisationParams randomised = cli::paramsOf(request.randomised);
    randomised.lean.tilt = randomised.lean.tilt + Angle::deg(one.tiltDeg);
    walks.rows.push_back(walk(config, randomised, one.spoil, seed));
  }
  return walks;
}

// All walks of one row.
struct Tally {
  Values cm, headingDeg;
  double cm2 = 0.0;
  double believed2 = 0.0;
  Share seen;

  void add(const Walked& one) {
    cm.push_back(one.cm);
    headingDeg.push_back(one.headingDeg);
    cm2 += one.cm2;
    believed2 += one.believed2;
    seen.add(one.recognised.seen);
  }
  double overSd() const { return std::sqrt(ratio(cm2, believed2)); }
  Json figures(const char* name) const {
    return {{"spoilt_by", name},
            {"mean_cm", mean(cm)},
            {"worst_cm", percentile(cm, 1.0)},
            {"lost_share", shareAbove(cm, kLost)},
            {"heading_deg", mean(headingDeg)},
            {"error_over_sd", overSd()},
            {"landmarks_seen", seen.value()}};
  }
};

Expected<Json> spoilt(const Request& request) {
  const auto config = agentConfig(request);
  if (!config) return Error{config.error()};
  const auto walks = trialsInChildProcesses(
      request, [&](const Trial& trial) { return walkAllRows(request, *config, trial.seed); });
  if (!walks) return Error{walks.error()};
  Values means, worst, overSd, light;
  Json each = Json::array();
  double unspoilt = 0.0;
  for (std::size_t i = 0; i < rows().size(); ++i) {
    Tally tally;
    for (const Walks& robot : *walks) tally.add(robot.rows[i]);
    means.push_back(mean(tally.cm));
    worst.push_back(percentile(tally.cm, 1.0));
    overSd.push_back(tally.overSd());
    if (i == 0) unspoilt = tally.seen.value();
    if (rows()[i].spoil.light != 1.0) light.push_back(ratio(tally.seen.value(), unspoilt));
    each.push_back(tally.figures(rows()[i].name));
  }
  return Json{{"worst_mean_cm", percentile(means, 1.0)},
              {"worst_cm", percentile(worst, 1.0)},
              {"error_over_sd_least", percentile(overSd, 0.0)},
              {"error_over_sd_most", percentile(overSd, 1.0)},
              {"light_seen_ratio", percentile(light, 0.0)},
              {"rows", each}};
}

const Registration kSpoilt("spoilt",
                           "walks from pixels, spoilt by time, odometry, light, noise: the pose",
                           {Option::trials, Option::seed, Option::randomised, Option::params}, 12,
                           spoilt);

}  // namespace
}  // namespace kelpie::experiments
