// SPDX-License-Identifier: Apache-2.0
// JSON as text. The library's own writer gives one number in a few hundred more digits than it
// takes to read the same bits back, such as 5.324000000000001e-2 for 0.05324; here each has the
// fewest.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace kelpie::cli {

// On one line, or with so many spaces for each level.
std::string jsonText(const nlohmann::ordered_json& value, int indent = -1);

}  // namespace kelpie::cli
