// SPDX-License-Identifier: Apache-2.0
// The whole object against a source without a world.
#include <gtest/gtest.h>

#include <algorithm>

#include "FakeWorld.h"
#include "robot/agent/Agent.h"
#include "robot/host/AgentStub.h"
#include "robot/host/RunAgent.h"

namespace kelpie::host {
namespace {

HostParams quiet() {
  HostParams params;
  params.printTo = nullptr;
  return params;
}

double panOf(const EffectorVector& vector, std::size_t tick = 0) {
  return anglesOf(vector.targets[tick])[Joint::headPan].deg();
}

TEST(RunAgentTest, PowersTheMotorsWhenCommandedToAndSetsGainsOnlyAfterATargetWasTaken) {
  FakeSource source;
  source.addSensors(2);
  FakeLoops loops;
  ASSERT_TRUE(runAgent(source, loops, quiet(), {}));
  EXPECT_TRUE(source.replies.at(0).motorPower);
  EXPECT_EQ(0U, source.replies.at(0).gains);
  EXPECT_EQ(kAllJoints, source.replies.at(1).gains);
  EXPECT_EQ(0U, loops.inputs.at(0).held);
}

TEST(RunAgentTest, MotorsThatNobodyOrdersHaveNoPower) {
  FakeSource source;
  source.addSensors(3);
  FakeLoops loops;
  loops.ordered = {};
  ASSERT_TRUE(runAgent(source, loops, quiet(), {}));
  EXPECT_FALSE(source.replies.back().motorPower);
  EXPECT_EQ(0U, source.replies.back().gains);
}

TEST(RunAgentTest, StartsWithTheSensedPoseAndKeepsTwoVectorsInFlight) {
  FakeSource source;
  source.addSensors(4);
  FakeLoops loops;
  ASSERT_TRUE(runAgent(source, loops, quiet(), {}));
  ASSERT_EQ(2U, source.replies.at(0).vectors.size());
  EXPECT_NEAR(11.0, panOf(source.replies[0].vectors[0]), 1e-4);
  EXPECT_NEAR(1.0, panOf(source.replies[0].vectors[1], 3), 1e-4);
  EXPECT_EQ(4U, source.replies[0].vectors[1].ticks);
  for (std::size_t i = 1; i < 4; ++i) {
    ASSERT_EQ(1U, source.replies.at(i).vectors.size());
    EXPECT_NEAR(static_cast<double>(i + 1), panOf(source.replies[i].vectors[0]), 1e-4);
  }
}

TEST(RunAgentTest, SendsTwoAgainAfterTheJointsRanDry) {
  FakeSource source;
  source.addSensors(3);
  source.steps[2].vectorsDone = 2;
  FakeLoops loops;
  ASSERT_TRUE(runAgent(source, loops, quiet(), {}));
  ASSERT_EQ(2U, source.replies.at(2).vectors.size());
  EXPECT_NEAR(2.0, panOf(source.replies[2].vectors[0]), 1e-4);  // the last target is held
  EXPECT_NEAR(3.0, panOf(source.replies[2].vectors[1]), 1e-4);
}

TEST(RunAgentTest, VectorWaitsForRoomWhenTheWorldPlaysLate) {
  FakeSource source;
  source.addSensors(3);
  source.steps[1].vectorsDone = 0;
  FakeLoops loops;
  ASSERT_TRUE(runAgent(source, loops, quiet(), {}));
  EXPECT_EQ(0U, source.replies.at(1).vectors.size());
  ASSERT_EQ(1U, source.replies.at(2).vectors.size());
  EXPECT_NEAR(2.0, panOf(source.replies[2].vectors[0]), 1e-4);  // none is lost
}

TEST(RunAgentTest, MoreVectorsPlayedThanSentIsAnError) {
  FakeSource source;
  source.addSensors(2);
  source.steps[1].vectorsDone = 3;
  FakeLoops loops;
  EXPECT_EQ("the world has played 3 command vectors, but got 2",
            runAgent(source, loops, quiet(), {}).error());
}

TEST(RunAgentTest, SensorTimeIsThatOfTheLastTick) {
  FakeSource source;
  source.addSensors(3);
  source.steps[1].time.us += 5000;  // delivered late, sensed in time
  FakeLoops loops;
  ASSERT_TRUE(runAgent(source, loops, quiet(), {}));
  EXPECT_EQ(32000, loops.inputs.at(0).time.us);
  EXPECT_NEAR(64000, static_cast<double>(loops.inputs.at(1).time.us), 3.0) << "of clocks that part";
  EXPECT_EQ(96000, loops.inputs.at(2).time.us);
}

TEST(RunAgentTest, ExposureIsInTheMiddleOfTheLastThirtiethOfASecond) {
  FakeSource source;
  source.addSensors(1);
  source.addImage(100000);
  FakeLoops loops;
  ASSERT_TRUE(runAgent(source, loops, quiet(), {}));
  ASSERT_EQ(1U, loops.exposures.size());
  EXPECT_NEAR(100000 - 1e6 / 60, static_cast<double>(loops.exposures[0].us), 1.0);
}

TEST(RunAgentTest, ImagePassesUnchangedButForTheTagLine) {
  for (const bool highPass : {false, true}) {
    FakeSource source;
    source.addSensors(1);
    source.addImage(50000);
    Random random(3);
    for (std::size_t i = 0; i < kImagePixels; ++i) {
      source.image.y[i] = static_cast<std::uint8_t>(random.next());
      source.image.cr[i] = static_cast<std::uint8_t>(random.next());
      source.image.cb[i] = static_cast<std::uint8_t>(random.next());
    }
    FakeLoops loops;
    HostParams params = quiet();
    params.highPassRows = highPass;
    ASSERT_TRUE(runAgent(source, loops, params, {}));
    for (int x = 0; x < kImageWidth; ++x) {
      const Yuv above = source.image.pixel(x, kImageHeight - 2);
      source.image.set(x, kImageHeight - 1, above);
    }
    EXPECT_EQ(source.image.y, loops.lastImage.y);
    EXPECT_EQ(source.image.cr, loops.lastImage.cr);
    EXPECT_EQ(source.image.cb, loops.lastImage.cb);
  }
}

TEST(RunAgentTest, LedsArriveBitByBit) {
  FakeSource source;
  source.addSensors(1);
  FakeLoops loops;
  loops.leds = 0x2a5a5a5;
  ASSERT_TRUE(runAgent(source, loops, quiet(), {}));
  EXPECT_EQ(0U, source.replies.at(0).vectors[0].leds);
  EXPECT_EQ(0x2a5a5a5U, source.replies.at(0).vectors[1].leds);
}

TEST(RunAgentTest, EveryVectorCommandsAllJoints) {
  FakeSource source;
  source.addSensors(1);
  FakeLoops loops;
  ASSERT_TRUE(runAgent(source, loops, quiet(), {}));
  for (const EffectorVector& vector : source.replies.at(0).vectors) {
    EXPECT_EQ((1U << kJointCount) - 1, vector.joints);
    EXPECT_NEAR(anglesOf(vector.targets[0])[Joint::mouth].deg(),
                &vector == &source.replies[0].vectors[0] ? -20 : 0, 1e-4);
  }
}

TEST(RunAgentTest, DropsExactlyTheImagesThatTheSeedChooses) {
  FakeSource source;
  source.addSensors(1);
  Random expected(42);
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < 300; ++i) {
    source.addImage(40000 + 1000 * i);
    kept += expected.chance(0.25) ? 0U : 1U;
  }
  FakeLoops loops;
  HostParams params = quiet();
  params.dropRate = 0.25;
  params.seed = 42;
  const auto summary = runAgent(source, loops, params, {});
  ASSERT_TRUE(summary) << summary.error();
  EXPECT_EQ(kept, loops.exposures.size());
  EXPECT_EQ(kept, summary->images);
  EXPECT_EQ(300U, summary->images + summary->droppedImages);
  EXPECT_NEAR(225, kept, 25);
  // The camera's numbers tell which are missing.
  EXPECT_LT(loops.cameraNumbers.back(), 300U);
  EXPECT_GT(loops.cameraNumbers.back(), kept);
  EXPECT_TRUE(std::is_sorted(loops.cameraNumbers.begin(), loops.cameraNumbers.end()));
}

TEST(RunAgentTest, NothingIsDroppedUnasked) {
  FakeSource source;
  source.addSensors(1);
  for (int i = 0; i < 100; ++i) source.addImage(40000 + 1000 * i);
  source.addSensors(100);
  for (std::size_t i = 101; i < source.steps.size(); ++i) source.steps[i].time.us += 200000;
  FakeLoops loops;
  ASSERT_TRUE(runAgent(source, loops, quiet(), {}));
  EXPECT_EQ(100U, loops.exposures.size());
  EXPECT_EQ(101U, loops.inputs.size());
}

TEST(RunAgentTest, EventsBeforeTheFirstSensorsAreAnsweredWithoutPower) {
  FakeSource source;
  source.addImage(1000);
  source.addSensors(1);
  FakeLoops loops;
  ASSERT_TRUE(runAgent(source, loops, quiet(), {}));
  ASSERT_EQ(2U, source.replies.size());
  EXPECT_FALSE(source.replies[0].motorPower);
  EXPECT_TRUE(source.replies[1].motorPower);
}

TEST(RunAgentTest, APacketOfTheGameControllerComesBeforeTheSensorsOfItsStep) {
  FakeSource source;
  source.addSensors(3);
  source.steps[1].control.bytes.push_back(3);
  FakeLoops loops;
  std::vector<std::size_t> inputsBefore;
  std::vector<int> bytes;
  Network network;
  network.control = [&](const ControlPacket& packet, TimeUs now) {
    inputsBefore.push_back(loops.inputs.size());
    bytes.push_back(packet.bytes[0]);
    EXPECT_EQ(64000, now.us);
  };
  ASSERT_TRUE(runAgent(source, loops, quiet(), network));
  EXPECT_EQ(std::vector<std::size_t>{1}, inputsBefore) << "none came with the other steps";
  EXPECT_EQ(std::vector<int>{3}, bytes);
}

TEST(RunAgentTest, BrokenSourceIsReportedAfterTheObjectWasStopped) {
  FakeSource source;
  source.addSensors(2);
  source.failure = "world socket: gone";
  FakeLoops loops;
  EXPECT_EQ("world socket: gone", runAgent(source, loops, quiet(), {}).error());
}

TEST(AgentTest, UsesTheCameraAndTheStandardGainsOf2005) {
  FakeSource source;
  source.addSensors(2);
  FakeLoops loops;
  const auto object = std::make_unique<agent::Agent>(loops);
  HostSystem system(source, quiet());
  ASSERT_TRUE(system.run(agentStub(*object), {}));
  EXPECT_EQ(ocamparamWB_FL_MODE, system.camera().whiteBalance);
  EXPECT_EQ(ocamparamGAIN_HIGH, system.camera().gain);
  EXPECT_EQ(ocamparamSHUTTER_FAST, system.camera().shutter);
  openr::GainSettings gain{};
  const auto knee = index(Joint::rightHindKnee);
  system.getGain(identifier({PrimitiveKind::joint, knee}), &gain);  // off again since DoStop
  EXPECT_EQ(0x1C, gain.p);
  system.getGain(identifier({PrimitiveKind::joint, knee - 1}), &gain);  // off again since DoStop
  EXPECT_EQ(0x14, gain.p);
  EXPECT_EQ(0x0E, gain.pShift);
}

TEST(AgentTest, TellsTheLoopsTheBatterysCurrentInWholeMilliamperesAndItsChargeInPercent) {
  FakeSource source;
  source.addSensors(2);
  source.steps[0].batteryCurrent = 2345.4;
  source.steps[1].batteryCurrent = 1e5;  // more than OPEN-R's word holds
  source.steps[1].batteryCharge = 0.734;
  FakeLoops loops;
  ASSERT_TRUE(runAgent(source, loops, quiet(), {}));
  EXPECT_EQ(loops.inputs.at(0).batteryCurrent, 2345.0);
  EXPECT_EQ(loops.inputs.at(1).batteryCurrent, 32767.0);
  EXPECT_EQ(loops.inputs.at(0).batteryCharge, 1.0);
  EXPECT_EQ(loops.inputs.at(1).batteryCharge, 0.73);
}

TEST(AgentTest, TellsTheLoopsOfAPauseAndOfItsEndBeforeTheSensorsOfThatStep) {
  FakeSource source;
  source.addSensors(4);
  FakeLoops loops;
  const auto object = std::make_unique<agent::Agent>(loops);
  HostSystem system(source, quiet());
  std::size_t reported[4] = {};
  Network network;
  int step = 0;
  network.tick = [&](TimeUs) { system.setRobotStatus(step++ == 1 ? orsbPAUSE : 0); };
  network.sends = [&](RadioPacket&) {
    reported[step - 1] = loops.reports.size();
    return false;
  };
  ASSERT_TRUE(system.run(agentStub(*object), network));
  EXPECT_EQ(1U, reported[0]) << "at the start it asks";
  ASSERT_EQ(3U, loops.reports.size());
  EXPECT_FALSE(loops.reports[0].paused);
  EXPECT_FALSE(loops.reports[0].motorPower);
  EXPECT_TRUE(loops.reports[1].paused);
  EXPECT_TRUE(loops.reports[1].motorPower);
  EXPECT_FALSE(loops.reports[2].paused);
  EXPECT_EQ(2U, reported[1]);
  EXPECT_EQ(3U, reported[3]);
}

TEST(AgentTest, HoldsNoJointWithoutPowerAndNoneAfterItBeforeATargetWasTaken) {
  FakeSource source;
  source.addSensors(7);
  FakeLoops loops;
  const auto object = std::make_unique<agent::Agent>(loops);
  HostSystem system(source, quiet());
  Network network;
  int step = 0;
  network.tick = [&](TimeUs) {
    if (++step == 3) system.setMotorPower(opowerOFF);
    loops.ordered.order.power = step != 3 && step != 4;
  };
  ASSERT_TRUE(system.run(agentStub(*object), network));
  EXPECT_EQ(kAllJoints, source.replies.at(1).gains);
  EXPECT_FALSE(loops.reports.at(2).motorPower);
  EXPECT_EQ(0U, source.replies.at(2).gains);
  EXPECT_EQ(0U, loops.inputs.at(2).held);
  EXPECT_TRUE(source.replies.at(4).motorPower);
  EXPECT_EQ(0U, source.replies.at(4).gains);
  EXPECT_EQ(kAllJoints, source.replies.at(6).gains);
}

TEST(AgentTest, WeakensTheLegsAloneWhenTheLoopsSaySo) {
  FakeSource source;
  source.addSensors(3);
  FakeLoops loops;
  const auto object = std::make_unique<agent::Agent>(loops);
  HostSystem system(source, quiet());
  loops.output.status.lowGain = true;
  ASSERT_TRUE(system.run(agentStub(*object), {}));
  openr::GainSettings gain{};
  const auto shoulder = index(Joint::leftHindShoulder);
  system.getGain(identifier({PrimitiveKind::joint, shoulder}), &gain);  // off again since DoStop
  EXPECT_EQ(0x0A, gain.p);
  const auto pan = index(Joint::headPan);
  system.getGain(identifier({PrimitiveKind::joint, pan}), &gain);  // off again since DoStop
  EXPECT_EQ(0x08, gain.p);
  EXPECT_NEAR(source.replies.back().legGain, (8 * 16.0 / 28 + 4 * 10.0 / 20) / 12, 1e-12);
}

// Wants soft legs in its first messages.
class LoopsThatSoften : public FakeLoops {
 public:
  explicit LoopsThatSoften(std::size_t messages) : messages_(messages) {}
  const MotionOutput& motion(const MotionInput& input) override {
    output.status.legGain = inputs.size() < messages_ ? 0.4 : 1.0;
    return FakeLoops::motion(input);
  }

 private:
  std::size_t messages_;
};

double legGainSent(LoopsThatSoften& loops) {
  FakeSource source;
  source.addSensors(5);
  EXPECT_TRUE(runAgent(source, loops, quiet(), {}));
  return source.replies.back().legGain;
}

TEST(AgentTest, SoftensTheLegsForAMotionAndGivesThemAllTheirGainBack) {
  LoopsThatSoften soft(5);
  EXPECT_NEAR(legGainSent(soft), (8 * 11.0 / 28 + 4 * 8.0 / 20) / 12, 1e-12);
  LoopsThatSoften softUntilTheThird(3);
  EXPECT_EQ(legGainSent(softUntilTheThird), 1.0);
}

}  // namespace
}  // namespace kelpie::host
