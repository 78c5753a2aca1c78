// SPDX-License-Identifier: Apache-2.0
#include "robot/agent/AgentIo.h"

#include <OPENR/OFbkImage.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace kelpie::agent {
namespace {

using openr::Sensor;

constexpr std::size_t kTicks = kTicksPerMessage;
constexpr std::size_t kFirstBackLed = 20;  // of Ers7Primitives.h's table

int placeOf(OPrimitiveID id, OSensorFrameVectorData& vector) {
  for (int i = 0; i < static_cast<int>(vector.vectorInfo.numData); ++i) {
    const OSensorFrameInfo& info = *vector.GetInfo(i);
    if (info.primitiveID == id && info.numFrames >= kTicks) return i;
  }
  return SensorReader::kAbsent;
}

template <std::size_t N>
std::size_t findAll(OSensorFrameVectorData& vector, const std::array<OPrimitiveID, N>& ids,
                    std::array<int, N>& places) {
  std::size_t lacking = 0;
  for (std::size_t i = 0; i < N; ++i) {
    places[i] = placeOf(ids[i], vector);
    if (places[i] == SensorReader::kAbsent) ++lacking;
  }
  return lacking;
}

void setLength(const OSensorValue* raw, double& length) {
  if (raw != nullptr) length = static_cast<double>(raw->value) * openr::kMicrometre;
}

// Part of a joint's value, which has the same bytes as a sensor's but is a type of its own with
// constructors: it may not be copied into as a whole.
template <class T>
T partOf(const OSensorValue& value, std::size_t offset) {
  static_assert(sizeof(OJointValue) == sizeof(OSensorValue), "one frame of any sensor");
  T part;
  std::memcpy(&part, reinterpret_cast<const byte*>(&value) + offset, sizeof part);
  return part;
}

Angle angleOf(slongword raw, double sense) {
  return Angle::rad(sense * static_cast<double>(raw) * openr::kMicroradian);
}

slongword toMicroradians(double radians) {
  return static_cast<slongword>(std::floor(radians / openr::kMicroradian + 0.5));
}

OCommandValue jointCommand(double radians) {
  const OJointCommandValue2 order = {toMicroradians(radians), 0};
  OCommandValue value;
  std::memcpy(&value, &order, sizeof value);
  return value;
}

// The lights of the back have no modes: Sony's sample BlinkingLED7 leaves theirs undefined, and so
// did the team of 2005.
OCommandValue ledCommand(std::size_t led, bool on) {
  constexpr sword kFullIntensity = 255;
  const OLEDCommandValue2 switched = {on ? oledON : oledOFF, 1, 0};
  const OLED3Mode mode = led < kFirstBackLed ? oled3_MODE_A : oled3_MODE_UNDEF;
  const OLEDCommandValue3 bright = {on ? kFullIntensity : sword{0}, mode, 1, 0};
  OCommandValue value;
  if (led < openr::kSwitchedLeds) {
    std::memcpy(&value, &switched, sizeof value);
  } else {
    std::memcpy(&value, &bright, sizeof value);
  }
  return value;
}

OCommandValue earCommand(bool up) {
  const OJointCommandValue4 order = {up ? ojoint4_STATE1 : ojoint4_STATE0, 1, 0};
  OCommandValue value;
  std::memcpy(&value, &order, sizeof value);
  return value;
}

void copyBand(const OFbkImage& band, Image::Plane& plane) {
  constexpr std::size_t kWidth = kImageWidth;
  const std::size_t stride = kWidth + static_cast<std::size_t>(band.Skip());
  for (std::size_t line = 0; line < kImageHeight; ++line) {
    const std::size_t source = line + 1 < kImageHeight ? line : line - 1;
    std::memcpy(plane.data() + line * kWidth, band.Pointer() + source * stride, kWidth);
  }
}

}  // namespace

