// SPDX-License-Identifier: Apache-2.0
#include "tests/openr/RawPoses.h"

#include <cmath>
#include <cstring>

#include "actuator/feeling/Falls.h"
#include "robot/body/Camera.h"
#include "robot/body/Ers7.h"
#include "robot/body/Legs.h"
#include "robot/host/primitives/DataVectors.h"
#include "tests/openr/OpenedRobot.h"

namespace kelpie::openr {

// Every joint is away from 0 in at least one pose, so that no sign of it can be wrong unseen.
const std::array<RawRow, kRawRowCount> kRawRows = {{
    // stands, on its nose, on its tail, on its left side, on its right side, on its back, carried
    // Head: 0 -60 -20 -30 -30 0 -30; 30 -40 0 0 0 0 -50; 20 10 0 30 30 -10 0 deg.
    {"PRM:/r1/c1-Joint2:11", {0, -1047198, -349066, -523599, -523599, 0, -523599}},
    {"PRM:/r1/c1/c2-Joint2:12", {523599, -698132, 0, 0, 0, 0, -872665}},
    {"PRM:/r1/c1/c2/c3-Joint2:13", {349066, 174533, 0, 523599, 523599, -174533, 0}},
    // Mouth: -3 -45 -3 -3 -3 -20 -3 deg.
    {"PRM:/r1/c1/c2/c3/c4-Joint2:14", {-52360, -785398, -52360, -52360, -52360, -349066, -52360}},
    // Left front: -15 -80 20 60 -30 40 0; 0 10 5 0 45 10 -5; 60 30 10 40 20 50 5 deg.
    {"PRM:/r2/c1-Joint2:21", {-261799, -1396263, 349066, 1047198, -523599, 698132, 0}},
    {"PRM:/r2/c1/c2-Joint2:22", {0, 174533, 87266, 0, 785398, 174533, -87266}},
    {"PRM:/r2/c1/c2/c3-Joint2:23", {1047198, 523599, 174533, 698132, 349066, 872665, 87266}},
    // Left hind: -20 40 -80 -60 30 -40 10; 0 5 15 0 45 10 -5; 90 60 115 60 20 50 -10 deg.
    {"PRM:/r3/c1-Joint2:31", {-349066, 698132, -1396263, -1047198, 523599, -698132, 174533}},
    {"PRM:/r3/c1/c2-Joint2:32", {0, 87266, 261799, 0, 785398, 174533, -87266}},
    {"PRM:/r3/c1/c2/c3-Joint2:33", {1570796, 1047198, 2007129, 1047198, 349066, 872665, -174533}},
    // Right front: -15 -80 20 -30 60 40 0; 0 10 5 45 0 10 -5; 60 30 10 20 40 50 5 deg.
    {"PRM:/r4/c1-Joint2:41", {-261799, -1396263, 349066, -523599, 1047198, 698132, 0}},
    {"PRM:/r4/c1/c2-Joint2:42", {0, 174533, 87266, 785398, 0, 174533, -87266}},
    {"PRM:/r4/c1/c2/c3-Joint2:43", {1047198, 523599, 174533, 349066, 698132, 872665, 87266}},
    // Right hind: -20 40 -80 30 -60 -40 10; 0 5 15 45 0 10 -5; 90 60 115 20 60 50 -10 deg.
    {"PRM:/r5/c1-Joint2:51", {-349066, 698132, -1396263, 523599, -1047198, -698132, 174533}},
    {"PRM:/r5/c1/c2-Joint2:52", {0, 87266, 261799, 785398, 0, 174533, -87266}},
    {"PRM:/r5/c1/c2/c3-Joint2:53", {1570796, 1047198, 2007129, 349066, 1047198, 872665, -174533}},
    // Tail: 30 50 10 40 40 20 45; 20 -30 0 0 0 10 -20 deg.
    {"PRM:/r6/c1-Joint2:61", {523599, 872665, 174533, 698132, 698132, 349066, 785398}},
    {"PRM:/r6/c2-Joint2:62", {349066, -523599, 0, 0, 0, 174533, -349066}},
    // Distances of the head, near and far, and of the chest.
    {"PRM:/r1/c1/c2/c3/p1-Sensor:p1", {410000, 50000, 500000, 500000, 60000, 500000, 300000}},
    {"PRM:/r1/c1/c2/c3/p2-Sensor:p2", {1200000, 200000, 1500000, 900000, 250000, 1500000, 310000}},
    {"PRM:/p1-Sensor:p1", {650000, 100000, 800000, 450000, 350000, 900000, 700000}},
    {"PRM:/a1-Sensor:a1", {-1110000, 9600000, -9500000, 300000, 300000, -2500000, 400000}},
    {"PRM:/a2-Sensor:a2", {150000, 300000, -200000, -9700000, 9700000, 500000, -300000}},
    {"PRM:/a3-Sensor:a3", {-9740000, -1500000, -2000000, -1000000, -1000000, 9400000, -9900000}},
    // Paws, left front and hind, right front and hind; chin.
    {"PRM:/r2/c1/c2/c3/c4-Sensor:24", {1, 1, 0, 0, 0, 0, 0}},
    {"PRM:/r3/c1/c2/c3/c4-Sensor:34", {1, 0, 1, 1, 0, 0, 0}},
    {"PRM:/r4/c1/c2/c3/c4-Sensor:44", {1, 0, 0, 0, 1, 0, 0}},
    {"PRM:/r5/c1/c2/c3/c4-Sensor:54", {1, 0, 1, 0, 0, 0, 0}},
    {"PRM:/r1/c1/c2/c3/c4/s5-Sensor:s5", {0, 1, 0, 0, 0, 0, 0}},
    // Touch of the head, then of the back, rear, middle, front.
    {"PRM:/r1/c1/c2/c3/t1-Sensor:t1", {0, 9, 25, 0, 0, 0, 0}},
    {"PRM:/t2-Sensor:t2", {0, 20, 0, 0, 0, 30, 0}},
    {"PRM:/t3-Sensor:t3", {0, 0, 0, 13, 0, 30, 40}},
    {"PRM:/t4-Sensor:t4", {0, 0, 0, 0, 12, 30, 0}},
}};

const std::array<const char*, kRawPoseCount> kSeen = {
    "belly down, up; looks left and up; mouth shut; tail right, tilted little; "
    "paws: ahead close, behind close, ahead close, behind close; pressed 1111; "
    "sees 41 120, chest 65; touched:",
    "nose down, fallen on its nose; looks right and down; mouth open; tail left, tilted much; "
    "paws: behind close, behind close, behind close, behind close; pressed 1000; "
    "sees 5 20, chest 10; touched: chin rear",
    "tail down, fallen back; looks ahead and down; mouth shut; tail straight, tilted little; "
    "paws: ahead close, below close, ahead close, below close; pressed 0101; "
    "sees 50 150, chest 80; touched: head",
    "left side down, fallen left; looks ahead and level; mouth shut; tail straight, tilted much; "
    "paws: ahead close, ahead close, below spread, behind spread; pressed 0100; "
    "sees 50 90, chest 45; touched:",
    "right side down, fallen right; looks ahead and level; mouth shut; tail straight, tilted "
    "much; paws: below spread, behind spread, ahead close, ahead close; pressed 0010; "
    "sees 6 25, chest 35; touched: front",
    "back down, fallen back; looks ahead and down; mouth open; tail right, tilted little; "
    "paws: ahead close, below close, ahead close, below close; pressed 0000; "
    "sees 50 150, chest 90; touched: front middle rear",
    "belly down, up; looks right and down; mouth shut; tail left, tilted much; "
    "paws: below close, below close, below close, below close; pressed 0000; "
    "sees 30 31, chest 70; touched: middle",
};

slongword rawValue(RawPose pose, const char* locator) {
  for (const RawRow& row : kRawRows)
    if (std::strcmp(row.locator, locator) == 0) return row.value[static_cast<std::size_t>(pose)];
  return 0;
}

namespace {

// The order of the vector is one that no table has.
RCRegion* vectorOf(RawPose pose, OpenedRobot& robot) {
  RCRegion* region = host::newSensorRegion(77);
  auto& vector = *reinterpret_cast<OSensorFrameVectorData*>(region->Base());
  for (const RawRow& row : kRawRows) {
    const OPrimitiveID id = robot.open(row.locator);
    for (int i = 0; i < static_cast<int>(vector.vectorInfo.numData); ++i) {
      if (vector.GetInfo(i)->primitiveID != id) continue;
      for (std::size_t tick = 0; tick < kTicksPerMessage; ++tick)
        vector.GetData(i)->frame[tick].value = row.value[static_cast<std::size_t>(pose)];
    }
  }
  return region;
}

std::string whatIsDown(const std::array<double, 3>& acceleration) {
  const auto [forward, left, up] = acceleration;
  const double max = std::fmax(std::fabs(forward), std::fmax(std::fabs(left), std::fabs(up)));
  if (max == std::fabs(up)) return up > 0.0 ? "belly" : "back";
  if (max == std::fabs(left)) return left > 0.0 ? "right side" : "left side";
  return forward > 0.0 ? "tail" : "nose";
}

std::string howFallen(const SensorFrame& frame) {
  constexpr int kSecond = 31;  // messages
  MotionInput in;
  in.sensors.fill(frame);
  actuator::FallState state;
  for (int i = 0; i < 2 * kSecond; ++i) actuator::stepFalls(in, {}, state);
  switch (state.fallen) {
    case FallSide::none: return "up";
    case FallSide::front: return "fallen on its nose";
    case FallSide::back: return "fallen back";
    case FallSide::left: return "fallen left";
    case FallSide::right: break;
  }
  return "fallen right";
}

std::string gaze(const JointAngles& joints) {
  constexpr double kLateral = 0.3;  // of a direction of length one
  constexpr double kUp = 0.15;
  const CameraPose camera = body::cameraPose(joints, Stance{});
  const double right = camera.axes[2];
  const double up = camera.axes[8];
  const std::string side = right > kLateral ? "right" : right < -kLateral ? "left" : "ahead";
  return side + " and " + (up > kUp ? "up" : up < -kUp ? "down" : "level");
}

std::string tail(const JointAngles& joints) {
  constexpr double kStraight = 5.0;  // deg
  constexpr double kMuch = 32.5;     // the middle of its range
  const double left = joints[Joint::tailPan].deg();
  const std::string side = left > kStraight ? "left" : left < -kStraight ? "right" : "straight";
  return side + ", tilted " + (joints[Joint::tailTilt].deg() > kMuch ? "much" : "little");
}

// Of a paw from its own shoulder or hip.
std::string whereIs(LegId leg, const JointAngles& joints) {
  constexpr double kFar = 3.0;  // cm
  constexpr double kSpread = 6.0;
  const bool right = leg == LegId::rightFront || leg == LegId::rightHind;
  const Point3<Torso> foot = body::footPosition(leg, body::legAngles(joints, leg));
  const double ahead = foot.y + (body::isFront(leg) ? 0.0 : body::kBodyLength);
  const double out = (right ? foot.x : -foot.x) - body::kBodyWidth / 2;
  const std::string along = ahead > kFar ? "ahead" : ahead < -kFar ? "behind" : "below";
  const bool raised = foot.z > 0.0;
  return along + (raised ? " raised" : "") +
         (out > kSpread ? " spread"
          : out < -kFar ? " crossed"
                        : " close");
}

std::string paws(const SensorFrame& frame) {
  std::string where;
  std::string pressed;
  for (std::size_t i = 0; i < kLegCount; ++i) {
    where += (i == 0 ? "" : ", ") + whereIs(static_cast<LegId>(i), frame.joints);
    pressed += frame.paw[i] ? '1' : '0';
  }
  return "paws: " + where + "; pressed " + pressed;
}

std::string touched(const SensorFrame& frame) {
  constexpr double kHeadTouched = 9.0;
  std::string text = "touched:";
  if (frame.chin) text += " chin";
  if (frame.headTouch > kHeadTouched) text += " head";
  if (frame.back[0]) text += " front";
  if (frame.back[1]) text += " middle";
  if (frame.back[2]) text += " rear";
  return text;
}

std::string centimetres(double length) { return std::to_string(std::lround(length)); }

}  // namespace

SensorFrame sensedBy(const agent::Senses& senses, RawPose pose) {
  OpenedRobot robot;
  RCRegion* region = vectorOf(pose, robot);
  auto& vector = *reinterpret_cast<OSensorFrameVectorData*>(region->Base());
  std::array<SensorFrame, kTicksPerMessage> frames{};
  agent::SensorReader reader(senses);
  reader.match(vector, robot.ids);
  reader.read(vector, frames);
  region->RemoveReference();
  return frames.back();
}

std::string seenIn(const SensorFrame& frame) {
  constexpr double kMouthOpen = -15.0;  // deg
  return whatIsDown(frame.acceleration) + " down, " + howFallen(frame) + "; looks " +
         gaze(frame.joints) + "; mouth " +
         (frame.joints[Joint::mouth].deg() < kMouthOpen ? "open" : "shut") + "; tail " +
         tail(frame.joints) + "; " + paws(frame) + "; sees " + centimetres(frame.headNearDistance) +
         " " + centimetres(frame.headFarDistance) + ", chest " + centimetres(frame.chestDistance) +
         "; " + touched(frame);
}

}  // namespace kelpie::openr
