// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/physics/Mjcf.h"

#include <fmt/format.h>

#include "tools/sim/bodies/Bodies.h"
#include "tools/sim/physics/RobotXml.h"
#include "tools/sim/physics/Things.h"
#include "tools/sim/physics/Units.h"

namespace kelpie::sim {
namespace {

std::string thing(const std::string& shape) {
  return fmt::format("<geom {} contype=\"{}\" conaffinity=\"{}\" friction=\"0.3 0.005 0.0001\"/>\n",
                     shape, kThingsBit, kAllBits & ~kThingsBit);
}

// Robots do not leave the room.
std::string slotsXml(const body::FieldDescription& field) {
  const double side = kCm * (field.sideFringe + kCapacity);
  const double end = kCm * (field.endFringe + kCapacity);
  const double width = kCm * field.width;
  const double length = kCm * field.length;
  const auto plane = [](double x, double y, const char* normal) {
    return thing(
        fmt::format("type=\"plane\" pos=\"{} {} 0\" zaxis=\"{}\" size=\"9 9 1\"", x, y, normal));
  };
  return plane(-side, 0, "1 0 0") + plane(width + side, 0, "-1 0 0") + plane(0, -end, "0 1 0") +
         plane(0, length + end, "0 -1 0");
}

std::string fieldXml(const body::FieldDescription& field, const ContactParams& contact) {
  std::string out = fmt::format(
      "<geom name=\"carpet\" type=\"plane\" size=\"9 9 1\" contype=\"{}\" conaffinity=\"{}\" "
      "friction=\"{} 0.005 0.0001\"/>\n",
      kThingsBit, kAllBits & ~kThingsBit, contact.carpet);
  return out + thingSlotsXml(field) + slotsXml(field);
}

std::string ballXml(const PhysicalBallParams& ball) {
  const double radius = kCm * body::kBallRadius;
  const double inertia = 2.0 / 3.0 * ball.mass * radius * radius;  // of a hollow sphere
  return fmt::format(
      "<body name=\"ball\" pos=\"0 0 {0}\">\n<freejoint name=\"ball\"/>\n"
      "<inertial pos=\"0 0 0\" mass=\"{1}\" diaginertia=\"{2} {2} {2}\"/>\n"
      "<geom name=\"ball\" type=\"sphere\" size=\"{0}\" contype=\"{3}\" conaffinity=\"{4}\" "
      "friction=\"{5} 0.005 0.0001\" priority=\"1\" condim=\"3\" solref=\"{6} {7}\"/>\n</body>\n",
      radius, ball.mass, inertia, kBallBit, kAllBits & ~kBallBit, ball.friction, ball.time,
      ball.damping);
}

}  // namespace

std::string worldXml(const body::FieldDescription& field, const RobotsPhysics& robots,
                     const PhysicsParams& world) {
  // Full buffers only warn, and robots fall through the carpet: eight robots dropped in a heap used
  // 260 rows and 65 contacts (physics.md section 8). MuJoCo clears the square of the rows when it
  // starts: 0.2 s for 3000.
  std::string out = fmt::format(
      "<mujoco model=\"kelpie\">\n<compiler angle=\"degree\" inertiafromgeom=\"false\"/>\n"
      "<size njmax=\"{}\" nconmax=\"{}\"/>\n",
      200 + 350 * robots.size(), 60 + 70 * robots.size());
  out +=
      "<option timestep=\"0.002\" solver=\"Newton\" integrator=\"Euler\" cone=\"pyramidal\" "
      "iterations=\"20\" gravity=\"0 0 -9.81\"/>\n<worldbody>\n";
  out += fieldXml(field, world.contact);
  out += ballXml(world.ball);
  for (std::size_t i = 0; i < robots.size(); ++i) out += robotXml(i, robots[i]);
  out += "</worldbody>\n<actuator>\n";
  for (std::size_t i = 0; i < robots.size(); ++i) out += servosXml(i, robots[i].servo);
  out += "</actuator>\n<sensor>\n";
  for (std::size_t i = 0; i < robots.size(); ++i)
    out += fmt::format("<accelerometer site=\"r{}_imu\" cutoff=\"19.6\"/>\n", i);
  return out + "</sensor>\n</mujoco>\n";
}

}  // namespace kelpie::sim
