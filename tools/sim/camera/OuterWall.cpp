// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/camera/OuterWall.h"

#include <algorithm>
#include <cmath>

namespace kelpie::sim {
namespace {

constexpr double kBeyondCarpet = 15.0;  // cm
constexpr double kApart = 70.0;         // cm between the middles of two sheets
constexpr double kFromCorner = 15.0;    // cm, of a sheet's end
constexpr double kBehindGoal = 75.0;    // cm to either side of a goal's middle hang none
constexpr double kMinPaper = 10.0;      // cm
constexpr double kLargestPaper = 22.0;
constexpr double kInFront = 1.0;  // cm, so that paper hides sheet and sheet hides wall

// What may hang there beside pink; black and white are not allowed.
constexpr std::array<Colour, 6> kOtherPapers{{{82, 121, 167},     // blue
                                              {120, 160, 61},     // yellow
                                              {140, 181, 79},     // orange
                                              {95, 90, 110},      // green
                                              {85, 145, 155},     // purple
                                              {120, 100, 150}}};  // light blue

Colour printed(Colour colour, Random& random) {
  colour.y *= static_cast<float>(random.uniform(0.9, 1.1));
  colour.cr += static_cast<float>(random.uniform(-3.0, 3.0));
  colour.cb += static_cast<float>(random.uniform(-3.0, 3.0));
  return colour;
}

// A paper somewhere in a cell of the sheet.
Paper paperIn(const Paper& cell, bool pink, Random& random) {
  const auto size = [&random](double room) {
    return random.uniform(kMinPaper, std::max(kMinPaper, std::min(room, kLargestPaper)));
  };
  Paper paper;
  const double width = size(cell.right - cell.left);
  const double height = size(cell.high - cell.low);
  paper.left = random.uniform(cell.left, std::max(cell.left, cell.right - width));
  paper.low = random.uniform(cell.low, std::max(cell.low, cell.high - height));
  paper.right = paper.left + width;
  paper.high = paper.low + height;
  paper.pink = pink;
  const auto other = random.index(static_cast<std::uint32_t>(kOtherPapers.size()));
  paper.colour = printed(pink ? colours::kPink : kOtherPapers[other], random);
  return paper;
}

// Two cells, beside or above each other; the first may be pink, the second may be empty.
void stickPapers(WallSheet& sheet, bool pink, Random& random) {
  Paper first{0.0, sheet.width, sheet.low, sheet.high, {}, false};
  Paper second = first;
  if (sheet.width < 2.0 * kMinPaper || random.chance(0.5)) {
    first.high = second.low = 0.5 * (sheet.low + sheet.high);
  } else {
    first.right = second.left = 0.5 * sheet.width;
  }
  if (random.chance(0.5)) std::swap(first, second);
  sheet.papers.push_back(paperIn(first, pink, random));
  if (!pink || random.chance(0.7)) sheet.papers.push_back(paperIn(second, false, random));
}

WallSheet sheetOf(bool pink, double height, Random& random) {
  WallSheet sheet;
  sheet.width = random.chance(0.5) ? 21.0 : random.uniform(21.0, 50.0);
  const double tall = random.uniform(21.0, 29.7);
  sheet.low = random.uniform(0.0, height - tall);
  sheet.high = sheet.low + tall;
  stickPapers(sheet, pink, random);
  return sheet;
}

Point2<Field> placeOn(const OuterWall& wall, std::size_t side, double at) {
  const Point2<Field> from = wall.corners[side];
  const Point2<Field> way = wall.corners[(side + 1) % 4] - from;
  return from + way * (at / way.norm());
}

Point2<Field> middleOf(const OuterWall& wall, const WallSheet& sheet) {
  return placeOn(wall, sheet.side, sheet.at + 0.5 * sheet.width);
}

bool isFree(const OuterWall& wall, const WallSheet& sheet, const body::FieldDescription& field) {
  const Point2<Field> middle = middleOf(wall, sheet);
  if (sheet.side % 2 == 0 && std::fabs(middle.x - 0.5 * field.width) < kBehindGoal) return false;
  return std::all_of(wall.sheets.begin(), wall.sheets.end(), [&](const WallSheet& other) {
    return distance(middle, middleOf(wall, other)) >= kApart;
  });
}

void hang(OuterWall& wall, WallSheet sheet, const body::FieldDescription& field, Random& random) {
  do {
    sheet.side = random.index(4);
    const double length = distance(wall.corners[sheet.side], wall.corners[(sheet.side + 1) % 4]);
    sheet.at = random.uniform(kFromCorner, length - sheet.width - kFromCorner);
  } while (!isFree(wall, sheet, field));
  wall.sheets.push_back(sheet);
}

Quad onWall(const OuterWall& wall, const WallSheet& sheet, const Paper& paper, double inFront) {
  Quad quad = uprightQuad(placeOn(wall, sheet.side, sheet.at + paper.left),
                          placeOn(wall, sheet.side, sheet.at + paper.right),
                          {paper.low, paper.high}, paper.colour);
  quad.depthBias = inFront;
  return quad;
}

}  // namespace

OuterWall outerWall(const body::FieldDescription& field, double slant, std::uint64_t seed) {
  Random random(seed);
  OuterWall wall;
  const double left = -field.sideFringe - kBeyondCarpet;
  const double bottom = -field.endFringe - kBeyondCarpet;
  const double right = field.width - left;
  const double top = field.length - bottom;
  wall.corners = {Point2<Field>{left, bottom}, Point2<Field>{right, bottom},
                  Point2<Field>{right, top}, Point2<Field>{left, top}};
  const double low = -slant;
  for (Point2<Field>& corner : wall.corners)
    corner = corner + Point2<Field>{random.uniform(low, slant), random.uniform(low, slant)};
  const std::uint32_t sheets = 6 + random.index(3);
  const std::uint32_t pinks = 3 + random.index(sheets - 3);
  for (std::uint32_t i = 0; i < sheets; ++i)
    hang(wall, sheetOf(i < pinks, wall.height, random), field, random);
  return wall;
}

std::vector<Point2<Field>> pinkPlaces(const OuterWall& wall) {
  std::vector<Point2<Field>> places;
  for (const WallSheet& sheet : wall.sheets)
    for (const Paper& paper : sheet.papers)
      if (paper.pink)
        places.push_back(placeOn(wall, sheet.side, sheet.at + 0.5 * (paper.left + paper.right)));
  return places;
}

void addWall(Scene& scene, const OuterWall& wall) {
  constexpr std::array<double, 4> kLight{1.0, 0.92, 1.04, 0.88};
  for (std::size_t side = 0; side < 4; ++side) {
    Solid solid;
    solid.quads.push_back(uprightQuad(wall.corners[side], wall.corners[(side + 1) % 4],
                                      {0.0, wall.height}, brighter(colours::kWall, kLight[side])));
    enclose(solid);
    scene.fixtures.push_back(solid);
  }
  for (const WallSheet& sheet : wall.sheets) {
    Solid solid;
    const Paper white{0.0, sheet.width, sheet.low, sheet.high, colours::kWhite, false};
    solid.quads.push_back(onWall(wall, sheet, white, kInFront));
    for (const Paper& paper : sheet.papers)
      solid.quads.push_back(onWall(wall, sheet, paper, 2.0 * kInFront));
    enclose(solid);
    scene.fixtures.push_back(solid);
  }
}

void hideLandmarks(Scene& scene) {
  scene.beacons.clear();
  for (std::size_t i = 0; i < scene.goals; ++i)
    for (Quad& quad : scene.fixtures[i].quads) quad.colour = colours::kWhite;
}

}  // namespace kelpie::sim
