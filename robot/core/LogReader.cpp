// SPDX-License-Identifier: Apache-2.0
#include "robot/core/LogReader.h"

#include <algorithm>
#include <cerrno>
#include <sstream>
#include <utility>

namespace kelpie {

using mcap::ContentReader;
using mcap::Op;

Expected<LogReader> LogReader::open(const std::string& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  file.seekg(0, std::ios::end);
  const std::streamoff size = file.tellg();
  if (!file || size < 0) {
    return Error{path + ": " + (errno != 0 ? std::strerror(errno) : "not a readable file")};
  }
  file.seekg(0);
  std::array<std::uint8_t, mcap::kMagic.size()> magic{};
  file.read(reinterpret_cast<char*>(magic.data()), magic.size());
  if (!file || magic != mcap::kMagic) return Error{path + ": byte 0: not an MCAP log"};
  return LogReader(path, std::move(file), static_cast<std::uint64_t>(size));
}

LogReader::LogReader(std::string path, std::ifstream file, std::uint64_t size)
    : path_(std::move(path)),
      file_(std::move(file)),
      fileSize_(size),
      offset_(mcap::kMagic.size()) {}

Status LogReader::status() const {
  if (!error_.empty()) return Error{error_};
  return Done{};
}

void LogReader::fail(const std::string& what) {
  if (error_.empty()) error_ = path_ + ": byte " + std::to_string(recordOffset_) + ": " + what;
}

bool LogReader::next(LogMessage& message) {
  Record record;
  while (error_.empty() && !ended_ && readRecord(record)) {
    if (take(record, message)) return true;
  }
  return false;
}

bool LogReader::cutOff() {
  truncated_ = true;
  ended_ = true;
  return false;
}

bool LogReader::readRecord(Record& record) {
  if (chunkAt_ < chunk_.size()) return readChunkRecord(record);
  recordOffset_ = offset_;
  std::array<std::uint8_t, mcap::kRecordHead> head{};
  file_.read(reinterpret_cast<char*>(head.data()), head.size());
  // Code 0 does not exist: a file system that lost power leaves zeros at the end.
  if (!file_ || head[0] == 0) return cutOff();
  ContentReader content(head.data() + 1, head.size() - 1);
  const auto length = content.number<std::uint64_t>();
  if (length > fileSize_ - std::min(fileSize_, offset_ + head.size())) return cutOff();
  record_.resize(static_cast<std::size_t>(length));
  file_.read(reinterpret_cast<char*>(record_.data()), static_cast<std::streamsize>(length));
  if (!file_) return cutOff();
  offset_ += head.size() + length;
  record = {static_cast<Op>(head[0]), record_.data(), record_.size()};
  return true;
}

bool LogReader::readChunkRecord(Record& record) {
  ContentReader content(chunk_.data() + chunkAt_, chunk_.size() - chunkAt_);
  record.op = content.number<Op>();
  const auto length = content.number<std::uint64_t>();
  record.data = content.take(length);
  record.size = static_cast<std::size_t>(length);
  if (!content.good()) {
    fail("damaged chunk");
    return false;
  }
  chunkAt_ = chunk_.size() - content.left();
  return true;
}

// True when the record is a message.
bool LogReader::take(const Record& record, LogMessage& message) {
  const ContentReader content(record.data, record.size);
  switch (record.op) {
    case Op::message: return takeMessage(content, message);
    case Op::schema: takeSchema(content); break;
    case Op::channel: takeChannel(content); break;
    case Op::chunk: takeChunk(content); break;
    case Op::attachment: takeAttachment(record); break;
    case Op::metadata: takeMetadata(content); break;
    case Op::footer: takeEnd(); break;
    default: break;  // indexes, statistics, and what later versions of MCAP add
  }
  return false;
}

void LogReader::takeSchema(ContentReader content) {
  const auto id = content.number<std::uint16_t>();
  LogSchema schema;
  schema.name = content.string();
  schema.encoding = content.string();
  schema.text = content.string();
  if (!content.good()) return fail("damaged schema record");
  schemas_.emplace(id, std::move(schema));
}

void LogReader::takeChannel(ContentReader content) {
  const auto id = content.number<std::uint16_t>();
  const auto schema = schemas_.find(content.number<std::uint16_t>());
  LogChannel channel;
  channel.topic = content.string();
  channel.messageEncoding = content.string();
  if (!content.good()) return fail("damaged channel record");
  if (schema == schemas_.end()) return fail("topic " + channel.topic + " has no schema");
  channel.schema = &schema->second;
  channels_.emplace(id, std::move(channel));
}

bool LogReader::takeMessage(ContentReader content, LogMessage& message) {
  const auto channel = channels_.find(content.number<std::uint16_t>());
  content.number<std::uint32_t>();  // sequence
  const auto logTime = content.number<std::uint64_t>();
  content.number<std::uint64_t>();  // publish time
  if (!content.good() || channel == channels_.end()) {
    fail(content.good() ? "message of an unknown channel" : "damaged message record");
    return false;
  }
  message.channel = &channel->second;
  message.time = {static_cast<std::int64_t>(logTime / 1000)};
  message.data = content.data();
  message.size = content.left();
  message.offset = recordOffset_;
  return true;
}

void LogReader::takeChunk(ContentReader content) {
  content.take(8 + 8 + 8 + 4);  // times, size and checksum of the content
  const std::string compression = content.string();
  const auto length = content.number<std::uint64_t>();
  const std::uint8_t* records = content.take(length);
  if (!content.good()) return fail("damaged chunk");
  if (chunkAt_ < chunk_.size()) return fail("a chunk inside a chunk");
  if (!compression.empty())
    return fail("compressed with " + compression + ", which we cannot read");
  chunk_.assign(records, records + length);
  chunkAt_ = 0;
}

void LogReader::takeAttachment(const Record& record) {
  ContentReader content(record.data, record.size);
  content.take(8 + 8);  // log and create time
  LogAttachment attachment;
  attachment.name = content.string();
  attachment.mediaType = content.string();
  const auto length = content.number<std::uint64_t>();
  if (const std::uint8_t* data = content.take(length)) attachment.data.assign(data, data + length);
  const std::size_t covered = record.size - content.left();
  const auto checksum = content.number<std::uint32_t>();
  if (!content.good()) return fail("damaged attachment record");
  if (checksum != 0 && checksum != mcap::crc32(record.data, covered)) {
    return fail("attachment " + attachment.name + ": wrong checksum");
  }
  attachments_.push_back(std::move(attachment));
}

void LogReader::takeMetadata(ContentReader content) {
  LogMetadata metadata;
  metadata.name = content.string();
  metadata.entries = content.map();
  if (!content.good()) return fail("damaged metadata record");
  metadata_.push_back(std::move(metadata));
}

void LogReader::takeEnd() {
  std::array<std::uint8_t, mcap::kMagic.size()> magic{};
  file_.read(reinterpret_cast<char*>(magic.data()), magic.size());
  ended_ = true;
  truncated_ = !file_ || magic != mcap::kMagic;
  if (!truncated_) offset_ += magic.size();
}

Status schemaMismatch(const LogMessage& message, const std::string& ours) {
  const std::string start = "topic " + message.topic() + " (" + message.schema().name + "): ";
  if (message.channel->messageEncoding != "ros1") {
    return Error{start + "encoded as " + message.channel->messageEncoding + ", not ros1"};
  }
  std::istringstream theirLines(message.schema().text);
  std::istringstream ourLines(ours);
  std::string theirLine;
  std::string ourLine;
  int line = 0;
  do {
    ++line;
    if (!std::getline(theirLines, theirLine)) theirLine = "(end)";
    if (!std::getline(ourLines, ourLine)) ourLine = "(end)";
  } while (theirLine == ourLine && theirLine != "(end)");
  return Error{start + "recorded with another field list; schema line " + std::to_string(line) +
               " is \"" + theirLine + "\", expected \"" + ourLine + "\""};
}

}  // namespace kelpie
