// SPDX-License-Identifier: Apache-2.0
// What `kelpie calibrate body` finds from twenty seconds of standing and looking round in stops,
// against what was drawn for the robot: every trial is another robot in another randomised world
// (or the nominal one, without --randomise) that stands somewhere else. The estimator reads the
// agent's log alone. At rest the head has sunk through the play of neck and nod, which is part of
// the truth.
#include <algorithm>
#include <cmath>

#include "tools/calibrate/body/BodyEstimate.h"
#include "tools/calibrate/body/ResidualPicture.h"
#include "tools/cli/DataFolder.h"
#include "tools/cli/RunDirectory.h"
#include "tools/cli/log/Logs.h"
#include "tools/experiments/harness/ChildProcesses.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/pose/LocaliseMatch.h"

namespace kelpie::experiments {
namespace {

using calibrate::BodyEstimate;

constexpr double kGetUp = 2.0;   // s
constexpr double kStand = 20.0;  // s
constexpr double kBoth = 0.5;    // of a play: where the middle of the dead zone is

// Found less true, and the estimator's own standard deviations.
struct Found {
  bool accepted = false;  // not refused
  double tilt = 0.0;      // deg, of neck and body
  double tiltSd = 0.0;
  double nod = 0.0;   // deg
  double roll = 0.0;  // deg, of the body
  double rollSd = 0.0;
  // deg, of the image's middle in a camera that looks straight ahead: nod and principal point,
  // which shift an image alike and can hardly be distinguished, count together.
  double ahead = 0.0;
  double focal = 0.0;  // percent
  double focalSd = 0.0;
  std::string trouble;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("accepted", &Found::accepted), field("tilt", &Found::tilt),
                     field("tiltSd", &Found::tiltSd), field("nod", &Found::nod),
                     field("roll", &Found::roll), field("rollSd", &Found::rollSd),
                     field("ahead", &Found::ahead), field("focal", &Found::focal),
                     field("focalSd", &Found::focalSd), field("trouble", &Found::trouble));
  }
};

// Plays, and keeps the log of the stand.
Status record(const agent::AgentConfig& config, const Request& request, std::uint64_t seed,
              const std::string& path, sim::RandomisedRobot& truth) {
  LocaliseMatch match(config, cli::dataFolder() + "/tools/calibrate/looking", seed,
                      request.randomised);
  if (match.world().randomised().robots.size() > 0) truth = match.world().randomised().robots[0];
  const Status up = match.play(kGetUp, {});
  if (!up) return up;
  auto log = cli::LogFile::create(path, config, {}, cli::ImagesKept::all);
  if (!log) return Error{log.error()};
  const Status played = match.play(
      kGetUp + kStand, [&](const WatchedFrame& frame) { log->frame(frame.input, frame.output); });
  if (!played) return played;
  return log->close();
}

Found compare(const BodyEstimate& e, const sim::RandomisedRobot& truth) {
  const auto sdOf = [&](calibrate::Unknown unknown) { return e.unknowns[unknown].sd; };
  const sim::NeckPlay& play = truth.body.play;
  Found found;
  found.accepted = true;
  found.tilt =
      e.params.neckTiltOffset.deg() + truth.body.lean.tilt.deg() + kBoth * play.neckTilt.deg();
  found.nod = e.params.headNodOffset.deg() + kBoth * play.headNod.deg();
  const double down = (e.params.lens.principalY - truth.lens.principalY) / truth.lens.focal;
  found.ahead = found.tilt + found.nod + Angle::rad(down).deg();
  found.roll = e.params.bodyRollOffset.deg() - truth.body.lean.roll.deg();
  found.focal = 100.0 * (e.params.lens.focalLength / truth.lens.focal - 1.0);
  found.tiltSd = sdOf(calibrate::kNeckTilt);
  found.rollSd = sdOf(calibrate::kBodyRoll);
  found.focalSd = 100.0 * sdOf(calibrate::kFocalLength) / truth.lens.focal;
  return found;
}

Expected<Found> calibrateOne(const Request& request, const agent::AgentConfig& config,
                             std::uint64_t seed) {
  const cli::RunDirectory runDirectory;
  if (!runDirectory.ready()) return Error{"there is no room for a temporary folder"};
  const std::string path = runDirectory.path("stand.mcap");
  sim::RandomisedRobot truth;
  const Status recorded = record(config, request, seed, path, truth);
  auto log = recorded ? calibrate::readStanding(path) : Error{recorded.error()};
  if (!recorded) return Error{recorded.error()};
  const auto estimate = log ? calibrate::estimateBody(*log) : Error{log.error()};
  if (!estimate) {
    Found refused;
    refused.trouble = estimate.error();
    return refused;
  }
  if (!request.pictures.empty()) {
    const Status drawn = calibrate::writeResidualPicture(
        *estimate, request.pictures + "/" + std::to_string(seed) + ".png");
    if (!drawn) return Error{drawn.error()};
  }
  return compare(*estimate, truth);
}

double worst(const Values& values) {
  double largest = 0.0;
  for (const double value : values) largest = std::max(largest, std::fabs(value));
  return largest;
}

Expected<Json> calibrateBody(const Request& request) {
  const auto config = agentConfig(request);
  if (!config) return Error{config.error()};
  const auto all = trialsInChildProcesses(
      request, [&](const Trial& trial) { return calibrateOne(request, *config, trial.seed); });
  if (!all) return Error{all.error()};
  Json json;
  Share accepted;
  for (const Found& found : *all) accepted.count(found.accepted);
  json["accepted_rate"] = accepted.value();
  const auto add = [&](const std::string& key, const char* unit, auto&& value) {
    Values errors;
    for (const Found& found : *all)
      if (found.accepted) errors.push_back(value(found));
    json[key + "_error_" + unit] = worst(errors);
    json[key + "_error_rms_" + unit] = rms(errors);
  };
  add("tilt", "deg", [](const Found& f) { return f.tilt; });
  add("nod", "deg", [](const Found& f) { return f.nod; });
  add("ahead", "deg", [](const Found& f) { return f.ahead; });
  add("roll", "deg", [](const Found& f) { return f.roll; });
  add("focal", "percent", [](const Found& f) { return f.focal; });
  add("tilt", "sds", [](const Found& f) { return f.tilt / std::max(f.tiltSd, 1e-6); });
  add("focal", "sds", [](const Found& f) { return f.focal / std::max(f.focalSd, 1e-6); });
  for (const Found& found : *all) json["each"].push_back(toJson(found));
  return json;
}

const Registration kCalibrateBody("calibrate-body",
                                  "body parameters found from 20 s of standing, against the truth",
                                  {Option::trials, Option::seed, Option::randomised, Option::params,
                                   Option::pictures},
                                  8, calibrateBody);

}  // namespace
}  // namespace kelpie::experiments
