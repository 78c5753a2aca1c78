// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/views/View.h"

#include <algorithm>
#include <cmath>

#include "gps/camera/Tilt.h"
#include "robot/body/Camera.h"
#include "tools/sim/bodies/BodyShape.h"
#include "tools/sim/bodies/KinematicBodies.h"

namespace kelpie::experiments {
namespace {

constexpr int kViewsPerCrowd = 25;
constexpr int kTries = 60;
constexpr double kJointNoise = 0.0015;    // rad, as tools/sim/bodies/RobotModel.h
constexpr double kHeightNoise = 0.1;      // cm, of the stance that the legs tell
constexpr double kTiltNoiseDeg = 0.2;     // the same for the body's tilt
constexpr double kRateNoise = 0.1;        // rad/s, joint noise over three ticks
constexpr double kTurnNoise = 0.006;      // rad a frame, of the odometry
constexpr double kFastestPanDeg = 150.0;  // deg/s, a scanning head
constexpr double kFastestTiltDeg = 60.0;
constexpr double kFastestTurnDeg = 60.0;
constexpr std::uint64_t kLooksStream = 0x6c6f6f6b73;
constexpr std::uint64_t kPlayStream = 0x706c6179;
constexpr std::uint64_t kLeanStream = 0x6c65616e;

bool awayFrom(const std::vector<sim::RobotLook>& robots, Point2<Field> place, double minDistance) {
  return std::all_of(robots.begin(), robots.end(), [&](const sim::RobotLook& robot) {
    return distance(fieldFromRobot(robot.pose, {0.0, -4.0}), place) >= minDistance;
  });
}

Angle randomDeg(Random& random, double low, double high) {
  return Angle::deg(random.uniform(low, high));
}

}  // namespace

ViewMaker::ViewMaker(const ViewParams& params, std::uint64_t seed)
    : params_(params),
      random_(seed),
      looks_(seed ^ kLooksStream),
      play_(seed ^ kPlayStream),
      lean_(seed ^ kLeanStream),
      seed_(seed) {}

const View& ViewMaker::next() {
  if (made_++ % kViewsPerCrowd == 0) {
    const sim::Venue venue =
        sim::drawRandomisedVenue(params_.randomised, seed_ + static_cast<std::uint64_t>(made_));
    brightness_ = venue.brightness;
    view_.scene = sim::fieldScene(params_.field, params_.crowd ? random_.next() | 1U : 0, venue);
  }
  view_.real =
      sim::drawRandomisedRobot(params_.randomised, seed_ + static_cast<std::uint64_t>(made_), 0);
  claimTilt();
  view_.robotCamera = {sim::randomShift(random_),
                       sim::randomCentres(looks_, params_.camera.artefacts.centreSd),
                       view_.real.tone, brightness_, view_.real.noise};
  const auto kind = random_.index(10);
  view_.target = kind < 4   ? ViewTarget::ball
                 : kind < 8 ? ViewTarget::landmark
                 : kind < 9 ? ViewTarget::robot
                            : ViewTarget::anywhere;
  placeThings();
  turnAndRender();
  return view_;
}

void ViewMaker::claimTilt() {
  const TiltClaim& claim = params_.tilt;
  double sd = claim.sd;
  if (claim.drawnTo > 0.0) {
    sd = claim.drawnFrom * std::pow(claim.drawnTo / claim.drawnFrom, lean_.uniform());
    sim::Lean& lean = view_.real.body.lean;
    lean.tilt = lean.tilt + Angle::deg(lean_.gaussian(0.0, sd));
    lean.roll = lean.roll + Angle::deg(lean_.gaussian(0.0, sd));
  }
  // No robot is informed of how it leans: it knows as much as after it is switched on.
  claimed_ = view_.real.body.lean.level() ? CameraTilt{} : gps::startingTilt({});
  if (sd > 0.0) claimed_.tiltVariance = claimed_.rollVariance = maths::square(Angle::deg(sd).rad());
}

// The robot anywhere on the field, the ball before it and inside the lines.
void ViewMaker::placeThings() {
  const auto& field = params_.field;
  view_.pose = {
      {random_.uniform(10.0, field.width - 10.0), random_.uniform(10.0, field.length - 10.0)},
      randomDeg(random_, -180.0, 180.0)};
  stance_ = {random_.uniform(8.5, 11.0), randomDeg(random_, 8.0, 16.0), {}};
  for (int i = 0; i < kTries; ++i) {
    const auto place = robotPolar(random_.uniform(params_.nearestBall, params_.farthestBall),
                                  randomDeg(random_, -85.0, 85.0));
    view_.ball = fieldFromRobot(view_.pose, place);
    if (view_.ball.x > 0.0 && view_.ball.x < field.width && view_.ball.y > 0.0 &&
        view_.ball.y < field.length)
      break;
  }
  placeRobots();
  view_.scene.balls.clear();
  if (params_.ball) sim::setBall(view_.scene, view_.ball);
  sim::setRobots(view_.scene, view_.robots);

  Point3<Field> target{view_.ball.x, view_.ball.y, body::kBallRadius};
  if (view_.target == ViewTarget::landmark) {
    const auto& mark =
        field.landmarks[random_.index(static_cast<std::uint32_t>(field.landmarks.size()))];
    target = {mark.position.x, mark.position.y, 20.0};
  } else if (view_.target == ViewTarget::robot && !view_.robots.empty()) {
    target = {view_.robots[0].pose.position.x, view_.robots[0].pose.position.y, 10.0};
  } else if (view_.target == ViewTarget::anywhere) {
    target = {random_.uniform(0.0, field.width), random_.uniform(0.0, field.length), 0.0};
  }
  lookAt(target);
  standOnLegs();
}

// Some before the robot, some in a goal's mouth, some beside the ball, the rest anywhere.
void ViewMaker::placeRobots() {
  const auto& field = params_.field;
  view_.robots.clear();
  const auto wanted = random_.index(static_cast<std::uint32_t>(params_.maxRobots) + 1);
  for (int i = 0; i < kTries && view_.robots.size() < wanted; ++i) {
    sim::RobotLook look;
    look.team = random_.chance(0.5) ? TeamColour::red : TeamColour::blue;
    look.shoulderHeight = random_.uniform(8.5, 11.0);
    look.pose.heading = randomDeg(random_, -180.0, 180.0);
    const double kind = random_.uniform();
    if (kind < 0.4) {
      look.pose.position = fieldFromRobot(
          view_.pose, robotPolar(random_.uniform(30.0, 250.0), randomDeg(random_, -80.0, 80.0)));
    } else if (kind < 0.65) {
      const double out = random_.uniform(-5.0, 40.0);
      const double across = field.width / 2 + random_.uniform(-35.0, 35.0);
      const bool own = random_.chance(0.5);
      look.pose = {{across, own ? out : field.length - out},
                   randomDeg(random_, own ? 50.0 : -130.0, own ? 130.0 : -50.0)};
    } else {
      look.pose.position = {random_.uniform(0.0, field.width), random_.uniform(0.0, field.length)};
    }
    const Point2<Field> middle = fieldFromRobot(look.pose, {0.0, -4.0});
    const bool inside = middle.x > -10.0 && middle.x < field.width + 10.0 && middle.y > 0.0 &&
                        middle.y < field.length;
    if (inside && distance(middle, view_.pose.position) > 38.0 &&
        distance(middle, view_.ball) > 24.0 && awayFrom(view_.robots, middle, 36.0)) {
      look.shine = looks_.next();
      look.uniform = sim::drawRandomisedRobot(params_.randomised, look.shine, 0).uniform;
      view_.robots.push_back(look);
    }
  }
}

// Head joints that bring the target to a random place in the image.
void ViewMaker::lookAt(Point3<Field> target) {
  const Point2<Robot> ground = robotFromField(view_.pose, {target.x, target.y});
  const Angle towards = bearing(ground);
  for (int i = 0; i < 4 * kTries; ++i) {
    joints_ = {};
    joints_[Joint::neckTilt] = randomDeg(random_, -60.0, 0.0);
    joints_[Joint::headNod] = randomDeg(random_, -15.0, 45.0);
    const double pan = towards.deg() + random_.uniform(-30.0, 30.0);
    joints_[Joint::headPan] = Angle::deg(maths::clamp(pan, -88.0, 88.0));
    view_.camera = body::cameraPose(joints_, stance_);
    const auto pixel = body::project(view_.camera, {ground.x, ground.y, target.z});
    if (pixel && pixel->x > 8.0 && pixel->x < kImageWidth - 8.0 && pixel->y > 8.0 &&
        pixel->y < kImageHeight - 8.0)
      return;
  }
}

// Front feet somewhere in their stroke (actuator/ActuatorParams.h).
void ViewMaker::standOnLegs() {
  constexpr double kLateral = 9.5;
  constexpr double kAhead = 2.0;
  constexpr double kHalfStroke = 2.9;
  const double left = kAhead + looks_.uniform(-kHalfStroke, kHalfStroke);
  const double right = kAhead + looks_.uniform(-kHalfStroke, kHalfStroke);
  sim::setFrontFeet(joints_, stance_, {Point2<Robot>{-kLateral, left}, {kLateral, right}});
  view_.scene.own = sim::frontLegs({view_.pose, stance_, joints_, {}});
}

// A head that turns is at the end of its gears' play that lies behind; one that is still hangs
// forward, and its pan is anywhere.
JointAngles ViewMaker::inPlay(const HeadRate& rate) {
  const sim::NeckPlay& play = view_.real.body.play;
  JointAngles joints = joints_;
  const double anywhere = play_.uniform(-0.5, 0.5);
  const double pan = rate.headPan == 0.0 ? anywhere : rate.headPan > 0.0 ? -0.5 : 0.5;
  const double nod = rate.headNod < 0.0 ? 0.5 : -0.5;
  joints[Joint::neckTilt] = joints[Joint::neckTilt] - play.neckTilt * 0.5;
  joints[Joint::headPan] = joints[Joint::headPan] + play.headPan * pan;
  joints[Joint::headNod] = joints[Joint::headNod] + play.headNod * nod;
  return joints;
}

// The camera `late` seconds after the image's stamp; leaves it in view_.camera too.
sim::FieldCamera ViewMaker::exposed(const HeadRate& rate, double turn, double late) {
  JointAngles joints = head_;
  joints[Joint::headPan] = joints[Joint::headPan] + Angle::rad(rate.headPan * late);
  joints[Joint::headNod] = joints[Joint::headNod] + Angle::rad(rate.headNod * late);
  const Pose2 pose{view_.pose.position, view_.pose.heading + Angle::rad(turn * late)};
  view_.camera = sim::trueCamera({pose, stance_, joints, view_.real.body.lean});
  return sim::fieldCamera(pose, view_.camera, view_.real.lens);
}

// Exposes the columns one after the other while head and body turn; then what the sensors tell.
void ViewMaker::turnAndRender() {
  HeadRate rate;
  if (random_.chance(params_.headTurning)) {
    rate.headPan = randomDeg(random_, -kFastestPanDeg, kFastestPanDeg).rad();
    rate.headNod = randomDeg(random_, -kFastestTiltDeg, kFastestTiltDeg).rad();
  }
  double turn = 0.0;
  if (random_.chance(params_.bodyTurning))
    turn = randomDeg(random_, -kFastestTurnDeg, kFastestTurnDeg).rad();
  head_ = inPlay(rate);
  for (std::size_t x = 0; x < kImageWidth; ++x) {
    const double share = sim::exposedAt(x, view_.real.readout) - 0.5 - view_.real.lag;
    view_.columns[x] = exposed(rate, turn, share * kFrameSeconds);
  }
  view_.eye = exposed(rate, turn, -view_.real.lag * kFrameSeconds);
  FrameInput& input = view_.input;
  input = {};
  input.elapsed = kFrameSeconds;
  input.cameraTilt = claimed_;
  input.sensors.joints = joints_;
  const double old = view_.real.jointsLag * kFrameSeconds;
  JointAngles& told = input.sensors.joints;
  told[Joint::headPan] = told[Joint::headPan] - Angle::rad(rate.headPan * old);
  told[Joint::headNod] = told[Joint::headNod] - Angle::rad(rate.headNod * old);
  for (auto& angle : input.sensors.joints.angle)
    angle = angle + Angle::rad(random_.gaussian(0.0, kJointNoise));
  input.sensors.acceleration = sim::accelerationAtRest(stance_, view_.real.body);

  input.headRate = {0.0, rate.headPan + random_.gaussian(0.0, kRateNoise),
                    rate.headNod + random_.gaussian(0.0, kRateNoise)};
  input.stance = {stance_.shoulderHeight + random_.gaussian(0.0, kHeightNoise),
                  stance_.bodyTilt + Angle::deg(random_.gaussian(0.0, kTiltNoiseDeg)),
                  {}};
  if (turn != 0.0)
    input.odometry.turn = Angle::rad(turn * kFrameSeconds + random_.gaussian(0.0, kTurnNoise));
  sim::Camera camera(params_.camera, view_.robotCamera);
  camera.render(view_.scene, view_.columns, random_, input.image);
}

}  // namespace kelpie::experiments
