// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/show/Jsonl.h"

#include <cmath>
#include <iterator>

#include "gps/Refusal.h"
#include "tools/cli/show/FieldJson.h"
#include "vision/Refusal.h"

namespace kelpie::cli {

template <>
inline constexpr std::array<const char*, kLandmarkKindCount> kEnumNames<LandmarkKind> = {
    "goal_blue", "goal_yellow", "beacon_bp", "beacon_pb", "beacon_yp", "beacon_py"};
template <>
inline constexpr std::array<const char*, 2> kEnumNames<TeamColour> = {"red", "blue"};
template <>
inline constexpr std::array<const char*, 5> kEnumNames<PlayState> = {"initial", "ready", "set",
                                                                     "playing", "finished"};
template <>
inline constexpr std::array<const char*, 3> kEnumNames<LinePointKind> = {"line", "border", "field"};
template <>
inline constexpr std::array<const char*, kTraceLayerCount> kEnumNames<TraceLayer> = {
    "player", "role", "decision", "skill"};

namespace {

template <class T>
void addPercept(const char* kind, const T& percept, Json& list) {
  Json object = {{"kind", kind}};
  object.update(fieldJson(percept));
  list.push_back(std::move(object));
}

// One list of all objects: distance and heading first, as a reader looks for them.
Json percepts(const Percepts& seen) {
  Json list = Json::array();
  if (seen.ball.present) addPercept("ball", seen.ball, list);
  for (const auto& landmark : seen.landmarks) list.push_back(fieldJson(landmark));
  for (const auto& robot : seen.robots) addPercept("robot", robot, list);
  for (const auto& patch : seen.pinkPatches) addPercept("pink", patch, list);
  return list;
}

// What was refused and how often, by the reason's name.
template <class Counts, class Names>
Json refusals(const Counts& counts, const Names& names) {
  Json object = Json::object();
  for (std::size_t i = 0; i < std::size(names); ++i)
    if (counts.refused[i] > 0) object[names[i].name] = counts.refused[i];
  return object;
}

Json cameraTilt(const CameraTilt& tilt) {
  return {{"tilt_deg", degreesOf(tilt.tilt)},
          {"roll_deg", degreesOf(tilt.roll)},
          {"tilt_sd_deg", degreesOf(Angle::rad(std::sqrt(tilt.tiltVariance)))},
          {"roll_sd_deg", degreesOf(Angle::rad(std::sqrt(tilt.rollVariance)))}};
}

Json pose(const WorldModel& world) {
  return {{"x_cm", world.pose.position.x},
          {"y_cm", world.pose.position.y},
          {"heading_deg", degreesOf(world.pose.heading)},
          {"sd_cm", world.positionSd},
          {"sd_deg", degreesOf(world.headingSd)},
          {"stuck", world.stuck}};
}

// Null until the ball has been seen, and again when it is given up.
Json ball(const BallEstimate& estimate) {
  if (!estimate.present) return nullptr;
  const auto& c = estimate.covariance;
  const double larger =
      0.5 * (c[0] + c[3]) + std::sqrt(maths::square(0.5 * (c[0] - c[3])) + c[1] * c[2]);
  return {{"x_cm", estimate.position.x},
          {"y_cm", estimate.position.y},
          {"vx_cm_s", estimate.velocity.x},
          {"vy_cm_s", estimate.velocity.y},
          {"sd_cm", std::sqrt(std::fmax(0.0, larger))},
          {"distance_cm", estimate.distance},
          {"heading_deg", degreesOf(estimate.heading)},
          {"since_seen_s", estimate.secondsSinceSeen},
          {"stopping_point", fieldJson(estimate.stoppingPoint)}};
}

}  // namespace

const char* landmarkName(LandmarkKind kind) {
  return kEnumNames<LandmarkKind>[static_cast<std::size_t>(kind)];
}

nlohmann::ordered_json frameObject(const FrameInput& input, const FrameOutput& output) {
  const Percepts& seen = output.percepts;
  const WorldModel& world = output.world;
  return {{"frame", input.frame},
          {"t_s", input.time.seconds()},
          {"dropped_frames", input.droppedFrames},
          {"game", fieldJson(input.game)},
          {"control_refused", refusals(input.control, kControlRefusalNames)},
          {"percepts", percepts(seen)},
          {"gaps", fieldJson(seen.gaps)},
          {"field_edge", fieldJson(seen.fieldEdges)},
          {"line_points", fieldJson(seen.linePoints)},
          {"obstacle_points", fieldJson(seen.obstacles)},
          {"obstacles_ahead", seen.obstaclesAhead},
          {"refused", refusals(seen.counts, vision::kRefusalNames)},
          {"gps_refused", refusals(world.counts, gps::kRefusalNames)},
          {"pose", pose(world)},
          {"camera_tilt", cameraTilt(world.cameraTilt)},
          {"focal_scale", world.focalScale.ratio},
          {"image_lag_s", world.imageLag.seconds},
          {"odometry_errors", fieldJson(world.odometryErrors)},
          {"moved_landmarks", fieldJson(world.movedLandmarks)},
          {"light", fieldJson(seen.light.applied)},
          {"modes", fieldJson(world.modes)},
          {"ball", ball(world.ball)},
          {"team_ball", fieldJson(world.teamBall)},
          {"opponents", fieldJson(world.opponents)},
          {"teammates", fieldJson(world.teammates)},
          {"obstacles", fieldJson(world.obstacles)},
          {"pink_map", fieldJson(world.pinkMap)},
          {"command", fieldJson(output.command)}};
}

}  // namespace kelpie::cli
