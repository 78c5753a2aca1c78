// SPDX-License-Identifier: Apache-2.0
// What the robot's camera is told, from the configuration to OPEN-R.
#include "robot/core/fields/FieldCheck.h"
#include "tests/agent/Story.h"

namespace kelpie::agent {
namespace {

// Loops that know their configuration late, as a robot's do, which reads its stick first.
class LateSettings : public AgentLoops {
 public:
  using AgentLoops::AgentLoops;

  const MotionOutput& motion(const MotionInput& input) override {
    known_ = known_ || ++messages_ > 5;
    return AgentLoops::motion(input);
  }
  CameraSettings cameraSettings() const override {
    return known_ ? AgentLoops::cameraSettings() : CameraSettings{};
  }

 private:
  int messages_ = 0;
  bool known_ = false;
};

constexpr CameraSettings kLamps{WhiteBalance::indoor, CameraGain::low, Shutter::slow};

class CameraStory : public Story {
 protected:
  void expectCamera(longword balance, longword gain, longword shutter) const {
    EXPECT_EQ(system_->camera().whiteBalance, balance);
    EXPECT_EQ(system_->camera().gain, gain);
    EXPECT_EQ(system_->camera().shutter, shutter);
  }
};

TEST_F(CameraStory, WithoutParametersItIsSetAsIn2005) {
  play(0.1);
  expectCamera(ocamparamWB_FL_MODE, ocamparamGAIN_HIGH, ocamparamSHUTTER_FAST);
}

TEST_F(CameraStory, TheConfigurationSetsIt) {
  config_->camera = kLamps;
  play(0.1);
  expectCamera(ocamparamWB_INDOOR_MODE, ocamparamGAIN_LOW, ocamparamSHUTTER_SLOW);
}

TEST_F(CameraStory, AConfigurationThatIsReadLaterSetsItThen) {
  config_->camera = kLamps;
  LateSettings loops(*config_, KELPIE_SOURCE_DIR "/pycode", *this);
  play(0.5, loops);
  expectCamera(ocamparamWB_INDOOR_MODE, ocamparamGAIN_LOW, ocamparamSHUTTER_SLOW);
}

TEST(CameraSettings, NumbersThatOpenrDoesNotHaveAreOutOfRange) {
  CameraSettings settings;
  std::string why;
  EXPECT_TRUE(verify(settings, &why));
  settings.gain = static_cast<CameraGain>(0);
  EXPECT_FALSE(verify(settings, &why));
  settings.gain = static_cast<CameraGain>(4);
  EXPECT_FALSE(verify(settings, &why));
}

}  // namespace
}  // namespace kelpie::agent
