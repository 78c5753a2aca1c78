// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/camera/Artefacts.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "robot/core/Maths.h"

namespace kelpie::sim {
namespace {

constexpr std::size_t kRows = kImageHeight;
constexpr std::size_t kColumns = kImageWidth;

constexpr std::array<RawColumn::Channel RawColumn::*, 3> kChannels{&RawColumn::y, &RawColumn::cr,
                                                                   &RawColumn::cb};

struct Polynomial {
  double a1, b1, a2, b2, a3, b3;
};
constexpr std::array<Polynomial, 3> kRing{
    {{-8.497e-8, 1.120e-5, -5.909e-6, -1.064e-3, -1.577e-3, 4.898e-2},
     {-1.561e-7, 1.081e-5, -3.532e-6, 1.331e-3, -1.145e-3, 1.363e-1},
     {-1.331e-7, 3.059e-5, -1.431e-5, 9.920e-4, -4.731e-4, 1.033e-1}}};

double ringGain(const Polynomial& p, double d) { return ((p.a1 * d + p.a2) * d + p.a3) * d + 1.0; }
double ringOffset(const Polynomial& p, double d) { return ((p.b1 * d + p.b2) * d + p.b3) * d; }

// One of each in turn. Sixteen at a time, since the two never overlap.
void riffle(const std::uint8_t* a, const std::uint8_t* b, std::size_t length,
            std::uint8_t* __restrict out) {
  for (std::size_t i = 0; i < length; ++i) {
    out[2 * i] = a[i];
    out[2 * i + 1] = b[i];
  }
}

}  // namespace

ColourShift randomShift(Random& random) {
  ColourShift shift;
  shift.gain[0] = random.uniform(0.95, 1.05);
  shift.offset[0] = random.uniform(-5.0, 3.0);
  for (std::size_t c = 1; c < 3; ++c) {
    shift.gain[c] = random.uniform(0.95, 1.05);
    shift.offset[c] = 128.0 * (1.0 - shift.gain[c]) + random.uniform(-3.0, 3.0);
  }
  return shift;
}

RingCentres randomCentres(Random& random, double sd) {
  constexpr RingCentres kMean{PixelPoint{110.0, 80.0}, {105.0, 80.0}, {97.0, 80.0}};
  constexpr double kFarthest = 12.0;  // px off the middle; vision's ring tables reach that far
  RingCentres centres;
  for (std::size_t c = 0; c < centres.size(); ++c) {
    const double right = kMean[c].x - kImageMiddle.x + random.gaussian(0.0, sd);
    const double below = kMean[c].y - kImageMiddle.y + random.gaussian(0.0, sd);
    centres[c] = {kImageMiddle.x + maths::clamp(right, -kFarthest, kFarthest),
                  kImageMiddle.y + maths::clamp(below, -kFarthest, kFarthest)};
  }
  return centres;
}

RobotCamera randomCamera(Random& random, const ArtefactParams& params) {
  RobotCamera camera;
  camera.shift = randomShift(random);
  camera.centres = randomCentres(random, params.centreSd);
  return camera;
}

double ringValue(std::size_t channel, double value, double distance) {
  const Polynomial& p = kRing[channel];
  return ringGain(p, distance) * value + ringOffset(p, distance);
}

Artefacts::Artefacts(const ArtefactParams& params, const RobotCamera& robot, SharedTables tables)
    : params_(params), robot_(robot), tables_(std::move(tables)) {
  prepareGains();
  prepareTone();
}

void Artefacts::prepareGains() {
  for (std::size_t c = 0; c < 3; ++c) {
    gain_[c].resize(kImagePixels);
    offset_[c].resize(kImagePixels);
    const double own = params_.shift ? robot_.shift.gain[c] : 1.0;
    const double add = params_.shift ? robot_.shift.offset[c] : 0.0;
    // Less light leaves grey grey.
    const double grey = c == 0 ? 0.0 : 128.0 * (1.0 - robot_.light);
    const PixelPoint centre = params_.centres ? robot_.centres[c] : kImageMiddle;
    for (std::size_t i = 0; i < kImagePixels; ++i) {
      const std::size_t column = i / kRows;
      const double dx = static_cast<double>(column) + 0.5 - centre.x;
      const double dy = static_cast<double>(i % kRows) + 0.5 - centre.y;
      const double d = params_.ring ? maths::hypot(dx, dy) : 0.0;
      const double ring = ringGain(kRing[c], d);
      gain_[c][i] = static_cast<float>(ring * own * robot_.light);
      offset_[c][i] = static_cast<float>(ring * (add + own * grey) + ringOffset(kRing[c], d));
    }
  }
}

void Artefacts::prepareTone() {
  for (std::size_t c = 0; c < 3; ++c) {
    if (robot_.tone[c] == 1.0) continue;
    const double middle = c == 0 ? 0.0 : 128.0;
    const double range = c == 0 ? 255.0 : 127.0;
    tone_[c].resize(256);
    for (std::size_t v = 0; v < tone_[c].size(); ++v) {
      const double off = static_cast<double>(v) - middle;
      const double share = std::fabs(off) / range;
      const double curved =
          share > 0.0 ? range * maths::exp(robot_.tone[c] * maths::log(share)) : 0.0;
      const double value = middle + (off < 0.0 ? -curved : curved);
      tone_[c][v] = static_cast<std::uint8_t>(maths::clamp(value + 0.5, 0.0, 255.0));
    }
  }
}

// Each pixel gives `blurShare` to its four neighbours; the border keeps what would leave.
RawColumn::Channel Artefacts::blurred(std::size_t channel, const RawColumn& of,
                                      const RawColumn& left, const RawColumn& right) const {
  const auto share = static_cast<float>(params_.blurShare);
  const RawColumn::Channel& own = of.*kChannels[channel];
  const RawColumn::Channel& before = left.*kChannels[channel];
  const RawColumn::Channel& after = right.*kChannels[channel];
  RawColumn::Channel out;
  out.front() = own.front();
  out.back() = own.back();
  for (std::size_t y = 1; y + 1 < kRows; ++y) {
    const float sum = before[y] + after[y] + own[y - 1] + own[y + 1];
    out[y] = own[y] + share * (sum - 4.0F * own[y]);
  }
  return out;
}

void Artefacts::bytes(std::size_t x, std::size_t channel, const RawColumn::Channel& value,
                      Random& random) {
  const double usual = channel == 0 ? params_.noiseSdY : params_.noiseSdChroma;
  const auto sd = static_cast<float>(maths::hypot(usual, robot_.noise));
  const float amount = params_.noise ? sd : 0.0F;
  const float* gain = gain_[channel].data() + x * kRows;
  const float* offset = offset_[channel].data() + x * kRows;
  // A random stretch of the table for each column: as good as fresh numbers and 20 times faster.
  const float* noise = tables_->noise.data() + random.index(kNoises);
  std::uint8_t* bytes = strip_[channel].data() + x % kStrip * kRows;
  for (std::size_t y = 0; y < kRows; ++y) {
    const float v = gain[y] * value[y] + offset[y] + amount * noise[y] + 0.5F;
    // Whole numbers are clamped eight at a time, floats are not: a NaN could be among them.
    bytes[y] = static_cast<std::uint8_t>(std::min(std::max(static_cast<int>(v), 0), 255));
  }
  if (tone_[channel].empty()) return;
  for (std::size_t y = 0; y < kRows; ++y) bytes[y] = tone_[channel][bytes[y]];
}

// The strip lies column by column, the image row by row: riffled four times, like a pack of cards,
// the sixteen columns lie so, too. Byte by byte every one would go to another line of the cache.
void Artefacts::writeStrip(std::size_t first, std::size_t channel, Image::Plane& out) {
  std::uint8_t* from = strip_[channel].data();
  std::uint8_t* to = riffled_.data();
  std::size_t length = kRows;
  for (std::size_t half = kStrip / 2; half > 0; half /= 2, length *= 2) {
    for (std::size_t i = 0; i < half; ++i)
      riffle(from + i * length, from + (i + half) * length, length, to + i * 2 * length);
    std::swap(from, to);
  }
  for (std::size_t y = 0; y < kRows; ++y)
    std::memcpy(out.data() + y * kColumns + first, from + y * kStrip, kStrip);
}

// A column between its neighbours.
void Artefacts::finish(std::size_t x, const RawColumn& left, const RawColumn& right, Random& random,
                       Image& image) {
  const RawColumn& own = column(x);
  for (std::size_t c = 0; c < 3; ++c)
    bytes(x, c, params_.blur ? blurred(c, own, left, right) : own.*kChannels[c], random);
  if (x % kStrip + 1 < kStrip) return;
  const std::array<Image::Plane*, 3> out{&image.y, &image.cr, &image.cb};
  for (std::size_t c = 0; c < 3; ++c) writeStrip(x + 1 - kStrip, c, *out[c]);
}

void Artefacts::add(std::size_t x, const RawColumn& added, Random& random, Image& image) {
  column(x) = added;
  if (x > 0) finish(x - 1, column(x > 1 ? x - 2 : 0), added, random, image);
  if (x + 1 == kColumns) finish(x, column(x - 1), added, random, image);
}

}  // namespace kelpie::sim
