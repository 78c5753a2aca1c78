// SPDX-License-Identifier: Apache-2.0
// How well the count of dark pixels in the box ahead tells that a robot stands there (thesis 2006
// section 6.4.4, which leaves the threshold open: checklist U07): rates of hits and false alarms by
// threshold, with dark pixels alone and with grey ones. Views in which the box is in the image.
#include <array>
#include <memory>

#include "robot/body/Camera.h"
#include "tools/experiments/views/View.h"
#include "vision/Vision.h"

namespace kelpie::experiments {
namespace {

constexpr std::array<int, 9> kThresholds{1, 2, 4, 8, 12, 16, 24, 40, 80};  // px
constexpr double kBoxHalfWidth = 25.0;
constexpr double kBoxLength = 100.0;
constexpr double kBoxMiddle = 65.0;  // cm ahead, of what a view must show

bool inBox(Point2<Robot> p) {
  return p.x >= -kBoxHalfWidth && p.x <= kBoxHalfWidth && p.y > 0.0 && p.y <= kBoxLength;
}

bool inImage(const View& view, Point2<Robot> p) {
  const Point2<Field> there = fieldFromRobot(view.pose, p);
  const auto pixel = sim::pixelIn(view.eye, {there.x, there.y, 0.0});
  return pixel && pixel->x > 0.0 && pixel->x < kImageWidth && pixel->y > 0.0 &&
         pixel->y < kImageHeight;
}

enum class Presence { none, part, robot };

// A robot is in the box when its middle is; views with a part of one alone are left out.
Presence presence(const View& view) {
  Presence found = Presence::none;
  for (const auto& look : view.robots) {
    const auto at = [&](double along) {
      return robotFromField(view.pose, fieldFromRobot(look.pose, {0.0, along}));
    };
    if (inBox(at(-4.0))) return Presence::robot;
    for (double along = -14.0; along <= 12.0; along += 2.0)
      if (inBox(at(along))) found = Presence::part;
  }
  return found;
}

struct Roc {
  std::array<int, kThresholds.size()> hits{};
  std::array<int, kThresholds.size()> alarms{};

  void add(int count, bool robot) {
    for (std::size_t i = 0; i < kThresholds.size(); ++i)
      if (count >= kThresholds[i]) ++(robot ? hits : alarms)[i];
  }
  Json figures(int robots, int empties) const {
    Json rows = Json::array();
    for (std::size_t i = 0; i < kThresholds.size(); ++i)
      rows.push_back({{"threshold_px", kThresholds[i]},
                      {"hit_rate", static_cast<double>(hits[i]) / robots},
                      {"false_rate", static_cast<double>(alarms[i]) / empties}});
    return rows;
  }
};

int countAhead(const FrameInput& input, bool grey, vision::VisionState& state) {
  vision::VisionParams params;
  params.obstacle.greyCounts = grey;
  return vision::step({input, body::step(input, {})}, params, state).obstaclesAhead;
}

Expected<Json> obstaclesAhead(const Request& request) {
  const auto state = std::make_unique<vision::VisionState>();
  Roc dark;
  Roc grey;
  int robots = 0;
  int empties = 0;
  eachView({}, request, [&](const View& view) {
    const Presence there = presence(view);
    if (!inImage(view, {0.0, kBoxMiddle}) || there == Presence::part) return;
    const bool robot = there == Presence::robot;
    ++(robot ? robots : empties);
    dark.add(countAhead(view.input, false, *state), robot);
    grey.add(countAhead(view.input, true, *state), robot);
  });
  if (robots == 0 || empties == 0) return Error{"too few views show the box ahead"};
  return Json{{"with_robot_count", robots},
              {"without_count", empties},
              {"dark", dark.figures(robots, empties)},
              {"dark_and_grey", grey.figures(robots, empties)}};
}

const Registration kObstaclesAhead(
    "obstacles-ahead", "dark pixels in the box ahead: hits and false alarms by threshold",
    {Option::trials, Option::seed, Option::randomised}, 3000, obstaclesAhead);

}  // namespace
}  // namespace kelpie::experiments
