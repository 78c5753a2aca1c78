// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/Jsonl.h"

#include <array>
#include <cmath>

namespace kelpie::cli {
namespace {

using Json = nlohmann::ordered_json;

Json percept(const char* kind, double distance, Angle heading) {
  return {{"kind", kind}, {"distance_cm", distance}, {"heading_deg", heading.deg()}};
}

Json percepts(const Percepts& seen) {
  Json list = Json::array();
  if (seen.ball.present) list.push_back(percept("ball", seen.ball.distance, seen.ball.heading));
  for (const auto& landmark : seen.landmarks)
    list.push_back(percept(landmarkName(landmark.kind), landmark.distance, landmark.heading));
  return list;
}

// Of each edge the rows of the image at its left and right border.
Json fieldEdges(const Percepts& seen) {
  Json list = Json::array();
  for (const auto& edge : seen.fieldEdges)
    list.push_back({{"left_px", edge.atLeft}, {"right_px", edge.atRight}});
  return list;
}

Json pose(const WorldModel& world) {
  return {{"x_cm", world.pose.position.x},
          {"y_cm", world.pose.position.y},
          {"heading_deg", world.pose.heading.deg()},
          {"sd_cm", world.positionSd},
          {"sd_deg", world.headingSd.deg()}};
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
          {"sd_cm", std::sqrt(std::fmax(0.0, larger))}};
}

}  // namespace

const char* landmarkName(LandmarkKind kind) {
  static constexpr std::array<const char*, kLandmarkKindCount> kNames = {
      "goal_blue", "goal_yellow", "beacon_bp", "beacon_pb", "beacon_yp", "beacon_py"};
  return kNames[static_cast<std::size_t>(kind)];
}

nlohmann::ordered_json frameObject(const FrameInput& input, const FrameOutput& output) {
  return {{"frame", input.frame},
          {"t_s", input.time.seconds()},
          {"percepts", percepts(output.percepts)},
          {"field_edges", fieldEdges(output.percepts)},
          {"line_points", output.percepts.linePoints.size()},
          {"pose", pose(output.world)},
          {"ball", ball(output.world.ball)}};
}

}  // namespace kelpie::cli
