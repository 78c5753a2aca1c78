// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/bodies/RobotModel.h"

#include <algorithm>
#include <cmath>

namespace kelpie::sim {
namespace {

constexpr int kHandStays = 25;  // ticks that a hand needs to let go: 0.2 s [chosen]
constexpr std::uint64_t kFeltStream = 0x6c656773;

bool isLeg(std::size_t joint) {
  return joint >= index(Joint::leftFrontRotator) && joint <= index(Joint::rightHindKnee);
}

// Of what feet roll in a tick: half of what the slowest walk that is asked for does.
bool walks(const PlanarMotion& rolled) {
  constexpr double kWay = 0.01;    // cm
  constexpr double kTurn = 0.001;  // rad
  return maths::hypot(rolled.x, rolled.y) > kWay || std::fabs(rolled.turn) > kTurn;
}

std::size_t legOf(std::size_t joint) { return (joint - index(Joint::leftFrontRotator)) / 3; }

}  // namespace

RobotModel::RobotModel(const RobotParams& params, const Pose2& start, std::uint64_t seed,
                       const BodyFaults& faults)
    : params_(params),
      random_(seed),
      resistance_(params.resistance, seed ^ kFeltStream),
      faults_(faults),
      neck_(faults.play),
      motors_(startingPose()),
      queue_(motors_) {
  place_.pose = start;
  place_.lean = faults.lean;
  place_.joints = neck_.step(motors_);
  place_.stance = body::stanceFromLegs(place_.joints);

  before_ = place_;
  sensed_ = motors_;
  onGround_ = standingLegs();
  (void)rolled();
}

double RobotModel::slowed(std::size_t joint) const {
  const double lag = isLeg(joint) ? params_.lagTicks / legGain() : params_.lagTicks;
  const double share = lag > 0.0 ? 1.0 - maths::exp(-1.0 / lag) : 1.0;
  const bool stands = isLeg(joint) && onGround_[legOf(joint)];
  return stands ? share * (1.0 - resistance_.slowed()) : share;
}

void RobotModel::moveJoints() {
  for (std::size_t j = 0; j < kJointCount; ++j) {
    if (!queue_.held(j)) continue;
    const bool head = j < index(Joint::leftFrontRotator);
    const double max = (head ? params_.headRate : params_.legRate) * kTickSeconds;
    const double now = motors_.angle[j].rad();
    const double step = slowed(j) * (target().angle[j].rad() - now);
    motors_.angle[j] = Angle::rad(now + maths::clamp(step, -max, max));
  }
  place_.joints = neck_.step(motors_);
}

void RobotModel::senseJoints() {
  for (std::size_t j = 0; j < kJointCount; ++j) {
    const double noise = random_.gaussian(0.0, params_.jointNoiseSd);
    sensed_.angle[j] = Angle::rad(motors_.angle[j].rad() + noise);
    dutyNoise_[j] = resistance_.dutyNoise();
  }
}

// A new step has a new slip; it begins when a foot comes down.
void RobotModel::drawSlip(const std::array<bool, kLegCount>& standing) {
  bool landed = false;
  for (std::size_t i = 0; i < kLegCount; ++i) landed = landed || (standing[i] && !onGround_[i]);
  if (!landed) return;
  slipForward_ = random_.gaussian(params_.slipMean, params_.slipSd);
  lateralSlip_ = random_.gaussian(params_.slipMean, params_.slipSd);
  slipTurn_ = random_.gaussian(params_.slipMean, params_.slipSd);
  drift_ = random_.gaussian(0.0, params_.driftSd);
  resistance_.newStep();
}

PlanarMotion RobotModel::onCarpet(const PlanarMotion& walked) const {
  const GroundParams& p = params_.ground;
  return {p.left * walked.x, p.forward * walked.y, p.turn * walked.turn};
}

PlanarMotion RobotModel::given(const PlanarMotion& walked) const {
  const bool weak = legGain() < params_.weak.below;
  const double free = 1.0 - resistance_.held();
  if (!weak) return {free * walked.x, free * walked.y, free * walked.turn};
  return {free * params_.weak.left * walked.x, free * params_.weak.forward * walked.y,
          free * params_.weak.turn * walked.turn};
}

// Those whose paws are on the ground, or nearly.
std::array<bool, kLegCount> RobotModel::standingLegs() const {
  std::array<bool, kLegCount> standing{};
  for (std::size_t i = 0; i < kLegCount; ++i) {
    const body::Support paw = body::supportOf(i, place_.joints);
    const double height = body::robotFromTorso(place_.stance, paw.middle).z - paw.radius;
    standing[i] = height < params_.contactHeight;
  }
  return standing;
}

// As far as the paws and cowls on the ground roll; in the air none does.
PlanarMotion RobotModel::rolled() {
  SensorFrame legs;
  legs.joints = place_.joints;
  const PlanarMotion motion = actuator::stepFootMotion(legs, rolling_);
  return lifted_ > 0.0 ? PlanarMotion{} : motion;
}

void RobotModel::moveBody() {
  place_.stance = body::stanceFromLegs(place_.joints);
  place_.stance.shoulderHeight += lifted_;
  const std::array<bool, kLegCount> standing = standingLegs();
  drawSlip(standing);
  const PlanarMotion motion = given(onCarpet(rolled()));
  const Stride& stride = faults_.stride;
  const double x = stride.share * motion.x * (1.0 - lateralSlip_);
  const double y = stride.share * motion.y * (1.0 - slipForward_);
  const double bias = walks(motion) ? stride.turn.rad() * kTickSeconds / kFrameSeconds : 0.0;
  const double turn =
      stride.share * motion.turn * (1.0 - slipTurn_) + drift_ * maths::hypot(x, y) + bias;
  const Point2<Field> was = place_.pose.position;
  place_.pose.position = fieldFromRobot(place_.pose, {x, y});
  walked_ = place_.pose.position - was;
  place_.pose.heading = place_.pose.heading + Angle::rad(turn);
  onGround_ = standing;
}

void RobotModel::tick() {
  before_ = place_;
  handTicks_ = std::max(0, handTicks_ - 1);
  resistance_.feel(walked_, pushed_);
  pushed_ = {};
  queue_.play();
  moveJoints();
  moveBody();
  senseJoints();
}

std::array<BodySphere, 9> RobotModel::spheres() const {
  const BodyParts was = bodyParts(before_);
  const BodyParts is = bodyParts(place_);
  std::array<BodySphere, 9> spheres;
  for (std::size_t i = 0; i < spheres.size(); ++i)
    spheres[i] = {was[i].centre, is[i].centre, is[i].radius};
  return spheres;
}

void RobotModel::carry(const Pose2& pose) {
  before_.pose = place_.pose = pose;
  handTicks_ = kHandStays;
}

Touch RobotModel::touched() const {
  Touch touch = touch_;
  touch.back[1] = touch.back[1] || lifted_ > 0.0 || handTicks_ > 0;
  return touch;
}

}  // namespace kelpie::sim
