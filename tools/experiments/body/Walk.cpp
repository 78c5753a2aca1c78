// SPDX-License-Identifier: Apache-2.0
// The walk on physical bodies, as many models as there are trials, each varied in friction,
// armature, contact, servo, mass and the play of its gears (tools/sim/physics/Variation.h), on
// carpet without an end: how fast it is in 24 directions, turning, with the fast set and with weak
// legs; how far odometry is off; how much a straight walk bends; and whether ten minutes of random
// commands make it fall.
#include <algorithm>
#include <array>
#include <cmath>

#include "robot/core/Random.h"
#include "tools/experiments/body/OnModels.h"
#include "tools/experiments/harness/Experiment.h"
#include "tools/experiments/harness/Statistics.h"

namespace kelpie::experiments {
namespace {

using learn::PhysicalWalker;
using learn::Walked;

constexpr double kMessageSeconds = kTickSeconds * kTicksPerMessage;
constexpr int kStart = 44;     // messages until the speed is even
constexpr int kMeasured = 94;  // 3 s
constexpr int kDirections = 24;
constexpr double kAll = 200.0;     // cm/s; more than any walk does
constexpr double kAllTurn = 20.0;  // rad/s
constexpr int kRandom = 18750;     // ten minutes
constexpr int kOneCommand = 40;    // 1.3 s

struct Leg {
  Walked real;
  Walked reported;
};

Leg legOf(PhysicalWalker& walker, const WalkRequest& request) {
  Command command;
  command.walk = request;
  for (int i = 0; i < kStart; ++i) walker.step(command);
  Leg leg;
  for (int i = 0; i < kMeasured; ++i) {
    leg.real += learn::walkOn(walker, command);
    const Odometry& reported = walker.output().odometry;
    leg.reported += {reported.forward, reported.left, reported.turn.rad()};
  }
  return leg;
}

double wayOf(const Walked& walked) { return std::hypot(walked.forward, walked.left); }

WalkRequest towards(int direction, double speed, WalkKind kind = WalkKind::normal) {
  const Angle angle = Angle::deg(360.0 / kDirections * direction);
  return {speed * angle.cos(), speed * angle.sin(), 0.0, 0.0, kind};
}

// What one model does.
struct Model {
  std::array<double, kDirections> speed{};  // cm/s
  double turn = 0.0;                        // deg/s
  double fast = 0.0;
  std::array<double, 4> weak{};  // forward, back, side cm/s, turn deg/s
  Values wayErrors;              // percent, of ways of one to two metres
  Values turnErrors;             // deg in 360
  Values bends;                  // deg in a metre of walking straight ahead
  double oscillation = 0.0;
  bool fell = false;
};

void judgeOdometry(const Leg& leg, Model& model) {
  const double off =
      std::hypot(leg.reported.forward - leg.real.forward, leg.reported.left - leg.real.left);
  model.wayErrors.push_back(100.0 * off / wayOf(leg.real));
}

double degrees(double rad) { return Angle::rad(1.0).deg() * rad; }

void walkDirections(PhysicalWalker& walker, Model& model) {
  constexpr double kSeconds = kMeasured * kMessageSeconds;
  for (int d = 0; d < kDirections; ++d) {
    const Leg leg = legOf(walker, towards(d, kAll));
    model.speed[static_cast<std::size_t>(d)] = wayOf(leg.real) / kSeconds;
    judgeOdometry(leg, model);
    judgeOdometry(legOf(walker, towards(d, 18.0)), model);
  }
  for (const double speed : {12.0, 24.0, 36.0}) {
    const Leg leg = legOf(walker, {speed, 0.0, 0.0});
    model.bends.push_back(degrees(std::fabs(leg.real.turn)) / (0.01 * wayOf(leg.real)));
  }
}

void turnRound(PhysicalWalker& walker, Model& model) {
  for (const double turn : {-1.0, -2.0, -kAllTurn, 1.0, 2.0, kAllTurn}) {
    const Leg leg = legOf(walker, {0.0, 0.0, turn});
    model.turnErrors.push_back(360.0 * std::fabs(leg.reported.turn / leg.real.turn - 1.0));
    if (turn > 2.0) model.turn = degrees(leg.real.turn) / (kMeasured * kMessageSeconds);
  }
}

void walkWeakly(const sim::PhysicsParams& physics, std::uint64_t seed, Model& model) {
  const actuator::ActuatorParams params;
  PhysicalWalker walker(physics, params, seed);
  learn::spare(walker);
  constexpr double kSeconds = kMeasured * kMessageSeconds;
  model.weak = {wayOf(legOf(walker, {kAll, 0.0, 0.0}).real) / kSeconds,
                wayOf(legOf(walker, {-kAll, 0.0, 0.0}).real) / kSeconds,
                wayOf(legOf(walker, {0.0, kAll, 0.0}).real) / kSeconds,
                degrees(legOf(walker, {0.0, 0.0, kAllTurn}).real.turn) / kSeconds};
}

bool fallsIn(PhysicalWalker& walker, std::uint64_t seed) {
  Random random(seed);
  Command command;
  for (int i = 0; i < kRandom; ++i) {
    if (i % kOneCommand == 0)
      command.walk = {random.uniform(-45.0, 60.0), random.uniform(-35.0, 35.0),
                      random.uniform(-4.5, 4.5)};
    walker.step(command);
    if (walker.fallen()) return true;
  }
  return false;
}

Model walkModel(const sim::PhysicsParams& physics, std::uint64_t seed) {
  const actuator::ActuatorParams params;
  PhysicalWalker walker(physics, params, seed);
  Model model;
  walkDirections(walker, model);
  turnRound(walker, model);
  model.fast = wayOf(legOf(walker, {kAll, 0.0, 0.0, 0.0, WalkKind::fast}).real) /
               (kMeasured * kMessageSeconds);
  walkWeakly(physics, seed, model);
  model.fell = fallsIn(walker, seed);
  return model;
}

// The mean over all models; and the least share that one of them does of it.
double meanOf(const std::vector<Model>& models, double (*speed)(const Model&), double& worst) {
  Values speeds;
  for (const Model& model : models) speeds.push_back(speed(model));
  const double all = mean(speeds);
  worst = std::min(worst, percentile(speeds, 0.0) / std::max(all, 1e-3));
  return all;
}

Expected<Json> walk(const Request& request) {
  const std::vector<Model> models = onModels<Model>(request, walkModel);
  double worst = 1.0;
  Json json;
  json["forward_cm_s"] = meanOf(
      models, [](const Model& m) { return m.speed[0]; }, worst);
  json["back_cm_s"] = meanOf(
      models, [](const Model& m) { return m.speed[12]; }, worst);
  json["side_cm_s"] = meanOf(
      models, [](const Model& m) { return 0.5 * (m.speed[6] + m.speed[18]); }, worst);
  json["turn_deg_s"] = meanOf(
      models, [](const Model& m) { return m.turn; }, worst);
  json["fast_cm_s"] = meanOf(
      models, [](const Model& m) { return m.fast; }, worst);
  Json weak;
  const std::array<const char*, 4> names{"forward_cm_s", "back_cm_s", "side_cm_s", "turn_deg_s"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    Values speeds;
    for (const Model& model : models) speeds.push_back(model.weak[i]);
    weak[names[i]] = mean(speeds);
  }
  Values slowest;
  for (std::size_t d = 0; d < kDirections; ++d) {
    Values speeds;
    for (const Model& model : models) speeds.push_back(model.speed[d]);
    slowest.push_back(mean(speeds));
    worst = std::min(worst, percentile(speeds, 0.0) / mean(speeds));
  }
  Values ways;
  Values turns;
  Values bends;
  int falls = 0;
  for (const Model& model : models) {
    append(model.wayErrors, ways);
    append(model.turnErrors, turns);
    append(model.bends, bends);
    falls += model.fell ? 1 : 0;
  }
  json["slowest_direction_cm_s"] = percentile(slowest, 0.0);
  json["worst_share"] = worst;
  json["weak"] = weak;
  json["odometry_pct"] = mean(ways);
  json["odometry_worst_pct"] = percentile(ways, 1.0);
  json["odometry_turn_deg"] = mean(turns);
  json["bend_deg_m"] = mean(bends);
  json["bend_worst_deg_m"] = percentile(bends, 1.0);
  json["falls"] = falls;
  return json;
}

const Registration kWalk("walk", "speeds of the physical body on varied models, odometry, falls",
                         {Option::trials, Option::seed}, 5, walk);

}  // namespace
}  // namespace kelpie::experiments
