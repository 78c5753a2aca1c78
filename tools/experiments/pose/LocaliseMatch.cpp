// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/pose/LocaliseMatch.h"

#include <algorithm>

#include "robot/body/Ers7.h"
#include "robot/body/FieldDescription.h"
#include "robot/host/primitives/Orders.h"
#include "tools/cli/options/Config.h"

namespace kelpie::experiments {
namespace {

constexpr std::int64_t kMessageUs = kTickUs * kTicksPerMessage;
constexpr double kBallFromLines = 40.0;  // cm, where it lies after a goal
constexpr double kMinToRobot = 40.0;     // cm between it and the robot

std::unique_ptr<sim::World> endlessMatch(const agent::AgentConfig& config, std::uint64_t seed,
                                         const cli::RandomisationOptions& randomised,
                                         bool physical) {
  const body::FieldDescription& field = config.field;
  const auto setup = *sim::scenario("empty-goal", field, {{config.team, config.player}}, seed);
  sim::WorldParams params;
  params.referee.seconds = 1e5;
  params.referee.goals = 0;
  params.randomised = cli::paramsOf(randomised);
  params.fast = !physical;
  return std::make_unique<sim::World>(params, field, setup, seed);
}

}  // namespace

Expected<agent::AgentConfig> agentConfig(const Request& request, bool physical) {
  cli::ConfigOptions options;
  options.params = request.params;
  options.field = request.field;
  options.body = physical ? cli::Body::physical : cli::Body::fast;
  return cli::makeConfig(options);
}

LocaliseMatch::LocaliseMatch(const agent::AgentConfig& config, const std::string& scripts,
                             std::uint64_t seed, const cli::RandomisationOptions& randomised,
                             bool physical)
    : field_(config.field),
      world_(endlessMatch(config, seed, randomised, physical)),
      loops_(std::make_unique<agent::AgentLoops>(config, scripts,
                                                 static_cast<agent::LogSink&>(*this))),
      random_(seed ^ 0xba11ULL),
      trouble_(loops_->scriptError()) {
  agent::PowerReport report;
  report.motorPower = true;
  loops_->power(report);
}

Status LocaliseMatch::play(double seconds, const Watcher& watch) {
  watch_ = watch;
  const TimeUs end{static_cast<std::int64_t>(1e6 * seconds)};
  std::int64_t messages = world_->time().us / kMessageUs + 1;
  std::int64_t images = world_->time().us * 30 / 1000000 + 1;
  while (trouble_.empty() && world_->time() < end) {
    const TimeUs sensorsAt{messages * kMessageUs};
    const TimeUs imageAt{images * 1000000 / 30};
    const TimeUs now = std::min(sensorsAt, imageAt);
    while (world_->time() < now) world_->tick();
    if (now == sensorsAt) {
      sense();
      ++messages;
    }
    if (now == imageAt) {
      see(now);
      ++images;
    }
  }
  if (!trouble_.empty()) return Error{trouble_};
  return Done{};
}

void LocaliseMatch::sense() {
  motion_.time = world_->time();
  motion_.sensors = world_->sensors(0);
  motion_.batteryCurrent = world_->batteryCurrent(0);
  const MotionOutput& output = loops_->motion(motion_);
  const body::LegGain legs{output.status.lowGain, output.status.legGain};
  // At the start a second vector ahead, as the OPEN-R object sends.
  if (world_->bodies().vectorsWaiting(0) == 0) {
    std::array<JointFrame, kTicksPerMessage> held;
    held.fill(output.joints[0]);
    send(held, legs);
  }
  send(output.joints, legs);
}

void LocaliseMatch::send(const std::array<JointFrame, kTicksPerMessage>& joints,
                         body::LegGain legs) {
  world_->bodies().command(0, host::ordersOf(joints, body::meanOf(legs)));
}

void LocaliseMatch::see(TimeUs now) {
  world_->render(0, now, *image_);
  net::GameControlData control = world_->control();
  if (halted_) control.state = PlayState::set;
  loops_->hear(net::packetOf(control), now);
  frameBegan_ = std::chrono::steady_clock::now();
  loops_->camera(*image_, {now.us - kExposureUs / 2}, images_++);
  replaceBall();
  trouble_ = loops_->scriptError();
}

void LocaliseMatch::replaceBall() {
  const std::vector<sim::MatchEvent> events = world_->takeEvents();
  const bool goal = std::any_of(events.begin(), events.end(), [](const sim::MatchEvent& event) {
    return event.kind == sim::EventKind::goal;
  });
  if (!goal) return;
  const Point2<Field> robot = world_->truth(world_->time()).robots[0].pose.position;
  Point2<Field> place;
  do {
    place = {random_.uniform(kBallFromLines, field_.width - kBallFromLines),
             random_.uniform(kBallFromLines, field_.length - kBallFromLines)};
  } while (distance(place, robot) < kMinToRobot);
  world_->putBall({place, {}});
}

void LocaliseMatch::frame(const FrameInput& input, const FrameOutput& output) {
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - frameBegan_;
  const sim::TruthFrame then = world_->truth(input.time);
  const Pose2 truth = then.robots[0].pose;
  if (!seen_) before_ = truth;
  seen_ = true;
  if (watch_) watch_({input, output, truth, before_, then.ball, took.count()});
  before_ = truth;
}

}  // namespace kelpie::experiments
