// SPDX-License-Identifier: Apache-2.0
#include "vision/robot/Obstacles.h"

#include <algorithm>
#include <cmath>

#include "robot/body/Camera.h"
#include "robot/core/ScratchVector.h"
#include "vision/Refusal.h"
#include "vision/pixels/FixedPoint.h"

namespace kelpie::vision {
namespace {

// Every 8 px: 2005 scanned every 16 px in full and every 4 px near the horizon (facts-2005 section
// 4.1). The lines are columns of the lattice, whose classes are known already: lines of their own
// cost 138 k instructions a frame, these 54 k.
constexpr int kColumnStep = 4;
constexpr int kMaxLines = 40;        // 264 px, the image's diagonal
constexpr int kMaxRows = 140;        // of the lattice
constexpr int kShadowReach = 20;     // px upwards that tell a shadow, facts-2005 section 4.2
constexpr double kBlack = 16.0;      // Y without light; the ERS-7's darkest pixels have 17
constexpr double kNoColour = 128.0;  // Cr and Cb of grey
constexpr unsigned kCarpetSeen = 8;  // latest samples that make the carpet's colour, 16 to 32 px

struct SampledRow {
  LatticeRow row;
  int height = 1;  // lattice rows that it stands for
};
using SampledRows = ScratchVector<SampledRow, kMaxRows>;

struct CarpetColour {
  double y = 0.0;
  double cr = 0.0;
  double cb = 0.0;
};

// One line on its way up. Carpet must have been seen before, so that the robot's own chest does not
// count.
struct ScanLine {
  std::array<std::uint16_t, kCarpetSeen> carpet{};  // its latest samples of green
  unsigned seen = 0;                                // all of them
  unsigned judgedAt = 0;                            // `seen` when the colour below was made
  CarpetColour colour;
  int kept = 0;
  bool over = false;
};

struct Sample {
  int px = 0;
  int py = 0;
  ColourClass colour = ColourClass::none;
};

struct Search {
  const Scene& scene;
  const ObstacleParams& params;
  VisionCounts& counts;
  SampledRows rows;  // from the top down
  int nearest = 0;   // of them the first that may see the ground near enough
  std::array<ScanLine, kMaxLines> lines{};
};

// Level row of the farthest obstacle's ground. The ray's height per focal length grows along a
// line; at the farthest obstacle's distance it is -height / distance or a little more.
double farthestRow(const Scene& scene, const ObstacleParams& p) {
  const CameraPose& camera = scene.body.camera;
  const auto& a = camera.axes;
  const ImageDirection up = scene.frame.up();
  const double rise = a[6] * up.dx + a[7] * up.dy;
  const double start = a[8] * focalLength(scene);
  const double highest = -camera.position.z / p.maxDistance * focalLength(scene);
  constexpr double kMinRise = 1e-9;  // where the lines run along the horizon every row counts
  return rise > kMinRise ? camera.lens.principalY - (highest - start) / rise : -kFarOutside;
}

// The rows that the blobs were made of, from those that tell a shadow at the farthest obstacle.
void collectRows(Search& s) {
  const Lattice& lattice = s.scene.lattice;
  const double farthest = farthestRow(s.scene, s.params);
  for (int row = 0; row < lattice.rows(); row += lattice.height(row)) {
    const double v = lattice.v(row);
    if (v < farthest - kShadowReach - kLatticeStep) continue;
    if (v < farthest) ++s.nearest;
    s.rows.push_back({lattice.row(row), lattice.height(row)});
  }
}

bool holds(const LatticeRow& row, int column) {
  return column >= row.first && column < row.first + row.count;
}

PixelPoint pointAt(const Scene& scene, const LatticeRow& row, int column) {
  const int along = column - row.first;
  return {(row.x + along * scene.lattice.stepX()) / kLatticeOne,
          (row.y + along * scene.lattice.stepY()) / kLatticeOne};
}

Sample sampleAt(const Scene& scene, const LatticeRow& row, int column) {
  const int along = column - row.first;
  const int px = (row.x + along * scene.lattice.stepX()) >> kLatticeBits;
  const int py = (row.y + along * scene.lattice.stepY()) >> kLatticeBits;
  return {px, py, scene.sampler.classAt(px, py)};
}

// Colour of the carpet around: where the line crossed it last.
const CarpetColour& carpetOf(const Sampler& sampler, ScanLine& line) {
  if (line.judgedAt == line.seen) return line.colour;
  line.judgedAt = line.seen;
  const unsigned count = std::min(line.seen, kCarpetSeen);
  int y = 0;
  int cr = 0;
  int cb = 0;
  for (unsigned i = 0; i < count; ++i) {
    const Yuv c = sampler.corrected(line.carpet[i] % kImageWidth, line.carpet[i] / kImageWidth);
    y += c.y;
    cr += c.cr;
    cb += c.cb;
  }
  const double share = 1.0 / count;
  line.colour = {share * y, share * cr, share * cb};
  return line.colour;
}

// Black and grey shades have one of these classes; so do a dark carpet's pixels.
bool mayBeObstacle(ColourClass c) {
  switch (c) {
    case ColourClass::green:
    case ColourClass::white:
    case ColourClass::orange:
    case ColourClass::yellow:
    case ColourClass::pink: return false;
    default: return true;
  }
}

bool isDark(Yuv value, const CarpetColour& carpet, const ObstacleParams& p) {
  return value.y - kBlack < p.maxOfCarpet * (carpet.y - kBlack);
}

// Nearer to grey than to the carpet, by the way from the one to the other.
bool isGrey(Yuv value, const CarpetColour& carpet) {
  const double toCr = kNoColour - carpet.cr;
  const double toCb = kNoColour - carpet.cb;
  const double along = (value.cr - carpet.cr) * toCr + (value.cb - carpet.cb) * toCb;
  return along > 0.5 * (toCr * toCr + toCb * toCb);
}

bool standsOut(Yuv value, ColourClass c, const CarpetColour& carpet, const ObstacleParams& p) {
  const bool grey = p.greyCounts && c == ColourClass::grey && isGrey(value, carpet);
  return grey || isDark(value, carpet, p);
}

// Carpet by its class, or by likeness where the colour table does not know it well.
bool isCarpet(const Sampler& sampler, const Sample& at, const CarpetColour& carpet,
              const ObstacleParams& p) {
  if (at.colour == ColourClass::green) return true;
  if (at.colour != ColourClass::none && at.colour != ColourClass::grey &&
      at.colour != ColourClass::black)
    return false;
  const Yuv value = sampler.corrected(at.px, at.py);
  return !isDark(value, carpet, p) && !isGrey(value, carpet);
}

// Whether carpet or ball go on in the row's column, up to the reach of a shadow.
bool isShadow(const Search& s, int from, int column, const CarpetColour& carpet) {
  double green = 0.0;  // px
  double orange = 0.0;
  int way = kLatticeStep;
  for (int i = from - 1; i >= 0 && way <= kShadowReach; --i) {
    const SampledRow& row = s.rows[static_cast<std::size_t>(i)];
    if (!holds(row.row, column)) break;
    const Sample at = sampleAt(s.scene, row.row, column);
    const int length = kLatticeStep * row.height;
    way += length;
    if (isCarpet(s.scene.sampler, at, carpet, s.params)) green += length;
    if (at.colour == ColourClass::orange) orange += length;
    if (green > s.params.maxGreenAbove || orange > s.params.maxBallAbove) return true;
  }
  return false;
}

// Whether what stands out lies on the carpet; counts why not. The carpet is convex: a line that
// has left it does not come back.
bool onCarpet(Search& s, ScanLine& line, int row, int column, PixelPoint at) {
  if (belowFieldEdge(s.scene, at) < 0.0) {
    line.over = true;
    refuse(s.counts, Refusal::obstacleAboveFieldEdge);
    return false;
  }
  if (isShadow(s, row, column, line.colour)) {
    refuse(s.counts, Refusal::obstacleGreenAbove);
    return false;
  }
  return true;
}

// Keeps one sample: the line's first as a point, every one in the box ahead in the count.
void keep(Search& s, ScanLine& line, int height, PixelPoint at, Obstacles& found) {
  const auto place = body::groundPoint(s.scene.body.camera, at);
  if (!place || place->norm() > s.params.maxDistance) {
    line.over = true;
    return;
  }
  const int max = static_cast<int>(s.params.maxPerLine);
  const int counted = std::min(height, max - line.kept);
  if (line.kept == 0) found.points.push_back({*place, at});
  line.kept += counted;
  line.over = line.kept >= max;
  const bool ahead =
      std::fabs(place->x) <= s.params.aheadSide && place->y > 0.0 && place->y <= s.params.aheadFar;
  if (ahead) found.ahead = static_cast<std::uint16_t>(found.ahead + counted);
}

void consider(Search& s, int row, int column, const Sample& sample, Obstacles& found) {
  const SampledRow& sampled = s.rows[static_cast<std::size_t>(row)];
  ScanLine& line = s.lines[static_cast<std::size_t>(column / kColumnStep)];
  const CarpetColour& carpet = carpetOf(s.scene.sampler, line);
  const Yuv value = s.scene.sampler.corrected(sample.px, sample.py);
  if (!standsOut(value, sample.colour, carpet, s.params)) return;
  const PixelPoint at = pointAt(s.scene, sampled.row, column);
  if (onCarpet(s, line, row, column, at)) keep(s, line, sampled.height, at, found);
}

// The samples of one row that lie on lines. Each frame has a thousand of them.
void walkRow(Search& s, int index, Obstacles& found) {
  const LatticeRow row = s.rows[static_cast<std::size_t>(index)].row;
  const std::int32_t stepX = s.scene.lattice.stepX();
  const std::int32_t stepY = s.scene.lattice.stepY();
  const int first = (row.first + kColumnStep - 1) & -kColumnStep;
  const int end = std::min(row.first + row.count, kColumnStep * kMaxLines);
  std::int32_t x = row.x + (first - row.first) * stepX;
  std::int32_t y = row.y + (first - row.first) * stepY;
  ScanLine* line = &s.lines[static_cast<std::size_t>(first) / kColumnStep];
  for (int column = first; column < end; column += kColumnStep, ++line) {
    const Sample at{x >> kLatticeBits, y >> kLatticeBits,
                    s.scene.sampler.classAt(x >> kLatticeBits, y >> kLatticeBits)};
    x += kColumnStep * stepX;
    y += kColumnStep * stepY;
    if (at.colour == ColourClass::green) {
      line->carpet[line->seen++ % kCarpetSeen] =
          static_cast<std::uint16_t>(Image::at(at.px, at.py));
    } else if (line->seen > 0 && !line->over && mayBeObstacle(at.colour)) {
      consider(s, index, column, at, found);
    }
  }
}

}  // namespace

Obstacles findObstacles(const Scene& scene, const ObstacleParams& params, VisionCounts& counts) {
  Search search{scene, params, counts, {}};
  collectRows(search);
  Obstacles found;
  for (int row = static_cast<int>(search.rows.size()) - 1; row >= search.nearest; --row)
    walkRow(search, row, found);
  return found;
}

}  // namespace kelpie::vision
