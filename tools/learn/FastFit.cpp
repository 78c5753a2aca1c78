// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/FastFit.h"

#include <cmath>

#include "tools/sim/WalkingBody.h"

namespace kelpie::learn {
namespace {

using actuator::Velocity;

constexpr int kStart = 36;     // messages until the speed is even
constexpr int kMeasured = 40;  // 1.3 s: it must not come to a wall
constexpr double kSeconds = kMeasured * kTicksPerMessage * kTickSeconds;

Velocity walkedBy(sim::WalkingBody& body, const Velocity& feet) {
  Command command;
  command.walk = {feet.forward, feet.left, feet.turn, 0.0, WalkKind::normal};
  (void)body.world().carry(0, {{180.0, 270.0}, Angle::deg(90.0)});
  for (int i = 0; i < kStart; ++i) body.step(command);
  Velocity sum;
  for (int i = 0; i < kMeasured; ++i) {
    const Pose2 last = body.pose();
    body.step(command);
    const Point2<Robot> moved = robotFromField(last, body.pose().position);
    sum = {sum.forward + moved.y / kSeconds, sum.left - moved.x / kSeconds,
           sum.turn + (body.pose().heading - last.heading).rad() / kSeconds};
  }
  return sum;
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

std::vector<Velocity> kinematicSpeeds(const std::vector<SpeedSample>& samples,
                                      const sim::GroundParams& ground, std::uint64_t seed) {
  actuator::ActuatorParams params;
  params.walks.normal.calibration = {};
  sim::WalkingBody body(seed, params, sim::BodyKind::fast, {}, ground);
  std::vector<Velocity> walked;
  for (const SpeedSample& sample : samples) walked.push_back(walkedBy(body, sample.feet));
  return walked;
}

sim::GroundParams fitGround(const std::vector<SpeedSample>& samples,
                            const std::vector<Velocity>& walked) {
  Ratio forward;
  Ratio back;
  TwoRatios left;
  TwoRatios turn;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Velocity& real = samples[i].real;
    const Velocity& by = walked[i];
    (by.forward < 0.0 ? back : forward).add(by.forward, real.forward);
    left.add(by.left, by.turn, real.left);
    turn.add(by.turn, by.left, real.turn);
  }
  return {forward.value(), back.value(), left.first(), turn.first(), left.second(), turn.second()};
}

}  // namespace kelpie::learn
