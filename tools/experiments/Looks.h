// SPDX-License-Identifier: Apache-2.0
// Random views one after the other, each as vision with its default parameters sees it.
#pragma once

#include <functional>

#include "robot/core/Percepts.h"
#include "tools/experiments/Experiment.h"
#include "tools/experiments/View.h"
#include "vision/Judged.h"

namespace kelpie::experiments {

struct Look {
  int number = 0;  // from 0
  const View& view;
  const BodyState& body;
  const Percepts& seen;
  const vision::Judged& judged;
};

// Calls `judge` for as many views as there are trials, and the options' progress after each.
void lookAtViews(const ViewParams& params, const ExperimentOptions& options,
                 const std::function<void(const Look&)>& judge);

}  // namespace kelpie::experiments
