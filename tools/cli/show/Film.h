// SPDX-License-Identifier: Apache-2.0
// Films and pictures of a match. Both are written whole or not at all.
#pragma once

#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "tools/match/Match.h"

namespace kelpie::cli {

struct FilmRequest {
  std::vector<std::string> logs;   // of the match, the watched robot's first
  std::string view = "broadcast";  // robot or split
  std::string out;
  bool still = false;  // one picture, drawn as well as can be
};

// The robot's view has 30 frames a second, the others 15. An interrupt ends it within a frame, with
// an error. `lacks`: a line for each log of which not all could be read.
Status filmMatch(const match::Match& match, const FilmRequest& request,
                 std::vector<std::string>& lacks);

// The match in one picture: title, paths from above, six moments.
Status drawMatchPicture(const match::Match& match, const std::string& out);

// The log, and those that `kelpie play --logs all` left of the other robots in the same folder.
std::vector<std::string> logsBeside(const std::string& log);

}  // namespace kelpie::cli
