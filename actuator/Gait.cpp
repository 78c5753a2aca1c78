// SPDX-License-Identifier: Apache-2.0
#include "actuator/Gait.h"

#include <cmath>

#include "robot/body/Legs.h"

namespace kelpie::actuator {
namespace {

constexpr double kTick = kTickSeconds;
constexpr double kAtHome = 0.15;  // cm; nearer than this a foot need not step again

// The pair that swings in the first half step.
bool isFirstPair(LegId leg) { return leg == LegId::leftFront || leg == LegId::rightHind; }

double finite(double value) { return std::isfinite(value) ? value : 0.0; }

// Speed of the ground below a point of the robot frame, seen from the robot, with the sign turned.
Point2<Robot> groundVelocity(const Velocity& v, Point2<Robot> at) {
  return {-v.left - v.turn * at.y, v.forward + v.turn * at.x};
}

// One pair is always down.
std::uint32_t swingTicks(const GaitParams& gait) {
  return gait.swingTicks < gait.halfStepTicks ? gait.swingTicks : gait.halfStepTicks;
}

double stanceSeconds(const GaitParams& gait) {
  return kTick * static_cast<double>(2 * gait.halfStepTicks - swingTicks(gait));
}

// Share of the request that no foot's ground stroke is too long for.
double affordable(const Velocity& target, const ActuatorParams& params) {
  double longest = 0.0;
  for (std::size_t leg = 0; leg < kLegCount; ++leg) {
    const Point3<Robot> home = footHome(static_cast<LegId>(leg), params.stance);
    longest = std::fmax(longest, groundVelocity(target, {home.x, home.y}).norm());
  }
  const double stroke = longest * stanceSeconds(params.gait);
  return stroke > params.gait.maxStroke ? params.gait.maxStroke / stroke : 1.0;
}

double approach(double now, double target, double most) {
  return now + maths::clamp(target - now, -most, most);
}

// How far a leg's swing has come, 0..1; negative while it is on the ground.
double swingPhase(LegId leg, const GaitState& state, const GaitParams& gait) {
  const std::uint32_t start = isFirstPair(leg) ? 0 : gait.halfStepTicks;
  if (state.standing || state.tick < start || state.tick >= start + swingTicks(gait)) return -1.0;
  return static_cast<double>(state.tick - start + 1) / static_cast<double>(swingTicks(gait));
}

// Where a place on the ground is one tick later: carried backwards under the body, turned against
// the body's turn.
Point2<Robot> carried(Point2<Robot> at, const Velocity& v) {
  const maths::SinCos turn = maths::sinCos(-v.turn * kTick);
  const Point2<Robot> moved{at.x + v.left * kTick, at.y - v.forward * kTick};
  return {turn.cos * moved.x - turn.sin * moved.y, turn.sin * moved.x + turn.cos * moved.y};
}

void carry(Foot& foot, const Velocity& v) {
  const Point2<Robot> moved = carried({foot.position.x, foot.position.y}, v);
  foot.position = {moved.x, moved.y, 0.0};
}

// Share of the way at a share of the time: constant speed but for the first and last quarter.
double flown(double phase) {
  constexpr double kEase = 0.25;
  const double early = phase < 0.5 ? phase : 1.0 - phase;
  const double part = early < kEase ? early * early / (2.0 * kEase) : early - 0.5 * kEase;
  return (phase < 0.5 ? part : 1.0 - kEase - part) / (1.0 - kEase);
}

// A foot in the air goes from the place it left to the place where it will land, both moving with
// the ground, so that it hardly slides while it is still low (measured with feet that carry below
// 0.4 cm: 6 % of the way is lost, 23 % when it starts from rest in the body's frame). The lift is a
// parabola: a steeper one asks the knee for over 4 deg a tick and the foot lands late.
void swing(LegId leg, double phase, const ActuatorParams& params, GaitState& state) {
  Foot& foot = state.feet[index(leg)];
  const double ticks = swingTicks(params.gait);
  if (phase * ticks < 1.5) foot.liftedAt = {foot.position.x, foot.position.y};
  foot.liftedAt = carried(foot.liftedAt, state.velocity);
  const Point3<Robot> home = footHome(leg, params.stance);
  const double early = 0.5 * stanceSeconds(params.gait) + (1.0 - phase) * ticks * kTick;
  const Point2<Robot> ahead = groundVelocity(state.velocity, {home.x, home.y}) * early;
  const double way = flown(phase);
  const double peak = body::isFront(leg) ? params.gait.frontLift : params.gait.hindLift;
  foot.position = {foot.liftedAt.x + way * (home.x + ahead.x - foot.liftedAt.x),
                   foot.liftedAt.y + way * (home.y + ahead.y - foot.liftedAt.y),
                   peak * 4.0 * phase * (1.0 - phase)};
}

bool feetAtHome(const GaitState& state, const StanceParams& stance) {
  for (std::size_t leg = 0; leg < kLegCount; ++leg) {
    const Point3<Robot> d = state.feet[leg].position - footHome(static_cast<LegId>(leg), stance);
    if (maths::hypot(d.x, d.y) > kAtHome) return false;
  }
  return true;
}

bool still(const Velocity& v) { return v.forward == 0.0 && v.left == 0.0 && v.turn == 0.0; }

void placeFeet(const StanceParams& stance, GaitState& state) {
  for (std::size_t leg = 0; leg < kLegCount; ++leg)
    state.feet[leg].position = footHome(static_cast<LegId>(leg), stance);
  state.placed = true;
}

}  // namespace

Point3<Robot> footHome(LegId leg, const StanceParams& stance) {
  const bool left = leg == LegId::leftFront || leg == LegId::leftHind;
  const double aside = body::isFront(leg) ? stance.frontAside : stance.hindAside;
  return {left ? -aside : aside, body::isFront(leg) ? stance.frontAhead : -stance.hindBehind, 0.0};
}

Velocity slewed(const Velocity& now, const WalkRequest& request, const ActuatorParams& params) {
  const Velocity target{maths::clamp(finite(request.forward), -30.0, 42.0),
                        maths::clamp(finite(request.left), -20.0, 20.0),
                        maths::clamp(finite(request.turn), -3.8, 3.8)};
  const double share = affordable(target, params);
  const double most = params.gait.acceleration * kTick;
  return {approach(now.forward, share * target.forward, most),
          approach(now.left, share * target.left, most),
          approach(now.turn, share * target.turn, params.gait.turnAcceleration * kTick)};
}

void stepGait(const WalkRequest& request, const ActuatorParams& params, GaitState& state) {
  if (!state.placed) placeFeet(params.stance, state);
  state.velocity = slewed(state.velocity, request, params);
  const bool boundary = state.tick % params.gait.halfStepTicks == 0;
  if (boundary) state.standing = still(state.velocity) && feetAtHome(state, params.stance);
  if (state.standing) {
    state.velocity = {};  // feet that do not step cannot carry the body on
    return;
  }
  for (std::size_t leg = 0; leg < kLegCount; ++leg) {
    const double phase = swingPhase(static_cast<LegId>(leg), state, params.gait);
    if (phase < 0.0)
      carry(state.feet[leg], state.velocity);
    else
      swing(static_cast<LegId>(leg), phase, params, state);
  }
  state.tick = (state.tick + 1) % (2 * params.gait.halfStepTicks);
}

void legsForFeet(const GaitState& state, const StanceParams& params, JointAngles& joints) {
  const Stance stance{params.shoulderHeight, params.bodyTilt};
  for (std::size_t i = 0; i < kLegCount; ++i) {
    const auto leg = static_cast<LegId>(i);
    const Point3<Torso> foot = body::torsoFromRobot(stance, state.feet[i].position);
    body::setLegAngles(joints, leg, body::reachFoot(leg, foot).angles);
  }
}

}  // namespace kelpie::actuator
