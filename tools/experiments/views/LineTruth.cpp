// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/views/LineTruth.h"

#include <algorithm>
#include <cmath>

#include "vision/line/BrightSegments.h"

namespace kelpie::experiments {
namespace {

using sim::colours::kGreen;

// Y tells the carpet, Cr the paint, Cb the border; mixtures are linear in the covered share.
constexpr float kMarked = 255.0F;
constexpr sim::Colour kPaint{kGreen.y, kMarked, kGreen.cb};
constexpr sim::Colour kBorder{kGreen.y, kGreen.cr, kMarked};
constexpr sim::Colour kElse{0.0F, kGreen.cr, kGreen.cb};

bool isBorder(const sim::Quad& quad, const body::FieldDescription& field) {
  return field.borderWidth > 0.0 && quad.corner[0].z == 0.0 &&
         quad.corner[2].z == field.borderWidth && quad.corner[3].z == field.borderWidth;
}

sim::Scene marked(sim::Scene scene, const body::FieldDescription& field) {
  const float green = scene.green.y;
  scene.ceiling = scene.floor = kElse;
  scene.green = kGreen;
  for (auto& line : scene.lines) line.colour = kPaint;
  for (auto& disc : scene.circle) disc.colour = disc.colour.y == green ? kGreen : kPaint;
  for (auto* group : {&scene.fixtures, &scene.robots})
    for (auto& solid : *group)
      for (auto& quad : solid.quads) quad.colour = isBorder(quad, field) ? kBorder : kElse;
  for (auto& beacon : scene.beacons) beacon.band.fill(kElse);
  for (auto& ball : scene.balls) ball.colour = kElse;
  return scene;
}

double share(std::uint8_t value, float none, float all) {
  const float covered = (static_cast<float>(value) - none) / (all - none);
  return static_cast<double>(std::clamp(covered, 0.0F, 1.0F));
}

bool inside(int px, int py) { return px >= 0 && px < kImageWidth && py >= 0 && py < kImageHeight; }

double offSegment(const body::FieldLine& line, Point2<Field> p) {
  const Point2<Field> along = line.end - line.start;
  const Point2<Field> d = p - line.start;
  const double square = along.x * along.x + along.y * along.y;
  const double t = std::clamp((d.x * along.x + d.y * along.y) / square, 0.0, 1.0);
  return distance(p, line.start + along * t);
}

}  // namespace

LineTruth::LineTruth(const body::FieldDescription& field)
    : field_(field), camera_(sim::idealCamera(), {}), image_(std::make_unique<Image>()) {}

void LineTruth::see(const View& view) {
  Random unused(1);  // an ideal camera adds no noise
  camera_.render(marked(view.scene, field_), view.columns, unused, *image_);
}

double LineTruth::paint(int px, int py) const {
  return inside(px, py) ? share(image_->cr[Image::at(px, py)], kGreen.cr, kMarked) : 0.0;
}

double LineTruth::border(int px, int py) const {
  return inside(px, py) ? share(image_->cb[Image::at(px, py)], kGreen.cb, kMarked) : 0.0;
}

double LineTruth::carpet(int px, int py) const {
  if (!inside(px, py) || paint(px, py) > 0.1 || border(px, py) > 0.1) return 0.0;
  // The ball's shadow takes a third of the light.
  return share(image_->y[Image::at(px, py)], 0.0F, 0.65F * kGreen.y);
}

double LineTruth::paintNear(PixelPoint pixel) const {
  const int px = static_cast<int>(std::floor(pixel.x));
  const int py = static_cast<int>(std::floor(pixel.y));
  double largest = 0.0;
  for (int i = 0; i < 9; ++i) largest = std::max(largest, paint(px + i % 3 - 1, py + i / 3 - 1));
  return largest;
}

double LineTruth::offLine(Point2<Field> place) const {
  const Point2<Field> centre{0.5 * field_.width, 0.5 * field_.length};
  const double radius = 0.5 * (field_.circleDiameter - field_.lineWidth);
  double nearest = std::fabs(distance(place, centre) - radius);
  for (const auto& line : field_.lines) nearest = std::min(nearest, offSegment(line, place));
  return nearest;
}

double LineTruth::offBorder(Point2<Field> place) const {
  double nearest = 1e9;
  for (const auto& piece : body::borderOf(field_))
    nearest = std::min(nearest, offSegment(piece.foot, place));
  return nearest;
}

namespace {

constexpr double kVisiblePaint = 0.5;  // of the brightest pixel
constexpr double kSomePaint = 0.1;

void addCrossings(const LineTruth& truth, const vision::GridLine& gridLine,
                  std::vector<Crossing>& all) {
  const auto paint = [&](int i) { return truth.paint(gridLine.column(i), gridLine.row(i)); };
  const auto carpet = [&](int i) {
    return truth.carpet(gridLine.column(i), gridLine.row(i)) > 0.8;
  };
  for (int i = 1; i < gridLine.length; ++i) {
    if (paint(i) < kSomePaint || paint(i - 1) >= kSomePaint) continue;
    const int first = i;
    double largest = 0.0;
    for (; i < gridLine.length && paint(i) >= kSomePaint; ++i)
      largest = std::max(largest, paint(i));
    if (largest < kVisiblePaint || i + 1 >= gridLine.length || first < 2) continue;
    if (!carpet(first - 1) || !carpet(first - 2) || !carpet(i) || !carpet(i + 1)) continue;
    all.push_back(
        {gridLine.at(0.5 * (first + i - 1)), gridLine.dy != 0, static_cast<double>(i - first)});
  }
}

}  // namespace

std::vector<Crossing> crossings(const LineTruth& truth) {
  std::vector<Crossing> all;
  for (int px = vision::kGridLeft; px < vision::kUsableRight; px += vision::kGridSpacing)
    addCrossings(truth, vision::gridLineUp(px, vision::kUsableTop), all);
  for (int py = vision::kGridTop; py < vision::kUsableBottom; py += vision::kGridSpacing)
    addCrossings(truth, vision::gridLineRight(py), all);
  return all;
}

}  // namespace kelpie::experiments
