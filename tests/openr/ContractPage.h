// SPDX-License-Identifier: Apache-2.0
// docs/robot-contract.md as the rows of robot/openr/Contract.h have it.
#pragma once

#include <string>

namespace kelpie::openr {

std::string contractPage();

}  // namespace kelpie::openr
