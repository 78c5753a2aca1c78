// SPDX-License-Identifier: Apache-2.0
// What the ERS-7's camera does to colours: blur, the light that reaches it, the difference between
// robots, the ring effect, noise and, of randomised robots, a response that is not linear, in that
// order. Each can be switched off.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "robot/core/Random.h"
#include "robot/core/fields/Fields.h"
#include "robot/core/types/Geometry.h"
#include "robot/core/types/Image.h"
#include "tools/sim/camera/RandomTables.h"

namespace kelpie::sim {

// A column of the image before it becomes bytes: Y, Cr, Cb from above down.
struct RawColumn {
  using Channel = std::array<float, kImageHeight>;
  Channel y{}, cr{}, cb{};
};

// A robot's own colours: out = gain * in + offset for Y, Cr, Cb.
struct ColourShift {
  std::array<double, 3> gain{1.0, 1.0, 1.0};
  std::array<double, 3> offset{0.0, 0.0, 0.0};

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("gain", &ColourShift::gain, "", 0.898, 1.117),
                     field("offset", &ColourShift::offset, "", -13.6, 10.1));
  }
};

// Where each channel's ring effect is centred: Y, Cr, Cb.
constexpr PixelPoint kImageMiddle{0.5 * kImageWidth, 0.5 * kImageHeight};
using RingCentres = std::array<PixelPoint, 3>;
constexpr RingCentres kMiddleCentres{kImageMiddle, kImageMiddle, kImageMiddle};

// What a robot's camera has for itself.
struct RobotCamera {
  ColourShift shift;
  RingCentres centres = kMiddleCentres;
  // Exponents of its response: Y over black, Cr and Cb over grey; 1: linear.
  std::array<double, 3> tone{1.0, 1.0, 1.0};
  double light = 1.0;  // of the place, over the nominal one
  double noise = 0.0;  // levels, sd in every channel besides ArtefactParams'
};

struct ArtefactParams {
  bool ring = true;
  bool centres = true;  // off: every ring is centred on the image
  bool noise = true;
  bool blur = true;
  bool shift = true;
  double noiseSdY = 2.5;       // grey levels
  double noiseSdChroma = 2.0;  // grey levels
  double blurShare = 0.08;     // of each of the four neighbours
  double centreSd = 2.0;       // px, of a robot's ring centres about those of 2005 [chosen]

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("ring", &ArtefactParams::ring),
                     field("centres", &ArtefactParams::centres),
                     field("noise", &ArtefactParams::noise), field("blur", &ArtefactParams::blur),
                     field("shift", &ArtefactParams::shift),
                     field("noiseSdY", &ArtefactParams::noiseSdY, "levels", 0, 20),
                     field("noiseSdChroma", &ArtefactParams::noiseSdChroma, "levels", 0, 20),
                     field("blurShare", &ArtefactParams::blurShare, "", 0, 0.2),
                     field("centreSd", &ArtefactParams::centreSd, "px", 0, 6));
  }
};

// A robot drawn at random, inside the range of the 35 fits to real robots (facts-2005 section 3).
// There chroma turns about 128, because grey stays grey.
ColourShift randomShift(Random& random);

// Ring centres of a robot drawn at random. Those of the correction of 2005 lay in columns 110 (Y),
// 105 (Cr) and 97 (Cb) of the middle row (facts-2005 section 3); how much robots differ is not
// known, so `sd` is a guess.
RingCentres randomCentres(Random& random, double sd);

RobotCamera randomCamera(Random& random, const ArtefactParams& params);

// Value after the ring effect: the published forward polynomial (thesis 2006 equations 2.1 and 2.2,
// checklist A-2.3.2.6) for channel 0 Y, 1 Cr, 2 Cb at `distance` px from the channel's centre.
double ringValue(std::size_t channel, double value, double distance);

class Artefacts {
 public:
  Artefacts(const ArtefactParams& params, const RobotCamera& robot,
            SharedTables tables = makeRandomTables());

  // Takes an image's columns from left to right, x = 0 first, and makes bytes of each when its
  // right neighbour is known; the image is whole after its last column. One at a time, so that
  // nothing leaves the cache between: what an image needs does not fit it.
  void add(std::size_t x, const RawColumn& column, Random& random, Image& image);

 private:
  void prepareGains();
  void prepareTone();
  void finish(std::size_t x, const RawColumn& left, const RawColumn& right, Random& random,
              Image& image);
  RawColumn& column(std::size_t x) { return columns_[x % columns_.size()]; }
  RawColumn::Channel blurred(std::size_t channel, const RawColumn& of, const RawColumn& left,
                             const RawColumn& right) const;
  void bytes(std::size_t x, std::size_t channel, const RawColumn::Channel& value, Random& random);
  void writeStrip(std::size_t first, std::size_t channel, Image::Plane& out);

  static constexpr std::size_t kStrip = 16;  // columns
  static_assert(kImageWidth % kStrip == 0);
  using Strip = std::array<std::uint8_t, kStrip * kImageHeight>;

  ArtefactParams params_;
  RobotCamera robot_;
  // Ring effect and shift together are linear in the value: gain and offset for each pixel.
  std::array<std::vector<float>, 3> gain_;
  std::array<std::vector<float>, 3> offset_;
  std::array<std::vector<std::uint8_t>, 3> tone_;  // by value; empty: linear
  SharedTables tables_;
  std::array<RawColumn, 3> columns_;  // the last ones
  // Columns that are bytes and not yet in the image, one after the other.
  std::array<Strip, 3> strip_{};
  Strip riffled_{};  // on their way
};

}  // namespace kelpie::sim
