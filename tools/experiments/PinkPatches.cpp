// SPDX-License-Identifier: Apache-2.0
// Pink sheets of 12 x 20 cm stand on the carpet in random views, square to the camera: how many are
// found and where they seem to be; and how many pink patches vision reports in the same views
// without a sheet, where pink is on beacons and spectators only.
#include <cmath>
#include <memory>
#include <optional>

#include "robot/body/Camera.h"
#include "tools/experiments/Experiment.h"
#include "tools/experiments/View.h"
#include "vision/Vision.h"

namespace kelpie::experiments {
namespace {

constexpr double kHalfWidth = 6.0;  // cm
constexpr double kHeight = 20.0;
constexpr double kNearest = 40.0;
constexpr double kFarthest = 250.0;
constexpr double kBorder = 6.0;  // px from the image border to the sheet
constexpr double kGate = 4.0;    // deg

bool insideImage(const CameraPose& camera, Point3<Robot> point) {
  const auto pixel = body::project(camera, point);
  return pixel && pixel->x > kBorder && pixel->x < kImageWidth - kBorder && pixel->y > kBorder &&
         pixel->y < kImageHeight - kBorder;
}

// A place on the field at which all of a sheet is in the image.
std::optional<Point2<Robot>> placeInView(const View& view, const body::FieldDescription& field,
                                         Random& random) {
  for (int i = 0; i < 60; ++i) {
    const PixelPoint pixel{random.uniform(0.0, kImageWidth), random.uniform(0.0, kImageHeight)};
    const auto place = body::groundPoint(view.camera, pixel);
    if (!place || place->norm() < kNearest || place->norm() > kFarthest) continue;
    const Point2<Field> on = fieldFromRobot(view.pose, *place);
    if (on.x < 0.0 || on.y < 0.0 || on.x > field.width || on.y > field.length) continue;
    if (insideImage(view.camera, {place->x, place->y, 0.0}) &&
        insideImage(view.camera, {place->x, place->y, kHeight}))
      return place;
  }
  return std::nullopt;
}

sim::Solid sheetAt(const View& view, Point2<Robot> place) {
  const Point2<Robot> across{kHalfWidth * place.y / place.norm(),
                             -kHalfWidth * place.x / place.norm()};
  sim::Solid sheet;
  sheet.quads.push_back(sim::uprightQuad(fieldFromRobot(view.pose, place - across),
                                         fieldFromRobot(view.pose, place + across), {0.0, kHeight},
                                         sim::colours::kPink));
  sim::enclose(sheet);
  return sheet;
}

struct Tally {
  int falses = 0;
  int sheets = 0;
  int found = 0;
  double heading = 0.0;   // sum of squares, deg2
  double distance = 0.0;  // the same, of shares
};

void judge(const Percepts& percepts, Point2<Robot> place, Tally& tally) {
  ++tally.sheets;
  for (const PinkPercept& pink : percepts.pinkPatches) {
    const double off = (pink.heading - bearing(place)).deg();
    if (std::fabs(off) > kGate) continue;
    ++tally.found;
    tally.heading += off * off;
    tally.distance += maths::square(pink.distance / place.norm() - 1.0);
    return;
  }
}

Percepts seenIn(const FrameInput& input, vision::VisionState& state) {
  const BodyState body = body::step(input, {});
  return vision::step({input, body}, {}, state);
}

}  // namespace

Expected<Json> pinkPatches(const ExperimentOptions& options) {
  ViewParams params;
  params.field = *body::fieldDescription("2006");
  ViewMaker maker(params, options.seed);
  Random random(options.seed + 1);
  const auto state = std::make_unique<vision::VisionState>();
  const auto input = std::make_unique<FrameInput>();
  Tally tally;
  for (int trial = 0; trial < options.trials; ++trial) {
    const View& view = maker.next();
    tally.falses += static_cast<int>(seenIn(view.input, *state).pinkPatches.size());
    if (const auto place = placeInView(view, params.field, random)) {
      sim::Scene scene = view.scene;
      scene.robots.clear();
      scene.balls.clear();
      scene.fixtures.push_back(sheetAt(view, *place));
      *input = view.input;
      sim::Camera(params.camera, view.shift).render(scene, view.columns, random, input->image);
      judge(seenIn(*input, *state), *place, tally);
    }
    if (options.progress) options.progress(trial + 1, options.trials);
  }
  if (tally.found == 0) return Error{"no sheet was found"};
  return Json{{"experiment", "pink-patches"},
              {"trials", options.trials},
              {"seed", options.seed},
              {"sheets_count", tally.sheets},
              {"recall_rate", static_cast<double>(tally.found) / tally.sheets},
              {"heading_rms_deg", std::sqrt(tally.heading / tally.found)},
              {"distance_rms_rate", std::sqrt(tally.distance / tally.found)},
              {"false_per_1000_views", 1000.0 * tally.falses / options.trials}};
}

}  // namespace kelpie::experiments
