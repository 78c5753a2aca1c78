// SPDX-License-Identifier: Apache-2.0
#include "vision/goal/GoalGaps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "vision/pixels/Between.h"
#include "vision/pixels/GroundRay.h"

namespace kelpie::vision {
namespace {

constexpr int kHeights = 7;             // places looked at between foot and top
constexpr double kLowestHeight = 0.12;  // of the way to the top, the first of these
constexpr double kHeightSpan = 0.72;    // from the first to the last of these
constexpr double kFreeShare = 0.85;     // of these must show the goal's colour
constexpr int kMinPlaces = 3;           // of these must be in the image
constexpr int kMaxSteps = 260;          // the image's width and a quarter
constexpr double kMinGap = 2.5;         // px

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

// Where the foot and the top of the wall behind the mouth are seen in one direction.
struct Sight {
  PixelPoint foot;
  PixelPoint top;
};

// What one direction shows between the foot and the top of the wall.
Look lookBetween(const Scene& scene, ColourClass colour, const Sight& wall, double shift) {
  int places = 0;
  int open = 0;
  for (int i = 0; i < kHeights; ++i) {
    const double share = kLowestHeight + kHeightSpan * i / (kHeights - 1);
    const PixelPoint at = moved(between(wall.foot, wall.top, share), scene.frame.up(), -shift);
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
  PixelBox box = kEmptyPixelBox;
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

// The mouth's walls as they are seen. What is between two directions on one wall is laid between
// their places: to project each pixel's foot and top took two thirds of the gaps.
class Walls {
 public:
  Walls(const Scene& scene, const GoalShape& shape, const Mouth& mouth)
      : scene_(scene), shape_(shape), mouth_(mouth) {}

  // Nothing without a wall there.
  std::optional<double> distance(double i) const {
    return shape_.wallAlong(wayOf(i), scene_.field);
  }
  std::optional<Sight> sight(int i, double wall) const {
    const Vec at = wayOf(i) * wall;
    const auto foot = pixelAt(scene_, at, 0.0);
    const auto top = pixelAt(scene_, at, scene_.field.goalHeight);
    return foot && top ? std::optional<Sight>(Sight{*foot, *top}) : std::nullopt;
  }
  // Inverse distances of a plane wall: those of two directions tell that half-way between.
  bool onOneWall(int i, double wall, int k, double other) const {
    constexpr double kMaxError = 1e-3;  // of it, a twentieth of a pixel
    const auto half = distance(0.5 * (i + k));
    if (!half) return false;
    const double bend = 2.0 * maths::sinCos(0.5 * mouth_.step * (k - i)).cos;
    return std::fabs(1.0 / wall + 1.0 / other - bend / *half) <= kMaxError * bend / *half;
  }

 private:
  Vec wayOf(double i) const {
    const maths::SinCos d = maths::sinCos(mouth_.from + mouth_.step * (i + 0.5));
    return {d.sin, d.cos};
  }

  const Scene& scene_;
  const GoalShape& shape_;
  const Mouth& mouth_;
};

// What each pixel's width of the mouth shows, asked from the left.
class MouthView {
 public:
  MouthView(const Scene& scene, const GoalCandidate& c, const GoalShape& shape, const Mouth& mouth)
      : scene_(scene),
        colour_(c.colour),
        shift_(footShift(scene, c, shape)),
        steps_(mouth.steps),
        walls_(scene, shape, mouth) {}

  Look at(int i) {
    while (i > to_.step) nextSpan();
    if (plain_) {
      const double share = static_cast<double>(i - from_.step) / (to_.step - from_.step);
      const Sight sight{between(from_.sight->foot, to_.sight->foot, share),
                        between(from_.sight->top, to_.sight->top, share)};
      return lookBetween(scene_, colour_, sight, shift_);
    }
    return lookFrom(i == to_.step ? to_ : knotAt(i));
  }

 private:
  struct Knot {
    int step = -1;
    std::optional<double> wall;
    std::optional<Sight> sight;
  };
  static constexpr int kSpan = 8;  // px; the arc's bend is a twentieth of a pixel

  Knot knotAt(int i) const {
    Knot knot{i, walls_.distance(i), {}};
    if (knot.wall) knot.sight = walls_.sight(i, *knot.wall);
    return knot;
  }
  Look lookFrom(const Knot& knot) const {
    if (!knot.wall) return Look::blocked;
    return knot.sight ? lookBetween(scene_, colour_, *knot.sight, shift_) : Look::outside;
  }
  void nextSpan() {
    from_ = to_;
    to_ = knotAt(from_.step < 0 ? 0 : std::min(from_.step + kSpan, steps_ - 1));
    plain_ =
        from_.sight && to_.sight && walls_.onOneWall(from_.step, *from_.wall, to_.step, *to_.wall);
  }

  const Scene& scene_;
  ColourClass colour_;
  double shift_;
  int steps_;
  Walls walls_;
  Knot from_;
  Knot to_;
  bool plain_ = false;
};

using Looks = std::array<Look, kMaxSteps + 1>;

// What all of the mouth shows, and after its end a post. Where two looks agree those between are
// not asked: what hides one pixel of a goal is noise, and a goal that fills the view
// took 450 k instructions pixel by pixel.
void lookThrough(const Scene& scene, const GoalCandidate& c, const GoalShape& shape, const Mouth& m,
                 Looks& looks) {
  constexpr int kApart = 2;  // px
  MouthView view(scene, c, shape, m);
  looks[static_cast<std::size_t>(m.steps)] = Look::blocked;
  int before = -1;
  for (int i = 0; i < m.steps; i = std::min(i + kApart, std::max(i + 1, m.steps - 1))) {
    const Look look = view.at(i);
    looks[static_cast<std::size_t>(i)] = look;
    for (int k = before + 1; k < i; ++k) {
      const bool agreed = looks[static_cast<std::size_t>(before)] == look;
      looks[static_cast<std::size_t>(k)] = agreed ? look : view.at(k);
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
