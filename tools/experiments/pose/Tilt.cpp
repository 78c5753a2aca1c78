// SPDX-License-Identifier: Apache-2.0
// A body that leans by a constant angle that the robot does not know: the walk of
// localise-observations from pixels, through body, vision and gps, for several such angles. Errors
// are means over the last two seconds of each walk; recall is of beacons and goals that show. The
// walk is kinematic, as there: no legs move, and the accelerometer feels no steps.
#include "gps/camera/Tilt.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "gps/Localiser.h"
#include "robot/agent/AgentConfig.h"
#include "tools/experiments/harness/ChildProcesses.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/pose/LocaliseMatch.h"
#include "tools/experiments/views/Objects.h"
#include "tools/sim/bodies/KinematicBodies.h"
#include "tools/sim/world/Observer.h"
#include "vision/Vision.h"

namespace kelpie::experiments {
namespace {

constexpr std::array<double, 9> kTilts{-3.0, -2.0, -1.5, -1.0, 0.0, 1.0, 1.5, 2.0, 3.0};  // deg
constexpr std::size_t kLevel = 4;
constexpr int kFrames = 240;
constexpr int kCounted = 60;   // the last of them
constexpr int kKnown = 150;    // from here on the tilt should be known
constexpr int kLookedAt = 3;   // every so many frames what shows is compared with what is seen
constexpr double kStep = 0.7;  // cm a frame
constexpr double kOscillation = 0.008;  // rad a frame
constexpr double kLost = 20.0;          // cm
// As tools/experiments/views/View.cpp has them.
constexpr double kJointNoise = 0.0015;  // rad
constexpr double kHeightNoise = 0.1;    // cm
constexpr double kTiltNoiseDeg = 0.2;
constexpr double kRateNoise = 0.1;  // rad/s
const Stance kStance{10.0, Angle::deg(14.25), {}};
const Angle kNod = Angle::deg(5.0);  // the horizon is in the upper third of the image

// What one walk showed.
struct Walked {
  double cm = 0.0;       // over the last two seconds
  double tiltDeg = 0.0;  // error of the believed tilt, mean after five seconds
  Share seen;            // of beacons and goals
  int falsePercepts = 0;
  int looked = 0;  // frames

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("cm", &Walked::cm, "cm"), field("tiltDeg", &Walked::tiltDeg, "deg"),
                     field("seen", &Walked::seen), field("falsePercepts", &Walked::falsePercepts),
                     field("looked", &Walked::looked));
  }
};

// Walks and looks: the world's side, with the truth as a View.
class PixelWalk {
 public:
  PixelWalk(const agent::AgentConfig& config, const sim::RandomisationParams& randomised,
            std::uint64_t seed)
      : random_(seed ^ 0x7157ULL),
        walker_(startOf(config.field, random_), seed),
        sensorRandom_(seed ^ 0x5e45ULL) {
    view_.real = sim::drawRandomisedRobot(randomised, seed, 0);
    // Whatever else is like: an accelerometer without a bias would tell every lean.
    sim::RandomisationParams biased = sim::randomisationParams(1, {"body"});
    view_.real.body.accelerationBias =
        sim::drawRandomisedRobot(biased, seed, 0).body.accelerationBias;
    view_.scene = sim::fieldScene(config.field, random_.next() | 1U);
    view_.ball = {random_.uniform(30.0, 330.0), random_.uniform(30.0, 510.0)};
    sim::setBall(view_.scene, view_.ball);
    view_.robotCamera = sim::randomCamera(random_, {});
    camera_ = std::make_unique<sim::Camera>(sim::CameraParams{}, view_.robotCamera);
  }

  View& next(int frame) {
    walker_.walk(kStep, 0.0, kOscillation * std::sin(frame / 20.0));
    view_.pose = walker_.truth.pose();
    const double turn = kOscillation * std::sin(frame / 20.0);
    for (std::size_t x = 0; x < kImageWidth; ++x)
      view_.columns[x] =
          exposed(frame, turn, sim::exposedAt(x, view_.real.readout) - 0.5 - view_.real.lag);
    view_.eye = exposed(frame, turn, -view_.real.lag);
    sense(frame);
    camera_->render(view_.scene, view_.columns, random_, view_.input.image);
    return view_;
  }
  const Pose2& truth() const { return view_.pose; }

 private:
  // The middle of the walk is anywhere in the middle of the field, so that all of it is inside.
  static sim::TruePose startOf(const body::FieldDescription& field, Random& random) {
    const double heading = 0.5 * maths::kPi * random.index(4);
    const double back = -0.5 * kFrames * kStep;
    const double x = random.uniform(110.0, field.width - 110.0);
    const double y = random.uniform(150.0, field.length - 150.0);
    return {x + back * std::cos(heading), y + back * std::sin(heading), heading};
  }

