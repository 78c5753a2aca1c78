// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/pose/PixelWalk.h"

#include <algorithm>
#include <cmath>

#include "gps/Localiser.h"
#include "gps/camera/Lag.h"
#include "gps/camera/Tilt.h"
#include "tools/sim/bodies/KinematicBodies.h"
#include "tools/sim/bodies/Sensors.h"

namespace kelpie::experiments {
namespace {

constexpr double kStep = 0.7;           // cm a frame
constexpr double kOscillation = 0.008;  // rad a frame
// As tools/experiments/views/View.cpp has them.
constexpr double kJointNoise = 0.0015;  // rad
constexpr double kHeightNoise = 0.1;    // cm
constexpr double kTiltNoiseDeg = 0.2;
constexpr double kRateNoise = 0.1;  // rad/s
const Stance kStance{10.0, Angle::deg(14.25), {}};
const Angle kNod = Angle::deg(5.0);  // the horizon is in the upper third of the image
constexpr double kNeutral = 128.0;   // of Cr and Cb
constexpr double kColoured = 20.0;   // levels off neutral: carpet and grey things have less

double turnAt(double frame) { return kOscillation * std::sin(frame / 20.0); }

// Looks left and right once in two seconds.
double panAt(double frame) { return 1.2 * std::sin(2.0 * maths::kPi * frame / 60.0); }

double panRate(double frame) {
  return 1.2 * 2.0 * maths::kPi / 60.0 * std::cos(2.0 * maths::kPi * frame / 60.0) / kFrameSeconds;
}

JointAngles headAt(double frame) {
  JointAngles joints;
  joints[Joint::headPan] = Angle::rad(panAt(frame));
  joints[Joint::headNod] = kNod;
  return joints;
}

bool isGoal(const body::Landmark& mark) {
  return mark.kind == LandmarkKind::goalBlue || mark.kind == LandmarkKind::goalYellow;
}

// The field as it stands there, which the robot is not told.
body::FieldDescription spoiltField(const body::FieldDescription& field, const Spoil& spoil,
                                   Point2<Field> end) {
  const body::Landmark* nearest = nullptr;
  for (const body::Landmark& mark : field.landmarks)
    if (!isGoal(mark) &&
        (!nearest || distance(mark.position, end) < distance(nearest->position, end)))
      nearest = &mark;
  body::FieldDescription real = field;
  real.landmarks.clear();
  for (body::Landmark mark : field.landmarks) {
    const bool spoilt = nearest && mark.kind == nearest->kind;
    if (spoilt) mark.position.y += spoil.beaconAside;
    if (!spoilt || !spoil.beaconAbsent) real.landmarks.push_back(mark);
  }
  return real;
}

std::uint8_t level(double value) {
  return static_cast<std::uint8_t>(std::lround(maths::clamp(value, 0.0, 255.0)));
}

bool ofALandmark(double cr, double cb) {
  const bool yellow = cb < -kColoured && cr < kColoured && cr > -kColoured;
  const bool blue = cb > kColoured && cr < kColoured;
  const bool pink = cr > kColoured && cb > -kColoured;
  return yellow || blue || pink;
}

void spoilImage(const Spoil& spoil, Random& random, Image& image) {
  const bool landmarks = spoil.landmarkColour != 1.0;
  for (std::size_t i = 0; i < kImagePixels; ++i) {
    double y = image.y[i] * spoil.light;
    double cr = (image.cr[i] - kNeutral) * spoil.light * spoil.colour;
    double cb = (image.cb[i] - kNeutral) * spoil.light * spoil.colour;
    if (landmarks && ofALandmark(cr, cb)) {
      y /= spoil.landmarkColour;
      cr *= spoil.landmarkColour;
      cb *= spoil.landmarkColour;
    }
    if (spoil.noiseSd > 0.0) {
      y += random.gaussian(0.0, spoil.noiseSd);
      cr += random.gaussian(0.0, spoil.noiseSd);
      cb += random.gaussian(0.0, spoil.noiseSd);
    }
    image.y[i] = level(y);
    image.cr[i] = level(cr + kNeutral);
    image.cb[i] = level(cb + kNeutral);
  }
}

bool spoilsImages(const Spoil& spoil) {
  return spoil.light != 1.0 || spoil.colour != 1.0 || spoil.landmarkColour != 1.0 ||
         spoil.noiseSd > 0.0;
}

}  // namespace

PixelWalk::PixelWalk(const agent::AgentConfig& config, const sim::RandomisationParams& randomised,
                     std::uint64_t seed, const Spoil& spoil)
    : spoil_(spoil),
      random_(seed ^ 0x7157ULL),
      walker_(startOf(config.field, random_), seed),
      sensorRandom_(seed ^ 0x5e45ULL),
      spoilRandom_(seed ^ 0x5b01ULL) {
  view_.real = sim::drawRandomisedRobot(randomised, seed, 0);
  // Whatever else is like: an accelerometer without a bias would tell every lean.
  sim::RandomisationParams biased = sim::randomisationParams(1, {"body"});
  view_.real.body.accelerationBias =
      sim::drawRandomisedRobot(biased, seed, 0).body.accelerationBias;
  const Point2<Field> end = fieldFromRobot(walker_.truth.pose(), {0.0, kFrames * kStep});
  field_ = spoiltField(config.field, spoil, end);
  view_.scene = sim::fieldScene(field_, random_.next() | 1U);
  view_.ball = {random_.uniform(30.0, 330.0), random_.uniform(30.0, 510.0)};
  sim::setBall(view_.scene, view_.ball);
  view_.robotCamera = sim::randomCamera(random_, {});
  camera_ = std::make_unique<sim::Camera>(sim::CameraParams{}, view_.robotCamera);
}

View& PixelWalk::next(int frame, double lag) {
  const double turn = turnAt(frame);
  walker_.walk(kStep, 0.0, turn);
  view_.pose = walker_.truth.pose();
  const double late = -view_.real.lag - spoil_.imageLate;
  for (std::size_t x = 0; x < kImageWidth; ++x)
    view_.columns[x] = exposed(frame, turn, sim::exposedAt(x, view_.real.readout) - 0.5 + late);
  view_.eye = exposed(frame, turn, late);
  sense(frame, lag);
  camera_->render(view_.scene, view_.columns, random_, view_.input.image);
  if (spoilsImages(spoil_)) spoilImage(spoil_, spoilRandom_, view_.input.image);
  return view_;
}

// The middle of the walk is anywhere in the middle of the field, so that all of it is inside.
sim::TruePose PixelWalk::startOf(const body::FieldDescription& field, Random& random) {
  const double heading = 0.5 * maths::kPi * random.index(4);
  const double back = -0.5 * kFrames * kStep;
  const double x = random.uniform(110.0, field.width - 110.0);
  const double y = random.uniform(150.0, field.length - 150.0);
  return {x + back * std::cos(heading), y + back * std::sin(heading), heading};
}

// The camera so many frames after the image's stamp; leaves it in view_.camera too.
sim::FieldCamera PixelWalk::exposed(int frame, double turn, double late) {
  const Pose2 pose{fieldFromRobot(view_.pose, {0.0, kStep * late}),
                   view_.pose.heading + Angle::rad(turn * late)};
  const JointAngles head = neck(frame + late, panRate(frame + late));
  view_.camera = sim::trueCamera({pose, kStance, head, leanAt(frame + late)});
  return sim::fieldCamera(pose, view_.camera, view_.real.lens);
}

// A head that turns is at the end of its play that lies behind, and hangs forward.
JointAngles PixelWalk::neck(double frame, double rate) const {
  JointAngles joints = headAt(frame);
  const sim::NeckPlay& play = view_.real.body.play;
  joints[Joint::neckTilt] = joints[Joint::neckTilt] - play.neckTilt * 0.5;
  joints[Joint::headNod] = joints[Joint::headNod] - play.headNod * 0.5;
  joints[Joint::headPan] =
      joints[Joint::headPan] - play.headPan * (rate > 0.0 ? 0.5 : -0.5) + Angle::deg(spoil_.pan);
  return joints;
}

// Tilt and roll swing a quarter of the period apart, as on legs.
sim::Lean PixelWalk::leanAt(double frame) const {
  const double phase = 2.0 * maths::kPi * spoil_.swayHz * frame * kFrameSeconds;
  sim::Lean lean = view_.real.body.lean;
  lean.tilt = lean.tilt + Angle::deg(spoil_.swayTilt * std::sin(phase));
  lean.roll = lean.roll + Angle::deg(spoil_.swayRoll * std::cos(phase));
  return lean;
}

void PixelWalk::sense(int frame, double lag) {
  FrameInput& input = view_.input;
  input.frame = static_cast<std::uint32_t>(frame);
  input.time = TimeUs::fromSeconds((frame + 1) * kFrameSeconds);
  input.elapsed = frame > 0 ? kFrameSeconds : 0.0;
  input.odometry = walker_.input.odometry;
  input.odometry.forward *= spoil_.odometryScale;
  input.odometry.left *= spoil_.odometryScale;
  input.odometry.turn = input.odometry.turn + Angle::deg(spoil_.odometryTurn);
  const double at = frame - spoil_.jointsLate - lag / kFrameSeconds;
  input.sensors.joints = headAt(at);
  for (Angle& angle : input.sensors.joints.angle)
    angle = angle + Angle::rad(sensorRandom_.gaussian(0.0, kJointNoise));
  input.headRate = {0.0, panRate(at) + sensorRandom_.gaussian(0.0, kRateNoise), 0.0};
  input.stance = {kStance.shoulderHeight + sensorRandom_.gaussian(0.0, kHeightNoise),
                  kStance.bodyTilt + Angle::deg(sensorRandom_.gaussian(0.0, kTiltNoiseDeg)),
                  {}};
  input.sensors.acceleration = sim::accelerationAtRest(kStance, view_.real.body);
  for (double& axis : input.sensors.acceleration)
    axis += sensorRandom_.gaussian(0.0, sim::SensorParams{}.accelerationSd);
}

Believer::Believer(const agent::AgentConfig& config)
    : config_(config),
      vision_(std::make_unique<vision::VisionState>(config.calibration)),
      gps_(std::make_unique<gps::GpsState>()) {
  gps::prepare(config_.gps, *gps_);
}

void Believer::step(FrameInput& input) {
  const bool first = input.frame == 0;
  input.cameraTilt = first ? gps::startingTilt(config_.gps.tilt) : world_.cameraTilt;
  if (!first) input.focalScale = world_.focalScale;
  input.imageLag = first ? gps::startingLag(config_.gps.lag) : world_.imageLag;
  if (!first) input.light = seen_.light;
  const BodyState body = body::step(input, config_.body);
  seen_ = vision::step({input, body}, config_.vision, *vision_);
  world_ = gps::step({input, seen_, body.camera}, config_.gps, *gps_);
}

void walkThrough(const agent::AgentConfig& config, PixelWalk& walking, const AfterFrame& each) {
  const auto robot = std::make_unique<Believer>(config);
  for (int frame = 0; frame < PixelWalk::kFrames; ++frame) {
    View& view = walking.next(frame, robot->lag());
    robot->step(view.input);
    each(frame, view, *robot);
  }
}

void Recognised::compare(const std::vector<TrueObject>& objects, const Percepts& percepts) {
  const std::vector<SeenObject> all = seenObjects(percepts);
  for (const TrueObject& object : objects) {
    const bool landmark = object.kind == ObjectKind::beacon || object.kind == ObjectKind::goal;
    if (!landmark || !object.toSee) continue;
    seen.count(std::any_of(all.begin(), all.end(),
                           [&](const SeenObject& p) { return matches(p, object); }));
  }
  for (const SeenObject& p : all)
    falsePercepts += std::none_of(objects.begin(), objects.end(),
                                  [&](const TrueObject& o) { return matches(p, o); })
                         ? 1
                         : 0;
}

}  // namespace kelpie::experiments
