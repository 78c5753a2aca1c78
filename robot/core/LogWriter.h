// SPDX-License-Identifier: Apache-2.0
// Writes a log: an append-only MCAP file without chunks whose messages are encoded from the field
// lists. Every record goes out whole with one write, so that a log cut off anywhere keeps all that
// was written. The first error (disk full) ends the writing and stays in status(); nothing crashes
// and the robot plays on.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/Encoding.h"
#include "robot/core/Expected.h"
#include "robot/core/LogFormat.h"

namespace kelpie {

class LogWriter {
 public:
  // Replaces a file that exists.
  static Expected<LogWriter> open(const std::string& path);
  LogWriter(LogWriter&& other) noexcept;
  LogWriter& operator=(LogWriter&& other) noexcept;
  ~LogWriter();  // closes

  // A topic keeps the type of its first message.
  template <class T>
  void write(std::string_view topic, TimeUs time, const T& value) {
    buffer_.clear();
    Channel* channel = channelFor(topic, {&schemaName<T>, &schemaText<T>});
    if (channel == nullptr) return;
    const std::size_t start = beginMessage(*channel, time);
    encode(value, buffer_);
    endMessage(*channel, start, time);
  }

  void metadata(const std::string& name, const LogMap& entries);
  // A file that belongs to the log: parameters, colour table.
  void attachment(const std::string& name, const std::string& mediaType,
                  const std::vector<std::uint8_t>& data);

  // What went wrong first, if anything.
  Status status() const;
  // Writes statistics and footer. The log is readable without them.
  Status close();
  std::uint64_t bytes() const { return bytes_; }

 private:
  struct SchemaOf {
    std::string (*name)();
    std::string (*text)();  // its address also tells types apart
  };
  struct Channel {
    std::string topic;
    SchemaOf schema;
    std::uint16_t id;
    std::uint32_t messages;
  };

  LogWriter(std::string path, int file);
  Channel* channelFor(std::string_view topic, SchemaOf schema);
  std::uint16_t schemaId(SchemaOf schema);
  std::size_t beginMessage(const Channel& channel, TimeUs time);
  void endMessage(Channel& channel, std::size_t start, TimeUs time);
  void writeSummary();
  void addStatistics(std::vector<std::uint8_t>& out) const;
  void flush();
  void fail(const std::string& what);

  std::string path_;
  int file_ = -1;
  std::uint64_t bytes_ = 0;
  std::string error_;
  std::vector<Channel> channels_;
  std::vector<std::string> schemas_;  // names; the id is the place plus 1
  std::vector<std::uint8_t> buffer_;  // records about to be written
  // Records repeated at the end of the file, by kind.
  std::vector<std::uint8_t> schemaRecords_;
  std::vector<std::uint8_t> channelRecords_;
  std::vector<std::uint8_t> attachmentIndexes_;
  std::vector<std::uint8_t> metadataIndexes_;
  std::uint32_t attachments_ = 0;
  std::uint32_t metadata_ = 0;
  std::uint64_t messages_ = 0;
  std::uint64_t firstTime_ = 0;  // ns
  std::uint64_t lastTime_ = 0;
};

}  // namespace kelpie
