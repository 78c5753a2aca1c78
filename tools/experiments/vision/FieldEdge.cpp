// SPDX-License-Identifier: Apache-2.0
// The field edge: the fit on made-up points, then the whole of vision on rendered views.
#include "tools/experiments/vision/FieldEdgeParts.h"

namespace kelpie::experiments {
namespace {

// The figures that are required stand first: at each share of wrong points those of the worst
// slope.
Expected<Json> fieldEdge(const Request& request) {
  const Json points = fieldEdgePoints(request);
  const Json corners = fieldEdgeCorners(request);
  return Json{{"success_0", points.at("success_0_worst_rate")},
              {"success_20", points.at("success_20_worst_rate")},
              {"success_50", points.at("success_50_worst_rate")},
              {"corner_success", corners.at("corner_success_rate")},
              {"points", points},
              {"views", fieldEdgeViews(request)},
              {"corners", corners}};
}

const Registration kFieldEdge("field-edge",
                              "where the carpet ends: the fit on made-up points, views, corners",
                              {Option::trials, Option::seed, Option::randomised}, 1000, fieldEdge);

}  // namespace
}  // namespace kelpie::experiments
