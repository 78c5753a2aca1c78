// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/world/World.h"

#include <algorithm>
#include <cmath>

#include "tools/sim/bodies/KinematicBodies.h"
#include "tools/sim/physics/Variation.h"

namespace kelpie::sim {
namespace {

constexpr double kTickUs = 8000.0;
constexpr double kExposureUs = 1e6 / 30.0;
constexpr double kUpright = 0.51;      // of gravity down through the body (robot/body/README.md)
constexpr double kHighestLift = 15.0;  // cm; a stance's shoulders are 30 cm up at most
constexpr double kRobotReach =
    45.0;  // cm from the ground under it to the top of one that is held up

// Seeds of parts that must not share a stream.
std::uint64_t partSeed(std::uint64_t seed, std::uint64_t part) {
  return Random(seed ^ (part * 0x9e3779b97f4a7c15ULL)).next();
}

}  // namespace

World::World(const WorldParams& params, const body::FieldDescription& field, const Setup& setup,
             std::uint64_t seed)
    : params_(params),
      field_(field),
      randomised_(drawRandomised(params.randomised, seed, setup.players.size())),
      obstacles_(obstaclesOf(field)),
      players_(setup.players),
      throws_(setup.throws),
      referee_(params.referee, field),
      interventions_(setup, field),
      radio_(params.radio, setup.players.size(), partSeed(seed, 3)) {
  const std::uint64_t crowd = params.spectators ? partSeed(seed, 1) | 1U : 0;
  const Scene scene = fieldScene(field, crowd, randomised_.venue);
  const SharedTables tables = makeRandomTables();
  for (std::size_t i = 0; i < players_.size(); ++i) {
    if (players_[i].deaf) radio_.deafen(i);
    const std::uint64_t part = 10 * (i + 1);
    Random colours(partSeed(seed, part));
    sensorRandom_.emplace_back(partSeed(seed, part + 2));
    RobotCamera camera = randomCamera(colours, params_.camera.artefacts);
    camera.tone = randomised_.robots[i].tone;
    camera.noise = randomised_.robots[i].noise;
    camera.light = randomised_.venue.brightness;
    eyes_.push_back(std::make_unique<Eye>(
        Eye{{params_.camera, camera, tables}, Random(partSeed(seed, part + 3)), scene}));
    joints_.emplace_back(randomised_.robots[i].jointsLag);
    shine_.push_back(partSeed(seed, part + 4));
  }
  buildBodies(seed);
  bodies_->putBall({setup.ball, setup.ballVelocity});
  sensors_.resize(players_.size());
  charge_.resize(players_.size(), 1.0);
  past_.remember(ticks_, *bodies_);
}

// Where physical ones cannot be built the kinematic ones stand there and the first tick says why.
void World::buildBodies(std::uint64_t seed) {
  const auto own = [seed](std::size_t i) { return partSeed(seed, 10 * (i + 1) + 1); };
  if (!params_.fast) {
    std::vector<PhysicalStart> starts;
    for (std::size_t i = 0; i < players_.size(); ++i) {
      const RandomisedRobot& robot = randomised_.robots[i];
      const PhysicsParams physics =
          robot.physics == 0 ? params_.physics : varied(params_.physics, robot.physics);
      starts.push_back({players_[i].start, physics, robot.body, own(i)});
    }
    auto built = PhysicalBodies::build(field_, starts, params_.physics, params_.physicalSensors);
    if (built) {
      bodies_ = std::move(*built);
      return;
    }
    fault_ = built.error();
  }
  auto kinematic = std::make_unique<KinematicBodies>(params_.ball, field_, partSeed(seed, 7));
  for (std::size_t i = 0; i < players_.size(); ++i)
    kinematic->add({params_.robot, players_[i].start, own(i), randomised_.robots[i].body});
  bodies_ = std::move(kinematic);
}

void World::senseAll() {
  for (std::size_t i = 0; i < robotCount(); ++i) {
    const Surroundings around{past_.ballNow(), obstacles_, past_.robotsNow(), i};
    BodyFeeling feeling = bodies_->feel(i);
    feeling.joints = joints_[i].tell(feeling.joints);
    std::rotate(sensors_[i].begin(), sensors_[i].begin() + 1, sensors_[i].end());
    sensors_[i].back() =
        sense(around, feeling, params_.sensors, sensorRandom_[i], randomised_.robots[i].nose);
    charge_[i] = drained(charge_[i], batteryCurrent(i), kTickSeconds, params_.sensors);
  }
}

// A robot at the edge may stand so that its throw would come from beyond the lines.
void World::throwBalls() {
  for (; thrown_ < throws_.size() && throws_[thrown_].time <= time().seconds(); ++thrown_) {
    const BallThrow& one = throws_[thrown_];
    Ball ball = one.ball;
    if (one.by) {
      const auto robot = std::find_if(players_.begin(), players_.end(),
                                      [&](const Player& player) { return player.is(*one.by); });
      if (robot == players_.end()) continue;
      const auto number = static_cast<std::size_t>(robot - players_.begin());
      const Pose2 pose = bodies_->place(number).pose;
      const auto onField = [&](Point2<Field> p) {
        return fieldFromRobot(pose, Point2<Robot>{p.x, p.y});
      };
      ball = {onField(ball.position), onField(ball.velocity) - pose.position};
    }
    ball.position = {maths::clamp(ball.position.x, 0.0, field_.width),
                     maths::clamp(ball.position.y, 0.0, field_.length)};
    bodies_->putBall(ball);
  }
}

MatchScene World::matchScene() const {
  MatchScene scene;
  scene.time = time();
  scene.ball = bodies_->ball();
  scene.ballToucher = bodies_->ballToucher();
  for (std::size_t i = 0; i < robotCount(); ++i) {
    const BodyPlace place = bodies_->place(i);
    const Angle tilt = place.stance.bodyTilt + place.lean.tilt;
    const bool upright = tilt.cos() * place.lean.roll.cos() > kUpright;
    scene.players.push_back({players_[i].team, players_[i].number, place.pose, upright, true});
  }
  return scene;
}

void World::obey(const Verdict& verdict) {
  if (verdict.ball) bodies_->putBall(*verdict.ball);
  for (const Carry& one : verdict.carries) bodies_->carry(one.robot, one.place);
}

// The referee has no ball to put anywhere while somebody else has it.
std::array<Verdict, 2> World::judge() {
  MatchScene scene = matchScene();
  const Verdict intervened = interventions_.step(scene);
  obey(intervened);
  if (intervened.ball || !intervened.carries.empty()) scene = matchScene();
  scene.ballAway = interventions_.ballAway();
  if (scene.ballAway) scene.ball = {interventions_.takenFrom(), {}};
  Verdict calls = referee_.judge(scene);
  if (scene.ballAway) calls.ball.reset();
  obey(calls);
  return {intervened, calls};
}

std::vector<MatchEvent> World::takeEvents() {
  std::vector<MatchEvent> events = interventions_.takeEvents();
  const std::vector<MatchEvent> calls = referee_.takeEvents();
  events.insert(events.end(), calls.begin(), calls.end());
  std::stable_sort(events.begin(), events.end(),
                   [](const MatchEvent& a, const MatchEvent& b) { return a.time < b.time; });
  return events;
}

Status World::tick() {
  if (!fault_.empty()) return Error{fault_};
  const Status moved = bodies_->tick();
  if (!moved) {
    fault_ = moved.error() + " at " + std::to_string(time().seconds()) + " s";
    return Error{fault_};
  }
  ++ticks_;
  throwBalls();
  const std::array<Verdict, 2> verdicts = judge();
  past_.remember(ticks_, *bodies_);
  // No image shows the way.
  for (const Verdict& verdict : verdicts)
    for (const Carry& one : verdict.carries) past_.carry(one.robot, one.place);
  senseAll();
  return Done{};
}

Status World::carry(std::size_t robot, const Pose2& pose) {
  if (robot >= robotCount()) return Error{"there is no robot " + std::to_string(robot)};
  const Point2<Field> p = pose.position;
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(pose.heading.rad()))
    return Error{"a place for a robot is not finite"};
  if (distance(p, nearestWalkable(field_, p)) > 0.0)
    return Error{"a place for a robot is off the ground"};
  bodies_->carry(robot, pose);
  past_.carry(robot, pose);
  return Done{};
}

