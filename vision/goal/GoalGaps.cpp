// SPDX-License-Identifier: Apache-2.0
#include "vision/goal/GoalGaps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "vision/pixels/GroundRay.h"

namespace kelpie::vision {
namespace {

constexpr int kHeights = 7;          // places looked at between foot and top
constexpr double kFreeShare = 0.85;  // of these must show the goal's colour
constexpr int kMinPlaces = 3;        // of these must be in the image
constexpr int kMaxSteps = 260;       // the image's width and a quarter
constexpr double kMinGap = 2.5;      // px

using Vec = Point2<Robot>;

double directionOf(Vec p) { return maths::atan2(p.x, p.y); }

std::optional<PixelPoint> pixelAt(const Scene& scene, Vec ground, double height) {
  const Point3<Robot>& eye = scene.body.camera.position;
  return body::project(scene.body.camera, {eye.x + ground.x, eye.y + ground.y, height});
}

// By how much the wall's foot is seen lower than the camera's pose says, px.
double footShift(const Scene& scene, const GoalCandidate& c, const GoalShape& shape) {
  double sum = 0.0;
  double count = 0.0;
  for (const GoalColumn& column : c.columns) {
    if (!column.chosen || column.footCut) continue;
    const GroundRay s = groundRayThrough(scene.body.camera, column.foot);
    const Vec way{s.right, s.forward};
    const auto wall = shape.wallAlong(way, scene.field);
    if (!wall) continue;
    const auto pixel = pixelAt(scene, way * *wall, 0.0);
    if (!pixel) continue;
    sum += scene.frame.fromImage(column.foot).v - scene.frame.fromImage(*pixel).v;
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

enum class Look { free, blocked, outside };

// What one direction shows between the foot and the top of the wall behind the mouth.
Look lookAlong(const Scene& scene, ColourClass colour, Vec wall, double shift) {
  const auto foot = pixelAt(scene, wall, 0.0);
  const auto top = pixelAt(scene, wall, scene.field.goalHeight);
  if (!foot || !top) return Look::outside;
  int places = 0;
  int open = 0;
  for (int i = 0; i < kHeights; ++i) {
    const double share = 0.12 + 0.72 * i / (kHeights - 1);
    const PixelPoint expected{foot->x + share * (top->x - foot->x),
                              foot->y + share * (top->y - foot->y)};
    const PixelPoint at = moved(expected, scene.frame.up(), -shift);
    if (!Sampler::usable(at)) continue;
    const ColourClass seen = scene.sampler.classAt(at);
    ++places;
    open += seen == colour || seen == ColourClass::orange ? 1 : 0;
  }
  if (places < kMinPlaces) return Look::outside;
  return open >= kFreeShare * places ? Look::free : Look::blocked;
}

// Where the direction crosses the mouth's line, seen from the robot's origin.
Angle mouthBearing(const Scene& scene, Vec left, Vec right, double direction) {
  const maths::SinCos d = maths::sinCos(direction);
  const Vec way{d.sin, d.cos};
  const Vec along = right - left;
  const double share = (left.y * way.x - left.x * way.y) / (along.x * way.y - along.y * way.x);
  const Point3<Robot>& eye = scene.body.camera.position;
  const Vec camera{eye.x, eye.y};
  return bearing(camera + left + along * maths::clamp(share, 0.0, 1.0));
}

struct Mouth {
  Vec left;
  Vec right;
  double from = 0.0;  // direction of the left post, right positive
  double step = 0.0;  // about one pixel
  int steps = 0;
};

Mouth mouthOf(const GoalShape& shape, const body::FieldDescription& field, double focalLength) {
  Mouth m{shape.leftPost(field), shape.rightPost(field)};
  m.from = directionOf(m.left);
  const double width = Angle::rad(directionOf(m.right) - m.from).rad();
  m.steps = static_cast<int>(maths::clamp(width * focalLength, 0.0, kMaxSteps * 1.0));
  m.step = m.steps > 0 ? width / m.steps : 0.0;
  return m;
}

GoalGap gapOf(const Scene& scene, const GoalCandidate& c, const Mouth& m, int first, int last) {
  const double left = m.from + m.step * first;
  const double right = m.from + m.step * (last + 1);
  GoalGap gap;
  gap.goal = c.colour == ColourClass::blue ? LandmarkKind::goalBlue : LandmarkKind::goalYellow;
  gap.left = mouthBearing(scene, m.left, m.right, left);
  gap.right = mouthBearing(scene, m.left, m.right, right);
  const Point3<Robot>& eye = scene.body.camera.position;
  const double distance = (m.left + m.right).norm() * 0.5;
  PixelBox box{1e9, 1e9, -1e9, -1e9};
  for (const double direction : {left, right}) {
    const maths::SinCos d = maths::sinCos(direction);
    for (const double height : {0.0, scene.field.goalHeight}) {
      const auto p = body::project(scene.body.camera,
                                   {eye.x + distance * d.sin, eye.y + distance * d.cos, height});
      if (!p) continue;
      box = {std::min(box.left, p->x), std::min(box.top, p->y), std::max(box.right, p->x),
             std::max(box.bottom, p->y)};
    }
  }
  gap.box = {maths::clamp(box.left, 0.0, kImageWidth * 1.0),
             maths::clamp(box.top, 0.0, kImageHeight * 1.0),
             maths::clamp(box.right, 0.0, kImageWidth * 1.0),
             maths::clamp(box.bottom, 0.0, kImageHeight * 1.0)};
  return gap;
}

// What a pixel's width of the mouth shows.
Look lookAt(const Scene& scene, const GoalCandidate& c, const GoalShape& shape, const Mouth& m,
            double shift, int i) {
  const maths::SinCos d = maths::sinCos(m.from + m.step * (i + 0.5));
  const Vec way{d.sin, d.cos};
  const auto wall = shape.wallAlong(way, scene.field);
  return wall ? lookAlong(scene, c.colour, way * *wall, shift) : Look::blocked;
}

using Looks = std::array<Look, kMaxSteps + 1>;

// What all of the mouth shows, and after its end a post. Where two looks agree those between are
// not asked: what hides one pixel of a goal is noise, and a goal that fills the view
// took 450 k instructions pixel by pixel.
void lookThrough(const Scene& scene, const GoalCandidate& c, const GoalShape& shape, const Mouth& m,
                 Looks& looks) {
  constexpr int kApart = 2;  // px
  const double shift = footShift(scene, c, shape);
  looks[static_cast<std::size_t>(m.steps)] = Look::blocked;
  int before = -1;
  for (int i = 0; i < m.steps; i = std::min(i + kApart, std::max(i + 1, m.steps - 1))) {
    const Look look = lookAt(scene, c, shape, m, shift, i);
    looks[static_cast<std::size_t>(i)] = look;
    for (int k = before + 1; k < i; ++k) {
      const bool agreed = looks[static_cast<std::size_t>(before)] == look;
      looks[static_cast<std::size_t>(k)] = agreed ? look : lookAt(scene, c, shape, m, shift, k);
    }
    before = i;
  }
}

}  // namespace

void findGaps(const Scene& scene, const GoalCandidate& c, const GoalShape& shape, GoalGaps& gaps) {
  const Mouth m = mouthOf(shape, scene.field, focalLength(scene));
  Looks looks;
  lookThrough(scene, c, shape, m, looks);
  int first = -1;
  Look before = Look::blocked;
  bool leftCut = false;
  for (int i = 0; i <= m.steps; ++i) {
    const Look look = looks[static_cast<std::size_t>(i)];
    if (look == Look::free && first < 0) {
      first = i;
      leftCut = before == Look::outside;
    } else if (look != Look::free && first >= 0) {
      if (i - first >= kMinGap) {
        GoalGap gap = gapOf(scene, c, m, first, i - 1);
        gap.leftCut = leftCut;
        gap.rightCut = look == Look::outside;
        gaps.push_back(gap);
      }
      first = -1;
    }
    before = look;
  }
}

}  // namespace kelpie::vision
