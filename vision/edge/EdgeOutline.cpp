// SPDX-License-Identifier: Apache-2.0
#include "vision/edge/EdgeOutline.h"

#include <array>
#include <cmath>

namespace kelpie::vision {
namespace {

EdgeLines refitted(const EdgeEvidence& evidence, const EdgeLines& lines, double tolerance) {
  constexpr double kMinFeatures = 2.0;  // weighted, that make a line
  std::array<EdgeMoments, EdgeLines::kCapacity> moments;
  for (const EdgeFeature& f : evidence.features) {
    const EdgePlace place = placeOf(lines, f.at);
    if (!f.open && std::fabs(place.distance) <= tolerance) moments[place.edge].add(f.at, f.weight);
  }
  EdgeLines better = lines;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (moments[i].n >= kMinFeatures) better[i] = lineOf(moments[i], evidence.frame);
  return better;
}

}  // namespace

double scoreOf(const EdgeEvidence& evidence, const EdgeLines& lines) {
  const double t = evidence.params.tolerance;
  const double perSquare = 1.0 / (t * t);
  double score = 0.0;
  for (const EdgeFeature& f : evidence.features) {
    const double d = placeOf(lines, f.at).distance;
    if (d > t) {
      score -= evidence.params.abovePenalty;
    } else if (d > -t && !f.open) {
      score += f.weight * (1.0 - d * d * perSquare);
    }
  }
  return score;
}

bool refine(const EdgeEvidence& evidence, double width, Outline& outline) {
  const EdgeLines lines = refitted(evidence, outline.lines, width * evidence.params.tolerance);
  const double score = scoreOf(evidence, lines);
  if (score <= outline.score) return false;
  outline = {lines, score};
  return true;
}

void measure(const EdgeEvidence& evidence, EdgeLines& lines) {
  std::array<double, EdgeLines::kCapacity> squares{};
  for (EdgeLine& line : lines) line.support = line.atGoal = 0;
  for (const EdgeFeature& f : evidence.features) {
    const EdgePlace place = placeOf(lines, f.at);
    if (f.open || !(std::fabs(place.distance) <= evidence.params.tolerance)) continue;
    ++lines[place.edge].support;
    lines[place.edge].atGoal += f.atGoal ? 1 : 0;
    squares[place.edge] += place.distance * place.distance;
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i].support > 0)
      lines[i].rms = std::sqrt(squares[i] / static_cast<double>(lines[i].support));
}

double carpetBeyond(const EdgeEvidence& evidence, const EdgeLines& lines) {
  double count = 0.0;
  for (const EdgeFeature& f : evidence.features)
    count += placeOf(lines, f.at).distance > evidence.params.tolerance ? 1.0 : 0.0;
  return count;
}

double noiseOf(const EdgeLines& lines) {
  double squares = 0.0;
  double count = 0.0;
  for (const EdgeLine& line : lines) {
    squares += static_cast<double>(line.support) * line.rms * line.rms;
    count += static_cast<double>(line.support);
  }
  return count > 0.0 ? std::fmax(squares / count, kMinNoise) : kMinNoise;
}

}  // namespace kelpie::vision
