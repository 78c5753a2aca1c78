// SPDX-License-Identifier: Apache-2.0
#include "tools/viewer/CameraMessages.h"

#include <fmt/core.h>

#include "tools/match/Draw.h"
#include "tools/viewer/Frames.h"
#include "tools/viewer/Shapes.h"

namespace kelpie::viewer {
namespace {

using foxglove::ImageAnnotations;
using foxglove::PointsAnnotation;

constexpr double kThin = 1.0;      // px
constexpr double kFontSize = 8.0;  // px

foxglove::Point2 point(double x, double y) {
  foxglove::Point2 p;
  p.set_x(x);
  p.set_y(y);
  return p;
}

PointsAnnotation& addPoints(ImageAnnotations& to, TimeUs time, PointsAnnotation::Type type,
                            const foxglove::Color& colour) {
  PointsAnnotation& points = *to.add_points();
  *points.mutable_timestamp() = stampOf(time);
  points.set_type(type);
  *points.mutable_outline_color() = colour;
  points.set_thickness(kThin);
  return points;
}

void addText(ImageAnnotations& to, TimeUs time, const foxglove::Point2& where,
             const std::string& words, const foxglove::Color& ink) {
  foxglove::TextAnnotation& text = *to.add_texts();
  *text.mutable_timestamp() = stampOf(time);
  *text.mutable_position() = where;
  text.set_text(words);
  text.set_font_size(kFontSize);
  *text.mutable_text_color() = ink;
  *text.mutable_background_color() = colour(0.0, 0.0, 0.0, 0.4);
}

void addBox(ImageAnnotations& to, TimeUs time, const PixelBox& box, const foxglove::Color& colour,
            const std::string& words) {
  PointsAnnotation& loop = addPoints(to, time, PointsAnnotation::LINE_LOOP, colour);
  *loop.add_points() = point(box.left, box.top);
  *loop.add_points() = point(box.right, box.top);
  *loop.add_points() = point(box.right, box.bottom);
  *loop.add_points() = point(box.left, box.bottom);
  if (!words.empty()) addText(to, time, point(box.left, box.top), words, colour);
}

template <class Percept>
std::string placeWords(const std::string& what, const Percept& percept) {
  return fmt::format("{} {:.0f} cm {:.0f} deg", what, percept.distance, percept.heading.deg());
}

void addBall(ImageAnnotations& to, TimeUs time, const BallPercept& ball) {
  if (!ball.present) return;
  foxglove::CircleAnnotation& circle = *to.add_circles();
  *circle.mutable_timestamp() = stampOf(time);
  *circle.mutable_position() = point(ball.centre.x, ball.centre.y);
  circle.set_diameter(2.0 * ball.radius);
  circle.set_thickness(kThin);
  *circle.mutable_fill_color() = colour(0.0, 0.0, 0.0, 0.0);
  *circle.mutable_outline_color() = ballColour();
  addText(to, time, point(ball.centre.x + ball.radius, ball.centre.y), placeWords("ball", ball),
          ballColour());
}

void addEdges(ImageAnnotations& to, TimeUs time, const Percepts& percepts) {
  for (const FieldEdgePercept& edge : percepts.fieldEdges) {
    PointsAnnotation& line = addPoints(to, time, PointsAnnotation::LINE_STRIP, white());
    *line.add_points() = point(0.0, edge.atLeft);
    *line.add_points() = point(kImageWidth, edge.atRight);
  }
}

void addLinePoints(ImageAnnotations& to, TimeUs time, const Percepts& percepts) {
  if (percepts.linePoints.empty()) return;
  PointsAnnotation& points = addPoints(to, time, PointsAnnotation::POINTS, white());
  for (const LinePoint& p : percepts.linePoints) {
    *points.add_points() = point(p.pixel.x, p.pixel.y);
    *points.add_outline_colors() = colourOf(p.kind);
  }
}

}  // namespace

foxglove::CompressedImage cameraImage(TimeUs time, const std::string& robot,
                                      const std::vector<std::uint8_t>& jpeg) {
  foxglove::CompressedImage image;
  *image.mutable_timestamp() = stampOf(time);
  image.set_frame_id(cameraFrame(robot));
  image.set_data(jpeg.data(), jpeg.size());
  image.set_format("jpeg");
  return image;
}

// Ours goes from the pixel's radius r to the ray's, r (1 + e r^2); theirs from the ray's to the
// pixel's: that series turned round is r (1 - e r^2 + 3 e^2 r^4 - 12 e^3 r^6 ...).
foxglove::CameraCalibration calibrationOf(TimeUs time, const std::string& robot, const Lens& lens) {
  foxglove::CameraCalibration calibration;
  *calibration.mutable_timestamp() = stampOf(time);
  calibration.set_frame_id(cameraFrame(robot));
  calibration.set_width(kImageWidth);
  calibration.set_height(kImageHeight);
  const double e = lens.edgeTerm;
  calibration.set_distortion_model("plumb_bob");
  for (const double d : {-e, 3.0 * e * e, 0.0, 0.0, -12.0 * e * e * e}) calibration.add_d(d);
  const double f = lens.focalLength;
  for (const double k : {f, 0.0, lens.principalX, 0.0, f, lens.principalY, 0.0, 0.0, 1.0})
    calibration.add_k(k);
  for (const double r : {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}) calibration.add_r(r);
  for (const double p :
       {f, 0.0, lens.principalX, 0.0, 0.0, f, lens.principalY, 0.0, 0.0, 0.0, 1.0, 0.0})
    calibration.add_p(p);
  return calibration;
}

foxglove::ImageAnnotations annotationsOf(TimeUs time, const Percepts& percepts) {
  ImageAnnotations marks;
  *marks.mutable_timestamp() = stampOf(time);
  addEdges(marks, time, percepts);
  addLinePoints(marks, time, percepts);
  for (const GoalGap& gap : percepts.gaps) addBox(marks, time, gap.box, white(), "");
  for (const LandmarkPercept& seen : percepts.landmarks)
    addBox(marks, time, seen.box, colourOf(seen.kind), placeWords(match::wordFor(seen.kind), seen));
  for (const RobotPercept& seen : percepts.robots)
    addBox(marks, time, seen.box, colourOf(seen.team), placeWords("robot", seen));
  for (const PinkPercept& seen : percepts.pinkPatches)
    addBox(marks, time, seen.box, colourOf(LandmarkKind::beaconBlueOnPink), "pink");
  addBall(marks, time, percepts.ball);
  return marks;
}

}  // namespace kelpie::viewer
