// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/kick/KickTrial.h"

#include <cmath>

#include "actuator/MotionList.h"
#include "actuator/motion/MotionPlayer.h"
#include "robot/core/Random.h"
#include "tools/learn/motion/BallInHold.h"

namespace kelpie::learn {
namespace {

constexpr int kStandMessages = 20;  // before a free ball is put down
constexpr int kRestMessages = 4;    // and until the kick
constexpr int kAfterMessages = 18;  // 0.58 s, back to the stance
constexpr int kTurnMessages = 20;   // 0.64 s with a held ball
constexpr int kStopMessages = 9;    // 0.29 s until the kick
constexpr double kKept = 3.0;       // cm, a ball that has gone no further has not left

Point2<Robot> scattered(const KickAim& aim, Random& random) {
  return {aim.ball.x + random.uniform(-aim.scatter, aim.scatter),
          aim.ball.y + random.uniform(-aim.scatter, aim.scatter)};
}

constexpr double kLookDown = -20.0;  // deg of the neck, before a free ball is kicked

Command lookingDown() {
  Command command;
  command.head.neckTilt = Angle::deg(kLookDown);
  return command;
}

void stepOn(int messages, const Command& command, PhysicalWalker& walker) {
  for (int i = 0; i < messages; ++i) walker.step(command);
}

void putBallDown(Point2<Robot> place, PhysicalWalker& walker) {
  walker.bodies().putBall({fieldFromRobot(walker.pose(), place), {}});
  stepOn(kRestMessages, lookingDown(), walker);
}

// Walks against the robot and touches it as the kick begins.
std::optional<Opponent> pusher(bool held) {
  Opponent opponent;
  opponent.ahead = held ? 36.0 : 33.0;  // a held ball is given first
  opponent.command.walk.forward = 12.0;
  return opponent;
}

// As a player aims: the ball then lies up to 1 cm to the side, and the legs are not as they stood.
void turnWithBall(PhysicalWalker& walker, Random& random) {
  Command command = holdingCommand();
  const double speed = random.uniform(0.5, 2.3);  // rad/s; 130 deg/s is the fastest in matches
  command.walk.turn = random.chance(0.5) ? speed : -speed;
  stepOn(kTurnMessages, command, walker);
  command.walk.turn = 0.0;
  stepOn(kStopMessages, command, walker);
}

void readBall(KickStart& start) {
  start.ball = start.walker->bodies().ball().position;
  start.pose = start.walker->pose();
}

KickStart copyOf(const KickStart& other) {
  KickStart start;
  start.params = std::make_unique<actuator::ActuatorParams>(*other.params);
  start.walker = std::make_unique<PhysicalWalker>(*other.walker, *start.params);
  start.roll = other.roll;
  return start;
}

// A kick that may be done from the hold and from the carpet is learnt from there.
KickAim wished(MotionKind motion, const actuator::KickWish& wish) {
  const bool held = !actuator::listed(motion).free;
  const actuator::KickEffect& kick = actuator::standardMotions()[motion].kick;
  const Point2<Robot> lies{-kick.left, kick.ahead};
  return {motion,
          held,
          held ? Point2<Robot>{0.0, kHeldAhead} : lies,
          wish.scatter,
          wish.distance,
          Angle::deg(wish.min),
          Angle::deg(wish.max),
          static_cast<int>(wish.frames)};
}

}  // namespace

const std::vector<KickAim>& kicks() {
  static const std::vector<KickAim> all = [] {
    std::vector<KickAim> aims;
    for (std::uint8_t i = 0; i < kMotionKindCount; ++i) {
      const auto motion = static_cast<MotionKind>(i);
      const actuator::KickWish& wish = actuator::listed(motion).wish;
      if (wish.distance > 0.0) aims.push_back(wished(motion, wish));
    }
    return aims;
  }();
  return all;
}

KickAim mirrored(const KickAim& aim) {
  KickAim other = aim;
  other.motion = mirrored(aim.motion);
  other.ball.x = -aim.ball.x;
  other.min = -aim.max;
  other.max = -aim.min;
  return other;
}

const KickAim* findKick(MotionKind motion) {
  for (const KickAim& aim : kicks())
    if (aim.motion == motion) return &aim;
  return nullptr;
}

KickAim aimOf(const KickAim& aim, const actuator::MotionData& motion) {
  KickAim own = aim;
  if (!aim.held && motion.kick.distance > 0.0) own.ball = {-motion.kick.left, motion.kick.ahead};
  return own;
}

// dv/dt = -(drag v + roll).
Point2<Field> restingPlace(const sim::Ball& ball, const sim::PhysicalBallParams& roll) {
  const double v = 0.01 * ball.velocity.norm();
  if (v <= 0.0) return ball.position;
  const double way =
      (v - roll.roll / roll.drag * std::log1p(roll.drag * v / roll.roll)) / roll.drag;
  return ball.position + ball.velocity * (way / v);
}

KickStart beforeKick(const KickAim& aim, const sim::PhysicsParams& model, std::uint64_t seed,
                     BeforeKick before) {
  const bool pushed = before == BeforeKick::pushed;
  Random random(seed ^ 0x61c4ULL);
  KickStart start;
  start.params = std::make_unique<actuator::ActuatorParams>();
  start.walker = std::make_unique<PhysicalWalker>(model, *start.params, seed,
                                                  pushed ? pusher(aim.held) : std::nullopt);
  PhysicalWalker& walker = *start.walker;
  const Point2<Robot> place = scattered(aim, random);
  if (aim.held) giveBall(place, walker);
  if (aim.held && before == BeforeKick::turned) turnWithBall(walker, random);
  if (!aim.held) {
    stepOn(kStandMessages, lookingDown(), walker);
    putBallDown(place, walker);
  }
  start.roll = model.ball;
  readBall(start);
  return start;
}

KickStart standingStart(const sim::PhysicsParams& model, std::uint64_t seed) {
  KickStart start;
  start.params = std::make_unique<actuator::ActuatorParams>();
  start.walker = std::make_unique<PhysicalWalker>(model, *start.params, seed);
  stepOn(kStandMessages, lookingDown(), *start.walker);
  start.roll = model.ball;
  readBall(start);
  return start;
}

KickStart walkingStart(const KickStart& standing, const WalkRequest& walk, int messages) {
  KickStart start = copyOf(standing);
  Command command = lookingDown();
  command.walk = walk;
  stepOn(messages, command, *start.walker);
  readBall(start);
  return start;
}

KickStart withBallAt(Point2<Robot> place, const KickStart& standing) {
  KickStart start = copyOf(standing);
  putBallDown(place, *start.walker);
  readBall(start);
  return start;
}

KickStart withBallJustAt(Point2<Robot> place, const KickStart& before) {
  KickStart start = copyOf(before);
  start.walker->bodies().putBall({fieldFromRobot(start.walker->pose(), place), {}});
  readBall(start);
  return start;
}

Kicked tryKick(const actuator::MotionData& motion, MotionKind kind, const KickStart& start) {
  actuator::ActuatorParams params = *start.params;
  params.motions[kind] = motion;
  PhysicalWalker walker(*start.walker, params);
  Command command;
  command.motion = kind;
  const int messages = static_cast<int>(ticksOf(motion) / kTicksPerMessage) + 1 + kAfterMessages;
  Kicked kicked;
  for (int i = 0; i < messages && !kicked.fell; ++i) {
    kicked.way += walkOn(walker, command);
    kicked.fell = walker.fallen();
  }
  if (walker.failed()) return kicked;
  const Point2<Field> whole = restingPlace(walker.bodies().ball(), start.roll) - start.ball;
  kicked.distance = whole.norm();
  kicked.direction = Angle::rad(maths::atan2(whole.y, whole.x)) - start.pose.heading;
  kicked.left = kicked.distance > kKept;
  return kicked;
}

}  // namespace kelpie::learn
