// SPDX-License-Identifier: Apache-2.0
// Reads a log message by message. A log without its end, cut off anywhere, gives all its whole
// records and chunks and then says truncated(). Damaged bytes inside it are passed over: everything
// before and behind them is read, and gaps() says what was lost. Reads MCAP files of others as
// well, if the program is linked with what decompresses them; decodeAs() then says whether a
// message is one of ours. Fails (status()) only for a compression that it does not know.
// A message of an older field list is translated member by member; notes() says which differ.
//
//   LogMessage message;
//   while (reader.next(message)) ...
//   if (!reader.status()) ...
#pragma once

#include <cstdint>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/Expected.h"
#include "robot/core/fields/Encoding.h"
#include "robot/core/fields/SchemaTranslation.h"
#include "robot/core/log/ChunkCodec.h"
#include "robot/core/log/LogFormat.h"
#include "robot/core/log/LogIndex.h"
#include "robot/core/log/LogScan.h"

namespace kelpie {

struct LogSchema {
  std::string name;
  std::string encoding;  // "ros1msg"
  std::string text;

  // How decodeAs() read it the last time: as which type, and by which translation if the text is
  // not that of today's field list.
  mutable std::string (*knownAs)() = nullptr;
  mutable std::shared_ptr<const SchemaTranslation> translation;
  mutable std::vector<std::uint8_t> defaults;    // a default value of that type, encoded
  mutable std::vector<std::uint8_t> translated;  // the last message
};

struct LogChannel {
  std::string topic;
  std::string messageEncoding;        // "ros1"
  std::uint16_t schemaId = 0;         // 0: none
  const LogSchema* schema = nullptr;  // never null in a message; without a name if there is none
};

// Points into the reader: valid until its next call of next().
struct LogMessage {
  const LogChannel* channel = nullptr;
  TimeUs time;
  const std::uint8_t* data = nullptr;
  std::size_t size = 0;
  std::uint64_t offset = 0;  // of its record (or of the chunk around it) in the file

  const std::string& topic() const { return channel->topic; }
  const LogSchema& schema() const { return *channel->schema; }
};

struct LogMetadata {
  std::string name;
  LogMap entries;
};

struct LogAttachment {
  std::string name;
  std::string mediaType;
  std::vector<std::uint8_t> data;
};

// Bytes of a log that could not be read.
struct LogGap {
  std::uint64_t from = 0;           // the first of them
  std::uint64_t to = 0;             // behind the last
  std::string what;                 // what is wrong with them
  std::optional<TimeUs> last;       // time of the message before; none if it is the log's beginning
  std::optional<TimeUs> following;  // of the message behind; none if no other was read

  // "bytes 12 to 345: damaged chunk: wrong checksum; what was from 1.200 to 2.300 s is lost"
  std::string text() const;
};

// How the messages read so far were stored.
struct LogChunkCounts {
  std::string compression;  // of the last; empty: none
  std::uint64_t chunks = 0;
  std::uint64_t stored = 0;  // bytes
  std::uint64_t held = 0;    // bytes of records
};

class LogReader {
 public:
  static Expected<LogReader> open(const std::string& path);

  // False at the end and after an error.
  bool next(LogMessage& message);
  // From here on next() begins with the first message in the file that is of `time` or later, as if
  // those before it had been read, but goes by the chunk index where the log has one. The metadata
  // and attachments on the way are then not met.
  void seek(TimeUs time);
  Status status() const;  // "path: byte 1234: what is wrong"
  // The file ends without footer; known when next() has returned false.
  bool truncated() const { return truncated_; }
  // In one line what of the file was not read so far, damage and a cut; empty: nothing.
  std::string lacks() const;
  // Damage on the way so far, in the order of the file; the rest behind a cut is not among it.
  const std::vector<LogGap>& gaps() const { return gaps_; }
  // Where the last whole record ends.
  std::uint64_t offset() const { return offset_; }

  // What was read so far.
  const std::map<std::uint16_t, LogChannel>& channels() const { return channels_; }
  const std::vector<LogMetadata>& metadata() const { return metadata_; }
  const std::vector<LogAttachment>& attachments() const { return attachments_; }
  const LogChunkCounts& chunkCounts() const { return chunkCounts_; }
  // A line for each type that was decoded by translation (what got defaults, what was left out) and
  // for each schema or channel that was defined twice with other content: the first counts.
  std::vector<std::string> notes() const;

