// SPDX-License-Identifier: Apache-2.0
// How a robot looks to another one: boxes for trunk, head and legs, coloured patches for the team,
// and along a red patch's edges what its gloss makes of it.
#include <algorithm>
#include <cmath>

#include "robot/core/Random.h"
#include "tools/sim/camera/Scene.h"

namespace kelpie::sim {
namespace {

// cm that a patch is drawn nearer than it is, to cover the shell and the patch that it lies on.
constexpr double kUniformBias = 2.0;
constexpr double kScuffBias = 2.6;
constexpr double kShineBias = 3.2;
constexpr std::uint64_t kWearStream = 0x77656172;

// A box in the robot frame.
struct Box {
  Point3<Robot> low;
  Point3<Robot> high;
};

// Where it stands; its heading's sine and cosine serve some hundred corners.
struct Stand {
  Point2<Field> position;
  maths::SinCos heading;
};

FieldPoint3 onField(const Stand& stand, Point3<Robot> p) {
  const maths::SinCos& h = stand.heading;
  return {stand.position.x + h.sin * p.x + h.cos * p.y,
          stand.position.y - h.cos * p.x + h.sin * p.y, p.z};
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

void addQuad(Solid& solid, const Stand& stand, const Face& face, Colour colour, double bias) {
  Quad quad;
  for (std::size_t i = 0; i < 4; ++i) quad.corner[i] = onField(stand, face.corner[i]);
  const FieldPoint3 tip = onField(stand, face.normal);
  quad.normal = {tip.x - stand.position.x, tip.y - stand.position.y, face.normal.z};
  quad.colour = colour;
  quad.lit = face.lit;
  quad.slope = 0.1;
  quad.oneSided = true;
  quad.depthBias = bias;
  solid.quads.push_back(quad);
}

void addBox(Solid& solid, const Stand& stand, const Box& box, Colour colour, double bias) {
  for (const Face& face : faces(box)) addQuad(solid, stand, face, colour, bias);
}

Point3<Robot> at(Point3<Robot> from, Point3<Robot> a, double s, Point3<Robot> b, double t) {
  return {from.x + s * a.x + t * b.x, from.y + s * a.y + t * b.y, from.z + s * a.z + t * b.z};
}

Colour mixed(Colour a, Colour b, double share) {
  const auto t = static_cast<float>(share);
  return {a.y + t * (b.y - a.y), a.cr + t * (b.cr - a.cr), a.cb + t * (b.cb - a.cb)};
}

// A row of yellow and pink along the edge from corner `first` of a red face, inside it.
void addShine(Solid& solid, const RobotLook& look, const Stand& stand, const Face& face,
              std::size_t first, const ShineParams& params, Random& random) {
  const double gloss = look.uniform.gloss;
  const Point3<Robot> start = face.corner[first];
  const Point3<Robot> edge = face.corner[(first + 1) % 4] - start;
  const Point3<Robot> inward = face.corner[(first + 3) % 4] - start;
  // Edges and sides are square to each other and to the axes: one term of each sum is not 0.
  const double length = std::fabs(edge.x + edge.y + edge.z);
  const double depth = std::fabs(inward.x + inward.y + inward.z);
  for (double done = 0.0; done < length;) {
    const double next = std::min(length, done + params.length * random.uniform(0.5, 1.5));
    const double width = std::min(depth, gloss * params.width * random.uniform(0.5, 1.5)) / depth;
    const Colour gleam = random.chance(0.5) ? colours::kYellow : colours::kPink;
    const double from = done / length;
    const double to = next / length;
    done = next;
    if (!random.chance(gloss * params.share)) continue;
    const Face patch{{at(start, edge, from, inward, 0.0), at(start, edge, to, inward, 0.0),
                      at(start, edge, to, inward, width), at(start, edge, from, inward, width)},
                     face.normal,
                     face.lit};
    addQuad(solid, stand, patch, mixed(colours::kRobotRed, gleam, params.strength), kShineBias);
  }
}

// Places where the colour has come off, and dirt, inside an upright face.
void addScuffs(Solid& solid, const RobotLook& look, const Stand& stand, const Face& face,
               Random& random) {
  const Point3<Robot> start = face.corner[0];
  const Point3<Robot> edge = face.corner[1] - start;
  const Point3<Robot> inward = face.corner[3] - start;
  for (double left = look.uniform.scuffs * random.uniform(0.0, 2.0); left > 0.5; left -= 1.0) {
    const double wide = random.uniform(0.1, 0.35);
    const double high = random.uniform(0.15, 0.5);
    const double s = random.uniform(0.0, 1.0 - wide);
    const double t = random.uniform(0.0, 1.0 - high);
    const Face patch{
        {at(start, edge, s, inward, t), at(start, edge, s + wide, inward, t),
         at(start, edge, s + wide, inward, t + high), at(start, edge, s, inward, t + high)},
        face.normal,
        face.lit};
    const Colour colour = random.chance(0.5) ? colours::kShell : colours::kGrey;
    addQuad(solid, stand, patch, colour, kScuffBias);
  }
}

// The team's colour on a box, glossy at its upright faces' edges when it is red.
void addUniform(Solid& solid, const RobotLook& look, const Stand& stand, const Box& box,
                const ShineParams& shine, Random& random) {
  const bool red = look.team == TeamColour::red;
  const Colour team = red ? colours::kRobotRed : colours::kRobotBlue;
  const Colour colour = mixed(team, colours::kGrey, look.uniform.fade);
  addBox(solid, stand, box, colour, kUniformBias);
  if (look.uniform.scuffs > 0.0) {
    Random wear(look.shine ^ kWearStream);
    for (const Face& face : faces(box))
      if (face.normal.z <= 0.0) addScuffs(solid, look, stand, face, wear);
  }
  if (!red || !shine.on) return;
  for (const Face& face : faces(box)) {
    if (face.normal.z > 0.0) continue;
    for (std::size_t edge = 0; edge < 4; ++edge)
      addShine(solid, look, stand, face, edge, shine, random);
  }
}

// Sizes of an ERS-7 (length 24 cm, trunk 13 cm wide at the legs); h is the shoulder's height. Into
// the solid of an image before, whose room for quads is kept.
void setRobot(const RobotLook& look, const ShineParams& shine, Solid& solid) {
  const double h = look.shoulderHeight;
  const Colour shell = colours::kShell;
  const Stand stand{look.pose.position, look.pose.heading.sinCos()};
  solid.quads.clear();
  addBox(solid, stand, {{-4.0, -15.0, h - 3.5}, {4.0, 1.5, h + 2.5}}, shell, 0.0);
  addBox(solid, stand, {{-3.5, 2.0, h + 5.0}, {3.5, 11.0, h + 11.0}}, shell, 0.0);
  addBox(solid, stand, {{-2.5, 11.0, h + 5.5}, {2.5, 13.0, h + 9.0}}, colours::kBlack, 0.0);
  addBox(solid, stand, {{-2.0, -1.5, h + 2.5}, {2.0, 1.5, h + 6.0}}, colours::kGrey, 0.0);
  for (const double side : {-5.6, 5.6}) {
    for (const double along : {0.5, -12.5}) {
      addBox(solid, stand,
             {{side - 1.6, along - 2.2, h * 0.45}, {side + 1.6, along + 2.2, h + 2.0}}, shell, 0.0);
      addBox(solid, stand, {{side - 1.4, along - 2.5, 0.0}, {side + 1.4, along + 1.5, h * 0.45}},
             colours::kGrey, 0.0);
    }
  }
  // Team patches: back, both flanks and the head's sides.
  Random random(look.shine);
  addUniform(solid, look, stand, {{-4.3, -10.5, h - 1.5}, {4.3, -4.0, h + 2.8}}, shine, random);
  addUniform(solid, look, stand, {{-3.8, 3.5, h + 7.0}, {3.8, 7.0, h + 11.3}}, shine, random);
  enclose(solid);
}

}  // namespace

void setRobots(Scene& scene, const std::vector<RobotLook>& robots, const ShineParams& shine) {
  scene.robots.resize(robots.size());
  for (std::size_t i = 0; i < robots.size(); ++i) setRobot(robots[i], shine, scene.robots[i]);
}

}  // namespace kelpie::sim
