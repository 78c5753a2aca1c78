// SPDX-License-Identifier: Apache-2.0
// The field edge: the fit on made-up points, then the whole of vision on rendered views.
#include "tools/cli/experiments/FieldEdgeParts.h"

namespace kelpie::cli {

Expected<Json> fieldEdge(const ExperimentOptions& options) {
  return Json{{"experiment", "field-edge"},
              {"trials", options.trials},
              {"seed", options.seed},
              {"points", fieldEdgePoints(options)},
              {"views", fieldEdgeViews(options)},
              {"corners", fieldEdgeCorners(options)}};
}

}  // namespace kelpie::cli
