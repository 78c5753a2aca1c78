// SPDX-License-Identifier: Apache-2.0
#include "vision/goal/GoalShape.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robot/core/ScratchVector.h"
#include "vision/pixels/GroundRay.h"

namespace kelpie::vision {
namespace {

constexpr std::size_t kMaxColumns = 12;  // used in the fit
constexpr double kEndSd = 0.006;         // rad, direction of an end that is seen
constexpr double kMinColumnSd = 0.012;   // of a column's distance, as a share of it
constexpr double kTurnSd = 0.7;          // rad; goals are seen from within the field
constexpr double kMaxError = 3.0;        // standard deviations, beyond which an error counts less
constexpr int kRounds = 8;
constexpr double kNoWall = 1e9;       // cm, of a ray that meets no wall
constexpr double kNoDirection = 1e9;  // rad, before any is known
constexpr double kNoCost = 1e18;      // more than any fit's
constexpr double kMaxWay = 2.0;       // of a column's distance, up to which its ray meets a wall
// Levenberg and Marquardt's: multiplied after a step that was worse, and after a better one.
constexpr double kFirstDamping = 0.01;
constexpr double kDampingRise = 10.0;
constexpr double kDampingFall = 0.3;
constexpr double kMinProgress = 0.01;  // of the cost, below which the fit ends

using Vec = Point2<Robot>;
using State = std::array<double, 3>;  // middle x, middle y, turn

Vec plus(Vec a, Vec b, double k) { return {a.x + k * b.x, a.y + k * b.y}; }
double crossOf(Vec a, Vec b) { return a.x * b.y - a.y * b.x; }
// How a vector moves when it is turned.
Vec turning(Vec a) { return {-a.y, a.x}; }

// What was measured: directions (right positive) and distances, relative to the camera.
struct Column {
  Vec way;  // unit vector
  double distance;
  double sd;
};
struct Measured {
  ScratchVector<Column, kMaxColumns> columns;
  double left = 0.0;  // rad, direction of the ends, right positive
  double right = 0.0;
  bool leftOpen = false;  // the true end may lie farther out
  bool rightOpen = false;
  double middle = 0.0;  // between them
};

double directionOf(const Scene& scene, PixelPoint p) {
  const GroundRay s = groundRayThrough(scene.body.camera, p);
  return maths::atan2(s.right, s.forward);
}

Measured measuredOf(const Scene& scene, const GoalCandidate& c) {
  Measured m;
  m.left = directionOf(scene, c.left.point);
  m.right = directionOf(scene, c.right.point);
  m.leftOpen = c.left.open();
  m.rightOpen = c.right.open();
  m.middle = 0.5 * (m.left + m.right);
  std::size_t usable = 0;
  for (const GoalColumn& column : c.columns)
    if (column.chosen && column.distance > 0.0) ++usable;
  std::size_t index = 0;
  for (const GoalColumn& column : c.columns) {
    if (!column.chosen || !(column.distance > 0.0)) continue;
    // Evenly thinned to what the fit takes.
    const std::size_t before = index * kMaxColumns / usable;
    const bool take = usable <= kMaxColumns || (index + 1) * kMaxColumns / usable != before;
    ++index;
    if (!take) continue;
    const GroundRay s = groundRayThrough(scene.body.camera, column.foot);
    m.columns.push_back({{s.right, s.forward}, column.distance, column.sd});
  }
  return m;
}

struct Corners {
  Vec leftPost;
  Vec rightPost;
  Vec leftBack;
  Vec rightBack;
};

Corners cornersOf(const State& s, const body::FieldDescription& field) {
  const maths::SinCos t = maths::sinCos(s[2]);
  const Vec along{t.cos, t.sin};
  const Vec inwards{-t.sin, t.cos};
  const Vec middle{s[0], s[1]};
  Corners c;
  const double half = 0.5 * field.goalWidth;
  c.leftPost = plus(middle, along, -half);
  c.rightPost = plus(middle, along, half);
  c.leftBack = plus(c.leftPost, inwards, field.goalDepth);
  c.rightBack = plus(c.rightPost, inwards, field.goalDepth);
  return c;
}

// A wall from one corner to the next, with what does not depend on the ray that meets it.
struct Wall {
  Vec from;
  Vec along;
  double cross;  // of both

