// SPDX-License-Identifier: Apache-2.0
// Raw vectors to frame structs and back: order, units, saturation, refusal.
#include <gtest/gtest.h>

#include "actuator/Actuator.h"
#include "robot/agent/AgentIo.h"
#include "robot/host/primitives/DataVectors.h"
#include "robot/host/primitives/RobotPrimitives.h"

namespace kelpie::agent {
namespace {

using host::identifier;
using host::PrimitiveKind;

PrimitiveIds allIds() {
  PrimitiveIds ids{};
  for (std::size_t i = 0; i < ids.joints.size(); ++i) {
    ids.joints[i] = identifier({PrimitiveKind::joint, i});
  }
  for (std::size_t i = 0; i < ids.sensors.size(); ++i) {
    ids.sensors[i] = identifier({PrimitiveKind::sensor, i});
  }
  for (std::size_t i = 0; i < ids.leds.size(); ++i) {
    ids.leds[i] = identifier({PrimitiveKind::led, i});
  }
  for (std::size_t i = 0; i < ids.ears.size(); ++i) {
    ids.ears[i] = identifier({PrimitiveKind::ear, i});
  }
  return ids;
}

// A frame in which every value differs from its neighbours.
SensorFrame distinct(int tick) {
  SensorFrame frame;
  for (std::size_t i = 0; i < kJointCount; ++i) {
    frame.joints.angle[i] = Angle::rad(0.01 * static_cast<double>(i) + 0.001 * tick - 0.1);
    frame.duty[i] = static_cast<double>(i) / 64.0;
  }
  frame.headNearDistance = 20.5;
  frame.headFarDistance = 100.25;
  frame.chestDistance = 33.0 + tick;
  frame.acceleration = {120.5, -60.25, 981.0};
  frame.paw = {true, false, false, true};
  frame.chin = tick % 2 == 1;
  frame.headTouch = 42.0;
  frame.back = {false, true, tick > 1};
  return frame;
}

std::array<SensorFrame, kTicksPerMessage> distinctFrames() {
  return {distinct(0), distinct(1), distinct(2), distinct(3)};
}

std::array<host::RawSensors, kTicksPerMessage> rawFrames() {
  std::array<host::RawSensors, kTicksPerMessage> raw;
  for (std::size_t i = 0; i < raw.size(); ++i) raw[i] = host::rawOf(distinct(static_cast<int>(i)));
  return raw;
}

void expectEqual(const SensorFrame& expected, const SensorFrame& got) {
  for (std::size_t i = 0; i < kJointCount; ++i) {
    EXPECT_NEAR(expected.joints.angle[i].rad(), got.joints.angle[i].rad(), 0.5001e-6);
    EXPECT_EQ(expected.duty[i], got.duty[i]);
  }
  EXPECT_NEAR(expected.headNearDistance, got.headNearDistance, 1e-9);
  EXPECT_NEAR(expected.headFarDistance, got.headFarDistance, 1e-9);
  EXPECT_NEAR(expected.chestDistance, got.chestDistance, 1e-9);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(expected.acceleration[i], got.acceleration[i], 1e-9);
  }
  EXPECT_EQ(expected.paw, got.paw);
  EXPECT_EQ(expected.chin, got.chin);
  EXPECT_EQ(expected.headTouch, got.headTouch);
  EXPECT_EQ(expected.back, got.back);
}

class SensorReaderTest : public testing::TestWithParam<std::uint64_t> {
 protected:
  SensorReaderTest() { host::fillSensors(*region_, 100, rawFrames()); }
  ~SensorReaderTest() override { region_->RemoveReference(); }
  OSensorFrameVectorData& vector() {
    return *reinterpret_cast<OSensorFrameVectorData*>(region_->Base());
  }

