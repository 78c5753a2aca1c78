// SPDX-License-Identifier: Apache-2.0
// `kelpie calibrate light`: whether the camera's settings fit a venue's light, from the images of a
// log: how bright they are, what is cut off at the ends, and what carpet and lines look like. Lines
// are what is brighter between carpet above and below, so that no colour table is needed. Fails
// where no carpet shows, and then judges the brightness alone; where a camera's step is no doubling
// of Y, as by its gamma, a step does less and another is asked for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/agent/CameraSettings.h"
#include "robot/core/Expected.h"
#include "robot/core/types/Image.h"
#include "vision/colour/RingTable.h"
#include "vision/light/LightParams.h"

namespace kelpie::calibrate {

struct LightMeasure {
  std::uint32_t images = 0;
  double brightness = 0.0;                      // mean Y, levels
  double dark = 0.0;                            // share of pixels with Y of at most 5
  double bright = 0.0;                          // at least 250
  std::optional<vision::SurfaceColour> carpet;  // mean
  std::optional<vision::SurfaceColour> line;    // median
};

class LightMeter {
 public:
  // Ring correction of the images; what the carpet is expected to look like, for its direction.
  LightMeter(const vision::RingTable& ring, const vision::SurfaceColour& carpet)
      : ring_(ring), expected_(carpet) {}

  void add(const Image& image);
  LightMeasure measure() const;

 private:
  struct Sum {
    double count = 0.0;
    double y = 0.0;
    double cr = 0.0;
    double cb = 0.0;
  };

  void addColumn(const Image& image, int px);
  void addBetween(const Image& image, int px, int above, int below);
  Yuv corrected(const Image& image, int px, int py) const;
  bool isCarpets(Yuv pixel) const;

  const vision::RingTable& ring_;
  vision::SurfaceColour expected_;
  vision::RingDistances distances_;
  std::uint32_t images_ = 0;
  double looked_ = 0.0;  // pixels
  double sumY_ = 0.0;
  double dark_ = 0.0;
  double bright_ = 0.0;
  Sum carpet_;
  std::vector<Yuv> lines_;  // their brightest pixels
};

enum class LightFault : std::uint8_t { none, tooDark, tooBright, tooWarm, tooCold };

struct LightVerdict {
  LightFault fault = LightFault::none;
  agent::CameraSettings next;  // as set, where nothing is left to set
};

// Brightness comes first: what is cut off has no colour.
LightVerdict verdictOn(const LightMeasure& measure, const agent::CameraSettings& set);

struct LightLog {
  LightMeasure measure;
  agent::CameraSettings set;
  vision::SurfaceColour carpet;  // expected
  std::string lacks;             // what of the log could not be read
};

// An error says in one line why nothing can be told.
Expected<LightLog> readLight(const std::string& path);

}  // namespace kelpie::calibrate
