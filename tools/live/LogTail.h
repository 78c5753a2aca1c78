// SPDX-License-Identifier: Apache-2.0
// Follows a log while another process writes it: gives each message once it is in the file whole.
// Unlike LogReader it does not look for the rest behind damage: the log ends there. Schemas and
// channels stay where they are for as long as the tail lives.
#pragma once

#include <cstdint>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "robot/core/log/LogReader.h"

namespace kelpie::live {

class LogTail {
 public:
  // Refuses a file that begins as no log.
  static Expected<LogTail> open(const std::string& path);

  // The next message that is in the file, valid until the next call; false: none yet.
  bool next(LogMessage& message);
  // Bytes of the file that have not been read.
  std::uint64_t behind();
  // Nothing more will come: the log has its end, or is damaged.
  bool ended() const { return ended_; }

 private:
  explicit LogTail(std::ifstream file) : file_(std::move(file)) {}
  bool readRecord(mcap::Record& record);
  bool readFileRecord(mcap::Record& record);
  bool take(const mcap::Record& record, LogMessage& message);
  bool takeMessage(mcap::ContentReader content, LogMessage& message);
  void takeSchema(mcap::ContentReader content);
  void takeChannel(mcap::ContentReader content);
  void takeChunk(mcap::ContentReader content);

  std::ifstream file_;
  std::uint64_t offset_ = mcap::kMagic.size();  // behind the last whole record
  std::uint64_t size_ = 0;                      // of the file when it was last looked at
  bool ended_ = false;
  std::vector<std::uint8_t> record_;
  std::vector<std::uint8_t> chunk_;
  std::size_t chunkAt_ = 0;
  std::map<std::uint16_t, LogSchema> schemas_;
  std::map<std::uint16_t, LogChannel> channels_;
  LogSchema noSchema_;
};

}  // namespace kelpie::live
