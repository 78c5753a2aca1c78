// SPDX-License-Identifier: Apache-2.0
// Films and pictures of a match. Both are written whole or not at all.
#pragma once

#include <string>

#include "robot/core/Expected.h"
#include "tools/match/Match.h"

namespace kelpie::cli {

// Camera with overlays and, below, why the robot did what it did, a line for each layer; beside it
// the field seen from above. 30 frames a second. An interrupt ends it
// within a frame, with an error.
Status filmMatch(const match::Match& match, const std::string& out);

// Paths of robot and ball from above, and six camera frames with overlays.
Status drawMatchPicture(const match::Match& match, const std::string& out);

}  // namespace kelpie::cli
