// SPDX-License-Identifier: Apache-2.0
// How a search went: the best gain after each trial, as a curve.
#pragma once

#include <string>
#include <vector>

#include "robot/core/Expected.h"

namespace kelpie::cli {

Status drawGain(const std::vector<double>& gains, const std::string& title,
                const std::string& path);

}  // namespace kelpie::cli