Status World::hold(std::size_t robot, double share) {
  if (robot >= robotCount()) return Error{"there is no robot " + std::to_string(robot)};
  if (!(share >= 0.0 && share <= 1.0)) return Error{"a robot is held by a share from 0 to 1"};
  bodies_->hold(robot, share);
  return Done{};
}

Status World::shove(std::size_t robot, Point2<Field> way, Angle turn) {
  if (robot >= robotCount()) return Error{"there is no robot " + std::to_string(robot)};
  if (!std::isfinite(way.x) || !std::isfinite(way.y) || !std::isfinite(turn.rad()))
    return Error{"a push is not finite"};
  bodies_->shove(robot, way, turn);
  return Done{};
}

Status World::lift(std::size_t robot, double height) {
  if (robot >= robotCount()) return Error{"there is no robot " + std::to_string(robot)};
  if (!(height >= 0.0 && height <= kHighestLift)) return Error{"a robot is lifted by 0 to 15 cm"};
  bodies_->lift(robot, height);
  return Done{};
}

Status World::touch(std::size_t robot, const Touch& touch) {
  if (robot >= robotCount()) return Error{"there is no robot " + std::to_string(robot)};
  if (!(touch.head >= 0.0 && touch.head <= kHardestTouch))
    return Error{"a head is pressed by 0 to 80"};
  bodies_->touch(robot, touch);
  return Done{};
}

