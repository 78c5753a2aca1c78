// SPDX-License-Identifier: Apache-2.0
// Pink sheets of 12 x 20 cm stand on the carpet in random views, square to the camera: how many are
// found and where they seem to be; and how many pink patches vision reports in the same views
// without a sheet, where pink is on beacons and spectators only.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "robot/body/Camera.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/views/View.h"
#include "vision/Vision.h"

namespace kelpie::experiments {
namespace {

constexpr double kHalfWidth = 6.0;  // cm
constexpr double kHeight = 20.0;
constexpr double kMinDistance = 40.0;
constexpr double kMaxDistance = 250.0;
constexpr double kBorder = 6.0;  // px from the image border to the sheet
constexpr double kGate = 4.0;    // deg

bool insideImage(const View& view, Point2<Field> place, double height) {
  const auto pixel = sim::pixelIn(view.eye, {place.x, place.y, height});
  return pixel && pixel->x > kBorder && pixel->x < kImageWidth - kBorder && pixel->y > kBorder &&
         pixel->y < kImageHeight - kBorder;
}

// A place on the field at which all of a sheet is in the image.
std::optional<Point2<Robot>> placeInView(const View& view, const body::FieldDescription& field,
                                         Random& random) {
  for (int i = 0; i < 60; ++i) {
    const PixelPoint pixel{random.uniform(0.0, kImageWidth), random.uniform(0.0, kImageHeight)};
    const auto place = body::groundPoint(view.camera, pixel);
    if (!place || place->norm() < kMinDistance || place->norm() > kMaxDistance) continue;
    const Point2<Field> on = fieldFromRobot(view.pose, *place);
    if (on.x < 0.0 || on.y < 0.0 || on.x > field.width || on.y > field.length) continue;
    if (insideImage(view, on, 0.0) && insideImage(view, on, kHeight)) return place;
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
  int falsePatches = 0;
  Share found;
  Values heading;   // deg
  Values distance;  // share of the true one
};

void addPatch(const Percepts& percepts, Point2<Robot> place, Tally& tally) {
  const auto error = [&](const PinkPercept& pink) { return (pink.heading - bearing(place)).deg(); };
  const auto pink =
      std::find_if(percepts.pinkPatches.begin(), percepts.pinkPatches.end(),
                   [&](const PinkPercept& p) { return std::fabs(error(p)) <= kGate; });
  const bool found = pink != percepts.pinkPatches.end();
  tally.found.count(found);
  if (!found) return;
  tally.heading.push_back(error(*pink));
  tally.distance.push_back(pink->distance / place.norm() - 1.0);
}

Percepts seenIn(const FrameInput& input, vision::VisionState& state) {
  const BodyState body = body::step(input, {});
  return vision::step({input, body}, {}, state);
}

Expected<Json> pinkPatches(const Request& request) {
  const ViewParams params;
  Random random(request.seed + 1);
  const auto state = std::make_unique<vision::VisionState>();
  const auto input = std::make_unique<FrameInput>();
  Tally tally;
  eachView(params, request, [&](const View& view) {
    tally.falsePatches += static_cast<int>(seenIn(view.input, *state).pinkPatches.size());
    if (const auto place = placeInView(view, params.field, random)) {
      sim::Scene scene = view.scene;
      scene.robots.clear();
      scene.balls.clear();
      scene.fixtures.push_back(sheetAt(view, *place));
      *input = view.input;
      sim::Camera(params.camera, view.robotCamera)
          .render(scene, view.columns, random, input->image);
      addPatch(seenIn(*input, *state), *place, tally);
    }
  });
  if (tally.found.hits == 0) return Error{"no sheet was found"};
  return Json{{"sheets_count", tally.found.all},
              {"recall_rate", tally.found.value()},
              {"heading_rms_deg", rms(tally.heading)},
              {"distance_rms_rate", rms(tally.distance)},
              {"false_per_1000_views", 1000.0 * tally.falsePatches / request.trials}};
}

const Registration kPinkPatches("pink-patches",
                                "pink sheets on the carpet: recall, errors, false ones",
                                {Option::trials, Option::seed, Option::randomised}, 400,
                                pinkPatches);

}  // namespace
}  // namespace kelpie::experiments
