// SPDX-License-Identifier: Apache-2.0
// Line, border and field points in random views with every artefact: how many really lie on paint,
// border and carpet, how far from the lines they are projected, and how many of the crossings that
// a perfect observer would see are found. Truth is a second picture of the same view in colours
// that vision never sees.
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "robot/body/Camera.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/views/LineTruth.h"
#include "vision/Refusal.h"
#include "vision/Vision.h"

namespace kelpie::experiments {
namespace {

constexpr std::array<double, 6> kBands = {0.0, 50.0, 100.0, 150.0, 200.0, 350.0};  // cm
constexpr std::size_t kBandCount = kBands.size() - 1;
constexpr std::array<double, 5> kSpeeds = {0.0, 1.5, 3.0, 4.0, 5.2};  // deg a frame
constexpr std::size_t kSpeedCount = kSpeeds.size() - 1;
constexpr double kOnPaint = 0.1;   // share of one of the nine pixels around a point
constexpr double kOnCarpet = 0.9;  // share of the pixel

std::size_t bandOf(double distance) {
  std::size_t band = 0;
  while (band + 1 < kBandCount && distance >= kBands[band + 1]) ++band;
  return band;
}

std::string bandName(std::size_t band) {
  return std::to_string(static_cast<int>(kBands[band])) + "_to_" +
         std::to_string(static_cast<int>(kBands[band + 1])) + "_cm";
}

// 1 where nothing was counted: nothing was wrong, nothing missed.
double valueOf(const Share& share) { return share.all > 0 ? share.value() : 1.0; }

struct KindTally {
  Share truth;
  std::array<Share, kBandCount> truthInBand;
  std::array<Values, kBandCount> errors;  // cm, of true points
  int views = 0;                          // with points of the kind
};

struct Tally {
  std::array<KindTally, 3> kind;
  Share pixelExact;  // paint in the very pixel
  Share recall;
  std::array<Share, kBandCount> recallInBand;
  int views = 0;
  int open = 0;       // head slow enough
  int withLines = 0;  // of these, with a crossing to be seen
  int pointsThere = 0;
  vision::VisionParams params;
  std::array<KindTally, kSpeedCount> atSpeed;  // line points, the gate open
  VisionCounts counts;
};

bool isTrue(const LineTruth& truth, const LinePoint& point) {
  const int px = static_cast<int>(std::floor(point.pixel.x));
  const int py = static_cast<int>(std::floor(point.pixel.y));
  switch (point.kind) {
    case LinePointKind::line: return truth.paintNear(point.pixel) >= kOnPaint;
    case LinePointKind::border: {
      double largest = 0.0;
      for (int i = 0; i < 9; ++i)
        largest = std::max(largest, truth.border(px + i % 3 - 1, py + i / 3 - 1));
      return largest >= kOnPaint;
    }
    default: return truth.carpet(px, py) >= kOnCarpet;
  }
}

std::size_t speedOf(double headSpeed) {
  const double degrees = Angle::rad(headSpeed).deg();
  std::size_t i = 0;
  while (i + 1 < kSpeedCount && degrees >= kSpeeds[i + 1]) ++i;
  return i;
}

// Line points within 150 cm, whose errors tell a warped image from a far point.
void addBySpeed(const View& view, const BodyState& body, const Percepts& percepts,
                const LineTruth& truth, Tally& tally) {
  KindTally& kind = tally.atSpeed[speedOf(body.headSpeed)];
  for (const LinePoint& point : percepts.linePoints) {
    if (point.kind != LinePointKind::line || point.position.norm() > kBands[3]) continue;
    kind.truth.count(isTrue(truth, point));
    kind.errors[0].push_back(truth.offLine(fieldFromRobot(view.pose, point.position)));
  }
}

void addPoint(const View& view, const LineTruth& truth, const LinePoint& point, Tally& tally) {
  KindTally& kind = tally.kind[static_cast<std::size_t>(point.kind)];
  const bool good = isTrue(truth, point);
  const std::size_t band = bandOf(point.position.norm());
  kind.truth.count(good);
  kind.truthInBand[band].count(good);
  if (point.kind == LinePointKind::line) {
    const int px = static_cast<int>(std::floor(point.pixel.x));
    tally.pixelExact.count(truth.paint(px, static_cast<int>(std::floor(point.pixel.y))) >=
                           kOnPaint);
  }
  if (!good || point.kind == LinePointKind::field) return;
  const Point2<Field> place = fieldFromRobot(view.pose, point.position);
  kind.errors[band].push_back(point.kind == LinePointKind::line ? truth.offLine(place)
                                                                : truth.offBorder(place));
}

bool found(const Crossing& crossing, const Percepts& percepts) {
  const double reach = 2.0 + 0.5 * crossing.length;
  for (const LinePoint& p : percepts.linePoints) {
    if (p.kind != LinePointKind::line) continue;
    const double dx = std::fabs(p.pixel.x - crossing.middle.x);
    const double dy = std::fabs(p.pixel.y - crossing.middle.y);
    if (crossing.vertical ? dx < 0.1 && dy < reach : dy < 0.1 && dx < reach) return true;
  }
  return false;
}

void addCrossings(const BodyState& body, const LineTruth& truth, const Percepts& percepts,
                  Tally& tally) {
  int seen = 0;
  for (const Crossing& crossing : crossings(truth)) {
    const auto place = body::groundPoint(body.camera, crossing.middle);
    if (!place || place->norm() > kBands.back()) continue;
    ++seen;
    const bool hit = found(crossing, percepts);
    tally.recall.count(hit);
    tally.recallInBand[bandOf(place->norm())].count(hit);
  }
  if (seen == 0) return;
  ++tally.withLines;
  for (const LinePoint& p : percepts.linePoints)
    tally.pointsThere += p.kind == LinePointKind::line ? 1 : 0;
}

void addView(const View& view, const BodyState& body, const Percepts& percepts,
             const LineTruth& truth, Tally& tally) {
  ++tally.views;
  addBySpeed(view, body, percepts, truth, tally);
  for (std::size_t i = 0; i < percepts.counts.refused.size(); ++i)
    tally.counts.refused[i] += percepts.counts.refused[i];
  if (body.headSpeed >= tally.params.line.maxHeadSpeed.rad()) return;
  ++tally.open;
  std::array<bool, 3> any{};
  for (const LinePoint& point : percepts.linePoints) {
    addPoint(view, truth, point, tally);
    any[static_cast<std::size_t>(point.kind)] = true;
  }
  for (std::size_t i = 0; i < any.size(); ++i) tally.kind[i].views += any[i] ? 1 : 0;
  addCrossings(body, truth, percepts, tally);
}

// Vision's own gate for a turning head is opened, so that what it keeps out can be measured; views
// beyond it count in figures by head speed only.
Tally look(const ViewParams& params, vision::VisionParams vision, const Request& request) {
  Tally tally;
  tally.params = vision;
  vision.line.maxHeadSpeed = Angle::deg(180.0);
  LineTruth truth(params.field);
  const auto state = std::make_unique<vision::VisionState>();
  eachView(params, request, [&](const View& view) {
    const BodyState body = body::step(view.input, {});
    const Percepts percepts = vision::step({view.input, body}, vision, *state);
    truth.see(view);
    addView(view, body, percepts, truth, tally);
  });
  return tally;
}

Json bandFigures(const KindTally& kind) {
  Json bands = Json::object();
  for (std::size_t i = 0; i < kBandCount; ++i)
    bands[bandName(i)] = {{"points", kind.truthInBand[i].all},
                          {"true_share", valueOf(kind.truthInBand[i])},
                          {"median_error_cm", percentile(kind.errors[i], 0.5)},
                          {"p90_error_cm", percentile(kind.errors[i], 0.9)}};
  return bands;
}

Json lineFigures(const Tally& tally) {
  const KindTally& line = tally.kind[static_cast<std::size_t>(LinePointKind::line)];
  Json recall = Json::object();
  for (std::size_t i = 0; i < kBandCount; ++i)
    recall[bandName(i)] = {{"crossings", tally.recallInBand[i].all},
                           {"recall_share", valueOf(tally.recallInBand[i])}};
  return {{"points", line.truth.all},
          {"true_share", valueOf(line.truth)},
          {"exact_pixel_share", valueOf(tally.pixelExact)},
          {"views_with_crossings", tally.withLines},
          {"points_per_view_with_crossings", ratio(tally.pointsThere, tally.withLines)},
          {"crossings", tally.recall.all},
          {"recall_share", valueOf(tally.recall)},
          {"recall_by_distance", recall},
          {"by_distance", bandFigures(line)}};
}

Json speedFigures(const Tally& tally) {
  Json all = Json::object();
  for (std::size_t i = 0; i < kSpeedCount; ++i) {
    const KindTally& kind = tally.atSpeed[i];
    all["from_" + std::to_string(static_cast<int>(10.0 * kSpeeds[i])) + "_tenth_deg_a_frame"] = {
        {"points", kind.truth.all},
        {"true_share", valueOf(kind.truth)},
        {"median_error_cm", percentile(kind.errors[0], 0.5)},
        {"p90_error_cm", percentile(kind.errors[0], 0.9)}};
  }
  return all;
}

Json refusals(const Tally& tally) {
  Json all = Json::object();
  for (std::size_t i = 0; i < vision::kRefusalCount; ++i) {
    const std::string name = vision::kRefusalNames[i].name;
    if (i >= static_cast<std::size_t>(vision::Refusal::lineAmbiguous))
      all[name] = tally.counts.refused[i];
  }
  return all;
}

Json fieldFigures(const Tally& tally) {
  const KindTally& field = tally.kind[static_cast<std::size_t>(LinePointKind::field)];
  return {{"points", field.truth.all},
          {"true_share", valueOf(field.truth)},
          {"points_per_view", ratio(field.truth.all, tally.open)}};
}

Json borderFigures(const Tally& tally) {
  const KindTally& border = tally.kind[static_cast<std::size_t>(LinePointKind::border)];
  return {{"points", border.truth.all},
          {"border_true_share", valueOf(border.truth)},
          {"points_per_view", ratio(border.truth.all, tally.open)},
          {"views_with_points", border.views},
          {"by_distance", bandFigures(border)}};
}

Expected<Json> linePoints(const Request& request) {
  ViewParams views;
  vision::VisionParams params;
  const Tally now = look(views, params, request);
  views.field = *body::fieldDescription("2004");
  params.field = views.field;
  const Tally before = look(views, params, request);
  return Json{{"head_slow_share", ratio(now.open, now.views)},
              {"true_share", valueOf(now.kind[0].truth)},
              {"line", lineFigures(now)},
              {"by_head_speed", speedFigures(now)},
              {"field", fieldFigures(now)},
              {"refused", refusals(now)},
              {"field_2004",
               {{"line_true_share", valueOf(before.kind[0].truth)},
                {"line_recall_share", valueOf(before.recall)},
                {"border", borderFigures(before)},
                {"refused", refusals(before)}}}};
}

const Registration kLinePoints(
    "line-points", "points on lines, border and carpet: share that is true, error, recall",
    {Option::trials, Option::seed, Option::randomised}, 400, linePoints);

}  // namespace
}  // namespace kelpie::experiments