 private:
  using Record = mcap::Record;
  enum class IndexState { unread, none, read };
  static constexpr TimeUs kFromStart{std::numeric_limits<std::int64_t>::min()};

  LogReader(std::string path, std::ifstream file, std::uint64_t size);
  bool readRecord(Record& record);
  bool readFileRecord(Record& record);
  bool readChunkRecord(Record& record);
  void cutOff();
  bool take(const Record& record, LogMessage& message);
  void takeOutside(const Record& record);
  void takeSchema(mcap::ContentReader content);
  void takeChannel(mcap::ContentReader content);
  bool takeMessage(mcap::ContentReader content, LogMessage& message);
  void takeChunk(mcap::ContentReader content);
  void unpack(const std::string& compression, const std::uint8_t* stored, std::uint64_t length,
              std::uint64_t size);
  void takeAttachment(const Record& record);
  void takeMetadata(mcap::ContentReader content);
  void takeEnd(const Record& record);
  void takeMessageIndex(mcap::ContentReader content);
  void takeDataEnd(const Record& record);
  void takeOther(const Record& record);
  const LogChannel* channelOf(std::uint16_t id);
  bool readIndex();
  void fail(const std::string& what);
  void spoil(const std::string& what);
  void passOver();
  std::optional<std::uint64_t> nextSound(const LogScan& scan, std::uint64_t from) const;
  void harvest();
  void addGap(std::uint64_t from, std::uint64_t to);
  void meet(TimeUs time);
  void goTo(std::uint64_t offset);

  std::string path_;
  std::ifstream file_;
  std::uint64_t fileSize_ = 0;
  std::uint64_t offset_ = 0;        // behind the last whole record
  std::uint64_t recordOffset_ = 0;  // of the record of the file being taken
  std::uint64_t before_ = 0;        // where the record before it begins, or ends if it is whole
  bool whole_ = false;              // the record being taken, by its checksum
  std::uint64_t strange_ = 0;       // where the record before stands if we do not know its kind
  bool dataEnded_ = false;          // what follows are indexes
  bool truncated_ = false;
  bool ended_ = false;
  std::string error_;
  std::string spoilt_;  // what is wrong with the record being taken; empty: nothing
  std::vector<LogGap> gaps_;
  std::optional<TimeUs> lastTime_;
  bool harvests_ = true;              // definitions may still be looked for elsewhere
  std::vector<std::uint8_t> record_;  // content of the record read last
  std::vector<std::uint8_t> chunk_;   // records of the chunk being read
  std::size_t chunkAt_ = 0;
  bool inChunk_ = false;  // the record being taken is of the chunk
  std::unique_ptr<ChunkDecompressor> decompressor_;
  std::string decompresses_;  // compression that it is for
  LogChunkCounts chunkCounts_;
  IndexState indexState_ = IndexState::unread;
  LogIndex index_;
  TimeUs from_ = kFromStart;  // messages before it are passed over
  LogSchema noSchema_;
  std::map<std::uint16_t, LogSchema> schemas_;
  std::map<std::uint16_t, LogChannel> channels_;
  std::vector<LogMetadata> metadata_;
  std::vector<LogAttachment> attachments_;
  std::set<std::string> twice_;
  std::set<std::uint64_t> met_;  // where those two stood: after seek() they are met again
};

// Finds out how to read messages like this one as a type called `name` whose text is `ours`. Fails
// for another type, and where the recorded text cannot be read; names topic and first line.
Status learnSchema(const LogMessage& message, const std::string& name, const std::string& ours);

// Decodes a message recorded with T's field list, or with another version of it.
template <class T>
Status decodeAs(const LogMessage& message, T& out) {
  const LogSchema& schema = message.schema();
  if (schema.knownAs != &schemaText<T>) {
    const Status learnt = learnSchema(message, schemaName<T>(), schemaText<T>());
    if (!learnt) return learnt;
    schema.defaults.clear();
    if (schema.translation) encode(*std::make_unique<T>(), schema.defaults);
    schema.knownAs = &schemaText<T>;
  }
  const bool done = schema.translation
                        ? schema.translation->translate(message.data, message.size, schema.defaults,
                                                        schema.translated) &&
                              decode(schema.translated.data(), schema.translated.size(), out)
                        : decode(message.data, message.size, out);
  if (done) return Done{};
  return Error{"topic " + message.topic() + ", byte " + std::to_string(message.offset) +
               ": damaged message"};
}

}  // namespace kelpie
