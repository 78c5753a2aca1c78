// SPDX-License-Identifier: Apache-2.0
#include "tools/viewer/Points.h"

#include <array>
#include <cmath>
#include <cstring>

#include "tools/viewer/Frames.h"

namespace kelpie::viewer {
namespace {

using Type = foxglove::PackedElementField;

struct Element {
  const char* name;
  std::uint32_t offset;
  foxglove::PackedElementField::NumericType type;
};
constexpr std::array<Element, 7> kElements = {{{"x", 0, Type::FLOAT32},
                                               {"y", 4, Type::FLOAT32},
                                               {"z", 8, Type::FLOAT32},
                                               {"red", 12, Type::UINT8},
                                               {"green", 13, Type::UINT8},
                                               {"blue", 14, Type::UINT8},
                                               {"alpha", 15, Type::UINT8}}};
constexpr std::uint32_t kStride = 16;

std::uint8_t byteOf(double share) { return static_cast<std::uint8_t>(std::lround(255.0 * share)); }

}  // namespace

Points::Points(TimeUs time, const std::string& frame) {
  *cloud_.mutable_timestamp() = stampOf(time);
  cloud_.set_frame_id(frame);
  *cloud_.mutable_pose() = poseAt({});
  cloud_.set_point_stride(kStride);
  for (const Element& element : kElements) {
    foxglove::PackedElementField& field = *cloud_.add_fields();
    field.set_name(element.name);
    field.set_offset(element.offset);
    field.set_type(element.type);
  }
}

void Points::add(const foxglove::Vector3& place, const foxglove::Color& colour) {
  const std::array<float, 3> numbers = {
      static_cast<float>(place.x()), static_cast<float>(place.y()), static_cast<float>(place.z())};
  const std::array<std::uint8_t, 4> bytes = {byteOf(colour.r()), byteOf(colour.g()),
                                             byteOf(colour.b()), byteOf(colour.a())};
  std::array<char, kStride> point{};
  std::memcpy(point.data(), numbers.data(), sizeof numbers);
  std::memcpy(point.data() + sizeof numbers, bytes.data(), sizeof bytes);
  cloud_.mutable_data()->append(point.data(), point.size());
}

}  // namespace kelpie::viewer
