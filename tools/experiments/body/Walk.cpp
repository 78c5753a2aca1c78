// SPDX-License-Identifier: Apache-2.0
// The walk on the physical body: how fast it is in each direction, what of it odometry tells, and
// whether random commands make it fall, on as many models as there are trials, each varied in
// friction, armature, contact and servo (tools/sim/physics/Variation.h).
#include <algorithm>
#include <array>
#include <cmath>

#include "robot/core/Random.h"
#include "tools/experiments/body/Ways.h"
#include "tools/experiments/harness/Experiment.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/sim/physics/Variation.h"

namespace kelpie::experiments {
namespace {

constexpr double kMessageSeconds = kTickSeconds * kTicksPerMessage;
constexpr int kStart = 62;       // messages until the speed is even
constexpr int kMeasured = 125;   // 4 s
constexpr int kRandom = 1875;    // a minute of random commands
constexpr int kOneCommand = 40;  // 1.3 s

struct Direction {
  const char* key;
  WalkRequest request;  // the largest that a behaviour may ask for
};
constexpr std::array<Direction, 4> kDirections{{{"forward_cm_s", {42.0, 0.0, 0.0}},
                                                {"back_cm_s", {-30.0, 0.0, 0.0}},
                                                {"side_cm_s", {0.0, 20.0, 0.0}},
                                                {"turn_deg_s", {0.0, 0.0, 3.8}}}};

sim::WalkingBody bodyOf(std::uint64_t seed) {
  return sim::WalkingBody(seed, {}, sim::BodyKind::physical, sim::varied({}, seed));
}

struct Speeds {
  double walked = 0.0;    // cm/s or deg/s
  double reported = 0.0;  // by odometry
};

// Of the direction that is asked for.
double speedIn(const WalkRequest& request, const Displacement& way) {
  const double seconds = kMeasured * kMessageSeconds;
  if (request.turn != 0.0) return std::fabs(Angle::rad(1.0).deg() * way.turn) / seconds;
  return std::fabs(request.forward != 0.0 ? way.forward : way.left) / seconds;
}

Speeds speedsOf(const WalkRequest& request, std::uint64_t seed) {
  sim::WalkingBody body = bodyOf(seed);
  Ways ways;
  walkOn(body, request, kStart, ways);
  ways = {};
  walkOn(body, request, kMeasured, ways);
  return {speedIn(request, ways.walked), speedIn(request, ways.reported)};
}

// Whether it fell within a minute.
bool fallsIn(std::uint64_t seed) {
  sim::WalkingBody body = bodyOf(seed);
  Random random(seed);
  Command command;
  for (int i = 0; i < kRandom; ++i) {
    if (i % kOneCommand == 0)
      command.walk = {random.uniform(-30.0, 42.0), random.uniform(-20.0, 20.0),
                      random.uniform(-3.8, 3.8)};
    body.step(command);
    if (body.fallen()) return true;
  }
  return false;
}

Expected<Json> walk(const Request& request) {
  Json json;
  double worstShare = 1.0;
  double odometry = 0.0;
  for (const Direction& direction : kDirections) {
    Values speeds;
    Values errors;
    for (int i = 0; i < request.trials; ++i) {
      const Speeds speed =
          speedsOf(direction.request, request.seed + static_cast<std::uint64_t>(i));
      speeds.push_back(speed.walked);
      errors.push_back(100.0 * std::fabs(speed.reported / std::max(speed.walked, 1.0) - 1.0));
    }
    json[direction.key] = mean(speeds);
    json[std::string("least_") + direction.key] = percentile(speeds, 0.0);
    worstShare = std::min(worstShare, percentile(speeds, 0.0) / mean(speeds));
    json[std::string("odometry_pct_of_") + direction.key] = mean(errors);
    odometry = std::max(odometry, mean(errors));
  }
  int falls = 0;
  for (int i = 0; i < request.trials; ++i)
    falls += fallsIn(request.seed + static_cast<std::uint64_t>(i)) ? 1 : 0;
  json["worst_share"] = worstShare;
  json["odometry_pct"] = odometry;
  json["falls"] = falls;
  return json;
}

const Registration kWalk("walk", "speeds of the physical body on varied models, odometry, falls",
                         {Option::trials, Option::seed}, 5, walk);

}  // namespace
}  // namespace kelpie::experiments
