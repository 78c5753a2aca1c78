// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/light/LightMeter.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "tools/calibrate/LoggedFrames.h"
#include "tools/calibrate/Quantile.h"
#include "vision/colour/ColourTable.h"
#include "vision/pixels/Sampler.h"

namespace kelpie::calibrate {
namespace {

constexpr int kDarkest = 5;      // at most, levels: nothing is told apart
constexpr int kBrightest = 250;  // at least
constexpr int kColumnStep = 3;   // px

// Carpet: as vision looks for it (LightSightings.cpp), but 45 deg off instead of 32, since lamps of
// 2856 K turn it by 34 deg in a camera set for 5000 K.
constexpr double kMinChroma = 5.0;  // levels
constexpr double kCosine = 0.7;
constexpr double kMinCarpet = 0.02;  // of all pixels

// A line from 50 cm on is at most that wide, a near ball is wider. White paint is 2.4 times as
// bright as the carpet.
constexpr int kWidestLine = 14;  // px
constexpr double kOverCarpet = 1.4;
constexpr std::size_t kMinLines = 30;  // pixels

// A step doubles the brightness or halves it: what is asked for must be right afterwards.
constexpr double kMostCutOff = 0.05;  // share of pixels; a lamp or a window is less
constexpr double kDarkLine = 100.0;   // levels; twice that is as far from the end as it should be
constexpr double kBrightLine = 235.0;
constexpr double kDarkImage = 40.0;  // mean, where no line is seen
constexpr double kBrightImage = 160.0;

// How much redder than bluer white is, over its brightness. The halves of what the steps between
// 2856, 5000 and 6500 K change by Planck's law at 600, 540 and 460 nm; not measured on a robot.
constexpr double kHalfWarmStep = 0.14;      // lamps of 2856 K in a camera set for 5000 K
constexpr double kHalfWarmestStep = 0.05;   // of 5000 K, set for 6500 K
constexpr double kHalfColdStep = -0.05;     // of 6500 K, set for 5000 K
constexpr double kHalfColdestStep = -0.20;  // of 5000 K, set for 2856 K

double chromaOf(const vision::SurfaceColour& c) {
  return std::hypot(c.cr - vision::kNeutralChroma, c.cb - vision::kNeutralChroma);
}

template <class Setting>
Setting stepped(Setting setting, int by) {
  return static_cast<Setting>(std::clamp(static_cast<int>(setting) + by, 1, 3));
}

// The gain first, since a slower shutter smears; the other way round the shutter first.
agent::CameraSettings brighter(agent::CameraSettings set) {
  if (set.gain != agent::CameraGain::high)
    set.gain = stepped(set.gain, 1);
  else
    set.shutter = stepped(set.shutter, -1);
  return set;
}

agent::CameraSettings darker(agent::CameraSettings set) {
  if (set.shutter != agent::Shutter::fast)
    set.shutter = stepped(set.shutter, 1);
  else
    set.gain = stepped(set.gain, -1);
  return set;
}

bool isTooBright(const LightMeasure& m) {
  if (m.bright > kMostCutOff) return true;
  return m.line ? m.line->y > kBrightLine : m.brightness > kBrightImage;
}

bool isTooDark(const LightMeasure& m) {
  return m.line ? m.line->y < kDarkLine : m.brightness < kDarkImage;
}

LightVerdict judgeBalance(const vision::SurfaceColour& line, agent::CameraSettings set) {
  using agent::WhiteBalance;
  const double tint = (line.cr - line.cb) / (2.0 * line.y);
  const WhiteBalance now = set.whiteBalance;
  const double warm = now == WhiteBalance::outdoor ? kHalfWarmestStep : kHalfWarmStep;
  const double cold = now == WhiteBalance::indoor ? kHalfColdestStep : kHalfColdStep;
  if (tint > warm) {
    set.whiteBalance =
        now == WhiteBalance::outdoor ? WhiteBalance::fluorescent : WhiteBalance::indoor;
    return {LightFault::tooWarm, set};
  }
  if (tint < cold) {
    set.whiteBalance =
        now == WhiteBalance::indoor ? WhiteBalance::fluorescent : WhiteBalance::outdoor;
    return {LightFault::tooCold, set};
  }
  return {LightFault::none, set};
}

}  // namespace

Yuv LightMeter::corrected(const Image& image, int px, int py) const {
  return ring_(image.pixel(px, py), distances_(px, py, ring_.centre));
}

bool LightMeter::isCarpets(Yuv pixel) const {
  const double cr = pixel.cr - vision::kNeutralChroma;
  const double cb = pixel.cb - vision::kNeutralChroma;
  const double norm = std::hypot(cr, cb);
  const double along =
      cr * (expected_.cr - vision::kNeutralChroma) + cb * (expected_.cb - vision::kNeutralChroma);
  return norm > kMinChroma && along > kCosine * norm * chromaOf(expected_);
}

void LightMeter::add(const Image& image) {
  ++images_;
  for (int px = vision::kUsableLeft; px < vision::kUsableRight; px += kColumnStep)
    addColumn(image, px);
}

void LightMeter::addColumn(const Image& image, int px) {
  int above = -1;  // the last row of carpet
  for (int py = vision::kUsableTop; py < vision::kUsableBottom; ++py) {
    const int y = image.pixel(px, py).y;
    looked_ += 1.0;
    sumY_ += y;
    dark_ += y <= kDarkest ? 1.0 : 0.0;
    bright_ += y >= kBrightest ? 1.0 : 0.0;
    const Yuv pixel = corrected(image, px, py);
    if (!isCarpets(pixel)) continue;
    carpet_ = {carpet_.count + 1.0, carpet_.y + pixel.y, carpet_.cr + pixel.cr,
               carpet_.cb + pixel.cb};
    if (above >= 0) addBetween(image, px, above, py);
    above = py;
  }
}

// What lies between two rows of carpet.
void LightMeter::addBetween(const Image& image, int px, int above, int below) {
  if (below - above < 2 || below - above > kWidestLine + 1) return;
  Yuv most;
  for (int py = above + 1; py < below; ++py) {
    const Yuv pixel = corrected(image, px, py);
    if (pixel.y > most.y) most = pixel;
  }
  const int carpet = std::max(corrected(image, px, above).y, corrected(image, px, below).y);
  if (most.y > kOverCarpet * carpet) lines_.push_back(most);
}

LightMeasure LightMeter::measure() const {
  LightMeasure m;
  m.images = images_;
  if (looked_ < 1.0) return m;
  m.brightness = sumY_ / looked_;
  m.dark = dark_ / looked_;
  m.bright = bright_ / looked_;
  if (carpet_.count < kMinCarpet * looked_) return m;
  m.carpet = {carpet_.y / carpet_.count, carpet_.cr / carpet_.count, carpet_.cb / carpet_.count};
  if (lines_.size() < kMinLines) return m;
  const auto median = [&](std::uint8_t Yuv::*channel) {
    std::vector<double> values;
    for (const Yuv& p : lines_) values.push_back(p.*channel);
    return quantile(std::move(values), 0.5);
  };
  m.line = {median(&Yuv::y), median(&Yuv::cr), median(&Yuv::cb)};
  return m;
}

LightVerdict verdictOn(const LightMeasure& measure, const agent::CameraSettings& set) {
  if (isTooBright(measure)) return {LightFault::tooBright, darker(set)};
  if (isTooDark(measure)) return {LightFault::tooDark, brighter(set)};
  if (!measure.line) return {LightFault::none, set};
  return judgeBalance(*measure.line, set);
}

// Images that were made again from class planes have no light of their own.
Expected<LightLog> readLight(const std::string& path) {
  const auto config = std::make_unique<agent::AgentConfig>();
  const auto input = std::make_unique<FrameInput>();
  std::unique_ptr<LightMeter> meter;
  LightLog log;
  const Status read =
      forEachMessage(path, *config, log.lacks, [&](const LogMessage& message) -> Status {
        if (message.topic() != kFrameInputTopic) return Done{};
        const Status done = decodeAs(message, *input);
        if (!done) return done;
        if (!meter)
          meter =
              std::make_unique<LightMeter>(config->calibration.ring, config->vision.light.carpet);
        meter->add(input->image);
        return done;
      });
  if (!read) return Error{read.error()};
  if (!meter) return Error{path + ": no image is kept in it"};
  log.measure = meter->measure();
  log.set = config->camera;
  log.carpet = config->vision.light.carpet;
  return log;
}

}  // namespace kelpie::calibrate
