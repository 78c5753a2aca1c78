// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/motion/MotionScene.h"

#include "tools/learn/kick/KickTrial.h"
#include "tools/learn/motion/BallInHold.h"
#include "tools/learn/motion/BlockTrial.h"
#include "tools/learn/motion/GetUpTrial.h"

namespace kelpie::learn {
namespace {

constexpr double kBeforeGrab = 10.0;  // cm ahead of the neck base
constexpr int kLies = 25;             // messages until a robot that was laid down is at rest
constexpr double kSpeed = 100.0;      // cm/s of a ball that is to be blocked

bool grabs(MotionKind kind) { return useOf(kind) == MotionUse::grab; }

KickAim exactAim(MotionKind kind, const actuator::MotionData& motion) {
  const KickAim* aim = findKick(kind);
  KickAim exact = aimOf(aim != nullptr ? *aim : mirrored(*findKick(mirrored(kind))), motion);
  exact.scatter = 0.0;
  return exact;
}

void startKick(const actuator::MotionData& motion, const sim::PhysicsParams& model,
               std::uint64_t seed, MotionStage& stage) {
  const KickStart start = beforeKick(exactAim(stage.command.motion, motion), model, seed);
  stage.walker = std::make_unique<PhysicalWalker>(*start.walker, *stage.params);
  stage.hasBall = true;
}

void startLying(FallSide side, std::uint64_t seed, MotionStage& stage) {
  layDown(side, seed, *stage.walker);
  for (int i = 0; i < kLies; ++i) stage.walker->step({});
  stage.lies = true;
}

void startHolding(MotionKind kind, MotionStage& stage) {
  stage.hasBall = true;
  stage.command = holdingCommand();
  stage.command.motion = kind;
  if (!grabs(kind)) return giveBall({0.0, kHeldAhead}, *stage.walker);
  PhysicalWalker& walker = *stage.walker;
  walker.bodies().putBall({fieldFromRobot(walker.pose(), {0.0, kBeforeGrab}), {}});
}

FallSide sideOf(MotionKind kind) {
  for (const FallSide side : {FallSide::front, FallSide::back, FallSide::left, FallSide::right})
    if (getUpMotion(side) == kind) return side;
  return FallSide::none;
}

}  // namespace

MotionStage sceneOf(MotionKind kind, const actuator::MotionData& motion,
                    const sim::PhysicsParams& model, std::uint64_t seed) {
  MotionStage stage = standingStage(kind, motion, model, seed);
  if (isKick(kind)) startKick(motion, model, seed, stage);
  if (sideOf(kind) != FallSide::none) startLying(sideOf(kind), seed, stage);
  if (grabs(kind) || kind == MotionKind::hold || kind == MotionKind::release)
    startHolding(kind, stage);
  if (!stage.lies) stage.pose = stage.walker->pose();
  if (isBlock(kind)) {
    const double side = kind == MotionKind::blockLeft ? -1.0 : 1.0;
    const double lateral = kind == MotionKind::block ? 0.5 : 1.0;
    constexpr double kWide = 14.0;  // cm
    stage.rolling = {{side * lateral * kWide, kBlockAhead}, kSpeed, kBlockSeconds, {}};
  }
  return stage;
}

}  // namespace kelpie::learn
