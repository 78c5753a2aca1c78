// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/Looks.h"

#include <memory>

#include "robot/body/Camera.h"
#include "vision/Vision.h"

namespace kelpie::experiments {

void lookAtViews(const ViewParams& params, const ExperimentOptions& options,
                 const std::function<void(const Look&)>& judge) {
  const auto maker = std::make_unique<ViewMaker>(params, options.seed);
  const auto state = std::make_unique<vision::VisionState>();
  const vision::VisionParams vision;
  for (int i = 0; i < options.trials; ++i) {
    const View& view = maker->next();
    const BodyState body = body::step(view.input, {});
    const Percepts seen = vision::step({view.input, body}, vision, *state);
    judge({i, view, body, seen, state->judged});
    if (options.progress) options.progress(i + 1, options.trials);
  }
}

}  // namespace kelpie::experiments