  RCRegion* region_ = host::newSensorRegion(GetParam());
  SensorReader reader_;
  std::array<SensorFrame, kTicksPerMessage> frames_{};
};

TEST_P(SensorReaderTest, EveryValueArrivesWhateverTheOrder) {
  ASSERT_EQ(0U, reader_.match(vector(), allIds()));
  ASSERT_TRUE(reader_.read(vector(), frames_));
  const auto expected = distinctFrames();
  for (std::size_t tick = 0; tick < frames_.size(); ++tick) {
    expectEqual(expected[tick], frames_[tick]);
  }
}

TEST_P(SensorReaderTest, MissingSensorKeepsItsDefault) {
  PrimitiveIds ids = allIds();
  ids.sensors[openr::index(openr::Sensor::chest)] = 99999;
  EXPECT_EQ(1U, reader_.match(vector(), ids));
  ASSERT_TRUE(reader_.read(vector(), frames_));
  EXPECT_EQ(SensorFrame{}.chestDistance, frames_[0].chestDistance);
  EXPECT_NEAR(20.5, frames_[0].headNearDistance, 1e-9);
}

TEST_P(SensorReaderTest, VectorThatDiffersFromTheMatchedOneIsRefused) {
  EXPECT_FALSE(reader_.read(vector(), frames_));
  reader_.match(vector(), allIds());
  vector().SetNumData(5);
  EXPECT_FALSE(reader_.read(vector(), frames_));
}

TEST_P(SensorReaderTest, VectorThatLacksATickOfAJointIsNoPatternAndIsNotRead) {
  OSensorFrameInfo* knee = nullptr;
  const OPrimitiveID id = allIds().joints[index(Joint::leftHindKnee)];
  for (int i = 0; i < static_cast<int>(vector().vectorInfo.numData); ++i)
    if (vector().GetInfo(i)->primitiveID == id) knee = vector().GetInfo(i);
  ASSERT_NE(knee, nullptr);
  knee->numFrames = kTicksPerMessage - 1;
  EXPECT_EQ(1U, reader_.match(vector(), allIds()));
  EXPECT_FALSE(reader_.matched());
  EXPECT_FALSE(reader_.read(vector(), frames_));
  knee->numFrames = kTicksPerMessage;
  EXPECT_EQ(0U, reader_.match(vector(), allIds()));
  EXPECT_TRUE(reader_.read(vector(), frames_));
  knee->numFrames = kTicksPerMessage - 1;
  EXPECT_FALSE(reader_.read(vector(), frames_));
}

INSTANTIATE_TEST_SUITE_P(Orders, SensorReaderTest, testing::Values(0, 1, 77));

TEST(SensorOrderTest, SeedsShuffleTheVector) {
  RCRegion* plain = host::newSensorRegion(0);
  RCRegion* shuffled = host::newSensorRegion(77);
  const auto idAt = [](RCRegion* region, std::size_t i) {
    return reinterpret_cast<OSensorFrameVectorData*>(region->Base())
        ->GetInfo(static_cast<int>(i))
        ->primitiveID;
  };
  int moved = 0;
  for (std::size_t i = 0; i < 33; ++i) moved += idAt(plain, i) != idAt(shuffled, i) ? 1 : 0;
  EXPECT_GT(moved, 25);
  plain->RemoveReference();
  shuffled->RemoveReference();
}

TEST(RawSensorTest, SensorsSaturateAtTheirRange) {
  SensorFrame frame;
  frame.headNearDistance = 500.0;
  frame.chestDistance = 0.0;
  frame.acceleration = {5000.0, 0.0, -1e9};
  const host::RawSensors raw = host::rawOf(frame);
  EXPECT_EQ(500000, raw.of(openr::Sensor::headNear));
  EXPECT_EQ(100000, raw.of(openr::Sensor::chest));
  EXPECT_EQ(-19613300, raw.of(openr::Sensor::accelerationBack));
  EXPECT_EQ(19613300, raw.of(openr::Sensor::accelerationDown));
}

TEST(BackTouchTest, ReleaseNeedsLessThanPress) {
  RCRegion* region = host::newSensorRegion(0);
  auto& vector = *reinterpret_cast<OSensorFrameVectorData*>(region->Base());
  const slongword pressure[] = {13, 14, 10, 9};  // on at 14, off below 10
  const auto place = static_cast<int>(kJointCount + openr::index(openr::Sensor::backMiddle));
  for (std::size_t tick = 0; tick < 4; ++tick) {
    vector.GetData(place)->frame[tick].value = pressure[tick];
  }
  SensorReader reader;
  reader.match(vector, allIds());
  std::array<SensorFrame, kTicksPerMessage> frames{};
  ASSERT_TRUE(reader.read(vector, frames));
  const bool expected[] = {false, true, true, false};
  for (std::size_t tick = 0; tick < 4; ++tick) EXPECT_EQ(expected[tick], frames[tick].back[1]);
  region->RemoveReference();
}

TEST(PowerTest, BitsBecomeWords) {
  OPowerStatus status;
  EXPECT_FALSE(reportOf(status).motorPower);
  status.robotStatus = orsbPAUSE | orsbMOTOR_POWER;
  status.current = -1200;
  EXPECT_TRUE(reportOf(status).paused);
  EXPECT_TRUE(reportOf(status).motorPower);
  EXPECT_FALSE(reportOf(status).batteryLow);
  EXPECT_EQ(1200.0, reportOf(status).current) << "whatever its sense";
  status.remainingCapacity = 62;
  EXPECT_EQ(0.62, reportOf(status).charge);
  status.remainingCapacity = 0xffff;
  EXPECT_EQ(1.0, reportOf(status).charge) << "at most a full battery";
  status.robotStatus = orsbBATTERY_CAPACITY_LOW;
  EXPECT_TRUE(reportOf(status).batteryLow);
  status.robotStatus = 0;
  status.batteryStatus = obsbTERMINATED_DISCHARGING_ALARM;
  EXPECT_TRUE(reportOf(status).batteryLow);
}

class ImageTest : public testing::TestWithParam<bool> {
 protected:
  ~ImageTest() override { region_->RemoveReference(); }
  OFbkImageVectorData& vector() { return *reinterpret_cast<OFbkImageVectorData*>(region_->Base()); }
  RCRegion* region_ = host::newImageRegion(GetParam());
  Image image_;
};

TEST_P(ImageTest, RowsGoToTheirPlanes) {
  const std::size_t bands = GetParam() ? 6 : 3;
  byte* data = vector().GetData(0);
  const std::size_t pixel = 50 * bands * kImageWidth + 7;  // line 50, column 7
  data[pixel] = 11;
  data[pixel + kImageWidth] = 22;
  data[pixel + 2 * kImageWidth] = 33;
  ASSERT_TRUE(readImage(vector(), image_));
  EXPECT_EQ(11, image_.pixel(7, 50).y);
  EXPECT_EQ(22, image_.pixel(7, 50).cr);
  EXPECT_EQ(33, image_.pixel(7, 50).cb);
  EXPECT_EQ(0, image_.pixel(7, 49).y);
  EXPECT_EQ(0, image_.pixel(7, 51).cr);
}

TEST_P(ImageTest, TagLineIsReplacedByTheLineAbove) {
  Image painted;
  painted.y.fill(200);
  host::fillImage(*region_, painted, 0x1234);
  const std::size_t stride = (GetParam() ? 6 : 3) * kImageWidth;
  EXPECT_EQ(0x34, vector().GetData(0)[159 * stride]);
  EXPECT_EQ(0x12, vector().GetData(0)[159 * stride + 1]);
  ASSERT_TRUE(readImage(vector(), image_));
  EXPECT_EQ(200, image_.pixel(0, 159).y);
  EXPECT_EQ(200, image_.pixel(207, 159).y);
}

TEST_P(ImageTest, OtherTypesAndSizesAreRefused) {
  vector().GetInfo(0)->type = odataFBK_CDT;
  EXPECT_FALSE(readImage(vector(), image_));
  vector().GetInfo(0)->type = odataFBK_YCrCb;
  vector().GetInfo(0)->width = 104;
  EXPECT_FALSE(readImage(vector(), image_));
  vector().vectorInfo.numData = 0;
  EXPECT_FALSE(readImage(vector(), image_));
}

INSTANTIATE_TEST_SUITE_P(Layouts, ImageTest, testing::Bool());

class CommandTest : public testing::Test {
 protected:
  CommandTest() {
    robot_.newCommandVector(kCommandCount, &memory_, &vector_);
    for (const char* locator : openr::kJointLocators) open(locator);
    for (const char* locator : openr::kLedLocators) open(locator);
    for (const char* locator : openr::kEarLocators) open(locator);
    places_ = prepareCommands(*vector_, allIds());
    region_ = new RCRegion(memory_, 0, vector_, vector_->vectorInfo.totalSize);
  }
  ~CommandTest() override { region_->RemoveReference(); }
  void open(const char* locator) {
    OPrimitiveID id = 0;
    ASSERT_EQ(oSUCCESS, robot_.openPrimitive(locator, &id));
  }

