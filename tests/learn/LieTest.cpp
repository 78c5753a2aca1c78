// SPDX-License-Identifier: Apache-2.0
// A robot that rests, on varied physical models: it lies down out of its walk and stands up again.
#include <gtest/gtest.h>

#include "tools/learn/walk/WalkLearner.h"

namespace kelpie::learn {
namespace {

constexpr double kStep = 0.002;
constexpr std::uint64_t kModels = 61;  // the first of five
constexpr int kSecond = 31;            // messages

void run(PhysicalWalker& walker, const Command& command, int messages) {
  for (int i = 0; i < messages; ++i)
    EXPECT_FALSE(walker.step(command).status.feeling.lifted) << "nobody has lifted it";
}

TEST(Lie, OutOfTheWalkDownAndUpAgainWithoutAFall) {
  const auto params = std::make_unique<actuator::ActuatorParams>();
  Command walk;
  walk.walk.forward = 25.0;
  for (const sim::PhysicsParams& varied : variedModels(kModels, 5, kStep)) {
    PhysicalWalker walker(varied, *params, 3);
    const double stands = walker.place().stance.shoulderHeight;
    run(walker, walk, 2 * kSecond);
    walker.rest(Rest::paused);
    run(walker, walk, 2 * kSecond);
    const Pose2 lay = walker.pose();
    EXPECT_LT(walker.place().stance.shoulderHeight, 0.75 * stands);
    run(walker, walk, 2 * kSecond);
    EXPECT_LT((walker.pose().position - lay.position).norm(), 0.5) << "it lies still";
    EXPECT_FALSE(walker.fallen());
    walker.rest(Rest::none);
    run(walker, {}, 3 * kSecond);
    EXPECT_FALSE(walker.fallen());
    EXPECT_NEAR(walker.place().stance.shoulderHeight, stands, 0.7);
  }
}

}  // namespace
}  // namespace kelpie::learn
