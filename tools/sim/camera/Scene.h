// SPDX-License-Identifier: Apache-2.0
// What the camera can see, as flat shapes, upright cylinders and spheres in the field frame. The
// field, goals, beacons, room and spectators are built once per match; ball, robots and markers are
// set again for each image. Shapes may touch but must not cut through each other: the camera sorts
// them by depth.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "robot/body/FieldDescription.h"
#include "robot/core/fields/Fields.h"
#include "robot/core/types/Geometry.h"
#include "tools/sim/camera/Colours.h"

namespace kelpie::sim {

using FieldPoint3 = Point3<Field>;
// At that share of the straight way from one to the other.
template <class Frame>
Point3<Frame> between(const Point3<Frame>& a, const Point3<Frame>& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z)};
}

// A convex four-cornered flat shape. `lit` is its brightness, `slope` the change of brightness from
// its lowest to its highest corner.
struct Quad {
  std::array<FieldPoint3, 4> corner{};
  Colour colour;
  double lit = 1.0;
  double slope = 0.0;
  double depthBias = 0.0;  // cm nearer than it is, for a patch on another shape
  bool oneSided = false;   // seen only from the side its normal points to
  FieldPoint3 normal;
};

// Shapes that belong together, inside one sphere.
struct Solid {
  FieldPoint3 centre;
  double radius = 0.0;
  std::vector<Quad> quads;
};

struct Cylinder {
  Point2<Field> centre;
  double radius = 5.0;
  std::array<double, 5> height{};  // borders of the bands, rising
  std::array<Colour, 4> band{};
};

struct Sphere {
  FieldPoint3 centre;
  double radius = body::kBallRadius;
  Colour colour = colours::kOrange;
};

// Spheres in a row, so close that they look like one convex thing.
struct Limb {
  std::array<Sphere, 7> part;
};

// A disc on the ground. `darkens` 0 = painted; otherwise what is below it loses that share of
// light.
struct Disc {
  Point2<Field> centre;
  double radius = 0.0;
  Colour colour;
  double darkens = 0.0;
};

// How a robot's uniform has aged: drawn for robots of randomised worlds.
struct Uniform {
  double fade = 0.0;    // share of the way from the team's colour to grey
  double scuffs = 0.0;  // of the shell's white or of dirt, on each upright face, mean number
  double gloss = 1.0;   // width and frequency of ShineParams, times this

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("fade", &Uniform::fade, "", 0, 1),
                     field("scuffs", &Uniform::scuffs, "", 0, 20),
                     field("gloss", &Uniform::gloss, "", 0, 5));
  }
};

// How another robot looks: place, size of the body by its stance, team.
struct RobotLook {
  Pose2 pose;
  double shoulderHeight = 10.0;
  TeamColour team = TeamColour::blue;
  std::uint64_t shine = 0;  // seed of where its uniform shines
  Uniform uniform = {};
};

// The ERS-7 is white and glossy: a red uniform's edges come out yellow and pink in small places,
// and were taken for beacons (checklist B-2.2.1.1). How wide, long and frequent those places are is
// not stated: [chosen].
struct ShineParams {
  bool on = true;
  double width = 0.6;      // cm, mean
  double length = 1.5;     // cm, mean
  double share = 0.4;      // of an edge
  double strength = 0.85;  // of the way from the uniform's red to full yellow or pink

  template <int = 0>
  static constexpr auto fields() {
    using P = ShineParams;
    return fieldList(field("on", &P::on), field("width", &P::width, "cm", 0, 4),
                     field("length", &P::length, "cm", 0.1, 20),
                     field("share", &P::share, "", 0, 1),
                     field("strength", &P::strength, "", 0, 1));
  }
};

// A light of another colour at one side of the field: what is nearer to it is brighter and takes on
// its colour, linearly across the field.
struct SecondLight {
  Angle side;             // from the field's middle towards it
  double strength = 0.0;  // share brighter at its side of the field, and darker at the other
  double warmth = 0.0;    // levels of Cr more and Cb less at its side, of something white

  bool on() const { return strength != 0.0 || warmth != 0.0; }
  template <int = 0>
  static constexpr auto fields() {
    using P = SecondLight;
    return fieldList(field("side", &P::side, "rad", -180, 180),
                     field("strength", &P::strength, "", 0, 1),
                     field("warmth", &P::warmth, "levels", -40, 40));
  }
};

// Strips of carpet side by side along the field whose pile lies to and fro.
struct Stripes {
  double width = 100.0;   // cm
  double contrast = 0.0;  // share brighter and darker by turns

  bool on() const { return contrast != 0.0; }
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("width", &Stripes::width, "cm", 10, 1000),
                     field("contrast", &Stripes::contrast, "", 0, 1));
  }
};

// How a venue differs from the nominal one.
struct Venue {
  double tapeWidth = 0.0;   // cm, of all lines; 0: the field's own
  double carpet = 1.0;      // brightness over the nominal one
  double brightness = 1.0;  // of all light, over the nominal one: for cameras (RobotCamera)
  Stripes stripes;
  SecondLight light;
  std::uint64_t room = 0;  // seed of walls, floor, boards and tables; 0: plain walls

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("tapeWidth", &Venue::tapeWidth, "cm", 0, 20),
                     field("carpet", &Venue::carpet, "", 0.1, 3),
                     field("brightness", &Venue::brightness, "", 0.1, 3),
                     field("stripes", &Venue::stripes), field("light", &Venue::light),
                     field("room", &Venue::room));
  }
};

struct Scene {
  Colour ceiling = colours::kCeiling;
  Colour floor = colours::kFloor;
  std::array<Point2<Field>, 2> carpet{};  // opposite corners
  Colour green = colours::kGreen;
  Stripes stripes;
  SecondLight light;
  Point2<Field> towardsLight{1.0, 0.0};  // unit vector of its side
  std::vector<Quad> lines;
  std::vector<Disc> circle;  // painted in order, under the lines' intersections
  std::vector<Solid> fixtures;
  std::size_t goals = 0;  // the first so many fixtures are goals
  std::vector<Cylinder> beacons;
  // Set for each image:
  std::vector<Disc> markers;
  std::vector<Sphere> balls;
  std::vector<Solid> robots;
  std::vector<Limb> own;  // of the robot that looks (BodyShape.h)
};

// Carpet, lines, goals, beacons and the room around them. With `crowdSeed` not 0 people and
// coloured things stand around the field.
Scene fieldScene(const body::FieldDescription& field, std::uint64_t crowdSeed,
                 const Venue& venue = {});

// Plain walls, or those of a seeded room with boards and tables
// (tools/sim/camera/Surroundings.cpp).
void addSurroundings(Scene& scene, const body::FieldDescription& field, std::uint64_t seed);
// The second light at a place: -1 at the far side of the field, 1 at its own.
double lightAt(const Scene& scene, Point2<Field> place);

// Seeded people and coloured things 30..150 cm beyond the carpet (tools/sim/camera/Crowd.cpp).
void addCrowd(Scene& scene, std::uint64_t seed);

// Replaces what moves. A ball's shadow comes with it.
void setBall(Scene& scene, Point2<Field> position);
void setRobots(Scene& scene, const std::vector<RobotLook>& robots, const ShineParams& shine = {});

// Upright rectangle from a to b, from `low` to `high` above the ground.
Quad uprightQuad(Point2<Field> a, Point2<Field> b, std::array<double, 2> lowHigh, Colour colour);
Quad groundQuad(Point2<Field> low, Point2<Field> high, Colour colour);
// The centre and radius of a sphere around all its quads.
void enclose(Solid& solid);

}  // namespace kelpie::sim
