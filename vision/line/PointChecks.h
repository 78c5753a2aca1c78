// SPDX-License-Identifier: Apache-2.0
// The checks of line, border and field points (thesis 2004 section 3.1.3), each alone so that each
// can be tested: true = keep. Added to the thesis: white inside, and the width that a line has on
// the ground, which upright things between camera and carpet do not have.
#pragma once

#include "vision/Scene.h"
#include "vision/line/BrightSegments.h"

namespace kelpie::vision {

// A bright segment of a grid line with its continuation on both sides.
struct LineCandidate {
  GridLine gridLine;
  BrightSegment segment;
  PixelPoint pixel;
};

// Width on the ground across the line's direction.
struct GroundWidth {
  double perPixel = 0.0;  // cm across the line that one pixel along the grid line covers
  double paint = 0.0;     // cm
  double doubt = 0.0;     // share by which a badly known tilt alone may make it wrong
};

// Any point.
bool headIsSlow(const BodyState& body, const LinePointParams& p);
bool pointIsBelowHorizon(const Scene& scene, PixelPoint pixel);
bool pointIsOutsideCorners(PixelPoint pixel, const LinePointParams& p);
bool pointIsOutsideObjects(const Percepts& seen, PixelPoint pixel, const LinePointParams& p);
// Line points.
bool lineIsBetweenGreen(const Sampler& sampler, const LineCandidate& c);
bool lineIsColourless(const Sampler& sampler, const LineCandidate& c, const LinePointParams& p);
bool lineIsNarrow(const GroundWidth& width, double lineWidth, const LinePointParams& p);
bool lineIsWide(const GroundWidth& width, double lineWidth, const LinePointParams& p);
// Border points: a rising edge on a grid line that leads away from the carpet.
bool borderIsAfterGreen(const Sampler& sampler, const GridLine& gridLine, const RisingEdge& edge);
bool borderIsLong(const Scene& scene, const GridLine& gridLine, const RisingEdge& edge,
                  const LinePointParams& p);
bool borderIsHigh(const Scene& scene, const GridLine& gridLine, const RisingEdge& edge,
                  const LinePointParams& p);
bool borderGoesOn(const Sampler& sampler, const GridLine& gridLine, const RisingEdge& edge,
                  const LinePointParams& p);
bool borderHasSide(const Scene& scene, const GridLine& gridLine, const RisingEdge& edge,
                   const LinePointParams& p);
// Field points.
bool fieldIsEven(const Sampler& sampler, PixelPoint pixel, const LinePointParams& p);
bool fieldIsGreenBeside(const Sampler& sampler, PixelPoint pixel, const LinePointParams& p);

// The line runs from one place beside the grid line to another.
std::optional<GroundWidth> widthOnGround(const CameraPose& camera, const LineCandidate& c,
                                         PixelPoint a, PixelPoint b);

}  // namespace kelpie::vision
