// SPDX-License-Identifier: Apache-2.0
// A decision tree drawn from left to right: questions, the answers that lead on, and leaves, each
// on a line of its own. With counts, a leaf is the brighter the more frames the tree named it in.
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "tools/match/DecisionTree.h"

namespace kelpie::match {

// `frames`: of the log, 0 without one. `caption`: the lines below the tree.
cv::Mat drawTree(const DecisionTree& tree, std::uint32_t frames,
                 const std::vector<std::string>& caption);

}  // namespace kelpie::match
