// SPDX-License-Identifier: Apache-2.0
// The behaviours as the one zip that the robot's Python reads, made by toolchain/make-pyzip.
#pragma once

#include <string>

#include "robot/core/Expected.h"

namespace kelpie::stick {

Expected<std::string> zipBehaviours(const std::string& folder);

}  // namespace kelpie::stick
