// SPDX-License-Identifier: Apache-2.0
#include "tools/stick/SystemFiles.h"

#include "robot/stick/StickFormat.h"

namespace kelpie::stick {
namespace {

// As the robot names its stick's files.
std::string onRobot(const char* path) { return std::string("/MS/") + path; }

// The services are those of robot/openr/stub/stub.cfg.
constexpr const char* kConnections =
    "OVirtualRobotComm.Sensor.OSensorFrameVectorData.S Agent.Sensor.OSensorFrameVectorData.O\n"
    "OVirtualRobotComm.FbkImageSensor.OFbkImageVectorData.S "
    "Agent.FbkImageSensor.OFbkImageVectorData.O\n"
    "Agent.Effector.OCommandVectorData.S OVirtualRobotComm.Effector.OCommandVectorData.O\n";

}  // namespace

StickTree systemFiles() {
  const std::string design =
      "[ERS-7]\nSTICK " + onRobot(kStickPath) + "\nPYCODE " + onRobot(kScriptsPath) + "\n";
  return {{kObjectListPath, onRobot(kObjectPath) + "\n"},
          {kConnectPath, kConnections},
          {kDesignPath, design}};
}

TreeFile relaxedJams() { return {kJamPath, "JamDetectionHighThreshold\n"}; }

}  // namespace kelpie::stick
