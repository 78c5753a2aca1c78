// SPDX-License-Identifier: Apache-2.0
// The room round the field: plain walls, or seeded ones at other distances and in other colours,
// with boards and tables between the spectators and the wall. All of it is [chosen]: no hall was
// measured.
#include <algorithm>
#include <array>

#include "robot/core/Random.h"
#include "tools/sim/camera/Scene.h"

namespace kelpie::sim {
namespace {

constexpr double kSurroundingsMargin = 320.0;  // cm from the field to the walls of the room
constexpr double kWallHeight = 420.0;
constexpr std::array<double, 4> kLight{1.0, 0.9, 1.05, 0.85};
constexpr double kNearestWall = 240.0;  // cm from the field; tables are up to 230
constexpr double kFarthestWall = 420.0;
constexpr int kMaxTables = 8;
// cm beyond the carpet: where the farthest spectator is at 150, and clear of where robots walk.
constexpr double kBoardsBeyond = 62.0;
constexpr double kNearestTable = 152.0;
constexpr double kFarthestTable = 195.0;

// Paint, wood, brick and curtain.
constexpr std::array<Colour, 6> kWalls{{{150, 129, 124},
                                        {178, 127, 127},
                                        {120, 130, 124},
                                        {118, 141, 112},
                                        {98, 146, 116},
                                        {60, 125, 136}}};
constexpr std::array<Colour, 4> kFloors{
    {{96, 131, 122}, {64, 127, 129}, {122, 134, 119}, {78, 125, 134}}};
// Bare wood, white, grey, blue and dark cloth.
constexpr std::array<Colour, 5> kTables{
    {{122, 142, 108}, {182, 126, 128}, {118, 128, 128}, {72, 122, 150}, {42, 130, 127}}};

template <std::size_t N>
Colour drawn(const std::array<Colour, N>& colours, Random& random) {
  return brighter(colours[random.index(static_cast<std::uint32_t>(N))], random.uniform(0.85, 1.15));
}

// One of the four sides of a rectangle round the field, from a to b.
struct Side {
  Point2<Field> a;
  Point2<Field> b;
};

std::array<Side, 4> sidesOf(Point2<Field> low, Point2<Field> high) {
  const Point2<Field> right{high.x, low.y};
  const Point2<Field> left{low.x, high.y};
  return {{{low, right}, {right, high}, {high, left}, {left, low}}};
}

std::array<Side, 4> beyondCarpet(const Scene& scene, double away) {
  return sidesOf({scene.carpet[0].x - away, scene.carpet[0].y - away},
                 {scene.carpet[1].x + away, scene.carpet[1].y + away});
}

void addUpright(Scene& scene, const Side& side, std::array<double, 2> lowHigh, Colour colour,
                double slope) {
  Solid solid;
  solid.quads.push_back(uprightQuad(side.a, side.b, lowHigh, colour));
  solid.quads.back().slope = slope;
  enclose(solid);
  scene.fixtures.push_back(solid);
}

// Each wall of its own colour; the lower part of one may be of another, as a dado.
void addWalls(Scene& scene, const std::array<Side, 4>& sides, Random& random) {
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Colour colour = brighter(drawn(kWalls, random), kLight[i]);
    const double dado = random.chance(0.4) ? random.uniform(70.0, 130.0) : 0.0;
    if (dado > 0.0) addUpright(scene, sides[i], {0.0, dado}, drawn(kWalls, random), 0.1);
    addUpright(scene, sides[i], {dado, kWallHeight}, colour, 0.15);
  }
}

// Low boards along some of the sides.
void addBoards(Scene& scene, Random& random) {
  const Colour colour = drawn(kTables, random);
  for (const Side& side : beyondCarpet(scene, kBoardsBeyond)) {
    if (!random.chance(0.3)) continue;
    addUpright(scene, side, {0.0, random.uniform(15.0, 45.0)}, colour, 0.08);
  }
}

Side part(const Side& side, double from, double to) {
  const Point2<Field> way = side.b - side.a;
  return {side.a + way * from, side.a + way * to};
}

// A table's front: an apron or a cloth to the floor, legs, and a screen or two on it.
void addTable(Scene& scene, Random& random) {
  const double beyond = random.uniform(kNearestTable, kFarthestTable);
  const Side side = beyondCarpet(scene, beyond)[random.index(4)];
  const double length = (side.b - side.a).norm();
  const double wide = random.uniform(120.0, 180.0) / length;
  const double at = random.uniform(0.1, 0.9 - wide);
  const bool cloth = random.chance(0.4);
  const double foot = cloth ? 4.0 : 66.0;
  const Colour colour = drawn(kTables, random);
  Solid solid;
  const auto add = [&](const Side& s, std::array<double, 2> lowHigh, Colour c) {
    solid.quads.push_back(uprightQuad(s.a, s.b, lowHigh, c));
    solid.quads.back().slope = 0.1;
  };
  add(part(side, at, at + wide), {foot, 74.0}, colour);
  if (!cloth)
    for (const double leg : {at + 0.02 * wide, at + 0.94 * wide})
      add(part(side, leg, leg + 0.04 * wide), {0.0, foot}, colours::kGrey);
  for (double s = 0.1; s < 0.8; s += 0.35)
    if (random.chance(0.6))
      add(part(side, at + s * wide, at + (s + 0.25) * wide), {76.0, random.uniform(96.0, 116.0)},
          brighter(colours::kBlack, random.uniform(1.0, 3.0)));
  enclose(solid);
  scene.fixtures.push_back(solid);
}

std::array<Side, 4> wallsAt(const body::FieldDescription& field, double margin) {
  return sidesOf({-margin, -margin}, {field.width + margin, field.length + margin});
}

}  // namespace

void addSurroundings(Scene& scene, const body::FieldDescription& field, std::uint64_t seed) {
  if (seed == 0) {
    const std::array<Side, 4> sides = wallsAt(field, kSurroundingsMargin);
    for (std::size_t i = 0; i < sides.size(); ++i)
      addUpright(scene, sides[i], {0.0, kWallHeight}, brighter(colours::kWall, kLight[i]), 0.15);
    return;
  }
  Random random(seed);
  scene.floor = drawn(kFloors, random);
  scene.ceiling = brighter(scene.ceiling, random.uniform(0.6, 1.1));
  addWalls(scene, wallsAt(field, random.uniform(kNearestWall, kFarthestWall)), random);
  addBoards(scene, random);
  const auto tables = static_cast<int>(random.index(kMaxTables + 1));
  for (int i = 0; i < tables; ++i) addTable(scene, random);
}

}  // namespace kelpie::sim
