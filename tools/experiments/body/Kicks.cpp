// SPDX-License-Identifier: Apache-2.0
// Each kick of actuator/data/motions on physical models varied in friction, armature, contact,
// servo, mass and play: twelve places of the ball on each, 12 mm to each side of where the kick
// wants it, of a held ball 6 mm. The same while another robot pushes from the front.
#include <cmath>

#include "tools/experiments/harness/Experiment.h"
#include "tools/learn/kick/KickLearner.h"
#include "tools/learn/walk/WalkLearner.h"

namespace kelpie::experiments {
namespace {

constexpr double kStep = 0.002;  // s, of the physics; shorter by itself while a ball touches it
constexpr int kPlaces = 12;      // on each model

std::string keyOf(MotionKind kind) {
  return actuator::kMotionNames[static_cast<std::size_t>(kind)];
}

void addKick(const learn::KickAim& aim, const Request& request, Json& json) {
  const actuator::MotionData& motion = actuator::standardMotions()[aim.motion];
  const std::string key = keyOf(aim.motion);
  constexpr std::pair<learn::BeforeKick, const char*> kBefore[] = {
      {learn::BeforeKick::rests, ""},
      {learn::BeforeKick::pushed, "_pushed"},
      {learn::BeforeKick::turned, "_turned"},
  };
  for (const auto& [before, suffix] : kBefore) {
    if (before == learn::BeforeKick::turned && !aim.held) continue;
    const auto starts =
        learn::beforeKicks(aim, learn::variedModels(request.seed, request.trials, kStep), kPlaces,
                           request.seed, before);
    const auto spread = learn::spreadOf(learn::tryFromAll(motion, aim, starts));
    const std::string name = key + suffix;
    json[name + "_cm"] = spread.distance;
    json[name + "_sd_cm"] = spread.distanceSd;
    json[name + "_deg"] = spread.direction.deg();
    json[name + "_sd_deg"] = spread.directionSd.deg();
    json[name + "_falls"] = spread.falls;
    json[name + "_stayed"] = spread.stayed;
  }
  json[key + "_frames"] = std::ceil(ticksOf(motion) * kTickSeconds * 30.0);
}

Expected<Json> kicks(const Request& request) {
  Json json;
  const actuator::Motions& motions = actuator::standardMotions();
  for (const learn::KickAim& found : learn::kicks()) {
    const learn::KickAim aim = learn::aimOf(found, motions[found.motion]);
    addKick(aim, request, json);
    const learn::KickAim other = learn::mirrored(aim);
    if (other.motion != aim.motion) addKick(other, request, json);
  }
  const auto min = [&](const char* one, const char* another) {
    return std::fmin(json[one].get<double>(), json[another].get<double>());
  };
  json["swipe_cm"] = min("head_swipe_left_cm", "head_swipe_right_cm");
  json["upenn_cm"] = min("upenn_left_cm", "upenn_right_cm");
  int falls = 0;
  for (const auto& [key, value] : json.items())
    if (key.find("_falls") != std::string::npos && key.find("pushed") == std::string::npos)
      falls += value.get<int>();
  json["falls"] = falls;
  json["runs"] = request.trials * kPlaces;
  return json;
}

const Registration kKicks("kicks", "each kick on varied physical models: how far, which way, falls",
                          {Option::trials, Option::seed}, 5, kicks);

}  // namespace
}  // namespace kelpie::experiments
