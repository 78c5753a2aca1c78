// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/FastFit.h"

#include <cmath>

#include "robot/core/Random.h"
#include "tools/sim/WalkingBody.h"

namespace kelpie::learn {
namespace {

using actuator::Velocity;

constexpr int kStart = 36;     // messages until the speed is even
constexpr int kMeasured = 40;  // 1.3 s: it must not come to a wall
constexpr double kSeconds = kMeasured * kTicksPerMessage * kTickSeconds;

// A direction alone, or all at once.
WalkRequest drawn(int number, Random& random) {
  const double share = random.uniform(0.3, 1.0);
  const double side = random.chance(0.5) ? share : -share;
  switch (number % 6) {
    case 0: return {share * 37.0, 0.0, 0.0};
    case 1: return {-share * 40.0, 0.0, 0.0};
    case 2: return {0.0, side * 30.0, 0.0};
    case 3: return {0.0, 0.0, side * 3.5};
    default:
      return {random.uniform(-20.0, 25.0), random.uniform(-15.0, 15.0), random.uniform(-1.2, 1.2)};
  }
}

Velocity plus(const Velocity& sum, double forward, double left, double turn) {
  return {sum.forward + forward / kSeconds, sum.left + left / kSeconds, sum.turn + turn / kSeconds};
}

FastSample walkedBy(sim::WalkingBody& body, const WalkRequest& request) {
  Command command;
  command.walk = request;
  (void)body.world().carry(0, {{180.0, 270.0}, Angle::deg(90.0)});
  for (int i = 0; i < kStart; ++i) body.step(command);
  FastSample sample;
  for (int i = 0; i < kMeasured; ++i) {
    const Pose2 last = body.pose();
    const Odometry told = body.step(command).odometry;
    const Point2<Robot> moved = robotFromField(last, body.pose().position);
    sample.told = plus(sample.told, told.forward, told.left, told.turn.rad());
    sample.walked =
        plus(sample.walked, moved.y, -moved.x, (body.pose().heading - last.heading).rad());
  }
  return sample;
}

// Least squares of b = share * a.
struct Ratio {
  double products = 0.0;
  double squares = 0.0;

  void add(double a, double b) {
    products += a * b;
    squares += a * a;
  }
  double value() const { return squares > 0.0 ? products / squares : 1.0; }
};

// Of b = first * x + second * y.
struct TwoRatios {
  double xx = 0.0, xy = 0.0, yy = 0.0, xb = 0.0, yb = 0.0;

  void add(double x, double y, double b) {
    xx += x * x;
    xy += x * y;
    yy += y * y;
    xb += x * b;
    yb += y * b;
  }
  double first() const { return (xb * yy - yb * xy) / (xx * yy - xy * xy); }
  double second() const { return (yb * xx - xb * xy) / (xx * yy - xy * xy); }
};

}  // namespace

std::vector<FastSample> sampleFast(const sim::GroundParams& ground, int count, std::uint64_t seed) {
  sim::WalkingBody body(seed, {}, sim::BodyKind::fast, {}, ground);
  Random random(seed);
  std::vector<FastSample> samples;
  for (int i = 0; i < count; ++i) samples.push_back(walkedBy(body, drawn(i, random)));
  return samples;
}

sim::GroundParams fitGround(const std::vector<FastSample>& samples) {
  Ratio forward;
  Ratio back;
  TwoRatios left;
  TwoRatios turn;
  for (const auto& [walked, told] : samples) {
    (walked.forward < 0.0 ? back : forward).add(walked.forward, told.forward);
    left.add(walked.left, walked.turn, told.left);
    turn.add(walked.turn, walked.left, told.turn);
  }
  return {forward.value(), back.value(), left.first(), turn.first(), left.second(), turn.second()};
}

FastError errorOf(const std::vector<FastSample>& samples) {
  FastError sum;
  double way = 0.0;
  double turn = 0.0;
  for (const auto& [walked, told] : samples) {
    sum.way += std::hypot(walked.forward - told.forward, walked.left - told.left);
    sum.turn += std::fabs(walked.turn - told.turn);
    way += std::hypot(told.forward, told.left);
    turn += std::fabs(told.turn);
  }
  return {100.0 * sum.way / way, 100.0 * sum.turn / turn};
}

}  // namespace kelpie::learn