  Wall(Vec a, Vec b) : from(a), along(b - a), cross(crossOf(a, along)) {}

  // The way along the ray to it.
  double hit(Vec ray) const {
    constexpr double kParallel = 1e-9;
    const double denominator = crossOf(ray, along);
    const double size = std::fabs(denominator);
    if (size < kParallel) return kNoWall;
    // The share of the wall at which it is met, and the way, are over the denominator: only a wall
    // that is met needs the quotient.
    const double sign = denominator < 0.0 ? -1.0 : 1.0;
    const double share = sign * crossOf(from, ray);
    constexpr double kSlack = 0.03;  // a ray that just passes an end still meets the wall
    if (!(share > -kSlack * size && share < (1.0 + kSlack) * size)) return kNoWall;
    return sign * cross > 0.0 ? cross / denominator : kNoWall;
  }

  // How the way to it grows with each part of the state of a goal with this middle.
  State slopes(Vec ray, double way, Vec middle) const {
    const double denominator = crossOf(ray, along);
    const Vec turned = turning(along);
    const double byTurn =
        crossOf(turning(from - middle), along) + crossOf(from, turned) - way * crossOf(ray, turned);
    const double share = 1.0 / denominator;
    return {along.y * share, -along.x * share, byTurn * share};
  }
};

// Where a ray ends.
struct Met {
  const Wall* wall;
  double way;
};

struct Walls {
  Wall left;
  Wall back;
  Wall right;

  explicit Walls(const Corners& c)
      : left(c.leftPost, c.leftBack),
        back(c.leftBack, c.rightBack),
        right(c.rightBack, c.rightPost) {}
  // The nearest, if one is nearer than `max`.
  Met met(Vec ray, double max) const {
    Met nearest{nullptr, max};
    for (const Wall* wall : {&left, &back, &right}) {
      const double way = wall->hit(ray);
      if (!(way >= nearest.way)) nearest = {wall, way};
    }
    return nearest;
  }
};

// The outermost corners and their directions, right positive.
struct Ends {
  Vec left;
  Vec right;
  double low = kNoDirection;
  double high = -kNoDirection;
};

Ends endsOf(const Corners& c) {
  Vec left = c.leftPost;
  Vec right = c.leftPost;
  bool ahead = left.y > 0.0;
  Ends ends;
  for (const Vec& corner : {c.rightPost, c.leftBack, c.rightBack}) {
    ahead = ahead && corner.y > 0.0;
    if (crossOf(corner, left) < 0.0) left = corner;
    if (crossOf(corner, right) > 0.0) right = corner;
  }
  // With all ahead the outermost are found by their ratios: two arcs in place of four.
  if (ahead) return {left, right, maths::atan2(left.x, left.y), maths::atan2(right.x, right.y)};
  for (const Vec& corner : {c.leftPost, c.rightPost, c.leftBack, c.rightBack}) {
    const double direction = maths::atan2(corner.x, corner.y);
    if (direction < ends.low) {
      ends.low = direction;
      ends.left = corner;
    }
    if (direction > ends.high) {
      ends.high = direction;
      ends.right = corner;
    }
  }
  return ends;
}

constexpr std::size_t kErrors = kMaxColumns + 3;
using Errors = std::array<double, kErrors>;

// Huber's weight as an error: beyond the limit its square grows with the error, not its square.
double limited(double error) {
  const double size = std::fabs(error);
  if (size <= kMaxError) return error;
  const double root = std::sqrt(kMaxError * (2.0 * size - kMaxError));
  return error > 0.0 ? root : -root;
}

std::size_t errorCount(const Measured& m) { return m.columns.size() + 3; }

// A goal in one place: what errors and slopes both ask of it.
struct Placed {
  Placed(const Measured& m, const State& s, const body::FieldDescription& field)
      : Placed(m, s, cornersOf(s, field)) {}
  Placed(const Placed&) = delete;  // `met` points to `walls`
  Placed& operator=(const Placed&) = delete;

  Vec middle;
  Walls walls;
  Ends ends;
  ScratchVector<Met, kMaxColumns> met;  // of each column

