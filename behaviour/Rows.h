// SPDX-License-Identifier: Apache-2.0
// What the behaviours say of themselves when a tool asks them, a table of texts.
#pragma once

#include <string>
#include <vector>

namespace kelpie::behaviour {

using Rows = std::vector<std::vector<std::string>>;

}  // namespace kelpie::behaviour
