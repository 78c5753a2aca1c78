// SPDX-License-Identifier: Apache-2.0
// The lag of a robot's images from a log of its percepts.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "robot/agent/log/LoggedTypes.h"
#include "robot/core/Random.h"
#include "robot/core/log/LogTopics.h"
#include "robot/core/log/LogWriter.h"
#include "tools/calibrate/lag/LagEstimate.h"

namespace kelpie::calibrate {
namespace {

struct Panning {
  double late = 0.0;      // s, truth
  double fastest = 3.8;   // rad/s
  double believed = 0.0;  // s, by which the robot took its joints earlier already
  int frames = 150;
};

// Standing at the middle, 240 cm from a beacon, its head panning to and fro once in two seconds.
std::string logOf(const std::string& name, const Panning& head) {
  const std::string path = std::string(KELPIE_OUT) + "/" + name + ".mcap";
  auto log = LogWriter::open(path);
  EXPECT_TRUE(log.ok());
  log->write(kConfigTopic, {}, *std::make_unique<agent::AgentConfig>());
  const auto input = std::make_unique<FrameInput>();
  const auto output = std::make_unique<FrameOutput>();
  Random random(3);
  LandmarkPercept beacon;
  beacon.kind = LandmarkKind::beaconPinkOnBlue;
  beacon.distance = 240.0;
  beacon.distanceVariance = 100.0;
  beacon.headingVariance = 0.00015;
  for (int i = 0; i < head.frames; ++i) {
    input->time = TimeUs::fromSeconds((i + 1) * kFrameSeconds);
    input->elapsed = kFrameSeconds;
    input->imageLag.seconds = head.believed;
    input->headRate.headPan = head.fastest * std::cos(i * maths::kPi / 30.0);
    beacon.heading = Angle::rad(0.3 + input->headRate.headPan * (head.late - head.believed) +
                                random.gaussian(0.0, 0.01));
    output->percepts.landmarks.clear();
    output->percepts.landmarks.push_back(beacon);
    log->write(kFrameInputTopic, input->time, *input);
    log->write(kFrameOutputTopic, input->time, *output);
  }
  return path;
}

TEST(LagEstimate, IsThatOfThePercepts) {
  for (const double late : {-0.03, 0.0, 0.045}) {
    Panning head;
    head.late = late;
    const auto found = estimateLag(logOf("late", head));
    ASSERT_TRUE(found.ok()) << found.error();
    EXPECT_NEAR(found->seconds, late, 0.006);
    EXPECT_EQ(found->frames, 150U);
    EXPECT_LT(found->sd, 0.01);
  }
}

TEST(LagEstimate, CountsWhatTheRobotTookAwayAlready) {
  Panning head;
  head.late = head.believed = 0.045;
  const auto found = estimateLag(logOf("known", head));
  ASSERT_TRUE(found.ok()) << found.error();
  EXPECT_NEAR(found->seconds, 0.045, 0.006);
}

TEST(LagEstimate, IsRefusedOfAHeadThatRests) {
  Panning head;
  head.fastest = 0.1;
  const std::string path = logOf("rests", head);
  const auto found = estimateLag(path);
  ASSERT_FALSE(found.ok());
  EXPECT_EQ(found.error().find(path + ": the head turned over a landmark in 0 frames"), 0U)
      << found.error();
}

TEST(LagEstimate, IsRefusedOfAFileThatIsNoLogOfAnAgent) {
  EXPECT_FALSE(estimateLag(KELPIE_OUT "/nothing.mcap").ok());
  const std::string path = std::string(KELPIE_OUT) + "/other.mcap";
  { ASSERT_TRUE(LogWriter::open(path).ok()); }
  const auto found = estimateLag(path);
  ASSERT_FALSE(found.ok());
  EXPECT_EQ(found.error(), path + ": not a log of an agent");
}

}  // namespace
}  // namespace kelpie::calibrate