  // Only its primitives are used.
  struct Robot : host::RobotPrimitives {
    void post(const OServiceEntry&, const openr::Message&) override {}
    OStatus registerService(const OServiceEntry&, const char*) override { return oSUCCESS; }
    void reportStatus(OStatus) override {}
    OID self() const override { return {}; }
    SystemTime time() const override { return {}; }
    void print(int, const char*) override {}
  } robot_;
  MemoryRegionID memory_ = 0;
  CommandPlaces places_{};
  OCommandVectorData* vector_ = nullptr;
  RCRegion* region_ = nullptr;
  host::EffectorVector out_;
};

TEST_F(CommandTest, EarsArriveEachForItself) {
  for (const bool left : {false, true}) {
    std::array<JointFrame, kTicksPerMessage> frames;
    for (JointFrame& frame : frames) frame.ears = {left, !left};
    host::EffectorVector out;
    writeCommands(frames, places_, *vector_);
    EXPECT_EQ("", host::readCommands(*region_, robot_, out));
    EXPECT_EQ(left ? 1U : 2U, out.ears);
  }
}

// From the Command to what the world gets, through the actuator and the OPEN-R vector.
TEST_F(CommandTest, LedsTailMouthAndEarsOfACommandArrive) {
  MotionInput in;
  in.command.leds = 0x2a5a5a5;
  in.command.tail = {Angle::deg(50.0), Angle::deg(-20.0)};
  in.command.mouthOpen = true;
  const actuator::ActuatorParams params;
  actuator::ActuatorState state;
  MotionOutput output;
  for (int message = 0; message < 60; ++message) {
    in.command.ears.rightUp = message == 59;  // it would go down by itself
    output = actuator::step(in, params, state);
  }
  writeCommands(output.joints, places_, *vector_);
  EXPECT_EQ("", host::readCommands(*region_, robot_, out_));
  const JointAngles last = host::anglesOf(out_.targets[kTicksPerMessage - 1]);
  EXPECT_EQ(0x2a5a5a5U, out_.leds);
  EXPECT_EQ(2U, out_.ears);
  EXPECT_NEAR(50.0, last[Joint::tailTilt].deg(), 1e-3);
  EXPECT_NEAR(-20.0, last[Joint::tailPan].deg(), 1e-3);
  EXPECT_NEAR(-55.0, last[Joint::mouth].deg(), 1e-3);
}

TEST_F(CommandTest, TargetsOfFourTicksArriveWithinAMicroradian) {
  std::array<JointFrame, kTicksPerMessage> frames;
  for (std::size_t tick = 0; tick < frames.size(); ++tick) {
    for (std::size_t i = 0; i < kJointCount; ++i) {
      frames[tick].target.angle[i] = Angle::rad(-0.7 + 0.05 * static_cast<double>(i + 3 * tick));
    }
  }
  writeCommands(frames, places_, *vector_);
  EXPECT_EQ("", host::readCommands(*region_, robot_, out_));
  EXPECT_EQ(4U, out_.ticks);
  for (std::size_t tick = 0; tick < frames.size(); ++tick) {
    for (std::size_t i = 0; i < kJointCount; ++i) {
      EXPECT_NEAR(frames[tick].target.angle[i].rad(),
                  host::anglesOf(out_.targets[tick]).angle[i].rad(), 0.501e-6);
    }
  }
}

TEST_F(CommandTest, APrimitiveThatDidNotOpenIsLeftOutAndTheOthersKeepTheirOrders) {
  PrimitiveIds ids = allIds();
  ids.leds[7] = ids.joints[2] = oprimitiveID_UNDEF;
  places_ = prepareCommands(*vector_, ids);
  std::array<JointFrame, kTicksPerMessage> frames;
  for (JointFrame& frame : frames) {
    frame.leds = 0x2a5a5a5;
    frame.ears.rightUp = true;
    frame.target[Joint::tailPan] = Angle::deg(30.0);
  }
  writeCommands(frames, places_, *vector_);
  EXPECT_EQ("", host::readCommands(*region_, robot_, out_));
  EXPECT_EQ(0x2a5a5a5U & ~(1U << 7U), out_.leds);
  EXPECT_EQ(2U, out_.ears);
  EXPECT_EQ(kAllJoints & ~4U, out_.joints);
  EXPECT_NEAR(30.0, host::anglesOf(out_.targets[0])[Joint::tailPan].deg(), 1e-4);
}

TEST_F(CommandTest, UnsoundCommandIsNamedAndTheRestKept) {
  writeCommands({}, places_, *vector_);
  vector_->GetInfo(2)->numFrames = 17;
  EXPECT_EQ("command 2 for primitive 258 of type 259 with 17 frames is refused",
            host::readCommands(*region_, robot_, out_));
  EXPECT_EQ(((1U << kJointCount) - 1) & ~4U, out_.joints);
}

TEST_F(CommandTest, DataOutsideTheVectorAreNotRead) {
  vector_->GetInfo(0)->dataOffset = vector_->vectorInfo.totalSize - 4;
  vector_->GetInfo(1)->dataOffset = 0xfffffff0;
  vector_->GetInfo(2)->type = odataLED_COMMAND2;
  vector_->GetInfo(3)->numFrames = 0;
  EXPECT_NE("", host::readCommands(*region_, robot_, out_));
  EXPECT_EQ(((1U << kJointCount) - 1) & ~15U, out_.joints);
}

TEST_F(CommandTest, ClosedPrimitiveIsNotCommanded) {
  robot_.closePrimitive(allIds().joints[5]);
  host::readCommands(*region_, robot_, out_);
  EXPECT_EQ(((1U << kJointCount) - 1) & ~32U, out_.joints);
}

}  // namespace
}  // namespace kelpie::agent
