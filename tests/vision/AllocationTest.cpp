// SPDX-License-Identifier: Apache-2.0
// An allocation inside vision::step fails the test.
#include <gtest/gtest.h>

#include <memory>

#include "robot/core/Random.h"
#include "tests/AllocationCount.h"
#include "tests/vision/Painting.h"
#include "vision/Vision.h"

namespace kelpie::vision {
namespace {

int allocationsIn(const FrameInput& input, const BodyState& body, VisionState& state) {
  startCountingAllocations();
  step({input, body}, {}, state);
  return stopCountingAllocations();
}

TEST(Allocation, StepTakesNoMemoryOnAFullScene) {
  Painting p;
  p.carpetEnd = 230;
  p.noise = 3.0;
  p.lineAt = 90;
  p.balls.push_back({20, 100});
  p.beacons.push_back({{-60, 200}, kBluePaint, kPinkPaint});
  addGoal(p, 20, 200, kYellowPaint);
  const CameraPose camera = cameraAt(16, 0, -5);
  const auto input = std::make_unique<FrameInput>();
  const auto state = std::make_unique<VisionState>();
  paint(p, camera, input->image);
  EXPECT_EQ(allocationsIn(*input, bodyOf(camera), *state), 0);
}

TEST(Allocation, RandomPlanesAndPosesNeitherAllocateNorCrash) {
  Random random(1);
  const auto input = std::make_unique<FrameInput>();
  const auto state = std::make_unique<VisionState>();
  for (int i = 0; i < 60; ++i) {
    // Noise in blocks of growing size: single specks up to large patches.
    const int block = 1 << (i % 6);
    for (int y = 0; y < kImageHeight; ++y) {
      for (int x = 0; x < kImageWidth; ++x) {
        Random cell(static_cast<std::uint64_t>((y / block) * 1000 + x / block + i * 1000000));
        const auto value = [&cell] { return static_cast<std::uint8_t>(cell.index(256)); };
        input->image.set(x, y, {value(), value(), value()});
      }
    }
    const CameraPose camera = cameraAt(random.uniform(2, 40), random.uniform(-180, 180),
                                       random.uniform(-90, 90), random.uniform(-180, 180));
    EXPECT_EQ(allocationsIn(*input, bodyOf(camera), *state), 0);
  }
}

TEST(Allocation, TheTestSeesAnAllocation) {
  startCountingAllocations();
  delete new int(3);
  ::operator delete(::operator new(8));
  EXPECT_GE(stopCountingAllocations(), 1);
}

}  // namespace
}  // namespace kelpie::vision
