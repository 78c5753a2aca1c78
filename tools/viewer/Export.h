// SPDX-License-Identifier: Apache-2.0
// The logs of one match, joined by time, as a file that viewers open with nothing of ours.
#pragma once

#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "robot/core/Time.h"
#include "tools/viewer/ViewerFile.h"

namespace kelpie::viewer {

struct Exported {
  std::size_t frames = 0;          // of robots
  std::vector<std::string> lacks;  // "LOG: what of it could not be read"
};

// `start` is what the match's time 0 becomes. Writes all that can be read; an error when a file is
// no log, when nothing in the logs can be shown, when two are of one robot, or when the file cannot
// be written (its status tells). Does not close it.
Expected<Exported> exportLogs(const std::vector<std::string>& logs, TimeUs start, ViewerFile& file);

}  // namespace kelpie::viewer
