// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/motion/BlockTrial.h"

#include <cmath>

#include "robot/body/FieldDescription.h"
#include "robot/host/OnCores.h"

namespace kelpie::learn {
namespace {

constexpr double kLevel = 3.0;    // cm over or under the ball's centre that stops it
constexpr double kCovered = 0.9;  // of the width
constexpr int kPieces = 10;       // of a rod
constexpr double kWanted = 25.0;  // cm to a side that count as 1
constexpr double kEarly = 0.35;   // s
constexpr double kHeld = 0.3;     // s after the ball would be there
constexpr double kLeant = 25.0;   // deg that cost nothing

struct Width {
  double left = 0.0;
  double right = 0.0;
};

void widen(const sim::Shape& shape, const Pose2& start, Width& width) {
  for (std::size_t a = 0; a < shape.corners.size(); ++a)
    for (std::size_t b = a; b < shape.corners.size(); ++b)
      for (int i = 0; i <= kPieces; ++i) {
        const double share = static_cast<double>(i) / kPieces;
        const Point3<Field> from = shape.corners[a];
        const Point3<Field> way = shape.corners[b] - from;
        if (std::fabs(from.z + share * way.z - body::kBallRadius) > kLevel) continue;
        const double x = robotFromField(start, {from.x + share * way.x, from.y + share * way.y}).x;
        width.left = std::fmax(width.left, shape.radius - x);
        width.right = std::fmax(width.right, shape.radius + x);
      }
}

Width widthOf(const MotionMoment& moment, const Pose2& start) {
  Width width;
  for (const sim::Shape& shape : moment.shapes)
    if (shape.part != sim::BodyPart::ball) widen(shape, start, width);
  return width;
}

double gainOn(const actuator::MotionData& motion, const MotionStage& stage) {
  MotionStage own = copyOf(stage);
  const MotionKind kind = own.command.motion;
  own.params->motions[kind] = motion;
  const MotionCourse course = playMotion(own, true);
  double min = 1000.0;
  for (const MotionMoment& moment : course.moments) {
    if (moment.seconds < kEarly || moment.seconds > kBlockSeconds + kHeld) continue;
    const Width width = widthOf(moment, course.start);
    if (kind != MotionKind::blockRight) min = std::fmin(min, width.left);
    if (kind != MotionKind::blockLeft) min = std::fmin(min, width.right);
  }
  const double leant = 0.02 * std::fmax(0.0, course.lean - kLeant);
  return min / kWanted - leant - (course.fell || !course.stands ? 1.0 : 0.0);
}

}  // namespace

bool isBlock(MotionKind kind) { return useOf(kind) == MotionUse::block; }

double blockGain(const actuator::MotionData& motion, const std::vector<MotionStage>& stages) {
  std::vector<double> gains(stages.size());
  host::onCores(stages.size(), [&](std::size_t i) { gains[i] = gainOn(motion, stages[i]); });
  double sum = 0.0;
  for (const double gain : gains) sum += gain;
  return stages.empty() ? 0.0 : sum / static_cast<double>(stages.size());
}

BlockCover coverOf(const MotionStage& stage) {
  MotionStage own = copyOf(stage);
  own.rolling.reset();
  const MotionCourse course = playMotion(own, true);
  Width held;
  for (const MotionMoment& moment : course.moments)
    if (moment.seconds <= kBlockSeconds) held = widthOf(moment, course.start);
  BlockCover cover{held.left,   held.right,    0.0,        course.lean,
                   course.fell, course.stands, course.way, course.turn};
  for (const MotionMoment& moment : course.moments) {
    const Width now = widthOf(moment, course.start);
    cover.seconds = moment.seconds;
    if (now.left + now.right >= kCovered * (held.left + held.right)) break;
  }
  return cover;
}

BlockedBall tryBlock(const MotionStage& stage, double lateral, double speed, Angle from) {
  MotionStage own = copyOf(stage);
  own.rolling = {{lateral, kBlockAhead}, speed, kBlockSeconds, from};
  const MotionCourse course = playMotion(own, false);
  const bool stopped = course.nearest > kBallPassed;
  return {stopped, stopped && course.ballVelocity.y > 0.0, course.fell, course.stands};
}

}  // namespace kelpie::learn
