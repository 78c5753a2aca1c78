// SPDX-License-Identifier: Apache-2.0
// Life cycle, calls and data layouts of the OPEN-R-shaped API.
#include <MCOOP.h>
#include <OPENR/OFbkImage.h>
#include <OPENR/OObject.h>
#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <OPENR/OUnits.h>
#include <gtest/gtest.h>

#include <numeric>

#include "FakeSystem.h"

namespace kelpie::openr {
namespace {

class ApiTest : public testing::Test {
 protected:
  OPrimitiveID open(const char* locator) {
    OPrimitiveID id = 0;
    EXPECT_EQ(oSUCCESS, OPENR::OpenPrimitive(locator, &id)) << locator;
    return id;
  }

  FakeSystem system_;
  SystemScope scope_{system_};
};

TEST_F(ApiTest, EveryLocatorOfTheTablesOpensOnItsOwn) {
  std::vector<OPrimitiveID> ids;
  ids.reserve(kJointLocators.size() + kSensorLocators.size() + kLedLocators.size() +
              kEarLocators.size() + 1);
  for (const char* locator : kJointLocators) ids.push_back(open(locator));
  for (const char* locator : kSensorLocators) ids.push_back(open(locator));
  for (const char* locator : kLedLocators) ids.push_back(open(locator));
  for (const char* locator : kEarLocators) ids.push_back(open(locator));
  ids.push_back(open(kCameraLocator));
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(ids.end(), std::adjacent_find(ids.begin(), ids.end()));
  EXPECT_EQ(62U, ids.size());
}

TEST_F(ApiTest, LocatorsOfLegsFollowLegAndJoint) {
  const auto knee = firstJoint(LegId::rightHind) + 2;
  EXPECT_STREQ("PRM:/r5/c1/c2/c3-Joint2:53", kJointLocators[knee]);
  EXPECT_STREQ("PRM:/r1/c1/c2-Joint2:12", kJointLocators[index(Joint::headPan)]);
}

TEST_F(ApiTest, UnknownPrimitivesAreRefused) {
  OPrimitiveID id = 0;
  EXPECT_EQ(oNOT_FOUND, OPENR::OpenPrimitive("PRM:/r9-Joint2:99", &id));
  EXPECT_EQ(oprimitiveID_UNDEF, id);
  EXPECT_EQ(oINVALID_ARG, OPENR::OpenPrimitive(nullptr, &id));
  OJointValue value;
  EXPECT_EQ(oINVALID_PRIMITIVE_ID, OPENR::GetJointValue(12345, &value));
  EXPECT_EQ(oINVALID_PRIMITIVE_ID, OPENR::ClosePrimitive(12345));
}

TEST_F(ApiTest, GainsMustBeEnabledBeforeTheyAreSet) {
  const OPrimitiveID pan = open(kJointLocators[1]);
  EXPECT_EQ(oGAIN_DISABLED, OPENR::SetJointGain(pan, 8, 2, 4, 14, 2, 15));
  EXPECT_EQ(oSUCCESS, OPENR::EnableJointGain(pan));
  EXPECT_EQ(oSUCCESS, OPENR::SetJointGain(pan, 8, 2, 4, 14, 2, 15));
  word gain[6];
  EXPECT_EQ(oSUCCESS,
            OPENR::GetJointGain(pan, &gain[0], &gain[1], &gain[2], &gain[3], &gain[4], &gain[5]));
  EXPECT_EQ(4, gain[2]);
  EXPECT_EQ(15, gain[5]);
  EXPECT_EQ(2U, system_.gains());
}

TEST_F(ApiTest, UndefinedPrimitiveNamesAllOpenedJoints) {
  EXPECT_EQ(oINVALID_PRIMITIVE_ID, OPENR::EnableJointGain(oprimitiveID_UNDEF));
  open(kJointLocators[0]);
  open(kJointLocators[17]);
  open(kCameraLocator);
  EXPECT_EQ(oSUCCESS, OPENR::EnableJointGain(oprimitiveID_UNDEF));
  EXPECT_EQ(0x20001U, system_.gains());
}

TEST_F(ApiTest, JointValueIsInMicroradiansAndUnknownBeforeTheFirstSensors) {
  const OPrimitiveID pan = open(kJointLocators[1]);
  OJointValue value;
  EXPECT_EQ(oNOT_AVAILABLE, OPENR::GetJointValue(pan, &value));
  SensorFrame frame;
  frame.joints[Joint::headPan] = Angle::deg(45);
  frame.duty[1] = -0.5;
  system_.setLatest(host::rawOf(frame));
  ASSERT_EQ(oSUCCESS, OPENR::GetJointValue(pan, &value));
  EXPECT_EQ(785398, value.value);
  EXPECT_EQ(-256, value.pwmDuty);
}

TEST_F(ApiTest, PowerStatusTellsTheBatterysCurrentAndWhatIsLeftOfIt) {
  EXPECT_EQ(oINVALID_ARG, OPENR::GetPowerStatus(nullptr));
  OPowerStatus status{};
  system_.setBattery(1800.0, 0.734);
  ASSERT_EQ(oSUCCESS, OPENR::GetPowerStatus(&status));
  EXPECT_EQ(1800, status.current);
  EXPECT_EQ(73, status.remainingCapacity);
}

TEST_F(ApiTest, WhoObservesThePowerIsInformedOfEachChange) {
  const OServiceEntry entry(objectOf(7), 10);
  EXPECT_EQ(oINVALID_ARG, OPENR::ObservePowerStatus(OPowerStatus(), OServiceEntry()));
  ASSERT_EQ(oSUCCESS, OPENR::ObservePowerStatus(OPowerStatus(), entry));
  system_.tellPower();
  EXPECT_TRUE(system_.posted.empty());
  system_.setRobotStatus(orsbPAUSE);
  system_.tellPower();
  system_.tellPower();
  ASSERT_EQ(1U, system_.posted.size());
  EXPECT_TRUE(system_.posted[0].to == entry);
  const auto& reported = std::get<OPowerStatusMessage>(system_.posted[0].message);
  EXPECT_EQ(omsgPOWER_STATUS, reported.msgType);
  EXPECT_EQ(orsbPAUSE, reported.powerStatus.robotStatus);
  ASSERT_EQ(oSUCCESS, OPENR::UnobservePowerStatus(entry));
  EXPECT_EQ(oNOT_FOUND, OPENR::UnobservePowerStatus(entry));
  system_.setRobotStatus(0);
  system_.tellPower();
  EXPECT_EQ(1U, system_.posted.size());
}

TEST_F(ApiTest, CameraTakesOnlyItsOwnSettings) {
  const OPrimitiveID camera = open(kCameraLocator);
  OPrimitiveControl_CameraParam fast(ocamparamSHUTTER_FAST);
  const auto set = [&](OPrimitiveID id, OPrimitiveRequest request) {
    return OPENR::ControlPrimitive(id, request, &fast, sizeof fast, nullptr, 0);
  };
  EXPECT_EQ(oSUCCESS, set(camera, oprmreqCAM_SET_SHUTTER_SPEED));
  EXPECT_EQ(ocamparamSHUTTER_FAST, system_.camera().shutter);
  EXPECT_EQ(oINVALID_REQUEST, set(camera, oprmreqSPEAKER_MUTE_ON));
  EXPECT_EQ(oINVALID_REQUEST, set(open(kJointLocators[0]), oprmreqCAM_SET_GAIN));
  fast.camparam = 4;
  EXPECT_EQ(oINVALID_ARG, set(camera, oprmreqCAM_SET_GAIN));
}

TEST_F(ApiTest, CommandVectorHasRoomForItsDataBehindTheInfos) {
  MemoryRegionID id = 0;
  OCommandVectorData* vector = nullptr;
  ASSERT_EQ(oSUCCESS, OPENR::NewCommandVectorData(3, &id, &vector));
  EXPECT_EQ(0U, vector->vectorInfo.numData);
  const std::size_t infos = sizeof(ODataVectorInfo) + 3 * sizeof(OCommandInfo);
  EXPECT_EQ(infos + 3 * 128, vector->vectorInfo.totalSize);
  EXPECT_EQ(infos + 2 * 128, vector->GetInfo(2)->dataOffset);
  EXPECT_EQ(vector->info + 2, vector->GetInfo(2));
  EXPECT_EQ(oSUCCESS, OPENR::DeleteCommandVectorData(id));
  EXPECT_EQ(oINVALID_DATA_VECTOR_ID, OPENR::DeleteCommandVectorData(id));
}

TEST_F(ApiTest, TimeAndIdentityComeFromTheSystem) {
  SystemTime time;
  GetSystemTime(&time);
  EXPECT_EQ(12U, time.seconds);
  EXPECT_EQ(345678U, time.useconds);
  OID self;
  WhoAmI(&self);
  EXPECT_TRUE(self == objectOf(7));
}

TEST_F(ApiTest, LogLinesEndAt243Characters) {
  OSYSLOG1((osyslogWARNING, "%s", std::string(500, 'x').c_str()));
  EXPECT_EQ(oSUCCESS, OSYSPRINT(("%d", 5)));
  ASSERT_EQ(2U, system_.lines.size());
  EXPECT_EQ(osyslogWARNING, system_.lines[0].first);
  EXPECT_EQ(243U, system_.lines[0].second.size());
  EXPECT_EQ("5", system_.lines[1].second);
}

TEST_F(ApiTest, LifeCycleCallsTheDoMethodAndReportsItsStatus) {
  class Refuses : public OObject {
   public:
    OStatus DoInit(const OSystemEvent&) override { return myOID_ == objectOf(7) ? oBUSY : oFAIL; }
  } object;
  object.Init(OSystemEvent(oreasonBOOT, nullptr, 0));
  object.Start(OSystemEvent(oreasonBOOT, nullptr, 0));
  EXPECT_EQ((std::vector<OStatus>{oBUSY, oSUCCESS}), system_.statuses);
}

TEST(ApiDeathTest, CallOutsideAMethodEndsTheProgram) {
  EXPECT_DEATH(OPENR::SetMotorPower(opowerON), "outside a method of an object");
}

TEST(UnitsTest, DegreesBecomeMicroradians) {
  EXPECT_EQ(1570796, oradians(90));
  EXPECT_EQ(-2500000, micro(-2.5));
}

// Rows of a 4 x 2 image: byte value = 10 * line + band in the row.
std::vector<byte> rows(int bands) {
  std::vector<byte> bytes;
  for (int i = 0; i < 2 * bands * 4; ++i) {
    const int line = i / (bands * 4);
    bytes.push_back(static_cast<byte>(10 * line + i / 4 % bands));
  }
  return bytes;
}

OFbkImageInfo small(ODataType type) {
  OFbkImageInfo info{};
  info.type = type;
  info.width = 4;
  info.height = 2;
  return info;
}

TEST(FbkImageTest, BandsAreRowsOfEachLine) {
  auto data = rows(3);
  OFbkImageInfo info = small(odataFBK_YCrCb);
  const OFbkImage cb(&info, data.data(), ofbkimageBAND_Cb);
  ASSERT_TRUE(cb.IsValid());
  EXPECT_EQ(8, cb.Skip());
  EXPECT_EQ(12, cb.Pixel(3, 1));
  EXPECT_FALSE(OFbkImage(&info, data.data(), ofbkimageBAND_Y_LH).IsValid());
}

TEST(FbkImageTest, HighPassRowsFollowTheChroma) {
  auto data = rows(6);
  OFbkImageInfo info = small(odataFBK_YCrCb_HPF);
  const std::pair<OFbkImageBand, int> places[] = {{ofbkimageBAND_Y, 0},    {ofbkimageBAND_Cr, 1},
                                                  {ofbkimageBAND_Cb, 2},   {ofbkimageBAND_Y_LH, 3},
                                                  {ofbkimageBAND_Y_HL, 4}, {ofbkimageBAND_Y_HH, 5}};
  for (const auto& [band, place] : places) {
    const OFbkImage image(&info, data.data(), band);
    ASSERT_TRUE(image.IsValid());
    EXPECT_EQ(20, image.Skip());
    EXPECT_EQ(10 + place, image.Pixel(0, 1));
  }
  EXPECT_FALSE(OFbkImage(&info, data.data(), ofbkimageBAND_CDT).IsValid());
}

TEST(FbkImageTest, TagIsReadFromTheLastLine) {
  OFbkImageInfo info = small(odataFBK_CDT);
  info.width = 12;
  std::vector<byte> data(24);
  std::iota(data.begin(), data.end(), byte{0});
  const OFbkImage image(&info, data.data(), ofbkimageBAND_CDT);
  EXPECT_EQ(12 + 256 * 13, image.FieldCounter());
  EXPECT_EQ(12 + 8, image.ColorFrequency(ocdtCHANNEL0));
  EXPECT_EQ(12 + 4, image.ColorFrequency(ocdtCHANNEL4));
  EXPECT_EQ(12 + 7, image.ColorFrequency(ocdtCHANNEL7));
  EXPECT_EQ(0, image.ColorFrequency(ocdtCHANNEL_UNDEF));
}

}  // namespace
}  // namespace kelpie::openr
