// SPDX-License-Identifier: Apache-2.0
// The checks of line, border and field points (thesis 2004 section 3.1.3), each alone so that each
// can be tested: true = keep. Added to the thesis: white inside, and the width that a line has on
// the ground, which upright things between camera and carpet have not.
#pragma once

#include "vision/LineScan.h"
#include "vision/Scene.h"

namespace kelpie::vision {

// A bright stretch of a scan with its continuation on both sides.
struct LineCandidate {
  Scan scan;
  Stretch stretch;
  PixelPoint pixel;
};

// Width on the ground across the line's direction.
struct GroundWidth {
  double perPixel = 0.0;  // cm across the line that one pixel along the scan covers
  double paint = 0.0;     // cm
};

// Any point.
bool headIsSlow(const BodyState& body, const LineParams& p);
bool pointIsBelowHorizon(const Scene& scene, PixelPoint pixel);
bool pointIsOutsideCorners(PixelPoint pixel, const LineParams& p);
bool pointIsOutsideObjects(const Percepts& seen, PixelPoint pixel, const LineParams& p);
// Line points.
bool lineIsBetweenGreen(const Sampler& sampler, const LineCandidate& c);
bool lineIsColourless(const Sampler& sampler, const LineCandidate& c, const LineParams& p);
bool lineIsNarrow(const GroundWidth& width, const LineParams& p);
bool lineIsWide(const GroundWidth& width, const LineParams& p);
// Border points: a rise on a scan that leads away from the carpet.
bool borderIsAfterGreen(const Sampler& sampler, const Scan& scan, const Rise& rise);
bool borderIsLong(const Scene& scene, const Scan& scan, const Rise& rise, const LineParams& p);
bool borderIsHigh(const Scene& scene, const Scan& scan, const Rise& rise, const LineParams& p);
bool borderGoesOn(const Sampler& sampler, const Scan& scan, const Rise& rise, const LineParams& p);
bool borderHasSide(const Scene& scene, const Scan& scan, const Rise& rise, const LineParams& p);
// Field points.
bool fieldIsEven(const Sampler& sampler, PixelPoint pixel, const LineParams& p);
bool fieldIsGreenBeside(const Sampler& sampler, PixelPoint pixel, const LineParams& p);

// The line runs from one place beside the scan to another.
std::optional<GroundWidth> widthOnGround(const CameraPose& camera, const LineCandidate& c,
                                         PixelPoint a, PixelPoint b);

}  // namespace kelpie::vision
