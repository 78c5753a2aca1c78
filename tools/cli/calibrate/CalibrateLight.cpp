// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <array>
#include <cmath>
#include <memory>

#include "robot/core/Maths.h"
#include "tools/calibrate/light/LightMeter.h"
#include "tools/cli/Commands.h"
#include "tools/cli/calibrate/Calibrate.h"

namespace kelpie::cli {
namespace {

using calibrate::LightFault;

constexpr const char* kHelp =
    R"(
Whether the camera's settings fit the light, from a log of images: a robot that looks over carpet,
lines and landmarks. Says how bright the images are, what of them is cut off at the ends, what the
carpet and the lines look like, and which setting to take next, or that it is right. Set it in a
file of parameters, take images again and ask again:
  [camera]
  whiteBalance = 3   # 1 indoor (2856 K), 2 outdoor (6500 K), 3 fluorescent (5000 K)
  gain = 3           # 1 low (-6 dB), 2 mid, 3 high (+6 dB)
  shutter = 3        # 1 slow (1/50 s), 2 mid (1/100 s), 3 fast (1/200 s)

  kelpie import DIR --params robot3.toml --out venue.mcap
  kelpie calibrate light venue.mcap)";

std::string nameOf(agent::WhiteBalance balance) {
  constexpr std::array<const char*, 3> kNames = {"indoor", "outdoor", "fluorescent"};
  const auto number = static_cast<std::size_t>(balance);
  return fmt::format("whiteBalance = {} ({})", number, kNames.at(number - 1));
}

std::string nameOf(agent::CameraGain gain) {
  constexpr std::array<const char*, 3> kNames = {"low", "mid", "high"};
  const auto number = static_cast<std::size_t>(gain);
  return fmt::format("gain = {} ({})", number, kNames.at(number - 1));
}

std::string nameOf(agent::Shutter shutter) {
  constexpr std::array<const char*, 3> kNames = {"slow", "mid", "fast"};
  const auto number = static_cast<std::size_t>(shutter);
  return fmt::format("shutter = {} ({})", number, kNames.at(number - 1));
}

// The one setting that differs.
std::string stepTo(const agent::CameraSettings& next, const agent::CameraSettings& set) {
  if (next.whiteBalance != set.whiteBalance) return nameOf(next.whiteBalance);
  return next.gain != set.gain ? nameOf(next.gain) : nameOf(next.shutter);
}

const char* textOf(LightFault fault) {
  switch (fault) {
    case LightFault::none: return "";
    case LightFault::tooDark: return "too dark";
    case LightFault::tooBright: return "too bright";
    case LightFault::tooWarm: return "white looks red: the lamps are warmer than the setting";
    case LightFault::tooCold: return "white looks blue: the light is colder than the setting";
  }
  return "";
}

double directionOf(const vision::SurfaceColour& c) {
  constexpr double kNeutral = 128.0;
  return std::atan2(c.cb - kNeutral, c.cr - kNeutral) * 180.0 / maths::kPi;
}

void tellSurfaces(const calibrate::LightLog& log) {
  const auto& carpet = log.measure.carpet;
  const auto& line = log.measure.line;
  if (carpet)
    fmt::print("carpet      Y {:.0f} Cr {:.0f} Cb {:.0f}, chroma at {:.0f} deg, expected {:.0f}\n",
               carpet->y, carpet->cr, carpet->cb, directionOf(*carpet), directionOf(log.carpet));
  else
    fmt::print("carpet      not found\n");
  if (line)
    fmt::print("lines       Y {:.0f} Cr {:.0f} Cb {:.0f}, neutral is 128 128\n", line->y, line->cr,
               line->cb);
  else
    fmt::print("lines       not found: the white balance cannot be told\n");
}

std::string verdictText(const calibrate::LightVerdict& verdict, const calibrate::LightLog& log) {
  if (verdict.fault == LightFault::none)
    return log.measure.line ? "the setting is right" : "the brightness is right";
  const std::string what = textOf(verdict.fault);
  if (verdict.next != log.set) return what + "; next: " + stepTo(verdict.next, log.set);
  return what + "; the camera has no further setting: change the light";
}

int calibrateLight(const std::string& path) {
  const auto log = calibrate::readLight(path);
  if (!log) return fail(log.error(), kExitBadInput);
  const calibrate::LightMeasure& measure = log->measure;
  const agent::CameraSettings& set = log->set;
  fmt::print("images      {}, taken with {}, {}, {}\n", measure.images, nameOf(set.whiteBalance),
             nameOf(set.gain), nameOf(set.shutter));
  fmt::print("brightness  {:.0f}; {:.1f} % of the pixels at most 5, {:.1f} % at least 250\n",
             measure.brightness, 100.0 * measure.dark, 100.0 * measure.bright);
  tellSurfaces(*log);
  fmt::print("{}\n", verdictText(verdictOn(measure, set), *log));
  if (log->lacks.empty()) return kExitDone;
  return fail(path + ": " + log->lacks + "; judged by the rest", kExitBadInput);
}

}  // namespace

void addCalibrateLight(CommandLine& command, int& code) {
  auto light = command.subcommand(
      "light", "Whether white balance, gain and shutter fit the light, from a log with images");
  auto path = std::make_shared<std::string>();
  light.option("LOG", *path, "Log with images").required();
  light.footer(kHelp);
  light.callback([path, &code] { code = calibrateLight(*path); });
}

}  // namespace kelpie::cli
