// SPDX-License-Identifier: Apache-2.0
// Between OPEN-R's data vectors and Kelpie's frame structs: microradians and micrometres become
// radians and centimetres here and nowhere else, and the robot's signs become Kelpie's. Vectors
// come from outside, so that a wrong type, size or count is refused, not read.
#pragma once

#include <OPENR/ODataFormats.h>
#include <OPENR/OPower.h>

#include <array>

#include "robot/agent/joints/PowerReport.h"
#include "robot/agent/joints/Senses.h"
#include "robot/core/types/Image.h"
#include "robot/core/types/Motion.h"
#include "robot/openr/Ers7Primitives.h"

namespace kelpie::agent {

// What OpenPrimitive gave, in the order of the tables of Ers7Primitives.h; oprimitiveID_UNDEF for
// what did not open.
struct PrimitiveIds {
  std::array<OPrimitiveID, kJointCount> joints;
  std::array<OPrimitiveID, openr::kSensorCount> sensors;
  std::array<OPrimitiveID, openr::kLedCount> leds;
  std::array<OPrimitiveID, openr::kEarCount> ears;
  OPrimitiveID camera;
};

// Finds the primitives in a sensor vector, whose order is not specified: once, because it stays.
class SensorReader {
 public:
  static constexpr int kAbsent = -1;

  explicit SensorReader(const Senses& senses = robotSenses()) : senses_(senses) {}

  // The number of primitives that the vector lacks; their values keep their defaults. A vector that
  // lacks a joint that was opened, or has not all of its ticks, is no pattern for the others. A
  // vector is not const anywhere here, because OPEN-R's accessors are not.
  std::size_t match(OSensorFrameVectorData& vector, const PrimitiveIds& ids);
  bool matched() const { return matched_; }

  // False: the vector is not like the one that was matched, or lacks a tick.
  bool read(OSensorFrameVectorData& vector, std::array<SensorFrame, kTicksPerMessage>& frames);

 private:
  void readTick(OSensorFrameVectorData& vector, std::size_t tick, SensorFrame& frame);
  void readTouch(OSensorFrameVectorData& vector, std::size_t tick, SensorFrame& frame);
  const OSensorValue* value(OSensorFrameVectorData& vector, openr::Sensor sensor,
                            std::size_t tick) const;

  Senses senses_;
  bool matched_ = false;
  std::size_t count_ = 0;
  std::array<int, kJointCount> joints_{};
  std::array<int, openr::kSensorCount> sensors_{};
  std::array<bool, 3> back_{};  // pressed or not: their thresholds have a memory
};

// Commands of one vector: all joints, LEDs and ears, in this order.
constexpr std::size_t kFirstLed = kJointCount;
constexpr std::size_t kFirstEar = kFirstLed + openr::kLedCount;
constexpr std::size_t kCommandCount = kFirstEar + openr::kEarCount;
// Where in a vector each command is; kNoCommand for a primitive that did not open.
constexpr int kNoCommand = -1;
using CommandPlaces = std::array<int, kCommandCount>;
// Type, primitive and number of frames of each command; these never change.
CommandPlaces prepareCommands(OCommandVectorData& vector, const PrimitiveIds& ids);
void writeCommands(const std::array<JointFrame, kTicksPerMessage>& frames,
                   const CommandPlaces& places, OCommandVectorData& vector,
                   const Senses& senses = robotSenses());

// A joint's raw value, as OPENR::GetJointValue has it.
Angle sensedAngle(Joint joint, slongword raw);

PowerReport reportOf(const OPowerStatus& status);

// Layer H with rows Y Cr Cb, or Y Cr Cb and three of high-pass. The last line carries a tag in
// place of pixels and becomes a copy of the line above. False: another type or size.
bool readImage(OFbkImageVectorData& vector, Image& image);

}  // namespace kelpie::agent
