// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <memory>

#include "robot/agent/log/FrameMessages.h"
#include "robot/core/log/LogWriter.h"
#include "vision/pixels/PlaneImage.h"

namespace kelpie::agent {
namespace {

// A file of its own for each test: they run side by side.
std::string pathOf(const std::string& name) {
  const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
  return testing::TempDir() + "kelpie_" + name + test;
}

// A log of one frame; the error of reading its input, empty when there is none.
template <class Frame>
std::string readBack(const char* topic, const Frame& frame, FrameInput& input) {
  const std::string path = pathOf("frame_messages");
  auto log = LogWriter::open(path);
  log->write(topic, TimeUs{1000}, frame);
  log->close();
  auto reader = LogReader::open(path);
  LogMessage message;
  EXPECT_TRUE(reader->next(message));
  EXPECT_TRUE(isFrameInput(message.topic()));
  const Status read = decodeFrameInput(message, input);
  return read ? "" : read.error();
}

TEST(FrameMessages, ImageIsMadeAgainFromItsClasses) {
  const auto frame = std::make_unique<PlaneFrame>();
  ClassNumbers plane{};
  plane[Image::at(7, 9)] = static_cast<std::uint8_t>(vision::ColourClass::orange);
  encodePlane(plane, frame->plane);
  frame->frame = 42;
  frame->sensors.joints[Joint::headPan] = Angle::deg(30);
  const auto input = std::make_unique<FrameInput>();
  ASSERT_EQ(readBack(kPlaneFrameTopic, *frame, *input), "");
  EXPECT_EQ(input->frame, 42U);
  EXPECT_EQ(input->sensors.joints[Joint::headPan].rad(), Angle::deg(30).rad());
  EXPECT_EQ(input->image.pixel(7, 9).cr, vision::kPlaneColours[1].cr);
  EXPECT_EQ(input->image.pixel(8, 9).cr, vision::kPlaneColours[0].cr);
}

TEST(FrameMessages, WholeInputIsReadAsItIs) {
  const auto frame = std::make_unique<FrameInput>();
  frame->image.y.fill(77);
  const auto input = std::make_unique<FrameInput>();
  ASSERT_EQ(readBack(kFrameInputTopic, *frame, *input), "");
  EXPECT_EQ(input->image.y, frame->image.y);
}

TEST(FrameMessages, DamagedPlaneIsReportedWithTopicAndPlaces) {
  const auto frame = std::make_unique<PlaneFrame>();
  encodePlane({}, frame->plane);
  frame->plane[4] = 0xFF;  // no class has the number 15
  const auto input = std::make_unique<FrameInput>();
  const std::string error = readBack(kPlaneFrameTopic, *frame, *input);
  EXPECT_EQ(error.find("topic /frame/plane, byte "), 0U) << error;
  EXPECT_NE(error.find("class plane, byte 4: no class has the number 15"), std::string::npos);
}

}  // namespace
}  // namespace kelpie::agent
