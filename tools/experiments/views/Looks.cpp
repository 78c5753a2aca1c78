// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/views/Looks.h"

#include <memory>

#include "robot/body/Camera.h"
#include "vision/Vision.h"

namespace kelpie::experiments {

void lookAtViews(const ViewParams& params, const Request& request,
                 const std::function<void(const Look&)>& use) {
  const auto state = std::make_unique<vision::VisionState>();
  const vision::VisionParams vision;
  int number = 0;
  eachView(params, request, [&](const View& view) {
    const BodyState body = body::step(view.input, {});
    const Percepts seen = vision::step({view.input, body}, vision, *state);
    use({number++, view, body, seen, state->judgedBalls, state->judgedBeacons, state->judgedGoals,
         state->judgedRobots});
  });
}

}  // namespace kelpie::experiments
