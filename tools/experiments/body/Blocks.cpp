// SPDX-License-Identifier: Apache-2.0
// The goalie's blocks on physical models varied in friction, armature, contact, servo, mass and
// play: how far to each side they cover the ball's height and how soon, and what becomes of balls
// that roll at 50 to 150 cm/s at what they cover. Of all motions that begin and end in the stance:
// whether the robot falls or does not stand at the end.
#include "robot/core/Random.h"
#include "tools/experiments/body/OnModels.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/learn/motion/BlockTrial.h"

namespace kelpie::experiments {
namespace {

constexpr int kBalls = 24;       // on each model
constexpr double kSlow = 50.0;   // cm/s
constexpr double kFast = 150.0;  // cm/s
constexpr double kSlant = 20.0;  // deg to each side that they come from

struct OfModel {
  learn::BlockCover cover;
  int stopped = 0;
  int thrownBack = 0;
  int own = 0;  // balls to the side that the block is for
  int ownStopped = 0;
  int falls = 0;
};

bool onOwnSide(MotionKind kind, double lateral) {
  return kind == MotionKind::block || (lateral < 0.0) == (kind == MotionKind::blockLeft);
}

// Balls come to places evenly drawn over what the block covers on that very model.
OfModel blockOn(MotionKind kind, const sim::PhysicsParams& model, std::uint64_t seed) {
  Random random(seed ^ 0xb10cULL);
  const auto stage = learn::standingStage(kind, actuator::standardMotions()[kind], model, seed);
  OfModel found;
  found.cover = learn::coverOf(stage);
  found.falls = found.cover.fell || !found.cover.stands ? 1 : 0;
  for (int i = 0; i < kBalls; ++i) {
    const double lateral = random.uniform(-found.cover.left, found.cover.right);
    const double speed = random.uniform(kSlow, kFast);
    const auto ball =
        learn::tryBlock(stage, lateral, speed, Angle::deg(random.uniform(-kSlant, kSlant)));
    found.stopped += ball.stopped ? 1 : 0;
    found.thrownBack += ball.thrownBack ? 1 : 0;
    found.own += onOwnSide(kind, lateral) ? 1 : 0;
    found.ownStopped += onOwnSide(kind, lateral) && ball.stopped ? 1 : 0;
    found.falls += ball.fell || !ball.stands ? 1 : 0;
  }
  return found;
}

template <class Of>
double meanOf(const std::vector<OfModel>& found, Of&& of) {
  Values values;
  for (const OfModel& one : found) values.push_back(of(one.cover));
  return mean(values);
}

OfModel sumOf(const std::vector<OfModel>& found) {
  OfModel sum;
  for (const OfModel& one : found) {
    sum.stopped += one.stopped;
    sum.thrownBack += one.thrownBack;
    sum.own += one.own;
    sum.ownStopped += one.ownStopped;
    sum.falls += one.falls;
  }
  return sum;
}

int addBlock(MotionKind kind, const Request& request, Json& json) {
  const auto found = onModels<OfModel>(
      request, [&](const auto& model, std::uint64_t seed) { return blockOn(kind, model, seed); });
  using Cover = learn::BlockCover;
  const std::string key = actuator::kMotionNames[static_cast<std::size_t>(kind)];
  json[key + "_covers_left_cm"] = meanOf(found, [](const Cover& c) { return c.left; });
  json[key + "_covers_right_cm"] = meanOf(found, [](const Cover& c) { return c.right; });
  json[key + "_covers_after_s"] = meanOf(found, [](const Cover& c) { return c.seconds; });
  json[key + "_way_forward_cm"] = meanOf(found, [](const Cover& c) { return c.way.y; });
  json[key + "_way_left_cm"] = meanOf(found, [](const Cover& c) { return -c.way.x; });
  json[key + "_way_turn_deg"] = meanOf(found, [](const Cover& c) { return c.turn.deg(); });
  const OfModel sum = sumOf(found);
  const double balls = kBalls * static_cast<double>(found.size());
  json[key + "_stopped"] = sum.stopped / balls;
  json[key + "_own_side_stopped"] = static_cast<double>(sum.ownStopped) / sum.own;
  json[key + "_thrown_back"] = sum.thrownBack / balls;
  json[key + "_falls"] = sum.falls;
  return sum.falls;
}

// Falls, or does not stand at the end.
int fallsOf(MotionKind kind, const Request& request) {
  int falls = 0;
  for (const bool bad : onModels<char>(request, [&](const auto&model, std::uint64_t seed) {
         auto stage = learn::standingStage(kind, actuator::standardMotions()[kind], model, seed);
         const auto course = learn::playMotion(stage, false);
         return static_cast<char>(course.fell || !course.stands);
       }))
    falls += bad ? 1 : 0;
  return falls;
}

Expected<Json> blocks(const Request& request) {
  Json json;
  int falls = 0;
  for (const MotionKind kind : {MotionKind::block, MotionKind::blockLeft, MotionKind::blockRight})
    falls += addBlock(kind, request, json);
  for (const MotionKind kind : {MotionKind::stand, MotionKind::sit, MotionKind::cheer}) {
    const int fallen = fallsOf(kind, request);
    json[std::string(actuator::kMotionNames[static_cast<std::size_t>(kind)]) + "_falls"] = fallen;
    falls += fallen;
  }
  json["falls"] = falls;
  json["balls"] = request.trials * kBalls;
  return json;
}

const Registration kBlocks("blocks",
                           "the goalie's blocks on varied physical models: width, balls stopped",
                           {Option::trials, Option::seed}, 10, blocks);

}  // namespace
}  // namespace kelpie::experiments
