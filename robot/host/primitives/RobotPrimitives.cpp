// SPDX-License-Identifier: Apache-2.0
#include "robot/host/primitives/RobotPrimitives.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "robot/body/Ers7.h"
#include "robot/host/primitives/VectorLayout.h"

namespace kelpie::host {
namespace {

using openr::kEarLocators;
using openr::kJointLocators;
using openr::kLedLocators;
using openr::kSensorLocators;
using openr::Sensor;

constexpr OPrimitiveID kKindStep = 0x100;
constexpr std::size_t kMaxCommands = 64;  // infos in a vector; the ERS-7 has 46 effectors

template <std::size_t N>
std::optional<Primitive> lookUp(const std::array<const char*, N>& table, PrimitiveKind kind,
                                const char* locator) {
  for (std::size_t i = 0; i < N; ++i) {
    if (std::strcmp(table[i], locator) == 0) return Primitive{kind, i};
  }
  return std::nullopt;
}

std::optional<Primitive> withLocator(const char* locator) {
  auto found = lookUp(kJointLocators, PrimitiveKind::joint, locator);
  if (!found) found = lookUp(kSensorLocators, PrimitiveKind::sensor, locator);
  if (!found) found = lookUp(kLedLocators, PrimitiveKind::led, locator);
  if (!found) found = lookUp(kEarLocators, PrimitiveKind::ear, locator);
  if (!found && std::strcmp(openr::kCameraLocator, locator) == 0) {
    found = Primitive{PrimitiveKind::camera, 0};
  }
  return found;
}

}  // namespace

OPrimitiveID identifier(Primitive primitive) {
  const auto kind = static_cast<OPrimitiveID>(primitive.kind) + 1;
  return kind * kKindStep + static_cast<OPrimitiveID>(primitive.index);
}

OSensorValue sensorValue(Sensor sensor, const RawSensors& frame) {
  OSensorValue raw{};
  raw.value = frame.of(sensor);
  return raw;
}

OJointValue jointValue(std::size_t joint, const RawSensors& frame) {
  OJointValue raw{};
  raw.value = frame.joints.value[joint];
  raw.pwmDuty = static_cast<sword>(frame.duty[joint]);
  return raw;
}

std::optional<Primitive> RobotPrimitives::find(OPrimitiveID id) const {
  if (std::find(opened_.begin(), opened_.end(), id) == opened_.end()) return std::nullopt;
  return Primitive{static_cast<PrimitiveKind>(id / kKindStep - 1), id % kKindStep};
}

OStatus RobotPrimitives::openPrimitive(const char* locator, OPrimitiveID* id) {
  *id = oprimitiveID_UNDEF;
  const auto primitive = withLocator(locator);
  if (!primitive) return oNOT_FOUND;
  *id = identifier(*primitive);
  if (!find(*id)) opened_.push_back(*id);
  return oSUCCESS;
}

OStatus RobotPrimitives::closePrimitive(OPrimitiveID id) {
  const auto place = std::find(opened_.begin(), opened_.end(), id);
  if (place == opened_.end()) return oINVALID_PRIMITIVE_ID;
  enableGain(id, false);
  opened_.erase(place);
  return oSUCCESS;
}

OStatus RobotPrimitives::controlPrimitive(OPrimitiveID id, OPrimitiveRequest request,
                                          longword parameter) {
  const auto primitive = find(id);
  if (!primitive) return oINVALID_PRIMITIVE_ID;
  if (primitive->kind != PrimitiveKind::camera) return oINVALID_REQUEST;
  longword* setting = nullptr;
  if (request == oprmreqCAM_SET_WHITE_BALANCE) setting = &camera_.whiteBalance;
  if (request == oprmreqCAM_SET_GAIN) setting = &camera_.gain;
  if (request == oprmreqCAM_SET_SHUTTER_SPEED) setting = &camera_.shutter;
  if (setting == nullptr) return oINVALID_REQUEST;
  if (parameter < 1 || parameter > 3) return oINVALID_ARG;
  *setting = parameter;
  return oSUCCESS;
}

OStatus RobotPrimitives::newCommandVector(std::size_t count, MemoryRegionID* memID,
                                          OCommandVectorData** data) {
  if (count > kMaxCommands) return oSIZE_TOO_LARGE;
  const std::size_t bytes = vectorBytes<OCommandInfo>(count, sizeof(OCommandData));
  auto memory = std::make_unique<std::max_align_t[]>(bytes / sizeof(std::max_align_t) + 1);
  auto* vector = reinterpret_cast<OCommandVectorData*>(memory.get());
  *memID = ++lastRegion_;
  layOut(*vector, odataCOMMAND_VECTOR, count, sizeof(OCommandData));
  vector->vectorInfo.memRegionID = *memID;
  for (std::size_t i = 0; i < count; ++i) {
    OCommandInfo& info = *vector->GetInfo(static_cast<int>(i));
    info.frameSize = sizeof(OCommandValue);
    info.primitiveID = oprimitiveID_UNDEF;
  }
  *data = vector;
  vectors_[*memID] = std::move(memory);
  return oSUCCESS;
}

OStatus RobotPrimitives::deleteCommandVector(MemoryRegionID memID) {
  return vectors_.erase(memID) == 1 ? oSUCCESS : oINVALID_DATA_VECTOR_ID;
}

std::uint32_t RobotPrimitives::jointsNamed(OPrimitiveID id) const {
  std::uint32_t joints = 0;
  for (const OPrimitiveID open : opened_) {
    const auto primitive = find(open);
    const bool named = id == oprimitiveID_UNDEF || id == open;
    if (named && primitive->kind == PrimitiveKind::joint) joints |= 1U << primitive->index;
  }
  return joints;
}

OStatus RobotPrimitives::enableGain(OPrimitiveID id, bool enable) {
  const std::uint32_t joints = jointsNamed(id);
  if (joints == 0) return oINVALID_PRIMITIVE_ID;
  gainsEnabled_ = enable ? gainsEnabled_ | joints : gainsEnabled_ & ~joints;
  return oSUCCESS;
}

OStatus RobotPrimitives::setGain(OPrimitiveID id, const openr::GainSettings& gain) {
  const std::uint32_t joints = jointsNamed(id);
  if (joints == 0) return oINVALID_PRIMITIVE_ID;
  if ((joints & ~gainsEnabled_) != 0) return oGAIN_DISABLED;
  for (std::size_t i = 0; i < kJointCount; ++i) {
    if ((joints >> i & 1U) != 0) gains_[i] = gain;
  }
  return oSUCCESS;
}

OStatus RobotPrimitives::getGain(OPrimitiveID id, openr::GainSettings* gain) {
  const auto primitive = find(id);
  if (!primitive || primitive->kind != PrimitiveKind::joint) return oINVALID_PRIMITIVE_ID;
  *gain = gains_[primitive->index];
  return (gainsEnabled_ >> primitive->index & 1U) != 0 ? oSUCCESS : oGAIN_DISABLED;
}

OStatus RobotPrimitives::jointValue(OPrimitiveID id, OJointValue* value) {
  const auto primitive = find(id);
  if (!primitive || primitive->kind != PrimitiveKind::joint) return oINVALID_PRIMITIVE_ID;
  if (!latest_) return oNOT_AVAILABLE;
  *value = host::jointValue(primitive->index, *latest_);
  return oSUCCESS;
}

OStatus RobotPrimitives::sensorValue(OPrimitiveID id, OSensorValue* value) {
  const auto primitive = find(id);
  if (!primitive || primitive->kind != PrimitiveKind::sensor) return oINVALID_PRIMITIVE_ID;
  if (!latest_) return oNOT_AVAILABLE;
  *value = host::sensorValue(static_cast<Sensor>(primitive->index), *latest_);
  return oSUCCESS;
}

OStatus RobotPrimitives::setMotorPower(OPower power) {
  power_ = power;
  return oSUCCESS;
}

OStatus RobotPrimitives::shutDown(const OBootCondition&) {
  ended_ = true;
  return oSUCCESS;
}

OStatus RobotPrimitives::powerStatus(OPowerStatus* status) {
  *status = power();
  return oSUCCESS;
}

OPowerStatus RobotPrimitives::power() const {
  OPowerStatus status;
  status.robotStatus = robotStatus_ | (power_ ? orsbMOTOR_POWER : 0);
  status.remainingCapacity = batteryCapacity_;
  status.current = batteryCurrent_;
  return status;
}

OStatus RobotPrimitives::observePower(const OPowerStatus&, const OServiceEntry& entry) {
  powerEntry_ = entry;
  reportedPower_ = power();
  return oSUCCESS;
}

OStatus RobotPrimitives::unobservePower(const OServiceEntry& entry) {
  if (powerEntry_ != entry) return oNOT_FOUND;
  powerEntry_ = OServiceEntry();
  return oSUCCESS;
}

void RobotPrimitives::tellPower() {
  const OPowerStatus now = power();
  const bool same = now.robotStatus == reportedPower_.robotStatus &&
                    now.remainingCapacity == reportedPower_.remainingCapacity &&
                    now.current == reportedPower_.current;
  if (same || !powerEntry_.IsValid()) return;
  reportedPower_ = now;
  post(powerEntry_, OPowerStatusMessage(now));
}

void RobotPrimitives::setBattery(double current, double charge) {
  constexpr double kMax = 32767.0;
  batteryCurrent_ = static_cast<sword>(maths::clamp(current, 0.0, kMax) + 0.5);
  batteryCapacity_ = static_cast<word>(100.0 * maths::clamp(charge, 0.0, 1.0) + 0.5);
}

double RobotPrimitives::legGain() const {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t j = index(Joint::leftFrontRotator); j <= index(Joint::rightHindKnee); ++j) {
    const double standard = body::gainOf(static_cast<Joint>(j), {}).p;
    sum += gains_[j].p == 0 ? 1.0 : gains_[j].p / standard;
    count += 1.0;
  }
  return maths::clamp(sum / count, 0.05, 10.0);
}

}  // namespace kelpie::host
