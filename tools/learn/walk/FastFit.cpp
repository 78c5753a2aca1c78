// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/walk/FastFit.h"

#include <cmath>

#include "robot/core/Random.h"
#include "tools/sim/bodies/WalkingBody.h"

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
    case 0: return {share * 34.0, 0.0, 0.0};
    case 1: return {-share * 34.0, 0.0, 0.0};
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
  sample.asked = {request.forward, request.left, request.turn};
  for (int i = 0; i < kMeasured; ++i) {
    const Pose2 last = body.pose();
    body.step(command);
    const Point2<Robot> moved = robotFromField(last, body.pose().position);
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

}  // namespace

std::vector<FastSample> sampleFast(const sim::GroundParams& ground, int count, std::uint64_t seed) {
  sim::WalkingBody body(seed, {}, sim::BodyKind::fast, {}, ground);
  Random random(seed);
  std::vector<FastSample> samples;
  samples.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) samples.push_back(walkedBy(body, drawn(i, random)));
  return samples;
}

sim::GroundParams fitGround(const std::vector<FastSample>& samples) {
  Ratio forward;
  Ratio left;
  Ratio turn;
  for (const auto& [walked, asked] : samples) {
    forward.add(walked.forward, asked.forward);
    left.add(walked.left, asked.left);
    turn.add(walked.turn, asked.turn);
  }
  return {forward.value(), left.value(), turn.value()};
}

FastError errorOf(const std::vector<FastSample>& samples) {
  FastError sum;
  double way = 0.0;
  double turn = 0.0;
  for (const auto& [walked, asked] : samples) {
    sum.way += std::hypot(walked.forward - asked.forward, walked.left - asked.left);
    sum.turn += std::fabs(walked.turn - asked.turn);
    way += std::hypot(asked.forward, asked.left);
    turn += std::fabs(asked.turn);
  }
  return {100.0 * sum.way / way, 100.0 * sum.turn / turn};
}

}  // namespace kelpie::learn
