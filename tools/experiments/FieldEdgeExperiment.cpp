// SPDX-License-Identifier: Apache-2.0
// The field edge: the fit on made-up points, then the whole of vision on rendered views.
#include "tools/experiments/FieldEdgeParts.h"

namespace kelpie::experiments {

// The figures asked for stand first: at each share of wrong points those of the worst slope.
Expected<Json> fieldEdge(const ExperimentOptions& options) {
  const Json points = fieldEdgePoints(options);
  const Json corners = fieldEdgeCorners(options);
  return Json{{"experiment", "field-edge"},
              {"trials", options.trials},
              {"seed", options.seed},
              {"success_0", points.at("success_0_worst_rate")},
              {"success_20", points.at("success_20_worst_rate")},
              {"success_50", points.at("success_50_worst_rate")},
              {"corner_success", corners.at("corner_success_rate")},
              {"points", points},
              {"views", fieldEdgeViews(options)},
              {"corners", corners}};
}

}  // namespace kelpie::experiments
