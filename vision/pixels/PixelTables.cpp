// SPDX-License-Identifier: Apache-2.0
#include "vision/pixels/PixelTables.h"

#include "robot/core/Maths.h"
#include "vision/colour/ColourBuilder.h"

namespace kelpie::vision {
namespace {

constexpr double kMax = kByteValues - 1.0;

std::uint8_t asByte(double value) {
  return static_cast<std::uint8_t>(maths::clamp(value + 0.5, 0.0, kMax));
}

// What each corrected value is in the light that the table was made for.
void fill(const LightGains& gains, ChannelBytes& bytes) {
  for (std::size_t value = 0; value < kByteValues; ++value) {
    const double v = static_cast<double>(value);
    bytes.y[value] = asByte(v / gains.brightness);
    bytes.chroma[value] = asByte(kNeutralChroma + (v - kNeutralChroma) / gains.colour);
  }
}

}  // namespace

RingByValue::RingByValue(const RingTable& table) : centre(table.centre) {
  for (std::size_t value = 0; value < kByteValues; ++value) {
    for (std::size_t d = 0; d < kRingDistances; ++d) {
      const std::size_t at = kStride * value + d;
      cells[at] = table.y[kByteValues * d + value];
      cells[at + kCr] = table.cr[kByteValues * d + value];
      cells[at + kCb] = table.cb[kByteValues * d + value];
    }
  }
}

PixelTables::PixelTables(const VisionCalibration& calibration)
    : colour(calibration.colour),
      ring(calibration.ring),
      otherColour_(withGlare(colour)),
      calibrated_(ring) {}

void PixelTables::follow(const CameraLight& light) {
  if (light.glare != inGlare_) colour.cells.swap(otherColour_.cells);
  inGlare_ = light.glare;
  for (std::size_t part = 0; part < kTableParts; ++part) {
    const LightGains& wanted = part < light.partsToMake ? light.before : light.applied;
    if (lights_[part] == wanted) continue;
    if (bytesAreOf_ != wanted) fill(wanted, bytes_);
    bytesAreOf_ = wanted;
    make(part);
    lights_[part] = wanted;
  }
}

void PixelTables::make(std::size_t part) {
  constexpr std::size_t kValues = kByteValues / kTableParts;
  for (std::size_t value = part * kValues; value < (part + 1) * kValues; ++value) {
    const std::uint8_t* const from = calibrated_.cells.data() + RingByValue::kStride * value;
    std::uint8_t* const to = ring.cells.data() + RingByValue::kStride * value;
    for (std::size_t i = 0; i < RingByValue::kCr; ++i) to[i] = bytes_.y[from[i]];
    for (std::size_t i = RingByValue::kCr; i < 3 * kRingDistances; ++i)
      to[i] = bytes_.chroma[from[i]];
  }
}

CameraLight advanced(CameraLight light) {
  if (light.partsToMake > 0) --light.partsToMake;
  return light;
}

}  // namespace kelpie::vision
