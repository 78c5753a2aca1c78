// SPDX-License-Identifier: Apache-2.0
#include "robot/host/primitives/DataVectors.h"

#include <algorithm>
#include <cstring>

#include "robot/core/Random.h"
#include "robot/host/primitives/RobotPrimitives.h"
#include "robot/host/primitives/VectorLayout.h"

namespace kelpie::host {
namespace {

constexpr std::size_t kSensedCount = kJointCount + openr::kSensorCount;
constexpr std::size_t kWidth = kImageWidth;
constexpr std::size_t kHeight = kImageHeight;

static_assert(sizeof(OJointValue) == sizeof(OSensorValue), "one frame of any sensor");

template <class Vector>
Vector& vectorIn(const RCRegion& region) {
  return *reinterpret_cast<Vector*>(region.Base());
}

std::vector<OPrimitiveID> sensedPrimitives(std::uint64_t orderSeed) {
  std::vector<OPrimitiveID> ids;
  for (std::size_t i = 0; i < kJointCount; ++i) {
    ids.push_back(identifier({PrimitiveKind::joint, i}));
  }
  for (std::size_t i = 0; i < openr::kSensorCount; ++i) {
    ids.push_back(identifier({PrimitiveKind::sensor, i}));
  }
  Random random(orderSeed);
  for (std::size_t left = ids.size(); orderSeed != 0 && left > 1; --left) {
    std::swap(ids[left - 1], ids[random.index(static_cast<std::uint32_t>(left))]);
  }
  return ids;
}

OSensorValue valueFrom(OPrimitiveID id, const RawSensors& frame) {
  const OPrimitiveID firstSensor = identifier({PrimitiveKind::sensor, 0});
  if (id >= firstSensor) return sensorValue(static_cast<openr::Sensor>(id - firstSensor), frame);
  const OJointValue joint = jointValue(id - identifier({PrimitiveKind::joint, 0}), frame);
  OSensorValue raw;
  std::memcpy(&raw, &joint, sizeof raw);
  return raw;
}

// Every order that one info gives for its frames.
class CommandReader {
 public:
  explicit CommandReader(EffectorVector& out) : out_(out) {}

  // False: the info does not fit the primitive.
  bool read(const OCommandInfo& info, const OCommandData& data, Primitive primitive) {
    if (primitive.kind == PrimitiveKind::joint && info.type == odataJOINT_COMMAND2) {
      joint(primitive.index, info.numFrames, data);
      return true;
    }
    if (primitive.kind == PrimitiveKind::ear && info.type == odataJOINT_COMMAND4) {
      ear(primitive.index, data.value[info.numFrames - 1]);
      return true;
    }
    if (primitive.kind != PrimitiveKind::led) return false;
    const bool switched = primitive.index < openr::kSwitchedLeds;
    if (info.type != (switched ? odataLED_COMMAND2 : odataLED_COMMAND3)) return false;
    led(primitive.index, switched, data.value[info.numFrames - 1]);
    return true;
  }

 private:
  void joint(std::size_t index, std::size_t frames, const OCommandData& data) {
    out_.joints |= 1U << index;
    for (std::size_t tick = 0; tick < kMaxVectorTicks; ++tick) {
      OJointCommandValue2 value;
      std::memcpy(&value, &data.value[std::min(tick, frames - 1)], sizeof value);
      out_.targets[tick].value[index] = static_cast<std::int32_t>(value.value);
    }
  }
  void led(std::size_t index, bool switched, const OCommandValue& last) {
    OLEDCommandValue2 onOff;
    OLEDCommandValue3 intensity;
    std::memcpy(&onOff, &last, sizeof onOff);
    std::memcpy(&intensity, &last, sizeof intensity);
    if (switched ? onOff.led != oledOFF : intensity.intensity > 0) out_.leds |= 1U << index;
  }

  void ear(std::size_t index, const OCommandValue& last) {
    OJointCommandValue4 state;
    std::memcpy(&state, &last, sizeof state);
    if (state.value != ojoint4_STATE0) out_.ears |= 1U << index;
  }

