// SPDX-License-Identifier: Apache-2.0
// Scan lines across the image and the bright stretches on them: brighter than the carpet on both
// sides, edges placed between pixels where the brightness is half-way. Brightness, not colour
// classes, because a line at 150 cm covers a third of a pixel and has the class of the carpet.
// Fails where the carpet itself changes its brightness by `minStep` within two pixels.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "robot/core/FixedVector.h"
#include "robot/core/Geometry.h"
#include "vision/LineParams.h"
#include "vision/Sampler.h"

namespace kelpie::vision {

constexpr int kScanLeft = 4;  // px; 21 columns and 16 rows
constexpr int kScanTop = 4;
constexpr int kScanSpacing = 10;       // px, thesis 2004 3.1.1
constexpr int kFieldScanSpacing = 50;  // px, thesis 2004 3.1.2

// `length` pixels from (px, py) on, one step (dx, dy) apart, along a row or a column.
struct Scan {
  int px = 0;
  int py = 0;
  int dx = 0;
  int dy = 0;
  int length = 0;

  int column(int i, int aside = 0) const { return px + dx * i + (dy != 0 ? aside : 0); }
  int row(int i, int aside = 0) const { return py + dy * i + (dx != 0 ? aside : 0); }
  // A place on the scan, or `aside` pixels right of it (below it, if it runs along a row).
  PixelPoint at(double i, double aside = 0.0) const {
    return {px + 0.5 + dx * i + (dy != 0 ? aside : 0.0),
            py + 0.5 + dy * i + (dx != 0 ? aside : 0.0)};
  }
};

// Outwards from the middle column along a row.
Scan scanOut(int py, int dx);
// Upwards from the lowest usable row to `highest`; along a row from left to right.
Scan scanUp(int px, int highest);
Scan scanRight(int py);

// Indices along a scan; `first` and `last` are carpet, at most one pixel away from the bright ones.
struct Stretch {
  int first = 0;
  int last = 0;
  double from = 0.0;  // where the brightness is half-way
  double to = 0.0;
  double base = 0.0;   // brightness of the carpet
  double top = 0.0;    // brightness of the brightest pixel
  double paint = 0.0;  // px covered by paint: brightness above the carpet over that of full paint
  double middle() const { return 0.5 * (from + to); }
};
using Stretches = FixedVector<Stretch, 32>;

Stretches brightStretches(const Sampler& sampler, const Scan& scan, const LineParams& params);

// An edge from carpet to something brighter, whatever comes after it.
struct Rise {
  int first = 0;       // the carpet's last pixel
  int last = 0;        // the first pixel of full brightness
  double foot = 0.0;   // where the brightness is half-way
  double level = 0.0;  // the brightness there
};
using Rises = FixedVector<Rise, 32>;
Rises risesOn(const Sampler& sampler, const Scan& scan, const LineParams& params);

// Where the edge is `aside` pixels beside the scan, followed pixel by pixel.
std::optional<double> riseBeside(const Sampler& sampler, const Scan& scan, const Rise& rise,
                                 int aside);

// Whether the image is usable on that side of all of the stretch.
bool hasBeside(const Scan& scan, const Stretch& stretch, int aside);
// Where the bright stretch goes on `aside` pixels beside the scan, followed pixel by pixel.
struct Beside {
  double from = 0.0;
  double to = 0.0;
  double middle() const { return 0.5 * (from + to); }
};
std::optional<Beside> stretchBeside(const Sampler& sampler, const Scan& scan,
                                    const Stretch& stretch, int aside);

}  // namespace kelpie::vision