  JointAngles headAt(double frame) const {
    JointAngles joints;
    joints[Joint::headPan] = Angle::rad(1.2 * std::sin(2.0 * maths::kPi * frame / 60.0));
    joints[Joint::headNod] = kNod;
    return joints;
  }

  // The camera so many frames after the image's stamp; leaves it in view_.camera too.
  sim::FieldCamera exposed(int frame, double turn, double late) {
    const Pose2 pose{fieldFromRobot(view_.pose, {0.0, kStep * late}),
                     view_.pose.heading + Angle::rad(turn * late)};
    const JointAngles head = neck(frame + late, panRate(frame));
    view_.camera = sim::trueCamera({pose, kStance, head, view_.real.body.lean});
    return sim::fieldCamera(pose, view_.camera, view_.real.lens);
  }

  // A head that turns is at the end of its play that lies behind, and hangs forward.
  JointAngles neck(double frame, double panRate) const {
    JointAngles joints = headAt(frame);
    const sim::NeckPlay& play = view_.real.body.play;
    joints[Joint::neckTilt] = joints[Joint::neckTilt] - play.neckTilt * 0.5;
    joints[Joint::headNod] = joints[Joint::headNod] - play.headNod * 0.5;
    joints[Joint::headPan] = joints[Joint::headPan] - play.headPan * (panRate > 0.0 ? 0.5 : -0.5);
    return joints;
  }

  static double panRate(int frame) {
    return 1.2 * 2.0 * maths::kPi / 60.0 * std::cos(2.0 * maths::kPi * frame / 60.0) /
           kFrameSeconds;
  }

  void sense(int frame) {
    FrameInput& input = view_.input;
    input.frame = static_cast<std::uint32_t>(frame);
    input.time = TimeUs::fromSeconds((frame + 1) * kFrameSeconds);
    input.elapsed = frame > 0 ? kFrameSeconds : 0.0;
    input.odometry = walker_.input.odometry;
    input.sensors.joints = headAt(frame);
    for (Angle& angle : input.sensors.joints.angle)
      angle = angle + Angle::rad(sensorRandom_.gaussian(0.0, kJointNoise));
    input.headRate = {0.0, panRate(frame) + sensorRandom_.gaussian(0.0, kRateNoise), 0.0};
    input.stance = {kStance.shoulderHeight + sensorRandom_.gaussian(0.0, kHeightNoise),
                    kStance.bodyTilt + Angle::deg(sensorRandom_.gaussian(0.0, kTiltNoiseDeg)),
                    {}};
    input.sensors.acceleration = sim::accelerationAtRest(kStance, view_.real.body);
    for (double& axis : input.sensors.acceleration)
      axis += sensorRandom_.gaussian(0.0, sim::SensorParams{}.accelerationSd);
  }

  View view_;
  Random random_;
  sim::Observer walker_;
  Random sensorRandom_;
  std::unique_ptr<sim::Camera> camera_;
};

// The robot's side: what the agent's frame loop does with a frame, but for the behaviours.
class Believer {
 public:
  explicit Believer(const agent::AgentConfig& config)
      : config_(config),
        vision_(std::make_unique<vision::VisionState>(config.calibration)),
        gps_(std::make_unique<gps::GpsState>()) {
    gps::prepare(config_.gps, *gps_);
  }

  // What the robot tells itself for the next frame goes into the input, as AgentLoops does.
  void step(FrameInput& input) {
    input.cameraTilt = input.frame > 0 ? world_.cameraTilt : gps::startingTilt(config_.gps.tilt);
    if (input.frame > 0) input.focalScale = world_.focalScale;
    const BodyState body = body::step(input, config_.body);
    seen_ = vision::step({input, body}, config_.vision, *vision_);
    world_ = gps::step({input, seen_, body.camera}, config_.gps, *gps_);
  }
  const Percepts& seen() const { return seen_; }
  const WorldModel& world() const { return world_; }

 private:
  const agent::AgentConfig& config_;
  std::unique_ptr<vision::VisionState> vision_;
  std::unique_ptr<gps::GpsState> gps_;
  Percepts seen_;
  WorldModel world_;
};

void compare(const std::vector<TrueObject>& objects, const Percepts& seen, Walked& walked) {
  ++walked.looked;
  const std::vector<SeenObject> percepts = seenObjects(seen);
  for (const TrueObject& object : objects) {
    const bool landmark = object.kind == ObjectKind::beacon || object.kind == ObjectKind::goal;
    if (!landmark || !object.toSee) continue;
    walked.seen.count(std::any_of(percepts.begin(), percepts.end(),
                                  [&](const SeenObject& p) { return matches(p, object); }));
  }
  for (const SeenObject& p : percepts)
    walked.falsePercepts += std::none_of(objects.begin(), objects.end(),
                                         [&](const TrueObject& o) { return matches(p, o); })
                                ? 1
                                : 0;
}

