// SPDX-License-Identifier: Apache-2.0
// Writes a log: an append-only MCAP file whose messages are encoded from the field lists. On the
// host messages go out in compressed chunks of a megabyte or a second, each with one write, so that
// a log cut off anywhere keeps all chunks before, and its channels are defined anew once in sixteen
// chunks, so that a log whose beginning is damaged is readable; without chunks, as on the robot,
// every record goes out alone. The first error (disk full) ends the writing and stays in status();
// nothing crashes and the robot plays on.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/Expected.h"
#include "robot/core/fields/Encoding.h"
#include "robot/core/log/ChunkCodec.h"
#include "robot/core/log/LogChunk.h"
#include "robot/core/log/LogFormat.h"
#include "robot/core/log/LogOutput.h"
#include "robot/core/log/LogSummary.h"

namespace kelpie {

// A type whose messages the caller encodes, in another way than ours: for files that are made for
// other programs.
struct ReadyType {
  std::string name;             // "foxglove.Log"
  std::string schemaEncoding;   // "protobuf"
  std::string schema;           // its bytes
  std::string messageEncoding;  // "protobuf"
};

class LogWriter {
 public:
  // Replaces a file that exists. The profile tells other programs what to expect of the messages;
  // none of those that MCAP lists fits every file.
  static Expected<LogWriter> open(const std::string& path,
                                  const LogOptions& options = defaultLogOptions(),
                                  std::string_view profile = "ros1");
  LogWriter(LogWriter&& other) noexcept = default;
  LogWriter& operator=(LogWriter&& other) noexcept;
  ~LogWriter();  // closes

  // A topic keeps the type of its first message.
  template <class T>
  void write(std::string_view topic, TimeUs time, const T& value) {
    buffer_.clear();
    const Channel* channel = channelFor(topic, {&schemaName<T>, &schemaText<T>});
    if (channel == nullptr) return;
    const std::size_t start = beginMessage(*channel, time);
    encode(value, buffer_);
    endMessage(*channel, start, time);
  }

  // The same for bytes that the caller has encoded.
  void write(std::string_view topic, TimeUs time, const ReadyType& type, const std::string& bytes);

  // These two stand outside chunks and are written at once.
  void metadata(const std::string& name, const LogMap& entries);
  // A file that belongs to the log: parameters, colour table.
  void attachment(const std::string& name, const std::string& mediaType,
                  const std::vector<std::uint8_t>& data);

  // Closes the open chunk: all messages so far are in the file.
  void flush();
  // What went wrong first, if anything.
  Status status() const { return output_.status(); }
  // Writes statistics, indexes and footer. The log is readable without them.
  Status close();
  // In the file; what the open chunk and the one being compressed hold comes on top.
  std::uint64_t bytes() const { return output_.bytes(); }

 private:
  struct SchemaOf {
    std::string (*name)();
    std::string (*text)();  // its address also tells types apart; null: a ReadyType
  };
  struct Channel {
    std::string topic;
    SchemaOf schema;
    std::uint16_t id;
    std::uint16_t schemaId;
    std::vector<std::uint8_t> definition;  // its records: schema and channel
    std::uint32_t definedIn;               // number of the last chunk that holds them
  };
  struct Schema {
    std::string name;
    std::vector<std::uint8_t> record;
  };

  LogWriter(LogOutput output, LogOptions options, std::unique_ptr<ChunkCompressor> compressor);
  const Channel* channelFor(std::string_view topic, SchemaOf schema);
  const Channel* channelFor(std::string_view topic, const ReadyType& type);
  const Channel* refuse(const Channel& channel, const std::string& name);
  std::uint16_t schemaId(const std::string& name) const;
  std::uint16_t addSchema(const std::string& name, std::string_view encoding,
                          std::string_view text);
  const Channel& addChannel(std::string_view topic, SchemaOf schema, std::uint16_t schemaNumber,
                            std::string_view encoding);
  std::size_t beginMessage(const Channel& channel, TimeUs time);
  void endMessage(const Channel& channel, std::size_t start, TimeUs time);
  void gather(Channel& channel, std::size_t start, std::uint64_t time);
  void closeChunk();
  void writeChunk();

  LogOutput output_;
  LogOptions options_;
  std::unique_ptr<ChunkCompressor> compressor_;  // null: chunks are not compressed
  LogChunk chunk_;                               // the open one
  LogChunk packing_;                             // the one before, until it is in the file
  LogSummary summary_;
  std::vector<Channel> channels_;     // the id is the place plus 1
  std::vector<Schema> schemas_;       // so
  std::uint32_t chunkNumber_ = 0;     // of the open one
  std::vector<std::uint8_t> buffer_;  // records about to be written
};

}  // namespace kelpie
