// SPDX-License-Identifier: Apache-2.0
// No image, posture or motion makes vision::step crash, take memory, or say anything that is not
// finite and in range; what it examines stays bounded.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "robot/core/fields/FieldCheck.h"
#include "tests/AllocationCount.h"
#include "tests/core/SpoiltValue.h"
#include "tests/vision/Hostile.h"
#include "vision/Vision.h"
#include "vision/ball/BallFinder.h"

namespace kelpie::vision {
namespace {

constexpr int kFrames = 100;  // of each kind

class Fuzz : public ::testing::TestWithParam<int> {
 protected:
  void survive(const HostileFrame& frame, const std::string& what) {
    startCountingAllocations();
    *seen_ = step({frame.input, frame.body}, {}, *state_);
    EXPECT_EQ(stopCountingAllocations(), 0) << what;
    std::string why;
    EXPECT_TRUE(verify(*seen_, &why)) << what << ": " << why;
  }
  std::unique_ptr<VisionState> state_ = std::make_unique<VisionState>();
  std::unique_ptr<Percepts> seen_ = std::make_unique<Percepts>();
  std::unique_ptr<HostileFrame> frame_ = std::make_unique<HostileFrame>();
};

TEST_P(Fuzz, HostileFramesGivePerceptsInRangeWithoutMemory) {
  const std::uint64_t seed = 1000 + static_cast<std::uint64_t>(GetParam());
  HostileFrames frames(seed);
  for (int i = 0; i < kFrames; ++i) {
    frames.make(static_cast<HostileKind>(GetParam()), *frame_);
    survive(*frame_, "seed " + std::to_string(seed) + ", frame " + std::to_string(i));
  }
}

std::string nameOfKind(const ::testing::TestParamInfo<int>& kind) {
  return kHostileNames[static_cast<std::size_t>(kind.param)];
}

INSTANTIATE_TEST_SUITE_P(Kinds, Fuzz, ::testing::Range(0, static_cast<int>(kHostileKindCount)),
                         nameOfKind);

TEST_F(Fuzz, APostureOfNoNumbersGivesPerceptsInRange) {
  Random random(53);
  HostileFrames frames(53);
  for (int i = 0; i < 8 * kFrames; ++i) {
    frames.make(static_cast<HostileKind>(i % static_cast<int>(kHostileKindCount)), *frame_);
    const std::uint32_t rarity = 1U << random.index(6);
    FrameInput& in = frame_->input;
    spoil(in.sensors.joints, random, rarity);
    spoil(in.stance, random, rarity);
    spoil(in.headRate, random, rarity);
    spoil(in.odometry, random, rarity);
    spoil(in.elapsed, random, 4);
    frame_->body = body::step(in, {});
    survive(*frame_, "seed 53, frame " + std::to_string(i));
  }
}

TEST_F(Fuzz, AnyBytesAreAFrame) {
  Random random(31);
  std::vector<std::uint8_t> bytes;
  for (int i = 0; i < kFrames; ++i) {
    bytes.resize(random.index(i % 2 == 0 ? 40 : 4000));
    for (auto& b : bytes) b = static_cast<std::uint8_t>(random.index(256));
    frameFromBytes(bytes.data(), bytes.size(), *frame_);
    survive(*frame_, "seed 31, frame " + std::to_string(i));
  }
}

// What one image can make vision look at: every pixel is classified once at most, so the rest of
// the work is in the candidates.
TEST_F(Fuzz, FullBuffersAreCountedAndTheRestIsStillSeen) {
  HostileFrames frames(77);
  bool overflowed = false;
  for (int i = 0; i < kFrames; ++i) {
    frames.make(HostileKind::chess, *frame_);
    survive(*frame_, "seed 77, frame " + std::to_string(i));
    EXPECT_LE(seen_->counts.runs, RunBuffer::kCapacity);
    EXPECT_LE(seen_->counts.blobs, BlobBuffer::kCapacity);
    overflowed = overflowed || seen_->counts.runs == RunBuffer::kCapacity;
  }
  EXPECT_TRUE(overflowed);
}

TEST(BallChecks, ANearlyStraightEdgeIsNoBall) {
  BallCandidate candidate;
  candidate.cone.radius = 1999.0;
  EXPECT_TRUE(ballIsRound(candidate, {}));
  candidate.cone.radius = 2001.0;  // seen in stripes: 17,000
  EXPECT_FALSE(ballIsRound(candidate, {}));
}

}  // namespace
}  // namespace kelpie::vision
