// SPDX-License-Identifier: Apache-2.0
#include "tools/match/drawing/CameraDrawing.h"

#include <fmt/core.h>

#include <algorithm>

#include "tools/match/Draw.h"
#include "tools/match/drawing/Inks.h"
#include "tools/picture/CameraPicture.h"

namespace kelpie::match {
namespace {

using namespace picture;

// Draws in the pixels of the camera's image.
class View {
 public:
  View(Canvas& canvas, const Frame& frame)
      : canvas_(canvas), frame_(frame), scale_(frame.width / kImageWidth) {}

  Spot at(PixelPoint p) const { return {frame_.x + p.x * scale_, frame_.y + p.y * scale_}; }
  void line(double left, double right, const Ink& ink) {
    canvas_.line({at({0.0, left}), at({kImageWidth, right})}, ink, 1.2);
  }
  void box(const PixelBox& box, const Ink& ink) {
    const Spot a = at({box.left, box.top});
    const Spot b = at({box.right, box.bottom});
    canvas_.outline({a.x, a.y, b.x - a.x, b.y - a.y}, ink, 1.6, 2.0);
  }
  // Kept within the picture.
  void word(Spot where, const std::string& words, const Ink& ink) {
    const Type type{std::clamp(6.2 * scale_, 10.0, 13.0), ink, true};
    const cv::Size2d size = canvas_.measure(words, type);
    where.x = std::clamp(where.x, frame_.x + 2.0, frame_.x + frame_.width - size.width - 2.0);
    where.y = std::clamp(where.y, frame_.y + 2.0, frame_.y + frame_.height - size.height - 2.0);
    canvas_.label(where, words, type);
  }
  void above(const PixelBox& box, const std::string& words, const Ink& ink) {
    const Spot corner = at({box.left, box.top});
    word({corner.x, corner.y - 8.8 * scale_}, words, ink);
  }
  void points(const Percepts& seen) {
    for (const auto& point : seen.linePoints)
      canvas_.disc(at(point.pixel), 1.6, inks::of(point.kind));
    for (const auto& point : seen.obstacles) cross(at(point.pixel));
  }
  void ball(const BallPercept& seen) {
    const double radius = std::max(3.0, seen.radius * scale_);
    const Spot middle = at(seen.centre);
    canvas_.ring(middle, radius + 1.0, inks::kGround.faded(0.8), 4.0);
    canvas_.ring(middle, radius + 1.0, inks::kBall, 2.2);
    word({middle.x + radius + 5.0, middle.y - 8.0}, fmt::format("ball {:.0f} cm", seen.distance),
         inks::kBall);
  }

 private:
  void cross(Spot p) {
    canvas_.line({{p.x - 2.5, p.y - 2.5}, {p.x + 2.5, p.y + 2.5}}, inks::kObstacle, 1.4);
    canvas_.line({{p.x - 2.5, p.y + 2.5}, {p.x + 2.5, p.y - 2.5}}, inks::kObstacle, 1.4);
  }

  Canvas& canvas_;
  Frame frame_;
  double scale_;
};

void drawMarks(View view, const FrameOutput& output) {
  const Percepts& seen = output.percepts;
  view.line(output.body.horizon.atLeft, output.body.horizon.atRight, inks::kQuiet);
  for (const auto& edge : seen.fieldEdges) view.line(edge.atLeft, edge.atRight, inks::kCarpetEdge);
  view.points(seen);
  for (const auto& robot : seen.robots) view.box(robot.box, inks::of(robot.team));
  for (const auto& mark : seen.landmarks) view.box(mark.box, inks::of(mark.kind));
  for (const auto& robot : seen.robots)
    view.above(robot.box, fmt::format("robot {:.0f} cm", robot.distance), inks::of(robot.team));
  for (const auto& mark : seen.landmarks)
    view.above(mark.box, fmt::format("{} {:.0f} cm", wordFor(mark.kind), mark.distance),
               inks::of(mark.kind));
  if (seen.ball.present) view.ball(seen.ball);
}

// What a robot perceived without having looked (tools/percepts).
void drawNoImage(Canvas& canvas, const Frame& frame) {
  canvas.box(frame, inks::kPanel);
  canvas.text({frame.x + 0.5 * frame.width, frame.y + frame.height - 22.0},
              "no image: percepts made of the true places",
              {11.0, inks::kQuiet, false, Align::centre});
}

}  // namespace

void drawCameraView(Canvas& canvas, const Frame& frame, const Moment& moment) {
  canvas.cut(frame, 6.0);
  if (moment.imaged)
    canvas.paste(pictureOf(moment.input.image), frame);
  else
    drawNoImage(canvas, frame);
  if (moment.fresh || !moment.imaged) drawMarks(View(canvas, frame), moment.output);
  canvas.uncut();
}

}  // namespace kelpie::match
