// SPDX-License-Identifier: Apache-2.0
// The value that a share of others lies below, as it stands among them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace kelpie::calibrate {

// share in 0..1, 0.5 for the median; 0 for no values.
inline double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto rank = static_cast<std::size_t>(share * static_cast<double>(values.size()));
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::min(rank, values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace kelpie::calibrate
