// SPDX-License-Identifier: Apache-2.0
// Films and pictures of a log. Both are written whole or not at all.
#pragma once

#include <functional>
#include <string>

#include "robot/core/Expected.h"

namespace kelpie::cli {

using Progress = std::function<void(std::size_t done, std::size_t all)>;

// Camera with overlays beside the field seen from above, 30 frames a second.
Status filmMatch(const std::string& log, const std::string& out, const Progress& progress);

// Paths of robot and ball from above, and six camera frames with overlays.
Status drawMatchPicture(const std::string& log, const std::string& out);

}  // namespace kelpie::cli