 private:
  Placed(const Measured& m, const State& s, const Corners& c)
      : middle{s[0], s[1]}, walls(c), ends(endsOf(c)) {
    for (const Column& column : m.columns)
      met.push_back(walls.met(column.way, kMaxWay * column.distance));
  }
};

// All errors in standard deviations; unused places are 0.
Errors errorsOf(const Measured& m, const State& s, const Placed& goal) {
  const Ends& ends = goal.ends;
  Errors e{};
  // An open end only says that the goal reaches at least so far.
  const double left = ends.low - m.left;
  const double right = ends.high - m.right;
  e[0] = limited((!m.leftOpen || left > 0.0 ? left : 0.0) / kEndSd);
  e[1] = limited((!m.rightOpen || right < 0.0 ? right : 0.0) / kEndSd);
  e[2] = (s[2] + m.middle) / kTurnSd;
  for (std::size_t i = 0; i < m.columns.size(); ++i) {
    const Column& column = m.columns[i];
    const double sd = std::max(column.sd, kMinColumnSd * column.distance);
    e[3 + i] = limited((goal.met[i].way - column.distance) / sd);
  }
  return e;
}

double costOf(const Errors& e) {
  double sum = 0.0;
  for (const double error : e) sum += error * error;
  return sum;
}

// Solves the damped normal equations for the next step (Cramer's rule on three unknowns).
State stepOf(const std::array<Errors, 3>& slopes, const Errors& e, std::size_t count,
             double damping) {
  constexpr double kMinDeterminant = 1e-12;
  std::array<double, 9> a{};
  State b{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < count; ++k) b[i] -= slopes[i][k] * e[k];
    for (std::size_t j = 0; j <= i; ++j) {
      for (std::size_t k = 0; k < count; ++k) a[3 * i + j] += slopes[i][k] * slopes[j][k];
      a[3 * j + i] = a[3 * i + j];
    }
  }
  for (std::size_t i = 0; i < 3; ++i) a[4 * i] *= 1.0 + damping;
  const auto minor = [&a](std::size_t r, std::size_t s, std::size_t t, std::size_t u) {
    return a[r] * a[u] - a[s] * a[t];
  };
  const double c00 = minor(4, 5, 7, 8);
  const double c01 = -minor(3, 5, 6, 8);
  const double c02 = minor(3, 4, 6, 7);
  const double determinant = a[0] * c00 + a[1] * c01 + a[2] * c02;
  if (std::fabs(determinant) < kMinDeterminant) return {};
  const double c11 = minor(0, 2, 6, 8);
  const double c12 = -minor(0, 1, 6, 7);
  const double c22 = minor(0, 1, 3, 4);
  return {(c00 * b[0] + c01 * b[1] + c02 * b[2]) / determinant,
          (c01 * b[0] + c11 * b[1] + c12 * b[2]) / determinant,
          (c02 * b[0] + c12 * b[1] + c22 * b[2]) / determinant};
}

struct Fit {
  State state;
  double cost;
};

using Slopes = std::array<Errors, 3>;

// Sets the slopes of one error: those of what is compared, over its standard deviation, less where
// the error counts less.
void setSlopes(const State& by, double sd, std::size_t k, const Errors& errors, Slopes& slopes) {
  const double size = std::fabs(errors[k]);
  const double share = size <= kMaxError ? 1.0 / sd : kMaxError / (size * sd);
  for (std::size_t i = 0; i < 3; ++i) slopes[i][k] = share * by[i];
}

// Of the direction of a corner that turns about the goal's middle.
State cornerSlopes(Vec corner, Vec middle) {
  const double share = 1.0 / (corner.x * corner.x + corner.y * corner.y);
  const Vec turned = turning(corner - middle);
  return {corner.y * share, -corner.x * share, -crossOf(corner, turned) * share};
}

// How the errors grow with each part of the state, from the geometry: three more looks at all
// errors took half of the fit.
Slopes slopesAt(const Measured& m, const Placed& goal, const Errors& errors) {
  const Ends& ends = goal.ends;
  Slopes slopes{};
  if (!m.leftOpen || errors[0] > 0.0)
    setSlopes(cornerSlopes(ends.left, goal.middle), kEndSd, 0, errors, slopes);
  if (!m.rightOpen || errors[1] < 0.0)
    setSlopes(cornerSlopes(ends.right, goal.middle), kEndSd, 1, errors, slopes);
  slopes[2][2] = 1.0 / kTurnSd;
  for (std::size_t i = 0; i < m.columns.size(); ++i) {
    const Column& column = m.columns[i];
    const double sd = std::max(column.sd, kMinColumnSd * column.distance);
    const Met& at = goal.met[i];
    const State by =
        at.wall != nullptr ? at.wall->slopes(column.way, at.way, goal.middle) : State{};
    setSlopes(by, sd, 3 + i, errors, slopes);
  }
  return slopes;
}

// So near that the same minimum would be found again.
bool isNear(const State& a, const State& b) {
  constexpr double kNear = 0.5;       // cm; two minima are tens apart,
  constexpr double kNearTurn = 0.01;  // rad, and half a radian
  return std::fabs(a[0] - b[0]) < kNear && std::fabs(a[1] - b[1]) < kNear &&
         std::fabs(a[2] - b[2]) < kNearTurn;
}

// The best place near a state; `known` as soon as the way leads to that one.
Fit improved(const Measured& m, State state, const Fit& known,
             const body::FieldDescription& field) {
  const Placed start(m, state, field);
  Errors errors = errorsOf(m, state, start);
  Slopes slopes = slopesAt(m, start, errors);
  double cost = costOf(errors);
  double damping = kFirstDamping;
  for (int round = 0; round < kRounds; ++round) {
    const State step = stepOf(slopes, errors, errorCount(m), damping);
    const State next{state[0] + step[0], state[1] + step[1], state[2] + step[2]};
    const Placed placed(m, next, field);
    const Errors nextErrors = errorsOf(m, next, placed);
    const double nextCost = costOf(nextErrors);
    if (!(nextCost < cost)) {
      damping *= kDampingRise;
      continue;
    }
    const bool done = cost - nextCost < kMinProgress;
    state = next;
    cost = nextCost;
    if (isNear(state, known.state)) return known;
    if (done || round + 1 == kRounds) break;
    errors = nextErrors;
    slopes = slopesAt(m, placed, errors);
    damping *= kDampingFall;
  }
  return {state, cost};
}

}  // namespace