Status World::putUp(const OuterWall& wall) {
  for (const auto& eye : eyes_) addWall(eye->scene, wall);
  for (std::size_t side = 0; side < 4; ++side)
    obstacles_.push_back({wall.corners[side], wall.corners[(side + 1) % 4], 1.0});
  return bodies_->setObstacles(obstacles_);
}

Status World::takeLandmarksAway() {
  for (const auto& eye : eyes_) hideLandmarks(eye->scene);
  const auto isBeacon = [this](const Obstacle& obstacle) {
    return distance(obstacle.a, obstacle.b) == 0.0 && obstacle.radius == field_.beaconRadius;
  };
  obstacles_.erase(std::remove_if(obstacles_.begin(), obstacles_.end(), isBeacon),
                   obstacles_.end());
  return bodies_->setObstacles(obstacles_);
}

// A share of the exposure of the image that the robot's camera stamps with `end`.
double World::ticksAt(std::size_t robot, TimeUs end, double share) const {
  const double late = 1.0 - share + randomised_.robots[robot].lag;
  return std::max(0.0, (static_cast<double>(end.us) - kExposureUs * late) / kTickUs);
}

// Bodies go evenly between two ticks: a camera between two places of a quarter of a tick is mixed
// of theirs, 0.005 px off for a head of 400 deg/s, and most columns cost no joint's sine.
ColumnCameras World::cameras(std::size_t robot, const Past& past, TimeUs end) const {
  constexpr double kPerTick = 4.0;
  const RandomisedRobot& own = randomised_.robots[robot];
  const double readout = params_.rolling ? own.readout : 0.0;
  const auto cameraAt = [&](double quarter) {
    const BodyPlace place = past.place(robot, quarter / kPerTick);
    return fieldCamera(place.pose, trueCamera(place), own.lens);
  };
  ColumnCameras cameras;
  double from = -2.0;  // a place that is not beside any
  FieldCamera before, after;
  for (std::size_t x = 0; x < kImageWidth; ++x) {
    const double at = kPerTick * ticksAt(robot, end, exposedAt(x, readout));
    const double whole = std::floor(at);
    if (whole != from) {
      before = whole == from + 1.0 ? after : cameraAt(whole);
      after = cameraAt(whole + 1.0);
      from = whole;
    }
    cameras[x] = mixed(before, after, at - from);
  }
  return cameras;
}

void World::render(std::size_t robot, const Past& past, TimeUs end, Image& image) {
  const double middle = ticksAt(robot, end, 0.5);
  Eye& eye = *eyes_[robot];
  setBall(eye.scene, past.ball(middle));
  const ColumnCameras columns = cameras(robot, past, end);
  std::vector<RobotLook> others;
  for (std::size_t i = 0; i < robotCount(); ++i) {
    if (i == robot) continue;
    const BodyPlace place = past.place(i, middle);
    const Point2<Field> at = place.pose.position;
    if (!mayShow(columns, {{at.x, at.y, 0.0}, kRobotReach, {}})) continue;
    others.push_back({place.pose, place.stance.shoulderHeight, players_[i].team, shine_[i],
                      randomised_.robots[i].uniform});
  }
  setRobots(eye.scene, others, params_.shine);
  if (params_.ownLegs) eye.scene.own = frontLegs(past.place(robot, middle));
  eye.camera.render(eye.scene, columns, eye.random, image);
}

void World::send(std::size_t robot, const RadioPacket& packet) {
  std::vector<Point2<Field>> places;
  for (std::size_t i = 0; i < robotCount(); ++i) places.push_back(bodies_->place(i).pose.position);
  radio_.send(robot, packet, time(), places);
}

GameState World::gameFor(std::size_t robot) const {
  return net::gameStateFrom(control(), players_[robot].team, players_[robot].number);
}

TruthFrame World::truth(TimeUs time) const {
  const double ticks = static_cast<double>(time.us) / kTickUs;
  TruthFrame truth;
  truth.time = time;
  for (std::size_t i = 0; i < robotCount(); ++i) {
    const BodyPlace place = past_.place(i, ticks);
    truth.robots.push_back({players_[i].team, players_[i].number, place.pose, place.stance});
  }
  truth.ball = past_.ball(ticks);
  truth.ballVelocity = bodies_->ball().velocity;
  truth.redScore = static_cast<std::uint8_t>(std::min(255, score().red));
  truth.blueScore = static_cast<std::uint8_t>(std::min(255, score().blue));
  return truth;
}

}  // namespace kelpie::sim
