// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/show/BodyDrawing.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace kelpie::cli {
namespace {

using sim::BodyPart;
using sim::Shape;

// cm of the window, from the robot's place.
constexpr double kBehind = -35.0;
constexpr double kAhead = 50.0;
constexpr double kLateral = 36.0;
constexpr double kTop = 33.0;
constexpr double kBelow = -3.0;
constexpr double kGrid = 10.0;
constexpr int kRound = 24;  // corners of a circle
constexpr int kShift = 4;   // bits of a pixel's parts
const cv::Scalar kWall(232, 228, 222);
const cv::Scalar kCarpet(96, 140, 84);
const cv::Scalar kCarpetLine(112, 156, 100);
const cv::Scalar kEdge(40, 36, 32);

enum class View { side, above };

// To the right and down on the picture, and how near to who looks: cm.
struct Seen {
  double right;
  double down;
  double near;
};

Seen seen(const Point3<Field>& p, const Pose2& origin, View view) {
  const Point2<Robot> at = robotFromField(origin, {p.x, p.y});
  if (view == View::side) return {at.y - kBehind, kTop - p.z, at.x};
  return {at.y - kBehind, at.x + kLateral, p.z};
}

cv::Scalar inkOf(BodyPart part) {
  switch (part) {
    case BodyPart::trunk: return {214, 208, 200};
    case BodyPart::head: return {244, 241, 236};
    case BodyPart::jaw: return {150, 140, 205};
    case BodyPart::leftFront: return {206, 152, 92};
    case BodyPart::leftHind: return {176, 118, 62};
    case BodyPart::rightFront: return {122, 182, 226};
    case BodyPart::rightHind: return {84, 146, 200};
    default: return {30, 120, 240};
  }
}

void fill(cv::Mat& picture, const Shape& shape, const Pose2& origin, View view, double scale) {
  std::vector<cv::Point> points;
  const double fine = scale * (1 << kShift);
  for (const Point3<Field>& corner : shape.corners) {
    const Seen at = seen(corner, origin, view);
    const int round = shape.radius > 0.0 ? kRound : 1;
    for (int i = 0; i < round; ++i) {
      const Angle way = Angle::deg(360.0 * i / round);
      points.emplace_back(
          static_cast<int>(std::lround(fine * (at.right + shape.radius * way.cos()))),
          static_cast<int>(std::lround(fine * (at.down + shape.radius * way.sin()))));
    }
  }
  std::vector<cv::Point> hull;
  cv::convexHull(points, hull);
  cv::fillConvexPoly(picture, hull, inkOf(shape.part), cv::LINE_AA, kShift);
  cv::polylines(picture, hull, true, kEdge, 1, cv::LINE_AA, kShift);
}

cv::Mat ground(View view, double scale) {
  const auto px = [&](double cm) { return static_cast<int>(std::lround(scale * cm)); };
  const int width = px(kAhead - kBehind);
  if (view == View::side) {
    cv::Mat picture(px(kTop - kBelow), width, CV_8UC3, kWall);
    picture(cv::Range(px(kTop), picture.rows), cv::Range::all()).setTo(kCarpet);
    return picture;
  }
  cv::Mat picture(px(2 * kLateral), width, CV_8UC3, kCarpet);
  for (double y = std::ceil(kBehind / kGrid) * kGrid; y < kAhead; y += kGrid)
    cv::line(picture, {px(y - kBehind), 0}, {px(y - kBehind), picture.rows}, kCarpetLine);
  for (double x = std::ceil(-kLateral / kGrid) * kGrid; x < kLateral; x += kGrid)
    cv::line(picture, {0, px(x + kLateral)}, {width, px(x + kLateral)}, kCarpetLine);
  return picture;
}

cv::Mat drawView(std::vector<Shape> shapes, const Pose2& origin, View view, double scale) {
  cv::Mat picture = ground(view, scale);
  const auto nearness = [&](const Shape& shape) {
    double sum = 0.0;
    for (const Point3<Field>& corner : shape.corners) sum += seen(corner, origin, view).near;
    return sum / static_cast<double>(shape.corners.size());
  };
  std::stable_sort(shapes.begin(), shapes.end(),
                   [&](const Shape& a, const Shape& b) { return nearness(a) < nearness(b); });
  for (const Shape& shape : shapes) fill(picture, shape, origin, view, scale);
  return picture;
}

}  // namespace

cv::Mat drawBodies(const std::vector<sim::Shape>& shapes, const Pose2& origin, double pixelsPerCm) {
  const cv::Mat side = drawView(shapes, origin, View::side, pixelsPerCm);
  cv::Mat both;
  cv::vconcat(side, drawView(shapes, origin, View::above, pixelsPerCm), both);
  cv::line(both, {0, side.rows}, {both.cols, side.rows}, kEdge, 2);
  return both;
}

}  // namespace kelpie::cli
