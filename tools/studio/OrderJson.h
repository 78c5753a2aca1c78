// SPDX-License-Identifier: Apache-2.0
// Orders to a live match as the page writes them: {"do": "step", "frames": 1}, with the names of
// tools/sim/staging/LiveOrder.h; "ball" and "robot" have x, y, heading_deg, team and player.
#pragma once

#include <string>

#include "tools/sim/staging/LiveOrder.h"

namespace kelpie::studio {

// An error is one line for the page's user.
Expected<sim::LiveOrder> orderFromJson(const std::string& text);

}  // namespace kelpie::studio
