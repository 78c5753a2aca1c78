// SPDX-License-Identifier: Apache-2.0
#include "vision/EdgeFeatures.h"

#include <algorithm>

namespace kelpie::vision {
namespace {

constexpr int kStep = 2;         // px between the lattice samples of a scan line
constexpr int kWidestLine = 24;  // px, of a white line before the robot's feet
constexpr int kLeastWindow = 4;  // px that must be left of the window at the image's end

bool isGreen(const Sampler& sampler, const ScanLine& line, int step) {
  return classAt(sampler, line, step) == ColourClass::green;
}

// Green from this step on for most of the window (thesis 2006 section 3.2.1 judges N px late and
// moves the position back; walking down the position is at hand).
bool carpetBegins(const Sampler& sampler, const ScanLine& line, int step,
                  const FieldEdgeParams& params) {
  const int window = std::min(static_cast<int>(params.window), line.steps - step);
  if (window < kLeastWindow) return false;
  int missing = static_cast<int>((1.0 - params.minGreen) * window);
  for (int i = 0; i < window; ++i) {
    if (!isGreen(sampler, line, step + i) && --missing < 0) return false;
  }
  return true;
}

// First step of the carpet at full resolution, -1 without any.
int carpetTop(const Sampler& sampler, const ScanLine& line, const FieldEdgeParams& params) {
  for (int step = 0; step < line.steps; step += kStep) {
    if (latticeClass(sampler, line, step) != ColourClass::green) continue;
    const int last = std::min(step + kStep, line.steps);
    for (int fine = std::max(step - kStep, 0); fine < last; ++fine) {
      if (!isGreen(sampler, line, fine)) continue;
      if (carpetBegins(sampler, line, fine, params)) return fine;
      break;
    }
  }
  return -1;
}

bool standsOnCarpet(ColourClass c) {
  return c == ColourClass::orange || c == ColourClass::pink || c == ColourClass::robotRed ||
         c == ColourClass::robotBlue;
}

// A goal's back wall stands on the edge, its side walls before it; white is a beacon or a robot.
bool mayStand(const Sampler& sampler, const ScanLine& line, int top) {
  if (top < 3) return false;
  const ColourClass c = classAt(sampler, line, top - 3);
  return c == ColourClass::blue || c == ColourClass::yellow || c == ColourClass::white;
}

// A ball or a robot, or a line that leaves through the image's top, hides carpet, not its end.
bool goesOn(const Sampler& sampler, const ScanLine& line, int top) {
  if (top == 0) return line.cutTop;
  for (const int above : {2, 4}) {
    if (top >= above && standsOnCarpet(classAt(sampler, line, top - above))) return true;
  }
  if (!line.cutTop || top > kWidestLine) return false;
  for (int step = 0; step < top - 1; ++step) {
    if (latticeClass(sampler, line, step) != ColourClass::white) return false;
  }
  return true;
}

}  // namespace

EdgeFeatures edgeFeatures(const Sampler& sampler, const ScanLines& lines,
                          const FieldEdgeParams& params) {
  EdgeFeatures features;
  for (const ScanLine& line : lines) {
    const int top = carpetTop(sampler, line, params);
    if (top < 0) continue;
    const bool open = goesOn(sampler, line, top);
    // Green at the very start of a line that begins above the horizon is no carpet.
    if (top == 0 && !open) continue;
    features.push_back(
        {line.at(top - 0.5), open, mayStand(sampler, line, top) ? params.doubtful : 1.0});
  }
  return features;
}

}  // namespace kelpie::vision
