// SPDX-License-Identifier: Apache-2.0
// Seeded people and coloured things around the field: the reason why vision needs its checks.
#include <array>

#include "robot/core/Random.h"
#include "tools/sim/camera/Scene.h"

namespace kelpie::sim {
namespace {

constexpr int kPeople = 16;
constexpr int kThings = 9;

constexpr std::array<Colour, 10> kClothes{{{140, 178, 84},   // orange shirt
                                           {80, 121, 165},   // blue shirt
                                           {60, 122, 150},   // jeans
                                           {118, 155, 70},   // yellow shirt
                                           {112, 180, 122},  // pink shirt
                                           {90, 168, 110},   // red shirt
                                           {185, 126, 128},
                                           {40, 127, 130},
                                           {95, 112, 116},
                                           {120, 128, 128}}};

Colour dressed(Random& random) {
  Colour c = kClothes[random.index(static_cast<std::uint32_t>(kClothes.size()))];
  c.y *= static_cast<float>(random.uniform(0.8, 1.2));
  c.cr += static_cast<float>(random.uniform(-5.0, 5.0));
  c.cb += static_cast<float>(random.uniform(-5.0, 5.0));
  return c;
}

struct Standing {
  Point2<Field> place;
  Point2<Field> across;  // unit vector along the carpet's edge
};

Standing beyondCarpet(const Scene& scene, Random& random) {
  const Point2<Field> low = scene.carpet[0];
  const Point2<Field> high = scene.carpet[1];
  const double away = random.uniform(30.0, 150.0);
  const double x = random.uniform(low.x, high.x);
  const double y = random.uniform(low.y, high.y);
  switch (random.index(4)) {
    case 0: return {{x, low.y - away}, {1, 0}};
    case 1: return {{x, high.y + away}, {1, 0}};
    case 2: return {{low.x - away, y}, {0, 1}};
    default: return {{high.x + away, y}, {0, 1}};
  }
}

void addBand(Solid& solid, const Standing& at, double half, std::array<double, 2> lowHigh,
             Colour colour) {
  solid.quads.push_back(
      uprightQuad(at.place - at.across * half, at.place + at.across * half, lowHigh, colour));
  solid.quads.back().slope = 0.1;
}

Solid person(const Scene& scene, Random& random) {
  const Standing at = beyondCarpet(scene, random);
  const double scale = random.uniform(0.9, 1.1);
  const double half = random.uniform(16.0, 24.0);
  const Colour trousers = dressed(random);
  Solid solid;
  const double gap = random.uniform(1.0, 6.0);
  for (const double side : {-1.0, 1.0}) {
    const Standing leg{at.place + at.across * (side * (gap + half / 2.0) / 1.2), at.across};
    addBand(solid, leg, half / 2.6, {0.0, 9.0}, colours::kBlack);
    addBand(solid, leg, half / 2.6, {9.0, 85.0 * scale}, trousers);
  }
  addBand(solid, at, half, {85.0 * scale, 145.0 * scale}, dressed(random));
  addBand(solid, at, 9.0, {147.0 * scale, 166.0 * scale}, colours::kSkin);
  addBand(solid, at, 9.5, {166.0 * scale, 174.0 * scale}, colours::kBlack);
  enclose(solid);
  return solid;
}

Solid thing(const Scene& scene, Random& random) {
  const Standing at = beyondCarpet(scene, random);
  Solid solid;
  const double low = random.chance(0.7) ? 0.0 : random.uniform(10.0, 60.0);
  addBand(solid, at, random.uniform(5.0, 30.0), {low, low + random.uniform(8.0, 60.0)},
          dressed(random));
  enclose(solid);
  return solid;
}

}  // namespace

void addCrowd(Scene& scene, std::uint64_t seed) {
  Random random(seed);
  for (int i = 0; i < kPeople; ++i) scene.fixtures.push_back(person(scene, random));
  for (int i = 0; i < kThings; ++i) scene.fixtures.push_back(thing(scene, random));
}

}  // namespace kelpie::sim
