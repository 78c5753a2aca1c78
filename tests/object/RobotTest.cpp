// SPDX-License-Identifier: Apache-2.0
// The loops that the OPEN-R object of a robot makes when it is initialised.
#include <gtest/gtest.h>

#include <memory>

#include "robot/core/fields/FieldCheck.h"
#include "robot/object/Robot.h"

namespace kelpie::object {
namespace {

TEST(Robot, TakesSensorsAndImagesWithTheStandardConfiguration) {
  const auto late = std::make_unique<LateLoops>();
  agent::Loops& loops = *late;  // kept before there are any
  late->make(*makeConfig(), "");
  const auto input = std::make_unique<MotionInput>();
  const auto image = std::make_unique<Image>();
  for (int message = 1; message <= 40; ++message) {
    input->time = TimeUs{32000 * message};
    const MotionOutput& out = loops.motion(*input);
    std::string why;
    EXPECT_TRUE(verify(out, &why)) << why;
    loops.camera(*image, TimeUs{32000 * message - 20000}, static_cast<std::uint32_t>(message));
  }
}

TEST(Robot, ASecondInitialisationLeavesTheLoopsThatPlay) {
  const auto late = std::make_unique<LateLoops>();
  const auto config = makeConfig();
  late->make(*config, "");
  const MotionOutput* first = &late->motion(*std::make_unique<MotionInput>());
  late->make(*config, "");
  EXPECT_EQ(&late->motion(*std::make_unique<MotionInput>()), first);
}

TEST(Robot, LoopsThatWereNeverMadeAreNotEnded) { const auto late = std::make_unique<LateLoops>(); }

}  // namespace
}  // namespace kelpie::object
