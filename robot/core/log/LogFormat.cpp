// SPDX-License-Identifier: Apache-2.0
#include "robot/core/log/LogFormat.h"

namespace kelpie::mcap {

void RecordWriter::map(const LogMap& entries) {
  std::size_t size = 0;
  for (const auto& entry : entries) size += 8 + entry.first.size() + entry.second.size();
  number(static_cast<std::uint32_t>(size));
  for (const auto& entry : entries) {
    string(entry.first);
    string(entry.second);
  }
}

LogMap ContentReader::map() {
  LogMap entries;
  const std::size_t size = number<std::uint32_t>();
  if (size > left_) good_ = false;
  const std::size_t end = good_ ? left_ - size : 0;
  while (good_ && left_ > end) {
    std::string key = string();
    entries[std::move(key)] = string();
  }
  return entries;
}

}  // namespace kelpie::mcap