  EffectorVector& out_;
};

bool fits(const OCommandInfo& info, std::size_t bytes) {
  return info.dataOffset % alignof(OCommandData) == 0 && info.dataOffset <= bytes &&
         sizeof(OCommandData) <= bytes - info.dataOffset;
}

}  // namespace

RCRegion* newSensorRegion(std::uint64_t orderSeed) {
  auto* region =
      new RCRegion(vectorBytes<OSensorFrameInfo>(kSensedCount, sizeof(OSensorFrameData)));
  auto& vector = vectorIn<OSensorFrameVectorData>(*region);
  layOut(vector, odataSENSOR_FRAME_VECTOR, kSensedCount, sizeof(OSensorFrameData));
  vector.SetNumData(kSensedCount);
  const auto ids = sensedPrimitives(orderSeed);
  for (std::size_t i = 0; i < kSensedCount; ++i) {
    OSensorFrameInfo& info = *vector.GetInfo(static_cast<int>(i));
    info.primitiveID = ids[i];
    info.numFrames = kTicksPerMessage;
    info.frameSize = sizeof(OSensorValue);
  }
  return region;
}

void fillSensors(RCRegion& region, std::uint32_t firstTick,
                 const std::array<RawSensors, kTicksPerMessage>& frames) {
  auto& vector = vectorIn<OSensorFrameVectorData>(region);
  for (int i = 0; i < static_cast<int>(vector.vectorInfo.numData); ++i) {
    OSensorFrameInfo& info = *vector.GetInfo(i);
    info.frameNumber = firstTick % oframeMAX_NUMBER;
    for (std::size_t tick = 0; tick < frames.size(); ++tick) {
      vector.GetData(i)->frame[tick] = valueFrom(info.primitiveID, frames[tick]);
    }
  }
}

RCRegion* newImageRegion(bool highPass) {
  const std::size_t bytes = kWidth * kHeight * (highPass ? 6 : 3);
  auto* region = new RCRegion(vectorBytes<OFbkImageInfo>(1, bytes));
  auto& vector = vectorIn<OFbkImageVectorData>(*region);
  layOut(vector, odataFBKIMAGE_VECTOR, 1, bytes);
  vector.vectorInfo.numData = 1;
  OFbkImageInfo& info = *vector.GetInfo(ofbkimageLAYER_H);
  info.type = highPass ? odataFBK_YCrCb_HPF : odataFBK_YCrCb;
  info.primitiveID = identifier({PrimitiveKind::camera, 0});
  info.width = kImageWidth;
  info.height = kImageHeight;
  return region;
}

void fillImage(RCRegion& region, const Image& image, std::uint32_t fieldCounter) {
  auto& vector = vectorIn<OFbkImageVectorData>(region);
  OFbkImageInfo& info = *vector.GetInfo(ofbkimageLAYER_H);
  info.frameNumber = fieldCounter;
  byte* rows = vector.GetData(ofbkimageLAYER_H);
  const std::size_t stride = info.dataSize / kHeight;
  for (std::size_t line = 0; line < kHeight; ++line) {
    byte* row = rows + line * stride;
    std::memcpy(row, image.y.data() + line * kWidth, kWidth);
    std::memcpy(row + kWidth, image.cr.data() + line * kWidth, kWidth);
    std::memcpy(row + 2 * kWidth, image.cb.data() + line * kWidth, kWidth);
  }
  byte* tag = rows + (kHeight - 1) * stride;
  std::memset(tag, 0, stride);
  tag[0] = static_cast<byte>(fieldCounter);
  tag[1] = static_cast<byte>(fieldCounter >> 8);
}

std::string readCommands(const RCRegion& region, const RobotPrimitives& primitives,
                         EffectorVector& out) {
  out = EffectorVector{};
  auto& vector = vectorIn<OCommandVectorData>(region);
  const ODataVectorInfo& header = vector.vectorInfo;
  if (header.type != odataCOMMAND_VECTOR) return "data that are no command vector";
  if (header.numData > header.maxNumData) return "more commands than the vector has room for";
  std::string complaint;
  CommandReader reader(out);
  for (std::size_t i = 0; i < header.numData; ++i) {
    const auto place = static_cast<int>(i);
    const OCommandInfo& info = *vector.GetInfo(place);
    const auto primitive = primitives.find(info.primitiveID);
    const bool sound = primitive && info.numFrames >= 1 && info.numFrames <= kMaxVectorTicks &&
                       fits(info, region.Size());
    if (sound && reader.read(info, *vector.GetData(place), *primitive)) {
      out.ticks = std::max(out.ticks, static_cast<std::uint32_t>(info.numFrames));
    } else if (complaint.empty()) {
      complaint = "command " + std::to_string(i) + " for primitive " +
                  std::to_string(info.primitiveID) + " of type " + std::to_string(info.type) +
                  " with " + std::to_string(info.numFrames) + " frames is refused";
    }
  }
  return complaint;
}

}  // namespace kelpie::host