// The robot's tilt lifts the nose, the world's lowers it.
double tiltError(const WorldModel& world, const sim::Lean& lean) {
  return (world.cameraTilt.tilt + lean.tilt).abs().deg();
}

Walked walk(const agent::AgentConfig& config, const sim::RandomisationParams& randomised,
            std::uint64_t seed) {
  const auto walking = std::make_unique<PixelWalk>(config, randomised, seed);
  const auto robot = std::make_unique<Believer>(config);
  Visibility visibility;
  Walked walked;
  for (int frame = 0; frame < kFrames; ++frame) {
    View& view = walking->next(frame);
    robot->step(view.input);
    if (frame % kLookedAt == 0)
      compare(trueObjects(view, config.field, visibility), robot->seen(), walked);
    if (frame >= kKnown)
      walked.tiltDeg += tiltError(robot->world(), view.real.body.lean) / (kFrames - kKnown);
    if (frame >= kFrames - kCounted)
      walked.cm += distance(robot->world().pose.position, walking->truth().position) / kCounted;
  }
  return walked;
}

struct Walks {
  std::vector<Walked> tilts;  // in the order of kTilts

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("tilts", &Walks::tilts));
  }
};

// One robot with each of the tilts.
Expected<Walks> walkAtAllTilts(const Request& request, const agent::AgentConfig& config,
                               std::uint64_t seed) {
  Walks walks;
  for (const double tilt : kTilts) {
    sim::RandomisationParams randomised = cli::paramsOf(request.randomised);
    randomised.lean.tilt = Angle::deg(tilt);
    walks.tilts.push_back(walk(config, randomised, seed));
  }
  return walks;
}

// All walks of one tilt.
struct Tally {
  Values cm;
  Values tiltDeg;
  Share seen;
  int falsePercepts = 0;
  int looked = 0;

  void add(const Walked& one) {
    cm.push_back(one.cm);
    tiltDeg.push_back(one.tiltDeg);
    seen.add(one.seen);
    falsePercepts += one.falsePercepts;
    looked += one.looked;
  }
  double falsePer1000() const { return 1000.0 * ratio(falsePercepts, looked); }
  Json figures(double tilt) const {
    return {
        {"tilt_deg", tilt},
        {"mean_cm", mean(cm)},
        {"worst_cm", percentile(cm, 1.0)},
        {"over_20_cm_walks", std::lround(shareAbove(cm, kLost) * static_cast<double>(cm.size()))},
        {"tilt_error_deg", mean(tiltDeg)},
        {"tilt_error_worst_deg", percentile(tiltDeg, 1.0)},
        {"recall", seen.value()},
        {"false_per_1000", falsePer1000()}};
  }
};

// Recall at 2 deg over that at 0, the smaller of both sides.
double recallRatio(const std::array<Tally, kTilts.size()>& tallies) {
  double min = 1.0;
  for (std::size_t i = 0; i < kTilts.size(); ++i)
    if (std::fabs(kTilts[i]) == 2.0)
      min = std::min(min, ratio(tallies[i].seen.value(), tallies[kLevel].seen.value()));
  return min;
}

Expected<Json> tilt(const Request& request) {
  const auto config = agentConfig(request);
  if (!config) return Error{config.error()};
  const auto walks = trialsInChildProcesses(
      request, [&](const Trial& trial) { return walkAtAllTilts(request, *config, trial.seed); });
  if (!walks) return Error{walks.error()};
  std::array<Tally, kTilts.size()> tallies;
  for (const Walks& robot : *walks)
    for (std::size_t i = 0; i < kTilts.size(); ++i) tallies[i].add(robot.tilts[i]);
  Values means, worst, wrong, tilts;
  Json each = Json::array();
  for (std::size_t i = 0; i < kTilts.size(); ++i) {
    means.push_back(mean(tallies[i].cm));
    worst.push_back(percentile(tallies[i].cm, 1.0));
    wrong.push_back(tallies[i].falsePer1000());
    tilts.push_back(mean(tallies[i].tiltDeg));
    each.push_back(tallies[i].figures(kTilts[i]));
  }
  return Json{
      {"worst_mean_cm", percentile(means, 1.0)},  {"worst_cm", percentile(worst, 1.0)},
      {"recall_ratio", recallRatio(tallies)},     {"false_per_1000", percentile(wrong, 1.0)},
      {"tilt_error_deg", percentile(tilts, 1.0)}, {"by_tilt", each}};
}

const Registration kTilt(
    "tilt", "walks from pixels with an unknown constant tilt: pose, recall, false ones",
    {Option::trials, Option::seed, Option::randomised, Option::params}, 12, tilt);

}  // namespace
}  // namespace kelpie::experiments
