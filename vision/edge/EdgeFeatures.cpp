// SPDX-License-Identifier: Apache-2.0
#include "vision/edge/EdgeFeatures.h"

#include <algorithm>

namespace kelpie::vision {
namespace {

constexpr int kStep = 2;           // px between the lattice samples of a scan line
constexpr int kMaxLineWidth = 24;  // px, of a white line before the robot's feet
constexpr int kAboveMixture = 3;   // px above the carpet, where no pixel is a mixture any more
constexpr int kMinWindow = 4;      // px that must be left of the window at the image's end

bool isGreen(const LineClasses& classes, int step) {
  return classes.nextTo(step) == ColourClass::green;
}

// Green from this step on for most of the window (thesis 2006 section 3.2.1 judges N px late and
// moves the position back; walking down the position is at hand).
bool carpetBegins(const LineClasses& classes, const ScanLine& line, int step,
                  const FieldEdgeParams& params) {
  const int window = std::min(static_cast<int>(params.window), line.steps - step);
  if (window < kMinWindow) return false;
  int missing = static_cast<int>((1.0 - params.minGreen) * window / kStep);
  for (int i = 0; i < window; i += kStep) {
    if (!isGreen(classes, step + i) && --missing < 0) return false;
  }
  return true;
}

// How many steps from this one on begin no carpet, judged by the last samples of its window: when
// so many of them are not green as no window may miss, each window from here to there holds them.
int surelyBefore(const LineClasses& classes, const ScanLine& line, int step,
                 const FieldEdgeParams& params) {
  const auto whole = static_cast<int>(params.window);
  const int window = whole / kStep * kStep;
  if (step + window > line.steps) return 0;
  const int missing = static_cast<int>((1.0 - params.minGreen) * whole / kStep);
  for (int i = 1; i <= missing + 1; ++i) {
    const int at = step + window - i * kStep;
    if (at < step || isGreen(classes, at)) return 0;
  }
  return window;
}

// First step of the carpet, -1 without any. The samples show it, one or two pixels more tell its
// first one: classifying all of the window would cost as much as the whole walk.
int carpetTop(const LineClasses& classes, const ScanLine& line, const FieldEdgeParams& params) {
  for (int step = 0; step < line.steps; step += kStep) {
    while (const int before = surelyBefore(classes, line, step, params)) step += before;
    if (step >= line.steps) break;
    if (!isGreen(classes, step) || !carpetBegins(classes, line, step, params)) continue;
    int fine = std::max(step - kStep, 0);
    while (fine < step + kStep && classes.at(fine) != ColourClass::green) ++fine;
    return fine;
  }
  return -1;
}

bool standsOnCarpet(ColourClass c) {
  return c == ColourClass::orange || c == ColourClass::pink || c == ColourClass::robotRed ||
         c == ColourClass::robotBlue;
}

// A ball or a robot, or a line that leaves through the image's top, hides carpet, not its end.
bool goesOn(const LineClasses& classes, const ScanLine& line, int top) {
  if (top == 0) return line.cutTop;
  for (const int above : {kAboveMixture, kAboveMixture + kStep}) {
    if (top >= above && standsOnCarpet(classes.nextTo(top - above))) return true;
  }
  if (!line.cutTop || top > kMaxLineWidth) return false;
  for (int step = 0; step < top - 1; ++step) {
    if (classes.nextTo(step) != ColourClass::white) return false;
  }
  return true;
}

// A goal's back wall stands on the edge, its side walls before it; white is a beacon or a robot.
EdgeFeature featureAt(const LineClasses& classes, const ScanLine& line, int top,
                      const FieldEdgeParams& params) {
  EdgeFeature feature{line.at(top - 0.5), goesOn(classes, line, top), 1.0, false};
  if (top < kAboveMixture) return feature;
  const ColourClass c = classes.nextTo(top - kAboveMixture);
  feature.atGoal = c == ColourClass::blue || c == ColourClass::yellow;
  if (feature.atGoal || c == ColourClass::white) feature.weight = params.doubtfulWeight;
  return feature;
}

}  // namespace

EdgeFeatures edgeFeatures(const Sampler& sampler, const ScanLines& lines,
                          const FieldEdgeParams& params) {
  EdgeFeatures features;
  for (const ScanLine& line : lines) {
    const LineClasses classes(sampler, line);
    const int top = carpetTop(classes, line, params);
    if (top < 0) continue;
    const EdgeFeature feature = featureAt(classes, line, top, params);
    // Green at the very start of a line that begins above the horizon is no carpet.
    if (top > 0 || feature.open) features.push_back(feature);
  }
  return features;
}

}  // namespace kelpie::vision
