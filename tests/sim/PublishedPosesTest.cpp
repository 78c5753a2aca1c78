// SPDX-License-Identifier: Apache-2.0
// Two poses that Sony published with its sample MovingLegs7, through the agent's OPEN-R side into
// the physical world: a dog must lie there. The angles know nothing of our signs. What the agent
// reads in them and what the world makes of them are judged apart, since a raw number that is
// turned on the way in and back on the way out is the same again whatever the sign.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "robot/agent/AgentIo.h"
#include "robot/body/Ers7.h"
#include "robot/body/Legs.h"
#include "robot/host/primitives/DataVectors.h"
#include "tests/openr/OpenedRobot.h"
#include "tools/sim/physics/PhysicalBodies.h"

namespace kelpie::sim {
namespace {

// Degrees in the robot's sign: J1, J2, J3 of both front legs, then of both hind legs.
struct Published {
  std::array<double, 3> front;
  std::array<double, 3> hind;
};
constexpr Published kSleeping = {{59, 0, 30}, {-119, 4, 122}};
constexpr Published kBroadBase = {{120, 90, 30}, {-120, 70, 30}};

std::array<slongword, kJointCount> rawOf(const Published& pose) {
  constexpr double kDegree = 17453.2925;  // urad
  constexpr std::size_t kLegs = index(Joint::leftFrontRotator);
  std::array<slongword, kJointCount> raw{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (const std::size_t front : {kLegs, kLegs + 6})
      raw[front + i] = static_cast<slongword>(kDegree * pose.front[i]);
    for (const std::size_t hind : {kLegs + 3, kLegs + 9})
      raw[hind + i] = static_cast<slongword>(kDegree * pose.hind[i]);
  }
  raw[index(Joint::mouth)] = -52360;
  raw[index(Joint::tailTilt)] = 523599;
  return raw;
}

// What the agent reads of a robot that is posed so.
JointAngles readBy(const agent::Senses& senses, const Published& pose) {
  openr::OpenedRobot robot;
  RCRegion* region = host::newSensorRegion(0);  // joints first, in the order of Joint
  auto& vector = *reinterpret_cast<OSensorFrameVectorData*>(region->Base());
  const auto raw = rawOf(pose);
  for (std::size_t i = 0; i < kJointCount; ++i)
    for (std::size_t tick = 0; tick < kTicksPerMessage; ++tick)
      vector.GetData(static_cast<int>(i))->frame[tick].value = raw[i];
  std::array<SensorFrame, kTicksPerMessage> frames{};
  agent::SensorReader reader(senses);
  reader.match(vector, robot.ids);
  reader.read(vector, frames);
  region->RemoveReference();
  return frames.back().joints;
}

// What the agent sends for it, as the world gets it.
host::AgentReply sentBy(const agent::Senses& senses, const JointAngles& joints) {
  openr::OpenedRobot robot;
  JointFrame frame;
  frame.target = joints;
  OCommandVectorData& vector = robot.commanded(frame, senses);
  auto* region =
      new RCRegion(vector.vectorInfo.memRegionID, 0, &vector, vector.vectorInfo.totalSize);
  host::AgentReply reply;
  reply.motorPower = true;
  reply.gains = kAllJoints;
  reply.vectors.resize(1);
  EXPECT_EQ("", host::readCommands(*region, robot, reply.vectors[0]));
  region->RemoveReference();
  return reply;
}

std::unique_ptr<PhysicalBodies> settled(const host::AgentReply& reply) {
  constexpr int kTwoSeconds = 250;  // ticks
  const auto field = *body::fieldDescription("2006");
  PhysicalStart start;
  start.pose = {{180.0, 200.0}, Angle::deg(90.0)};
  auto built = PhysicalBodies::build(field, {start}, {}, {});
  std::unique_ptr<PhysicalBodies> bodies = std::move(*built);
  bodies->putBall({{20.0, 20.0}, {}});
  bodies->command(0, reply);
  for (int tick = 0; tick < kTwoSeconds; ++tick) EXPECT_TRUE(bodies->tick());
  return bodies;
}

// How a robot lies on the ground; heights in cm of its own shoulder and hip axes and of the lowest
// point of each paw.
struct Lying {
  double shoulder = 0.0;
  double hip = 0.0;
  double roll = 0.0;  // deg
  std::array<double, kLegCount> paw{};
};

double hipOf(const Stance& stance) {
  return stance.shoulderHeight + body::kBodyLength * stance.bodyTilt.sin();
}

// As the agent's kinematics have it.
Lying believed(const JointAngles& joints) {
  const Stance stance = body::stanceFromLegs(joints);
  Lying lying{stance.shoulderHeight, hipOf(stance), 0.0, {}};
  for (std::size_t i = 0; i < kLegCount; ++i) {
    const body::Support paw = body::supportOf(i, joints);
    lying.paw[i] = body::robotFromTorso(stance, paw.middle).z - paw.radius;
  }
  return lying;
}

// As it lies in the world.
Lying truth(PhysicalBodies& bodies) {
  const BodyPlace place = bodies.place(0);
  Lying lying{place.stance.shoulderHeight, hipOf(place.stance), place.lean.roll.deg(), {}};
  const Engine& engine = bodies.physics().engine();
  for (std::size_t i = 0; i < kLegCount; ++i) {
    const int geom = engine.geom("r0_paw" + std::to_string(i));
    lying.paw[i] =
        100.0 * (engine.data().geom_xpos[3 * geom + 2] - engine.model().geom_size[3 * geom]);
  }
  return lying;
}

// Sleeping: the trunk level and low, forearms flat, every paw near the ground. The hips come to
// rest on the belly, 5 cm up; the angles alone have them at 4.5 to 5.7.
bool sleeps(const Lying& lying) {
  bool low = std::fabs(lying.shoulder - lying.hip) < 2.0 && std::fabs(lying.roll) < 3.0 &&
             lying.shoulder < 7.0 && lying.hip < 7.0;
  for (const double paw : lying.paw) low = low && paw < 2.5;
  return low;
}

// Broad base: chest and belly on the ground, the hind legs down beside it.
bool liesBroad(const Lying& lying) {
  return std::fabs(lying.shoulder - body::kChestDepth) < 1.0 &&
         std::fabs(lying.hip - body::kChestDepth) < 1.0 && std::fabs(lying.roll) < 3.0 &&
         lying.paw[index(LegId::leftHind)] < 4.0 && lying.paw[index(LegId::rightHind)] < 4.0;
}

std::string reported(const Lying& lying) {
  std::string text = "shoulder " + std::to_string(lying.shoulder) + ", hip " +
                     std::to_string(lying.hip) + ", roll " + std::to_string(lying.roll) + ", paws";
  for (const double paw : lying.paw) text += " " + std::to_string(paw);
  return text;
}

agent::Senses withHindLegsTurned() {
  agent::Senses senses = agent::robotSenses();
  for (const Joint joint : {Joint::leftHindRotator, Joint::rightHindRotator})
    senses.joints[index(joint)] = -senses.joints[index(joint)];
  return senses;
}

TEST(PublishedPoses, TheAgentReadsADogThatSleeps) {
  const Lying lying = believed(readBy(agent::robotSenses(), kSleeping));
  EXPECT_TRUE(sleeps(lying)) << reported(lying);
}

TEST(PublishedPoses, TheAgentReadsABroadBase) {
  const Lying lying = believed(readBy(agent::robotSenses(), kBroadBase));
  EXPECT_TRUE(liesBroad(lying)) << reported(lying);
}

TEST(PublishedPoses, SleepingLiesInTheWorldAsTheAgentReadsIt) {
  const JointAngles joints = readBy(agent::robotSenses(), kSleeping);
  const auto bodies = settled(sentBy(agent::robotSenses(), joints));
  const Lying lying = truth(*bodies);
  EXPECT_TRUE(sleeps(lying)) << reported(lying);
  EXPECT_NEAR(believed(joints).shoulder, lying.shoulder, 1.0);
  EXPECT_NEAR(believed(joints).hip, lying.hip, 1.0);
}

TEST(PublishedPoses, TheBroadBaseLiesOnChestAndBellyInTheWorld) {
  const JointAngles joints = readBy(agent::robotSenses(), kBroadBase);
  const auto bodies = settled(sentBy(agent::robotSenses(), joints));
  const Lying lying = truth(*bodies);
  EXPECT_TRUE(liesBroad(lying)) << reported(lying);
  for (std::size_t i = 0; i < kLegCount; ++i) {
    const auto leg = static_cast<LegId>(i);
    const Point3<Torso> foot =
        body::footPosition(leg, body::legAngles(bodies->place(0).joints, leg));
    EXPECT_GT(std::fabs(foot.x), body::kBodyWidth / 2 + 10.0) << "spread " << i;
  }
}

// So that the words above mean something: no dog lies so whose hind legs are read or sent the
// other way.
TEST(PublishedPoses, WithTheHindLegsTurnedNoDogLies) {
  const agent::Senses turned = withHindLegsTurned();
  EXPECT_FALSE(sleeps(believed(readBy(turned, kSleeping))));
  EXPECT_FALSE(liesBroad(believed(readBy(turned, kBroadBase))));
  const JointAngles sleeping = readBy(agent::robotSenses(), kSleeping);
  const JointAngles broad = readBy(agent::robotSenses(), kBroadBase);
  EXPECT_FALSE(sleeps(truth(*settled(sentBy(turned, sleeping)))));
  EXPECT_FALSE(liesBroad(truth(*settled(sentBy(turned, broad)))));
}

}  // namespace
}  // namespace kelpie::sim
