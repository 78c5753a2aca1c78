// SPDX-License-Identifier: Apache-2.0
// The map of a standing robot from pixels, every camera artefact on: a robot is put somewhere,
// stands and looks about. Localisers that hear lines alone start within 40 cm and 20 deg of its
// place, with the map and without; compared after eight seconds, a pan low and one high.
#include <cmath>

#include "robot/core/Random.h"
#include "tools/cli/DataFolder.h"
#include "tools/experiments/harness/ChildProcesses.h"
#include "tools/experiments/pose/LocaliseFilters.h"

namespace kelpie::experiments {
namespace {

constexpr int kPlaces = 10;      // of one robot
constexpr double kSettle = 1.0;  // s, to stand still after being put there
constexpr double kStand = 8.0;   // s
constexpr double kFromLines = 30.0;

// Errors at the end of one stand.
struct StandErrors {
  PoseError with;
  PoseError without;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("with", &StandErrors::with), field("without", &StandErrors::without));
  }
};

// Those of all places of one robot.
struct Stands {
  std::vector<StandErrors> errors;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("errors", &Stands::errors));
  }
};

class Stand {
 public:
  Stand(const gps::GpsParams& params, const Pose2& believed) {
    gps::GpsParams known = params;
    known.initialPose = {true, believed, 20.0, Angle::deg(12)};
    Hearing lines;
    lines.landmarks = false;
    with_ = std::make_unique<Listener>("with", known, lines);
    known.lines.map.use = false;
    without_ = std::make_unique<Listener>("without", known, lines);
  }
  void frame(const WatchedFrame& frame) {
    errors_.with = poseError(with_->hear(frame), frame.truth);
    errors_.without = poseError(without_->hear(frame), frame.truth);
  }
  const StandErrors& errors() const { return errors_; }

 private:
  std::unique_ptr<Listener> with_;
  std::unique_ptr<Listener> without_;
  StandErrors errors_;
};

Pose2 beside(const Pose2& pose, Random& random) {
  const Angle way = Angle::rad(random.uniform(-maths::kPi, maths::kPi));
  const double away = 40.0 * std::sqrt(random.uniform(0.0, 1.0));
  return {pose.position + Point2<Field>{way.cos(), way.sin()} * away,
          pose.heading + Angle::deg(random.uniform(-20.0, 20.0))};
}

Expected<Stands> standAtPlaces(const Request& request, const agent::AgentConfig& config,
                               std::uint64_t seed) {
  LocaliseMatch match(config, cli::dataFolder() + "/tools/experiments/pose/standing", seed,
                      request.randomised);
  Random random(seed ^ 0x57a2dULL);
  const body::FieldDescription& field = config.field;
  Stands stands;
  for (int place = 0; place < kPlaces; ++place) {
    const Pose2 pose{{random.uniform(kFromLines, field.width - kFromLines),
                      random.uniform(kFromLines, field.length - kFromLines)},
                     Angle::rad(random.uniform(-maths::kPi, maths::kPi))};
    const Status carried = match.world().carry(0, pose);
    if (!carried) return Error{carried.error()};
    Stand stand(config.gps, beside(pose, random));
    const double began = match.world().time().seconds();
    const Status played = match.play(began + kSettle + kStand, [&](const WatchedFrame& frame) {
      if (frame.input.time.seconds() > began + kSettle) stand.frame(frame);
    });
    if (!played) return Error{played.error()};
    stands.errors.push_back(stand.errors());
  }
  return stands;
}

void addFigures(const std::string& prefix, const ErrorTrack& track, Json& json) {
  const Json all = track.summary();
  for (const char* key : {"mean_cm", "median_cm", "p95_cm", "mean_deg", "nees"})
    json[prefix + key] = all[key];
}

Expected<Json> stationaryViews(const Request& request) {
  const auto config = agentConfig(request);
  if (!config) return Error{config.error()};
  const auto robots = trialsInChildProcesses(
      request, [&](const Trial& trial) { return standAtPlaces(request, *config, trial.seed); });
  if (!robots) return Error{robots.error()};
  ErrorTrack with, without;
  for (const Stands& stands : *robots)
    for (const StandErrors& errors : stands.errors) {
      with.add(errors.with);
      without.add(errors.without);
    }
  Json json{{"stands", with.cm.size()}};
  addFigures("", with, json);
  addFigures("without_map_", without, json);
  return json;
}

const Registration kStationaryViews(
    "stationary-views", "standing, from pixels, lines alone: errors with the map and without it",
    {Option::trials, Option::seed, Option::randomised, Option::params}, 4, stationaryViews);

}  // namespace
}  // namespace kelpie::experiments
