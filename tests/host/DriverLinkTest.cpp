// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "robot/host/world/DriverLink.h"
#include "robot/host/world/Messages.h"

namespace kelpie::host {
namespace {

struct Line {
  Line() {
    auto pair = connectedPair(ConnectionParams{});
    driver.emplace(std::move(pair->first));
    link.emplace(std::move(pair->second));
  }
  std::optional<Connection> driver;
  std::optional<DriverLink> link;
  std::unique_ptr<FrameInput> input = std::make_unique<FrameInput>();
  std::unique_ptr<FrameOutput> output = std::make_unique<FrameOutput>();
};

TEST(DriverLinkTest, RobotThatWaitsForItsDriverStands) {
  const Line line;
  EXPECT_TRUE(line.link->drive().present);
  EXPECT_EQ(line.link->drive().command.walk.forward, 0.0);
}

TEST(DriverLinkTest, ViewGoesOutAndTheAnswerIsTheDrive) {
  Line line;
  line.input->motion.running = MotionKind::cheer;
  line.input->image.y[77] = 9;
  line.output->percepts.ball.present = true;
  const auto seen = std::make_unique<DriverView>();
  std::thread driver([&] {
    std::vector<std::uint8_t> body;
    EXPECT_TRUE(receiveMessage(*line.driver, MessageType::view, *seen, body));
    Drive drive{true, {}};
    drive.command.walk.forward = 15.0;
    EXPECT_TRUE(sendMessage(*line.driver, MessageType::drive, drive, body));
  });
  const Status reported = line.link->tell(*line.input, *line.output);
  driver.join();
  ASSERT_TRUE(reported) << reported.error();
  EXPECT_EQ(line.link->drive().command.walk.forward, 15.0);
  EXPECT_EQ(seen->motion.running, MotionKind::cheer);
  EXPECT_EQ(seen->image.y[77], 9);
  EXPECT_TRUE(seen->ball.present);
}

TEST(DriverLinkTest, WithoutItsDriverTheRobotStands) {
  Line line;
  line.driver.reset();
  const Status reported = line.link->tell(*line.input, *line.output);
  EXPECT_EQ(reported.error(), "connection closed by the world");
  EXPECT_TRUE(line.link->drive().present);
}

}  // namespace
}  // namespace kelpie::host
