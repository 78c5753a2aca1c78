// SPDX-License-Identifier: Apache-2.0
// Figures of experiments and benchmarks: plain numbers under snake_case keys that end in their
// unit.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

namespace kelpie::cli {

using Json = nlohmann::ordered_json;

// p in 0..1; linear between neighbours; 0 for no values.
double percentile(std::vector<double> values, double p);

}  // namespace kelpie::cli