double GoalShape::obliqueAngle() const {
  return std::fabs((Angle::rad(turn) - bearing(middle)).rad());
}

double GoalShape::lateralOffset() const { return middle.norm() * maths::sin(obliqueAngle()); }

Point2<Robot> GoalShape::leftPost(const body::FieldDescription& field) const {
  return cornersOf({middle.x, middle.y, turn}, field).leftPost;
}

Point2<Robot> GoalShape::rightPost(const body::FieldDescription& field) const {
  return cornersOf({middle.x, middle.y, turn}, field).rightPost;
}

std::optional<double> GoalShape::wallAlong(Point2<Robot> way,
                                           const body::FieldDescription& field) const {
  const double t = Walls(cornersOf({middle.x, middle.y, turn}, field)).met(way, kNoWall).way;
  return t < kNoWall ? std::optional<double>(t) : std::nullopt;
}

bool goalFacesField(const GoalShape& shape, const GoalFinderParams& p) {
  return shape.valid && shape.obliqueAngle() <= p.maxTurn.rad() &&
         shape.lateralOffset() <= p.maxLateralOffset;
}

GoalShape fitGoal(const Scene& scene, const GoalCandidate& c) {
  constexpr double kSeenDepth = 0.7;     // of the goal's, from mouth to walls seen
  constexpr double kMinDistance = 20.0;  // cm, to the mouth
  constexpr std::array<double, 3> kTurns{-0.6, 0.0, 0.6};  // rad, to begin with
  const Measured m = measuredOf(scene, c);
  if (m.columns.empty()) return {};
  const double mouth = std::max(c.wallDistance - kSeenDepth * scene.field.goalDepth, kMinDistance);
  const maths::SinCos ahead = maths::sinCos(m.middle);
  Fit best{{}, kNoCost};
  for (const double turn : kTurns) {
    const Fit fit =
        improved(m, {mouth * ahead.sin, mouth * ahead.cos, turn - m.middle}, best, scene.field);
    if (fit.cost < best.cost) best = fit;
  }
  return {true, {best.state[0], best.state[1]}, best.state[2], best.cost};
}

}  // namespace kelpie::vision
