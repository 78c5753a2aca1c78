// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/physics/Things.h"

#include <fmt/format.h>

#include <cmath>

#include "tools/sim/physics/RobotXml.h"
#include "tools/sim/physics/Units.h"

namespace kelpie::sim {
namespace {

constexpr double kWallHigh = 0.15;  // m, half the height of a wall
constexpr std::size_t kWalls = 4;   // of an outer wall
constexpr double kAway = -9.0;      // m over the carpet, of an empty slot

// A solid of the engine: its half sizes in m.
struct Solid {
  int type = mjGEOM_BOX;
  std::array<double, 3> half{};
};

Solid solidOf(const Obstacle& thing, const body::FieldDescription& field) {
  const double way = distance(thing.a, thing.b);
  if (way > 0.0)
    return {mjGEOM_BOX, {kCm * (0.5 * way + thing.radius), kCm * thing.radius, kWallHigh}};
  const bool beacon = thing.radius == field.beaconRadius;
  const double height = beacon ? field.beaconHeight : field.goalHeight;
  return {mjGEOM_CYLINDER, {kCm * thing.radius, 0.5 * kCm * height, 0.0}};
}

void put(const Obstacle& thing, const Solid& solid, int geom, mjModel& model) {
  const Point2<Field> middle = (thing.a + thing.b) * 0.5;
  const Point2<Field> way = thing.b - thing.a;
  const double half = 0.5 * maths::atan2(way.y, way.x);
  const bool box = solid.type == mjGEOM_BOX;
  mjtNum* place = model.geom_pos + 3 * geom;
  place[0] = kCm * middle.x;
  place[1] = kCm * middle.y;
  place[2] = box ? solid.half[2] : solid.half[1];
  mjtNum* turn = model.geom_quat + 4 * geom;
  turn[0] = std::cos(half);
  turn[1] = turn[2] = 0.0;
  turn[3] = std::sin(half);
  model.geom_type[geom] = solid.type;
  double squares = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    model.geom_size[3 * static_cast<std::size_t>(geom) + k] = solid.half[k];
    squares += maths::square(solid.half[k]);
  }
  model.geom_rbound[geom] = std::sqrt(squares);  // within which the engine looks for contacts
  model.geom_contype[geom] = kThingsBit;
  model.geom_conaffinity[geom] = kAllBits & ~kThingsBit;
}

void clear(int geom, mjModel& model) {
  model.geom_contype[geom] = model.geom_conaffinity[geom] = 0;
}

int slot(std::size_t i, const Engine& engine) { return engine.geom(fmt::format("thing{}", i)); }

}  // namespace

std::string thingSlotsXml(const body::FieldDescription& field) {
  std::string out;
  for (std::size_t i = 0; i < obstaclesOf(field).size() + kWalls; ++i)
    out += fmt::format(
        "<geom name=\"thing{}\" type=\"box\" pos=\"0 0 {}\" size=\"0.1 0.1 0.1\" contype=\"0\" "
        "conaffinity=\"0\" friction=\"0.3 0.005 0.0001\"/>\n",
        i, kAway);
  return out;
}

Status putThings(const std::vector<Obstacle>& things, const body::FieldDescription& field,
                 Engine& engine) {
  if (!things.empty() && slot(things.size() - 1, engine) < 0)
    return Error{
        fmt::format("the physical world has no room for {} things on the field", things.size())};
  mjModel& model = engine.model();
  for (std::size_t i = 0; i < things.size(); ++i)
    put(things[i], solidOf(things[i], field), slot(i, engine), model);
  for (std::size_t i = things.size(); slot(i, engine) >= 0; ++i) clear(slot(i, engine), model);
  return Done{};
}

}  // namespace kelpie::sim
