// SPDX-License-Identifier: Apache-2.0
// Three recorded seconds of an attack, as class planes, replayed with today's stages, parameters
// and behaviours: the same bits each time, and what is seen and believed is near what really was.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "robot/agent/log/Replay.h"
#include "robot/core/fields/Encoding.h"
#include "tools/sim/world/Truth.h"

namespace kelpie::recorded {
namespace {

const std::string kLog = KELPIE_SOURCE_DIR "/tests/data/attack.mcap";

// What a replay made of one frame, and what really was at the end of its exposure.
struct Moment {
  TimeUs time;
  Percepts seen;
  Pose2 believed;
  std::vector<std::uint8_t> bytes;  // the whole output
};

std::vector<Moment> replayed() {
  std::vector<Moment> moments;
  agent::ReplayOptions options;
  options.scripts = KELPIE_SOURCE_DIR "/pycode";
  options.adjust = [](agent::AgentConfig& config) {
    config.vision = {};
    config.gps = {};
    agent::shareField(config);
  };
  options.onFrame = [&](const FrameInput& input, const FrameOutput& output) {
    moments.push_back({input.time, output.percepts, output.world.pose, {}});
    encode(output, moments.back().bytes);
  };
  agent::StageObserver silent;
  const auto result = agent::replay(kLog, options, silent);
  EXPECT_TRUE(result) << result.error();
  EXPECT_TRUE(!result || result->scriptError.empty());
  return moments;
}

std::vector<sim::TruthFrame> truths() {
  std::vector<sim::TruthFrame> all;
  auto reader = LogReader::open(kLog);
  if (!reader) ADD_FAILURE() << reader.error();
  LogMessage message;
  while (reader && reader->next(message)) {
    if (message.topic() != sim::kTruthTopic) continue;
    all.emplace_back();
    const Status read = decodeAs(message, all.back());
    if (!read) ADD_FAILURE() << read.error();
  }
  return all;
}

// Moments with their truth, the robot being the red team's first.
class Replay : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_GE(moments_.size(), 85U);
    ASSERT_EQ(truths_.size(), moments_.size());
    for (std::size_t i = 0; i < moments_.size(); ++i)
      ASSERT_NEAR((truths_[i].time - moments_[i].time).seconds(), kFrameSeconds / 2, 0.001);
  }
  const Pose2& pose(std::size_t i) const { return truths_[i].robots[0].pose; }

  std::vector<Moment> moments_ = replayed();
  std::vector<sim::TruthFrame> truths_ = truths();
};

TEST_F(Replay, GivesTheSameBitsAgain) {
  const std::vector<Moment> again = replayed();
  ASSERT_EQ(again.size(), moments_.size());
  for (std::size_t i = 0; i < again.size(); ++i)
    ASSERT_EQ(again[i].bytes, moments_[i].bytes) << "frame " << i;
}

TEST_F(Replay, ShowsTheBallWhereItReallyLay) {
  int seen = 0;
  int right = 0;
  for (std::size_t i = 0; i < moments_.size(); ++i) {
    const BallPercept& ball = moments_[i].seen.ball;
    if (!ball.present) continue;
    ++seen;
    const Point2<Robot> really = robotFromField(pose(i), truths_[i].ball);
    const double allowed = std::max(4.0, 0.1 * really.norm());  // cm
    if (std::fabs(ball.distance - really.norm()) <= allowed &&
        (ball.heading - bearing(really)).abs().deg() <= 3.0)
      ++right;
  }
  EXPECT_GE(seen, 76) << "of 90 frames, in 81 when they were recorded";
  EXPECT_GE(right, seen - 3);
}

TEST_F(Replay, ShowsGoalAndBeaconsWhereTheyReallyStand) {
  const auto field = *body::fieldDescription("2006");
  int seen = 0;
  int right = 0;
  for (std::size_t i = 0; i < moments_.size(); ++i)
    for (const LandmarkPercept& mark : moments_[i].seen.landmarks) {
      const auto really = std::find_if(field.landmarks.begin(), field.landmarks.end(),
                                       [&](const auto& m) { return m.kind == mark.kind; });
      const Point2<Robot> place = robotFromField(pose(i), really->position);
      ++seen;
      if ((mark.heading - bearing(place)).abs().deg() <= 8.0 &&
          std::fabs(mark.distance - place.norm()) <= 0.2 * place.norm())
        ++right;
    }
  EXPECT_GE(seen, 80) << "in 90 frames, 89 when they were recorded";
  EXPECT_GE(right, seen - 2);
}

TEST_F(Replay, EndsWithThePoseThatTheRobotReallyHad) {
  const std::size_t last = moments_.size() - 1;
  EXPECT_LE(distance(moments_[last].believed.position, pose(last).position), 20.0) << "cm";
  EXPECT_LE((moments_[last].believed.heading - pose(last).heading).abs().deg(), 5.0);
}

}  // namespace
}  // namespace kelpie::recorded
