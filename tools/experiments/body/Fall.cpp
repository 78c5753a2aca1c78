// SPDX-License-Identifier: Apache-2.0
// Falling and getting up on physical models varied in friction, armature, contact, servo and mass:
// a walking robot is laid on each side or thrown over, feels on which side it lies, and gets up by
// the motion for that side, as a behaviour would. And whether it ever thinks that it has fallen
// while it walks at random.
#include <algorithm>
#include <array>

#include "robot/core/Random.h"
#include "tools/experiments/harness/Experiment.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/harness/Trials.h"
#include "tools/learn/motion/GetUpTrial.h"
#include "tools/learn/walk/WalkLearner.h"

namespace kelpie::experiments {
namespace {

using learn::PhysicalWalker;

constexpr double kMessageSeconds = kTickSeconds * kTicksPerMessage;
constexpr double kInTime = 6.0;   // s, from the fall to standing
constexpr double kWatched = 8.0;  // s
constexpr double kStep = 0.002;   // s, of the physics
constexpr int kWalks = 47;        // messages before the fall
constexpr int kStandsFor = 16;    // messages in a row, upright, that count as standing
constexpr int kRest = 6;          // messages for which the true side was the same
constexpr int kRandom = 1875;     // a minute
constexpr int kOneCommand = 40;   // 1.3 s
constexpr std::array<FallSide, 4> kSides{FallSide::front, FallSide::back, FallSide::left,
                                         FallSide::right};
constexpr std::array<const char*, 4> kNames{"front", "back", "left", "right"};

// Gets up as a behaviour would: the motion for the side that it feels, when nothing else runs.
class GettingUp {
 public:
  Command command(const MotionStatus& status) {
    Command command;
    if (status.running != MotionKind::none) asked_ = false;
    const MotionKind motion = learn::getUpMotion(status.feeling.fallen);
    // Between two motions one message must ask for none.
    if (status.running == MotionKind::none && !asked_) command.motion = motion;
    asked_ = command.motion != MotionKind::none;
    return command;
  }

