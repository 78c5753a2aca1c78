// SPDX-License-Identifier: Apache-2.0
// What the near infrared sensor of a robot's head reads of the bare carpet while the robot stands:
// a mean for each pose in which the head is held, from 0.5 s after it was asked for. A pose with a
// reading at an end of the sensor's range is none: its mean would say too little.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "robot/body/Infrared.h"
#include "robot/core/Expected.h"
#include "robot/core/types/FrameInput.h"

namespace kelpie::calibrate {

// How the head was asked to be held.
struct HeadPose {
  std::array<double, 3> angles{};  // deg, neck, pan and nod
  bool mouthOpen = false;

  bool operator==(const HeadPose& other) const;
  bool operator!=(const HeadPose& other) const { return !(*this == other); }
};

// As a held ball is carried (pycode/skills/ball/hold.py): neck -52 or as low as a grab leaves it,
// nod 45 deg, the mouth open.
bool isBallStance(const HeadPose& pose);

// What of a frame tells of the carpet.
struct CarpetMoment {
  double seconds = 0.0;
  bool stands = false;  // and holds its head by joint angles
  HeadPose pose;
  double reading = 0.0;  // cm
};

struct CarpetReadings {
  HeadPose pose;
  std::size_t count = 0;
  double mean = 0.0;  // cm
};

struct CarpetLog {
  body::InfraredParams infrared;  // as the log's robot had it
  std::vector<CarpetReadings> poses;
  std::string lacks;  // what of the log could not be read; the rest is taken
};

CarpetMoment carpetMoment(const FrameInput& input);

// In the order in which they were held first; of each at least fifteen readings.
std::vector<CarpetReadings> carpetReadings(const std::vector<CarpetMoment>& moments);

// An error says in one line why nothing can be learnt of the log.
Expected<CarpetLog> readCarpet(const std::string& path);

}  // namespace kelpie::calibrate
