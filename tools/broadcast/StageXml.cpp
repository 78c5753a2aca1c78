// SPDX-License-Identifier: Apache-2.0
#include "tools/broadcast/StageXml.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "tools/broadcast/DogXml.h"

namespace kelpie::broadcast {
namespace {

constexpr double kCm = 0.01;      // m
constexpr double kPaint = 0.001;  // m, how high lines stand above the carpet, to be seen
constexpr double kWall = 0.006;   // m, half the thickness of a goal's walls
constexpr int kCirclePieces = 28;

std::string box(double x, double y, double z, double halfX, double halfY, double halfZ,
                const std::string& material, double turn = 0.0) {
  return fmt::format(
      "<geom type=\"box\" pos=\"{} {} {}\" size=\"{} {} {}\" euler=\"0 0 {}\" "
      "material=\"{}\"/>\n",
      x, y, z, halfX, halfY, halfZ, turn, material);
}

std::string stripe(Point2<Field> a, Point2<Field> b, double width) {
  const Point2<Field> way = b - a;
  const double turn = std::atan2(way.y, way.x) * 180.0 / maths::kPi;
  return box(kCm * 0.5 * (a.x + b.x), kCm * 0.5 * (a.y + b.y), 0.0,
             0.5 * kCm * (way.norm() + width), 0.5 * kCm * width, kPaint, "paint", turn);
}

std::string linesXml(const body::FieldDescription& field) {
  std::string out;
  for (const auto& line : field.lines) out += stripe(line.start, line.end, field.lineWidth);
  const double radius = 0.5 * (field.circleDiameter - field.lineWidth);
  const auto onCircle = [&](int i) {
    const double turn = 2.0 * maths::kPi * i / kCirclePieces;
    return Point2<Field>{0.5 * field.width + radius * std::cos(turn),
                         0.5 * field.length + radius * std::sin(turn)};
  };
  for (int i = 0; i < kCirclePieces; ++i)
    out += stripe(onCircle(i), onCircle(i + 1), field.lineWidth);
  return out;
}

std::string goalXml(const body::FieldDescription& field, const body::Landmark& mouth) {
  const bool far = mouth.position.y > 0.5 * field.length;
  const std::string paint = mouth.kind == LandmarkKind::goalBlue ? "bluegoal" : "yellowgoal";
  const double x = kCm * mouth.position.x, y = kCm * mouth.position.y;
  const double deep = kCm * field.goalDepth * (far ? 1.0 : -1.0);
  const double half = 0.5 * kCm * field.goalWidth, high = 0.5 * kCm * field.goalHeight;
  std::string out = box(x, y + deep, high, half + kWall, kWall, high, paint);
  for (const double side : {-1.0, 1.0})
    out += box(x + side * half, y + 0.5 * deep, high, kWall, 0.5 * std::fabs(deep), high, paint);
  return out;
}

// From the ground up: two white bands, and the two that tell it from the others.
std::array<const char*, 4> bandsOf(LandmarkKind kind) {
  switch (kind) {
    case LandmarkKind::beaconBlueOnPink: return {"shell", "shell", "pink", "bluegoal"};
    case LandmarkKind::beaconPinkOnBlue: return {"shell", "shell", "bluegoal", "pink"};
    case LandmarkKind::beaconYellowOnPink: return {"shell", "shell", "pink", "yellowgoal"};
    default: return {"shell", "shell", "yellowgoal", "pink"};
  }
}

std::string beaconXml(const body::FieldDescription& field, const body::Landmark& beacon) {
  const double half = 0.125 * kCm * field.beaconHeight;
  std::string out;
  double z = half;
  for (const char* const paint : bandsOf(beacon.kind)) {
    out += fmt::format(
        "<geom type=\"cylinder\" pos=\"{} {} {}\" size=\"{} {}\" material=\"{}\"/>\n",
        kCm * beacon.position.x, kCm * beacon.position.y, z, kCm * field.beaconRadius, half, paint);
    z += 2.0 * half;
  }
  return out;
}

std::string fieldXml(const body::FieldDescription& field) {
  const body::Carpet green = body::carpetOf(field);
  const Point2<Field> middle = (green.low + green.high) * 0.5;
  const Point2<Field> size = green.high - green.low;
  std::string out = box(kCm * middle.x, kCm * middle.y, -0.02, 0.5 * kCm * size.x,
                        0.5 * kCm * size.y, 0.02, "carpet");
  out +=
      fmt::format("<geom type=\"plane\" pos=\"{} {} -0.035\" size=\"7 7 1\" material=\"floor\"/>\n",
                  kCm * middle.x, kCm * middle.y);
  out += linesXml(field);
  for (const auto& mark : field.landmarks)
    out += mark.kind == LandmarkKind::goalBlue || mark.kind == LandmarkKind::goalYellow
               ? goalXml(field, mark)
               : beaconXml(field, mark);
  return out;
}

const char* const kAssets = R"(<asset>
<texture name="sky" type="skybox" builtin="gradient" rgb1="0.30 0.34 0.40" rgb2="0.07 0.08 0.10"
 width="256" height="256"/>
<texture name="carpet" type="2d" builtin="flat" mark="random" random="0.35" width="512" height="512"
 rgb1="0.10 0.40 0.14" markrgb="0.13 0.46 0.18"/>
<texture name="floor" type="2d" builtin="checker" width="256" height="256"
 rgb1="0.20 0.21 0.23" rgb2="0.22 0.23 0.25"/>
<material name="carpet" texture="carpet" texrepeat="3 3" texuniform="true" specular="0"/>
<material name="floor" texture="floor" texrepeat="2 2" texuniform="true" specular="0"/>
<material name="paint" rgba="0.97 0.97 0.97 1" specular="0" emission="0.1"/>
<material name="bluegoal" rgba="0.10 0.30 0.85 1" specular="0.2" emission="0.1"/>
<material name="yellowgoal" rgba="0.98 0.80 0.08 1" specular="0.2" emission="0.1"/>
<material name="pink" rgba="0.95 0.36 0.60 1" specular="0.2" emission="0.1"/>
<material name="ball" rgba="1.0 0.42 0.04 1" specular="0.6" shininess="0.6" emission="0.15"/>
<material name="shell" rgba="0.95 0.95 0.97 1" specular="0.5" shininess="0.5"/>
<material name="joint" rgba="0.24 0.25 0.28 1" specular="0.3"/>
<material name="paw" rgba="0.34 0.35 0.39 1" specular="0.2"/>
<material name="ear" rgba="0.16 0.16 0.18 1" specular="0.3"/>
<material name="visor" rgba="0.03 0.03 0.05 1" specular="1" shininess="0.9"/>
<material name="red" rgba="0.86 0.10 0.10 1" specular="0.3" emission="0.08"/>
<material name="blue" rgba="0.12 0.22 0.86 1" specular="0.3" emission="0.08"/>
</asset>
)";

// Two lamps above the field, of which one casts the shadows, and a little light from everywhere.
std::string visualXml(int width, int height) {
  return fmt::format(
      "<visual>\n<global fovy=\"32\" offwidth=\"{}\" offheight=\"{}\"/>\n"
      "<quality shadowsize=\"1024\" offsamples=\"0\" numslices=\"14\" numstacks=\"8\" "
      "numquads=\"1\"/>\n"
      "<map znear=\"0.02\" zfar=\"8\" shadowclip=\"0.9\"/>\n"
      "<headlight ambient=\"0.38 0.38 0.40\" diffuse=\"0.16 0.16 0.16\" specular=\"0 0 0\"/>\n"
      "</visual>\n<statistic extent=\"3\" center=\"1.8 2.7 0.1\"/>\n",
      width, height);
}

std::string lightsXml(const body::FieldDescription& field) {
  const double x = 0.5 * kCm * field.width, y = 0.5 * kCm * field.length;
  return fmt::format(
      "<light directional=\"true\" pos=\"{0} {1} 4\" dir=\"-0.35 0.25 -1\" "
      "diffuse=\"0.55 0.55 0.53\" specular=\"0.25 0.25 0.25\" castshadow=\"false\"/>\n"
      "<light directional=\"true\" pos=\"{0} {1} 4\" dir=\"0.5 -0.3 -0.8\" "
      "diffuse=\"0.16 0.17 0.20\" specular=\"0 0 0\" castshadow=\"false\"/>\n",
      x, y);
}

}  // namespace

std::string stageXml(const body::FieldDescription& field, const std::set<Player>& players,
                     int width, int height) {
  std::string out =
      "<mujoco model=\"stage\">\n<compiler angle=\"degree\" inertiafromgeom=\"true\"/>\n"
      "<option gravity=\"0 0 0\"/>\n" +
      visualXml(width, height) + kAssets +
      "<default><geom contype=\"0\" conaffinity=\"0\"/></default>\n<worldbody>\n" +
      lightsXml(field) + fieldXml(field);
  out += fmt::format(
      "<body name=\"ball\" pos=\"0 0 -9\"><freejoint name=\"ball\"/>"
      "<geom name=\"ball\" type=\"sphere\" size=\"{}\" material=\"ball\"/></body>\n",
      kCm * body::kBallRadius);
  for (const auto& [team, player] : players) out += dogXml(team, player);
  return out + "</worldbody>\n</mujoco>\n";
}

}  // namespace kelpie::broadcast
