// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tools/cli/show/Sheet.h"
#include "tools/match/Draw.h"
#include "vision/Refusal.h"

namespace kelpie::cli {
namespace {

using namespace match;

using Lines = std::vector<std::string>;

// "name <tab> distance <tab> sd <tab> heading <tab> sd <tab> remark" of anything with these fields.
template <class Percept>
std::string row(const std::string& name, const Percept& p, const std::string& remark) {
  return fmt::format("{}\t{:.1f}\t{:.1f}\t{:.1f}\t{:.1f}\t{}", name, p.distance,
                     std::sqrt(p.distanceVariance), p.heading.deg(),
                     Angle::rad(std::sqrt(p.headingVariance)).deg(), remark);
}

std::string landmarkRemark(const LandmarkPercept& p) {
  if (p.kind > LandmarkKind::goalYellow) return {};
  return fmt::format("posts {:.1f}{} to {:.1f}{}", p.leftEdge.deg(), p.leftEdgeCut ? " cut" : "",
                     p.rightEdge.deg(), p.rightEdgeCut ? " cut" : "");
}

std::string gapRow(const GoalGap& gap) {
  const Angle middle = Angle::rad(0.5 * (gap.left.rad() + gap.right.rad()));
  return fmt::format("gap, {}\t\t\t{:.1f}\t\t{:.1f}{} to {:.1f}{}", wordFor(gap.goal), middle.deg(),
                     gap.left.deg(), gap.leftCut ? " cut" : "", gap.right.deg(),
                     gap.rightCut ? " cut" : "");
}

Lines objectRows(const Percepts& seen) {
  Lines rows;
  if (seen.ball.present)
    rows.push_back(row("ball", seen.ball, fmt::format("radius {:.1f} px", seen.ball.radius)));
  for (const auto& p : seen.landmarks) rows.push_back(row(wordFor(p.kind), p, landmarkRemark(p)));
  for (const auto& gap : seen.gaps) rows.push_back(gapRow(gap));
  for (const auto& p : seen.robots)
    rows.push_back(row(p.team == TeamColour::red ? "red robot" : "blue robot", p, ""));
  for (const auto& p : seen.pinkPatches) rows.push_back(row("pink patch", p, ""));
  return rows;
}

std::string edgeLine(const Percepts& seen) {
  if (seen.fieldEdges.empty()) return "field edge: none";
  std::string line = "field edge: row";
  for (const auto& edge : seen.fieldEdges)
    line += fmt::format(" {:.0f} at the left, {:.0f} at the right;", edge.atLeft, edge.atRight);
  return line;
}

std::string pointLine(const Percepts& seen) {
  std::array<int, 3> kinds{};
  for (const auto& point : seen.linePoints) ++kinds[static_cast<std::size_t>(point.kind)];
  return fmt::format("points: {} line, {} border, {} field; {} obstacle, {} dark ahead", kinds[0],
                     kinds[1], kinds[2], seen.obstacles.size(), seen.obstaclesAhead);
}

Lines frameLines(const SheetIn& in) {
  const auto& joints = in.input.sensors.joints;
  const auto& body = in.output.body;
  const auto& counts = in.output.percepts.counts;
  std::size_t looked = 0;
  for (std::size_t i = 0; i < kImagePixels; ++i)
    looked += in.vision.classes.looked(i) != vision::kNotLookedAt ? 1U : 0U;
  return {fmt::format("head: tilt {:.1f}, pan {:.1f}, nod {:.1f} deg; turns {:.1f} deg a frame",
                      joints[Joint::neckTilt].deg(), joints[Joint::headPan].deg(),
                      joints[Joint::headNod].deg(), Angle::rad(body.headSpeed).deg()),
          fmt::format("camera {:.1f} cm above the ground; horizon: row {:.0f} to {:.0f}",
                      body.camera.position.z, body.horizon.atLeft, body.horizon.atRight),
          edgeLine(in.output.percepts), pointLine(in.output.percepts),
          fmt::format("looked at {} of {} pixels; {} runs, {} blobs", looked, kImagePixels,
                      counts.runs, counts.blobs)};
}

Lines refusalRows(const VisionCounts& counts) {
  std::vector<std::size_t> reasons;
  for (std::size_t i = 0; i < vision::kRefusalCount; ++i)
    if (counts.refused[i] > 0) reasons.push_back(i);
  std::stable_sort(reasons.begin(), reasons.end(), [&](std::size_t a, std::size_t b) {
    return counts.refused[a] > counts.refused[b];
  });
  Lines rows;
  rows.reserve(reasons.size());
  for (const std::size_t i : reasons)
    rows.push_back(fmt::format("{}\t{}", vision::kRefusalNames[i].name, counts.refused[i]));
  return rows;
}

}  // namespace

SheetText sheetText(const SheetIn& in) {
  return {frameLines(in), objectRows(in.output.percepts), refusalRows(in.output.percepts.counts)};
}

}  // namespace kelpie::cli
