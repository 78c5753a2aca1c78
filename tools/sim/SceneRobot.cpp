// SPDX-License-Identifier: Apache-2.0
// How a robot looks to another one: boxes for trunk, head and legs, coloured patches for the team.
#include "tools/sim/Scene.h"

namespace kelpie::sim {
namespace {

// A box in the robot frame.
struct Box {
  Point3<Robot> low;
  Point3<Robot> high;
};

FieldPoint3 onField(const Pose2& pose, Point3<Robot> p) {
  const Point2<Field> ground = fieldFromRobot(pose, {p.x, p.y});
  return {ground.x, ground.y, p.z};
}

struct Face {
  std::array<Point3<Robot>, 4> corner;
  Point3<Robot> normal;
  double lit;
};

// The faces that can be seen from outside and above; light falls from above and a little in front.
std::array<Face, 5> faces(const Box& box) {
  const Point3<Robot> a = box.low;
  const Point3<Robot> b = box.high;
  return {
      {{{{{a.x, a.y, b.z}, {b.x, a.y, b.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}}}, {0, 0, 1}, 1.1},
       {{{{a.x, b.y, a.z}, {b.x, b.y, a.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}}}, {0, 1, 0}, 1.0},
       {{{{a.x, a.y, a.z}, {b.x, a.y, a.z}, {b.x, a.y, b.z}, {a.x, a.y, b.z}}}, {0, -1, 0}, 0.88},
       {{{{b.x, a.y, a.z}, {b.x, b.y, a.z}, {b.x, b.y, b.z}, {b.x, a.y, b.z}}}, {1, 0, 0}, 0.94},
       {{{{a.x, a.y, a.z}, {a.x, b.y, a.z}, {a.x, b.y, b.z}, {a.x, a.y, b.z}}}, {-1, 0, 0}, 0.94}}};
}

void addBox(Solid& solid, const Pose2& pose, const Box& box, Colour colour, double bias) {
  for (const Face& face : faces(box)) {
    Quad quad;
    for (std::size_t i = 0; i < 4; ++i) quad.corner[i] = onField(pose, face.corner[i]);
    const FieldPoint3 tip = onField(pose, face.normal);
    quad.normal = {tip.x - pose.position.x, tip.y - pose.position.y, face.normal.z};
    quad.colour = colour;
    quad.lit = face.lit;
    quad.slope = 0.1;
    quad.oneSided = true;
    quad.depthBias = bias;
    solid.quads.push_back(quad);
  }
}

// Sizes of an ERS-7 (length 24 cm, trunk 13 cm wide at the legs); h is the shoulder's height.
Solid robotSolid(const RobotLook& look) {
  const double h = look.shoulderHeight;
  const Colour team = look.team == TeamColour::red ? colours::kRobotRed : colours::kRobotBlue;
  const Colour shell = brighter(colours::kWhite, 0.92);
  Solid solid;
  addBox(solid, look.pose, {{-4.0, -15.0, h - 3.5}, {4.0, 1.5, h + 2.5}}, shell, 0.0);
  addBox(solid, look.pose, {{-3.5, 2.0, h + 5.0}, {3.5, 11.0, h + 11.0}}, shell, 0.0);
  addBox(solid, look.pose, {{-2.5, 11.0, h + 5.5}, {2.5, 13.0, h + 9.0}}, colours::kBlack, 0.0);
  addBox(solid, look.pose, {{-2.0, -1.5, h + 2.5}, {2.0, 1.5, h + 6.0}}, colours::kGrey, 0.0);
  for (const double side : {-5.6, 5.6}) {
    for (const double along : {0.5, -12.5}) {
      addBox(solid, look.pose,
             {{side - 1.6, along - 2.2, h * 0.45}, {side + 1.6, along + 2.2, h + 2.0}}, shell, 0.0);
      addBox(solid, look.pose,
             {{side - 1.4, along - 2.5, 0.0}, {side + 1.4, along + 1.5, h * 0.45}}, colours::kGrey,
             0.0);
    }
  }
  // Team patches: back, both flanks and the head's sides.
  addBox(solid, look.pose, {{-4.3, -10.5, h - 1.5}, {4.3, -4.0, h + 2.8}}, team, 2.0);
  addBox(solid, look.pose, {{-3.8, 3.5, h + 7.0}, {3.8, 7.0, h + 11.3}}, team, 2.0);
  enclose(solid);
  return solid;
}

}  // namespace

void setRobots(Scene& scene, const std::vector<RobotLook>& robots) {
  scene.robots.clear();
  for (const RobotLook& look : robots) scene.robots.push_back(robotSolid(look));
}

}  // namespace kelpie::sim
