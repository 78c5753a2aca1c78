// SPDX-License-Identifier: Apache-2.0
#include "tools/live/LogTail.h"

#include <algorithm>
#include <array>

namespace kelpie::live {
namespace {

using mcap::Op;

constexpr std::uint64_t kLongestRecord = 64U << 20;  // bytes; a chunk of ours has a megabyte

}  // namespace

Expected<LogTail> LogTail::open(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{path + ": cannot be opened"};
  std::array<std::uint8_t, mcap::kMagic.size()> magic{};
  if (!readAt(file, 0, magic.data(), magic.size()) || magic != mcap::kMagic)
    return Error{path + ": does not begin as a log"};
  return LogTail(std::move(file));
}

std::uint64_t LogTail::behind() {
  file_.clear();
  file_.seekg(0, std::ios::end);
  size_ = static_cast<std::uint64_t>(file_.tellg());
  return size_ - std::min(size_, offset_);
}

bool LogTail::next(LogMessage& message) {
  mcap::Record record;
  while (!ended_ && readRecord(record))
    if (take(record, message)) return true;
  return false;
}

// A chunk inside a chunk is damage: it would be unpacked over itself.
bool LogTail::readRecord(mcap::Record& record) {
  if (chunkAt_ >= chunk_.size()) return readFileRecord(record);
  mcap::ContentReader content(chunk_.data() + chunkAt_, chunk_.size() - chunkAt_);
  record = content.record();
  if (!content.good() || record.op == Op::chunk) ended_ = true;
  chunkAt_ = chunk_.size() - content.left();
  return !ended_;
}

// A record of which a part is not there yet is asked for again.
bool LogTail::readFileRecord(mcap::Record& record) {
  std::array<std::uint8_t, mcap::kRecordHead> head{};
  if (size_ < offset_ + head.size() && behind() < head.size()) return false;
  if (!readAt(file_, offset_, head.data(), head.size())) return false;
  mcap::ContentReader content(head.data(), head.size());
  record.op = content.number<Op>();
  const auto length = content.number<std::uint64_t>();
  ended_ = length > kLongestRecord;
  if (ended_) return false;
  if (size_ < offset_ + head.size() + length && behind() < head.size() + length) return false;
  record_.resize(static_cast<std::size_t>(length));
  if (!readAt(file_, offset_ + head.size(), record_.data(), record_.size())) return false;
  offset_ += head.size() + length;
  record.data = record_.data();
  record.size = record_.size();
  return true;
}

// True for a message. What is neither needed nor known is passed over.
bool LogTail::take(const mcap::Record& record, LogMessage& message) {
  const mcap::ContentReader content(record.data, record.size);
  if (record.op == Op::message) return takeMessage(content, message);
  if (record.op == Op::schema) takeSchema(content);
  if (record.op == Op::channel) takeChannel(content);
  if (record.op == Op::chunk) takeChunk(content);
  ended_ = ended_ || record.op == Op::dataEnd || record.op == Op::footer;
  return false;
}

bool LogTail::takeMessage(mcap::ContentReader content, LogMessage& message) {
  const auto channel = channels_.find(content.number<std::uint16_t>());
  content.number<std::uint32_t>();  // sequence
  const auto ns = content.number<std::uint64_t>();
  content.number<std::uint64_t>();  // time of publication
  if (!content.good() || channel == channels_.end()) return false;
  message.channel = &channel->second;
  message.time = {static_cast<std::int64_t>(ns / 1000)};
  message.data = content.data();
  message.size = content.left();
  message.offset = offset_;
  return true;
}

// Definitions are repeated in a log; the first counts, and messages point to it.
void LogTail::takeSchema(mcap::ContentReader content) {
  const auto id = content.number<std::uint16_t>();
  LogSchema schema;
  schema.name = content.string();
  schema.encoding = content.string();
  schema.text = content.string();
  if (content.good()) schemas_.emplace(id, std::move(schema));
}

void LogTail::takeChannel(mcap::ContentReader content) {
  const auto id = content.number<std::uint16_t>();
  LogChannel channel;
  channel.schemaId = content.number<std::uint16_t>();
  channel.topic = content.string();
  channel.messageEncoding = content.string();
  const auto schema = schemas_.find(channel.schemaId);
  channel.schema = schema == schemas_.end() ? &noSchema_ : &schema->second;
  if (content.good()) channels_.emplace(id, std::move(channel));
}

void LogTail::takeChunk(mcap::ContentReader content) {
  content.number<std::uint64_t>();  // first and last time
  content.number<std::uint64_t>();
  const auto size = content.number<std::uint64_t>();
  content.number<std::uint32_t>();  // checksum
  const std::string compression = content.string();
  const auto stored = content.number<std::uint64_t>();
  const std::uint8_t* const from = content.take(stored);
  ended_ = from == nullptr || size > kLongestRecord;
  if (ended_) return;
  chunkAt_ = 0;
  if (compression.empty()) return chunk_.assign(from, from + stored);
  const auto decompressor = makeDecompressor(compression);
  ended_ = !decompressor || !decompressor->decompress(from, static_cast<std::size_t>(stored),
                                                      static_cast<std::size_t>(size), chunk_);
}

}  // namespace kelpie::live
