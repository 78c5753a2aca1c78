// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "robot/openr/Ers7Primitives.h"
#include "tests/behaviour/Scripts.h"

namespace kelpie::behaviour {
namespace {

Command decided(const std::string& body, std::string* error = nullptr) {
  const Scripts scripts(body);
  HostRun run(scripts);
  const Command command = run.step();
  if (error != nullptr) *error = run.state.lastError();
  return command;
}

TEST(CommandReader, NotANumberIsABadCommand) {
  std::string error;
  const Command command =
      decided("return kelpie.Command(walk=kelpie.WalkRequest(forward=math.nan))", &error);
  EXPECT_EQ(command.fallback, Fallback::badCommand);
  EXPECT_EQ(command.walk.forward, 0.0);
  EXPECT_NE(error.find("Command.walk.forward is not finite"), std::string::npos) << error;
}

TEST(CommandReader, InfiniteHeadAngleIsABadCommand) {
  EXPECT_EQ(
      decided("return kelpie.Command(head=kelpie.HeadRequest(head_pan_deg=math.inf))").fallback,
      Fallback::badCommand);
}

TEST(CommandReader, WrongTypesAreBadCommands) {
  for (const char* body :
       {"return None", "return 7", "return kelpie.Command(walk=3)",
        "return kelpie.Command(walk=kelpie.WalkRequest(left='fast'))",
        "return kelpie.Command(mouth_open=1)", "return kelpie.Command(motion=1.5)",
        "return kelpie.Command(leds=10**400)"}) {
    EXPECT_EQ(decided(body).fallback, Fallback::badCommand) << body;
  }
}

TEST(CommandReader, MisspeltNameIsAScriptError) {
  EXPECT_EQ(decided("return kelpie.Command(wlak=kelpie.WalkRequest())").fallback,
            Fallback::scriptError);
}

TEST(CommandReader, EverythingIsClampedToTheFieldLists) {
  const Command command = decided(
      "return kelpie.Command(walk=kelpie.WalkRequest(forward=1e9, left=-1e9, turn_deg=-1e9), "
      "head=kelpie.HeadRequest(neck_tilt_deg=300, head_pan_deg=-300, head_nod_deg=46), "
      "motion=77, leds=-4)");
  EXPECT_EQ(command.fallback, Fallback::none);
  EXPECT_EQ(command.walk.forward, 60.0);
  EXPECT_EQ(command.walk.left, -35.0);
  EXPECT_EQ(command.walk.turn, -4.5);
  EXPECT_NEAR(command.head.neckTilt.deg(), 0.0, 1e-12);
  EXPECT_NEAR(command.head.headPan.deg(), -88.0, 1e-12);
  EXPECT_NEAR(command.head.headNod.deg(), 45.0, 1e-12);
  EXPECT_EQ(command.motion, MotionKind::grabLift);
  EXPECT_EQ(command.leds, 0u);
}

TEST(CommandReader, LedsAreAskedForByName) {
  const Command command = decided(
      "return kelpie.Command(leds=kelpie.LED_MODE_RED + kelpie.LED_FACE[0] + "
      "kelpie.LED_FACE[13] + kelpie.LED_BACK_REAR_WHITE)");
  std::string lit;
  for (std::size_t i = 0; i < openr::kLedCount; ++i)
    if ((command.leds >> i & 1U) != 0) lit += std::string(openr::kLedLocators[i]).substr(4) + " ";
  EXPECT_EQ(lit,
            "/r1/c1/c2/c3/l3-LED2:l3 /r1/c1/c2/c3/la-LED3:la /r1/c1/c2/c3/ln-LED3:ln "
            "/lz-LED3:lz ");
}

TEST(CommandReader, TailEarsAndMouthAreAsTheScriptAsked) {
  const Command command = decided(
      "return kelpie.Command(tail=kelpie.TailRequest(tilt_deg=50, pan_deg=-20), "
      "ears=kelpie.EarRequest(right_up=True), mouth_open=True)");
  EXPECT_EQ(command.fallback, Fallback::none);
  EXPECT_NEAR(command.tail.tilt.deg(), 50.0, 1e-12);
  EXPECT_NEAR(command.tail.pan.deg(), -20.0, 1e-12);
  EXPECT_TRUE(command.ears.rightUp && !command.ears.leftUp && command.mouthOpen);
}

}  // namespace
}  // namespace kelpie::behaviour
