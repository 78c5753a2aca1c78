// SPDX-License-Identifier: Apache-2.0
// A physical robot walks at a ball and grabs it (tools/learn/motion/GrabTrial.h), each trial on
// another varied model: a ball at rest, one that rolls anywhere at up to 30 cm/s, one that rolls
// purely across. Who has it turns by half a circle and carries it 50 cm ahead. All the while: does
// the robot feel rightly whether it has the ball, and soon enough when it is taken away?
#include "robot/core/Random.h"
#include "robot/host/OnCores.h"
#include "tools/experiments/harness/Experiment.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/learn/motion/GrabTrial.h"
#include "tools/learn/walk/WalkLearner.h"

namespace kelpie::experiments {
namespace {

using learn::PhysicalWalker;

constexpr double kStep = 0.002;  // s, of the physics
constexpr double kMessageSeconds = kTickSeconds * kTicksPerMessage;
constexpr double kTurning = 2.0;   // rad/s
constexpr double kAhead = 15.0;    // cm/s
constexpr double kCarried = 50.0;  // cm
constexpr double kSettled = 0.26;  // s after which a window has seen nothing but what is now

enum class Rolls : std::uint8_t { no, anywhere, across };

struct Grabbed {
  learn::GrabEnd end = learn::GrabEnd::missed;
  bool keptTurning = false;
  bool keptAhead = false;
  int reported = 0;  // windows that were reported correctly,
  int windows = 0;
  int reportedEmpty = 0;
  int emptyWindows = 0;
  double emptySeconds = 1.0;  // from taking the ball away until that is reported
};

learn::GrabPlace placeOf(Rolls rolls, Random& random) {
  learn::GrabPlace place;
  const double bearing = Angle::deg(random.uniform(-60.0, 60.0)).rad();
  const double far = random.uniform(50.0, 90.0);
  const maths::SinCos way = maths::sinCos(rolls == Rolls::across ? 0.3 * bearing : bearing);
  place.ball = {far * way.sin, far * way.cos};
  if (rolls == Rolls::no) return place;
  place.speed = random.uniform(5.0, 30.0);
  place.direction = Angle::deg(random.uniform(-180.0, 180.0));
  if (rolls == Rolls::across) place.direction = Angle::deg(random.chance(0.5) ? 90.0 : -90.0);
  return place;
}

// Stands, turns and walks in the hold, half a second each.
void watch(bool holds, PhysicalWalker& walker, int& right, int& windows) {
  for (const WalkRequest& walk :
       {WalkRequest{}, WalkRequest{0.0, 0.0, kTurning, 0.0}, WalkRequest{kAhead, 0.0, 0.0, 0.0}}) {
    Command command = learn::holdingCommand();
    command.walk = walk;
    command.walk.kind = WalkKind::dribble;
    for (int i = 0; i < 16; ++i) {
      walker.step(command);
      if (holds != learn::holdsBall(walker)) continue;
      ++windows;
      right += walker.output().status.feeling.ballHeld == holds ? 1 : 0;
    }
  }
}

void takeAway(PhysicalWalker& walker, Grabbed& grabbed) {
  walker.bodies().putBall({{0.0, 0.0}, {}});
  grabbed.emptySeconds = 0.0;
  for (int i = 0; i < 30 && walker.output().status.feeling.ballHeld; ++i) {
    walker.step(learn::holdingCommand());
    grabbed.emptySeconds += kMessageSeconds;
  }
  for (double t = grabbed.emptySeconds; t < kSettled; t += kMessageSeconds)
    walker.step(learn::holdingCommand());
  watch(false, walker, grabbed.reportedEmpty, grabbed.emptyWindows);
}

Grabbed one(Rolls rolls, MotionKind motion, std::uint64_t seed) {
  const actuator::ActuatorParams params;
  Random random(seed);
  PhysicalWalker walker(learn::variedModels(seed, 1, kStep).front(), params, seed);
  learn::GrabPlace place = placeOf(rolls, random);
  place.motion = motion;
  Grabbed grabbed;
  grabbed.end = learn::grab(place, random, walker);
  if (grabbed.end != learn::GrabEnd::held) return grabbed;
  watch(true, walker, grabbed.reported, grabbed.windows);
  learn::turnWithBall(kTurning, walker);
  grabbed.keptTurning = learn::holdsBall(walker);
  if (grabbed.keptTurning) {
    learn::walkWithBall(kAhead, kCarried, walker);
    grabbed.keptAhead = learn::holdsBall(walker);
  }
  takeAway(walker, grabbed);
  return grabbed;
}

struct Sums {
  Share success;
  Share turning;
  Share ahead;
  Share reported;
  Share fell;
  Values emptySeconds;

  void add(const Grabbed& grabbed) {
    const bool held = grabbed.end == learn::GrabEnd::held;
    success.count(held);
    fell.count(grabbed.end == learn::GrabEnd::fell);
    if (!held) return;
    turning.count(grabbed.keptTurning);
    if (grabbed.keptTurning) ahead.count(grabbed.keptAhead);
    for (int i = 0; i < grabbed.windows; ++i) reported.count(i < grabbed.reported);
    for (int i = 0; i < grabbed.emptyWindows; ++i) reported.count(i < grabbed.reportedEmpty);
    emptySeconds.push_back(grabbed.emptySeconds);
  }
};

Sums tryAll(Rolls rolls, MotionKind motion, const Request& request) {
  std::vector<Grabbed> all(static_cast<std::size_t>(request.trials));
  host::onCores(all.size(), [&](std::size_t i) { all[i] = one(rolls, motion, request.seed + i); });
  Sums sums;
  for (const Grabbed& grabbed : all) sums.add(grabbed);
  return sums;
}

Expected<Json> grabs(const Request& request) {
  const Sums rest = tryAll(Rolls::no, MotionKind::grab, request);
  const Sums rolling = tryAll(Rolls::anywhere, MotionKind::grab, request);
  const Sums across = tryAll(Rolls::across, MotionKind::grab, request);
  const Sums quick = tryAll(Rolls::no, MotionKind::grabQuick, request);
  const Sums lift = tryAll(Rolls::no, MotionKind::grabLift, request);
  return Json{{"success_rest", rest.success.value()},
              {"success_rolling", rolling.success.value()},
              {"success_across", across.success.value()},
              {"success_quick", quick.success.value()},
              {"success_lift", lift.success.value()},
              {"kept_turning", rest.turning.value()},
              {"kept_ahead", rest.ahead.value()},
              {"felt_rate", rest.reported.value()},
              {"felt_rolling_rate", rolling.reported.value()},
              {"empty_felt_p95_s", percentile(rest.emptySeconds, 0.95)},
              {"fell_rate", rest.fell.value()}};
}

const Registration kGrab("grab", "a physical robot grabs a ball, keeps it, and feels that it does",
                         {Option::trials, Option::seed}, 40, grabs);

}  // namespace
}  // namespace kelpie::experiments
