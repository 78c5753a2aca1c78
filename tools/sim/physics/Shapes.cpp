// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/physics/Shapes.h"

#include <string>

#include "robot/body/FieldDescription.h"
#include "tools/sim/physics/Units.h"

namespace kelpie::sim {
namespace {

// By the name that RobotXml.cpp gives: "r0_shin2" is of the leg 2.
BodyPart partOf(const std::string& name) {
  const std::string part = name.substr(name.find('_') + 1);
  if (part == "trunk" || part == "chest") return BodyPart::trunk;
  if (part == "jaw") return BodyPart::jaw;
  const int leg = part.back() - '0';
  if (leg < 0 || leg >= static_cast<int>(kLegCount)) return BodyPart::head;
  return static_cast<BodyPart>(static_cast<int>(BodyPart::leftFront) + leg);
}

// A place in the geom's own axes, in metres, as a point of the field.
Point3<Field> placed(const mjData& data, int geom, const std::array<double, 3>& p) {
  const mjtNum* x = data.geom_xpos + 3 * geom;
  const mjtNum* r = data.geom_xmat + 9 * geom;
  const auto along = [&](std::size_t axis) {
    return (x[axis] + r[3 * axis] * p[0] + r[3 * axis + 1] * p[1] + r[3 * axis + 2] * p[2]) / kCm;
  };
  return {along(0), along(1), along(2)};
}

Shape shapeOf(const Engine& engine, int geom) {
  const mjtNum* size = engine.model().geom_size + 3 * geom;
  const int type = engine.model().geom_type[geom];
  Shape shape;
  if (type != mjGEOM_BOX) {
    const double half = type == mjGEOM_CAPSULE ? size[1] : 0.0;
    shape.radius = size[0] / kCm;
    shape.corners.push_back(placed(engine.data(), geom, {0.0, 0.0, half}));
    if (half > 0.0) shape.corners.push_back(placed(engine.data(), geom, {0.0, 0.0, -half}));
    return shape;
  }
  for (const double x : {-size[0], size[0]})
    for (const double y : {-size[1], size[1]})
      for (const double z : {-size[2], size[2]})
        shape.corners.push_back(placed(engine.data(), geom, {x, y, z}));
  return shape;
}

}  // namespace

std::vector<Shape> shapesOf(const Physics& physics, std::size_t robot) {
  const Engine& engine = physics.engine();
  std::vector<Shape> shapes;
  for (int geom = 0; geom < engine.model().ngeom; ++geom) {
    if (!physics.robot(robot).owns(geom)) continue;
    shapes.push_back(shapeOf(engine, geom));
    shapes.back().part = partOf(mj_id2name(&engine.model(), mjOBJ_GEOM, geom));
  }
  return shapes;
}

Shape ballShape(const Physics& physics) {
  const Ball ball = physics.ball();
  return {BodyPart::ball,
          {{ball.position.x, ball.position.y, physics.ballHeight()}},
          body::kBallRadius};
}

}  // namespace kelpie::sim