std::size_t SensorReader::match(OSensorFrameVectorData& vector, const PrimitiveIds& ids) {
  count_ = vector.vectorInfo.numData;
  const std::size_t lacking =
      findAll(vector, ids.joints, joints_) + findAll(vector, ids.sensors, sensors_);
  matched_ = true;
  for (std::size_t i = 0; i < kJointCount; ++i)
    if (ids.joints[i] != oprimitiveID_UNDEF && joints_[i] == kAbsent) matched_ = false;
  return lacking;
}

bool SensorReader::read(OSensorFrameVectorData& vector,
                        std::array<SensorFrame, kTicksPerMessage>& frames) {
  if (!matched_ || vector.vectorInfo.numData != count_) return false;
  for (const int place : joints_)
    if (place != kAbsent && vector.GetInfo(place)->numFrames < kTicks) return false;
  for (std::size_t tick = 0; tick < kTicks; ++tick) readTick(vector, tick, frames[tick]);
  return true;
}

const OSensorValue* SensorReader::value(OSensorFrameVectorData& vector, Sensor sensor,
                                        std::size_t tick) const {
  const int place = sensors_[openr::index(sensor)];
  return place == kAbsent ? nullptr : &vector.GetData(place)->frame[tick];
}

void SensorReader::readTick(OSensorFrameVectorData& vector, std::size_t tick, SensorFrame& frame) {
  for (std::size_t i = 0; i < kJointCount; ++i) {
    if (joints_[i] == kAbsent) continue;
    const OSensorValue& raw = vector.GetData(joints_[i])->frame[tick];
    const auto angle = partOf<slongword>(raw, offsetof(OJointValue, value));
    const double sense = senses_.joints[i];
    frame.joints.angle[i] = angleOf(angle, sense);
    frame.duty[i] = sense * partOf<sword>(raw, offsetof(OJointValue, pwmDuty)) / openr::kFullDuty;
  }
  setLength(value(vector, Sensor::headNear, tick), frame.headNearDistance);
  setLength(value(vector, Sensor::headFar, tick), frame.headFarDistance);
  setLength(value(vector, Sensor::chest, tick), frame.chestDistance);
  setLength(value(vector, Sensor::accelerationBack, tick), frame.acceleration[0]);
  setLength(value(vector, Sensor::accelerationLeft, tick), frame.acceleration[1]);
  setLength(value(vector, Sensor::accelerationDown, tick), frame.acceleration[2]);
  for (std::size_t i = 0; i < frame.acceleration.size(); ++i)
    frame.acceleration[i] *= senses_.acceleration[i];
  readTouch(vector, tick, frame);
}

void SensorReader::readTouch(OSensorFrameVectorData& vector, std::size_t tick, SensorFrame& frame) {
  const auto pressed = [&](Sensor sensor) {
    const OSensorValue* raw = value(vector, sensor, tick);
    return raw != nullptr && raw->value != 0;
  };
  constexpr std::array<Sensor, kLegCount> kPaws = {Sensor::pawLeftFront, Sensor::pawLeftHind,
                                                   Sensor::pawRightFront, Sensor::pawRightHind};
  for (std::size_t i = 0; i < kLegCount; ++i) frame.paw[i] = pressed(kPaws[i]);
  frame.chin = pressed(Sensor::chin);
  const OSensorValue* head = value(vector, Sensor::headTouch, tick);
  if (head != nullptr) frame.headTouch = static_cast<double>(head->value);
  const auto touch = [&](Sensor sensor, const openr::TouchThresholds& limits, bool before) {
    const OSensorValue* raw = value(vector, sensor, tick);
    return raw != nullptr && raw->value >= (before ? limits.off : limits.on);
  };
  back_[0] = touch(Sensor::backFront, openr::kBackFrontTouch, back_[0]);
  back_[1] = touch(Sensor::backMiddle, openr::kBackMiddleTouch, back_[1]);
  back_[2] = touch(Sensor::backRear, openr::kBackRearTouch, back_[2]);
  frame.back = back_;
}

