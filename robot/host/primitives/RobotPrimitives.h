// SPDX-License-Identifier: Apache-2.0
// The half of the system calls that concerns the body: which primitives are open, motor power and
// gains, the latest sensor values, camera settings, the memory of command vectors. Unknown locators
// and identifiers are refused with the documented status.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "robot/host/primitives/RawFrame.h"
#include "robot/openr/Ers7Primitives.h"
#include "robot/openr/System.h"

namespace kelpie::host {

enum class PrimitiveKind : std::uint8_t { joint, sensor, led, ear, camera };

struct Primitive {
  PrimitiveKind kind = PrimitiveKind::joint;
  std::size_t index = 0;  // Joint, Sensor or number of the LED or ear
};

// The identifier that a primitive gets when it is opened.
OPrimitiveID identifier(Primitive primitive);

// What the robot gives of it in a sensor vector.
OSensorValue sensorValue(openr::Sensor sensor, const RawSensors& frame);
OJointValue jointValue(std::size_t joint, const RawSensors& frame);

struct CameraSettings {
  longword whiteBalance = ocamparamWB_FL_MODE;  // the robot's defaults
  longword gain = ocamparamGAIN_MID;
  longword shutter = ocamparamSHUTTER_MID;
};

class RobotPrimitives : public openr::System {
 public:
  // An opened primitive, or nothing.
  std::optional<Primitive> find(OPrimitiveID id) const;
  bool cameraOpen() const { return find(identifier({PrimitiveKind::camera, 0})).has_value(); }
  bool motorPower() const { return power_; }
  // An object has asked for the end of the system.
  bool ended() const { return ended_; }
  std::uint32_t gains() const { return gainsEnabled_; }  // bit i: joint i
  const CameraSettings& camera() const { return camera_; }

  // The latest sensor values, for GetJointValue and GetSensorValue.
  void setLatest(const RawSensors& frame) { latest_ = frame; }
  // Drawn from the battery, mA, and the share of a full one that is left.
  void setBattery(double current, double charge);
  // Bits of OPowerStatus::robotStatus but for the motors', such as orsbPAUSE.
  void setRobotStatus(longword bits) { robotStatus_ = bits; }
  // Proportional gain of the leg joints over the standard one, their mean; 1 before any was set.
  double legGain() const;

  OStatus openPrimitive(const char* locator, OPrimitiveID* id) override;
  OStatus closePrimitive(OPrimitiveID id) override;
  OStatus controlPrimitive(OPrimitiveID id, OPrimitiveRequest request, longword parameter) override;
  OStatus newCommandVector(std::size_t count, MemoryRegionID* memID,
                           OCommandVectorData** data) override;
  OStatus deleteCommandVector(MemoryRegionID memID) override;
  OStatus enableGain(OPrimitiveID id, bool enable) override;
  OStatus setGain(OPrimitiveID id, const openr::GainSettings& gain) override;
  OStatus getGain(OPrimitiveID id, openr::GainSettings* gain) override;
  OStatus jointValue(OPrimitiveID id, OJointValue* value) override;
  OStatus sensorValue(OPrimitiveID id, OSensorValue* value) override;
  OStatus setMotorPower(OPower power) override;
  OStatus shutDown(const OBootCondition& condition) override;
  OStatus powerStatus(OPowerStatus* status) override;
  OStatus observePower(const OPowerStatus& watched, const OServiceEntry& entry) override;
  OStatus unobservePower(const OServiceEntry& entry) override;

 protected:
  // A message to whoever observes the power when it differs from what was reported last. The
  // current counts as well, and comes with every step: more often than on the robot, which reports
  // it with what was asked for (openr-measured.md 2).
  void tellPower();

 private:
  OPowerStatus power() const;
  std::uint32_t jointsNamed(OPrimitiveID id) const;  // bits; UNDEF names all opened joints

  std::vector<OPrimitiveID> opened_;
  bool power_ = false;
  bool ended_ = false;
  std::uint32_t gainsEnabled_ = 0;
  std::array<openr::GainSettings, kJointCount> gains_{};
  CameraSettings camera_;
  std::optional<RawSensors> latest_;
  sword batteryCurrent_ = 0;    // mA
  word batteryCapacity_ = 100;  // percent
  longword robotStatus_ = orsbBATTERY_CONNECTED;
  OServiceEntry powerEntry_;  // whoever observes the power
  OPowerStatus reportedPower_;
  std::map<MemoryRegionID, std::unique_ptr<std::max_align_t[]>> vectors_;
  MemoryRegionID lastRegion_ = 0;
};

}  // namespace kelpie::host
