// SPDX-License-Identifier: Apache-2.0
#include "tools/live/LogsOf.h"

#include <algorithm>
#include <filesystem>

namespace kelpie::live {

namespace fs = std::filesystem;

std::vector<std::string> logsOf(const std::string& folder) {
  std::vector<std::string> logs;
  std::error_code error;
  for (fs::directory_iterator i(folder, error), end; !error && i != end; i.increment(error))
    if (i->path().extension() == ".mcap") logs.push_back(i->path().string());
  std::sort(logs.begin(), logs.end());
  return logs;
}

}  // namespace kelpie::live