CommandPlaces prepareCommands(OCommandVectorData& vector, const PrimitiveIds& ids) {
  CommandPlaces places;
  int next = 0;
  const auto lay = [&](std::size_t command, ODataType type, OPrimitiveID id) {
    const bool opened = id != oprimitiveID_UNDEF;
    places[command] = opened ? next++ : kNoCommand;
    if (opened) vector.GetInfo(places[command])->Set(type, id, kTicks);
  };
  for (std::size_t i = 0; i < kJointCount; ++i) lay(i, odataJOINT_COMMAND2, ids.joints[i]);
  for (std::size_t i = 0; i < openr::kLedCount; ++i) {
    const bool switched = i < openr::kSwitchedLeds;
    lay(kFirstLed + i, switched ? odataLED_COMMAND2 : odataLED_COMMAND3, ids.leds[i]);
  }
  for (std::size_t i = 0; i < openr::kEarCount; ++i)
    lay(kFirstEar + i, odataJOINT_COMMAND4, ids.ears[i]);
  vector.SetNumData(static_cast<std::size_t>(next));
  return places;
}

void writeCommands(const std::array<JointFrame, kTicksPerMessage>& frames,
                   const CommandPlaces& places, OCommandVectorData& vector, const Senses& senses) {
  for (std::size_t tick = 0; tick < kTicks; ++tick) {
    const auto put = [&](std::size_t command, const OCommandValue& value) {
      if (places[command] != kNoCommand) vector.GetData(places[command])->value[tick] = value;
    };
    for (std::size_t i = 0; i < kJointCount; ++i)
      put(i, jointCommand(senses.joints[i] * frames[tick].target.angle[i].rad()));
    for (std::size_t i = 0; i < openr::kLedCount; ++i)
      put(kFirstLed + i, ledCommand(i, (frames[tick].leds >> i & 1U) != 0));
    put(kFirstEar, earCommand(frames[tick].ears.leftUp));
    put(kFirstEar + 1, earCommand(frames[tick].ears.rightUp));
  }
}

Angle sensedAngle(Joint joint, slongword raw) {
  return angleOf(raw, robotSenses().joints[index(joint)]);
}

PowerReport reportOf(const OPowerStatus& status) {
  const auto has = [&](longword bit) { return (status.robotStatus & bit) != 0; };
  PowerReport report;
  report.paused = has(orsbPAUSE);
  report.batteryLow = has(orsbBATTERY_CAPACITY_LOW) ||
                      (status.batteryStatus & obsbTERMINATED_DISCHARGING_ALARM) != 0;
  report.overCurrent = has(orsbBATTERY_OVER_CURRENT);
  report.hot =
      has(orsbBATTERY_OVER_TEMP_DISCHARGING) || (status.batteryStatus & obsbOVER_TEMP_ALARM) != 0;
  report.fanFault = has(orsbERROR_OF_FAN);
  report.motorPower = has(orsbMOTOR_POWER);
  report.current = status.current < 0 ? -status.current : status.current;
  report.charge = std::min<word>(status.remainingCapacity, 100) / 100.0;
  return report;
}

bool readImage(OFbkImageVectorData& vector, Image& image) {
  if (vector.vectorInfo.numData == 0) return false;
  OFbkImageInfo* info = vector.GetInfo(ofbkimageLAYER_H);
  byte* data = vector.GetData(ofbkimageLAYER_H);
  if (info->width != kImageWidth || info->height != kImageHeight) return false;
  const OFbkImage y(info, data, ofbkimageBAND_Y);
  const OFbkImage cr(info, data, ofbkimageBAND_Cr);
  const OFbkImage cb(info, data, ofbkimageBAND_Cb);
  if (!y.IsValid() || !cr.IsValid() || !cb.IsValid()) return false;
  copyBand(y, image.y);
  copyBand(cr, image.cr);
  copyBand(cb, image.cb);
  return true;
}

}  // namespace kelpie::agent