 private:
  bool asked_ = false;
};

struct Fallen {
  bool found = false;         // that it lies, or was up again before
  bool lay = false;           // it was at rest on a side
  bool wrongSide = false;     // another was reported while it was
  double seconds = kWatched;  // until it stood
};

// Watched from the moment it was laid down.
Fallen watch(PhysicalWalker& walker) {
  Fallen fallen;
  GettingUp getUp;
  FallSide side = FallSide::none;
  int sameSide = 0;
  int standing = 0;
  for (double t = 0.0; t < kWatched && standing < kStandsFor; t += kMessageSeconds) {
    const MotionStatus& status = walker.output().status;
    walker.step(getUp.command(status));
    const FallSide now = learn::trueSide(walker);
    sameSide = now == side ? sameSide + 1 : 0;
    side = now;
    const FallSide reported = walker.output().status.feeling.fallen;
    const bool rests = now != FallSide::none && sameSide >= kRest;
    const bool acts = walker.output().status.running != MotionKind::none;
    fallen.lay = fallen.lay || rests;
    fallen.wrongSide =
        fallen.wrongSide || (rests && !acts && reported != FallSide::none && reported != now);
    fallen.found = fallen.found || reported != FallSide::none;
    standing = learn::standsUpright(walker) && !acts ? standing + 1 : 0;
    if (standing == kStandsFor) fallen.seconds = t - (kStandsFor - 1) * kMessageSeconds;
  }
  fallen.found = fallen.found || !fallen.lay;
  return fallen;
}

// Thrown over: speed to that side and a spin that lifts the feet, as by a foul. Not every throw
// brings the robot down.
void throwOver(FallSide side, std::uint64_t seed, PhysicalWalker& walker) {
  Random random(seed ^ 0xb10UL);
  sim::Engine& engine = walker.bodies().physics().engine();
  const int trunk = walker.bodies().physics().robot(0).trunk();
  mjtNum* v = engine.data().qvel + engine.model().jnt_dofadr[engine.model().body_jntadr[trunk]];
  const mjtNum* axes = engine.data().xmat + 9 * trunk;  // columns: right, ahead, up
  const double push = random.uniform(0.4, 0.7);         // m/s
  const double spin = random.uniform(6.0, 9.0);         // rad/s
  constexpr double kHop = 0.5;                          // m/s upwards
  const bool lateral = side == FallSide::left || side == FallSide::right;
  const double sign = side == FallSide::right || side == FallSide::front ? 1.0 : -1.0;
  const int along = lateral ? 0 : 1;
  for (int k = 0; k < 3; ++k) v[k] += sign * push * axes[3 * k + along];
  v[2] += kHop;
  v[3 + (lateral ? 1 : 0)] += (lateral ? sign : -sign) * spin;
}

Fallen fall(FallSide side, bool thrown, std::uint64_t seed) {
  const actuator::ActuatorParams params;
  PhysicalWalker walker(learn::variedModels(seed, 1, kStep).front(), params, seed);
  Random random(seed);
  Command command;
  command.walk = {random.uniform(-20.0, 30.0), random.uniform(-15.0, 15.0),
                  random.uniform(-1.5, 1.5)};
  for (int i = 0; i < kWalks; ++i) walker.step(command);
  if (thrown) {
    throwOver(side, seed, walker);
  } else {
    learn::layDown(side, seed, walker);
  }
  return watch(walker);
}

int falseFalls(std::uint64_t seed) {
  const actuator::ActuatorParams params;
  PhysicalWalker walker(learn::variedModels(seed, 1, kStep).front(), params, seed);
  Random random(seed);
  Command command;
  int falls = 0;
  bool last = false;
  for (int i = 0; i < kRandom; ++i) {
    if (i % kOneCommand == 0)
      command.walk = {random.uniform(-30.0, 42.0), random.uniform(-20.0, 20.0),
                      random.uniform(-3.8, 3.8)};
    const bool reported = walker.step(command).status.feeling.fallen != FallSide::none;
    falls += reported && !last && !walker.fallen() ? 1 : 0;
    last = reported;
  }
  return falls;
}

Expected<Json> falls(const Request& request) {
  Share found;
  Share wrong;
  Share thrownUp;
  Share thrownLay;
  std::array<Share, kSides.size()> upright;  // of those laid down
  std::array<Share, kSides.size()> lay;
  Share all;
  Values seconds;
  int falseOnes = 0;
  eachTrial(request, [&](const Trial& trial) {
    for (std::size_t i = 0; i < 2 * kSides.size(); ++i) {
      const std::size_t side = i % kSides.size();
      const bool thrown = i >= kSides.size();
      const Fallen one = fall(kSides[side], thrown, 100 * trial.seed + i);
      const bool up = one.seconds <= kInTime;
      found.count(one.found);
      if (one.lay) wrong.count(one.wrongSide);
      if (thrown) thrownUp.count(up);
      if (!thrown) upright[side].count(up);
      if (!thrown) lay[side].count(one.lay);
      if (thrown) thrownLay.count(one.lay);
      all.count(up);
      seconds.push_back(one.seconds);
    }
    falseOnes += falseFalls(100 * trial.seed + 50);
  });
  Json json{{"found_rate", found.value()},
            {"upright_rate", all.value()},
            {"thrown_upright_rate", thrownUp.value()},
            {"thrown_lay_rate", thrownLay.value()},
            {"seconds_p95", percentile(seconds, 0.95)},
            {"wrong_side_rate", wrong.value()},
            {"false_a_minute", falseOnes / (request.trials * kRandom * kMessageSeconds / 60.0)}};
  double min = 1.0;
  for (std::size_t i = 0; i < kSides.size(); ++i) {
    json[std::string(kNames[i]) + "_upright_rate"] = upright[i].value();
    json[std::string(kNames[i]) + "_lay_rate"] = lay[i].value();
    min = std::min(min, upright[i].value());
  }
  json["min_upright_rate"] = min;
  return json;
}

const Registration kFall("fall", "falls of the physical body: found, which side, up again",
                         {Option::trials, Option::seed}, 20, falls);

}  // namespace
}  // namespace kelpie::experiments
