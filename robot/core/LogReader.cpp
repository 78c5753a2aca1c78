// SPDX-License-Identifier: Apache-2.0
#include "robot/core/LogReader.h"

#include <algorithm>
#include <cerrno>
#include <sstream>
#include <utility>

#include "robot/core/Checksum.h"
#include "robot/core/ChunkRoom.h"

namespace kelpie {

using mcap::ContentReader;
using mcap::Op;

namespace {

// Writers make chunks of about a megabyte; a chunk that says more than this is not believed.
constexpr std::uint64_t kMaxChunk = 256U << 20;

}  // namespace

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
    if (!take(record, message) || message.time < from_) continue;
    from_ = kFromStart;
    return true;
  }
  return false;
}

void LogReader::seek(TimeUs time) {
  if (!error_.empty()) return;
  if (indexState_ == IndexState::unread)
    indexState_ = readIndex() ? IndexState::read : IndexState::none;
  const bool indexed = indexState_ == IndexState::read;
  offset_ = indexed ? index_.placeOf(time) : mcap::kMagic.size();
  file_.clear();
  file_.seekg(static_cast<std::streamoff>(offset_));
  chunk_.clear();
  chunkAt_ = 0;
  truncated_ = false;
  ended_ = false;
  from_ = time;
}

// With the schemas and channels, which may stand in chunks that are passed over.
bool LogReader::readIndex() {
  const std::vector<std::uint8_t> summary = readSummary(file_, fileSize_);
  ContentReader records(summary.data(), summary.size());
  while (records.left() > 0) {
    const Record record = records.record();
    if (!records.good()) return false;
    const ContentReader content(record.data, record.size);
    if (record.op == Op::schema) takeSchema(content);
    if (record.op == Op::channel) takeChannel(content);
    if (record.op == Op::chunkIndex && !index_.add(content, fileSize_)) return false;
    if (error_.empty()) continue;
    error_.clear();  // the log is read without the index
    return false;
  }
  index_.sort();
  return !index_.chunks.empty();
}

bool LogReader::cutOff() {
  truncated_ = true;
  ended_ = true;
  return false;
}

bool LogReader::readRecord(Record& record) {
  inChunk_ = chunkAt_ < chunk_.size();
  if (inChunk_) return readChunkRecord(record);
  recordOffset_ = offset_;
  std::array<std::uint8_t, mcap::kRecordHead> head{};
  file_.read(reinterpret_cast<char*>(head.data()), head.size());
  // Code 0 does not exist: a file system that lost power leaves zeros at the end.
  if (!file_ || head[0] == 0) return cutOff();
  ContentReader content(head.data() + 1, head.size() - 1);
  const auto length = content.number<std::uint64_t>();
  if (length > fileSize_ - std::min(fileSize_, offset_ + head.size())) return cutOff();
  makeRoom(record_, static_cast<std::size_t>(length));
  record_.resize(static_cast<std::size_t>(length));
  file_.read(reinterpret_cast<char*>(record_.data()), static_cast<std::streamsize>(length));
  if (!file_) return cutOff();
  offset_ += head.size() + length;
  record = {static_cast<Op>(head[0]), record_.data(), record_.size()};
  return true;
}

bool LogReader::readChunkRecord(Record& record) {
  ContentReader content(chunk_.data() + chunkAt_, chunk_.size() - chunkAt_);
  record = content.record();
  chunkAt_ = chunk_.size() - content.left();
  if (content.good() && record.op != Op::chunk) return true;
  fail(content.good() ? "a chunk inside a chunk" : "damaged chunk");
  return false;
}

// True when the record is a message.
bool LogReader::take(const Record& record, LogMessage& message) {
  const ContentReader content(record.data, record.size);
  switch (record.op) {
    case Op::message: return takeMessage(content, message);
    case Op::schema: takeSchema(content); break;
    case Op::channel: takeChannel(content); break;
    default:
      if (!inChunk_) takeOutside(record);
  }
  return false;
}

// Records that have no place in a chunk.
void LogReader::takeOutside(const Record& record) {
  const ContentReader content(record.data, record.size);
  switch (record.op) {
    case Op::chunk: takeChunk(content); break;
    case Op::attachment: takeAttachment(record); break;
    case Op::metadata: takeMetadata(content); break;
    case Op::footer: takeEnd(); break;
    default: break;  // indexes, statistics, and what later versions of MCAP add
  }
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
  content.take(8 + 8);  // first and last time
  const auto size = content.number<std::uint64_t>();
  const auto checksum = content.number<std::uint32_t>();
  const std::string compression = content.string();
  const auto length = content.number<std::uint64_t>();
  const std::uint8_t* stored = content.take(length);
  if (!content.good()) return fail("damaged chunk");
  const Status unpacked = unpack(compression, stored, length, size);
  if (!unpacked) return fail(unpacked.error());
  if (checksum != 0 && checksum != crc32(chunk_.data(), chunk_.size()))
    return fail("damaged chunk: wrong checksum");
  chunkAt_ = 0;
  chunkCounts_.compression = compression;
  ++chunkCounts_.chunks;
  chunkCounts_.stored += length;
  chunkCounts_.held += size;
}

// Fills chunk_ with the `size` bytes of records that `length` bytes hold.
Status LogReader::unpack(const std::string& compression, const std::uint8_t* stored,
                         std::uint64_t length, std::uint64_t size) {
  const std::string says = "damaged chunk: says that it holds " + std::to_string(size) + " bytes";
  if (size > kMaxChunk) return Error{says};
  if (compression.empty()) {
    if (size != length) return Error{says + ", has " + std::to_string(length)};
    makeRoom(chunk_, static_cast<std::size_t>(length));
    chunk_.assign(stored, stored + length);
    return Done{};
  }
  if (!decompressor_ || decompresses_ != compression) decompressor_ = makeDecompressor(compression);
  if (!decompressor_) return Error{"compressed with " + compression + ", which we cannot read"};
  decompresses_ = compression;
  const Status done = decompressor_->decompress(stored, static_cast<std::size_t>(length),
                                                static_cast<std::size_t>(size), chunk_);
  return done ? done : Error{"damaged chunk: " + done.error()};
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
  if (checksum != 0 && checksum != crc32(record.data, covered)) {
    return fail("attachment " + attachment.name + ": wrong checksum");
  }
  if (met_.insert(recordOffset_).second) attachments_.push_back(std::move(attachment));
}

void LogReader::takeMetadata(ContentReader content) {
  LogMetadata metadata;
  metadata.name = content.string();
  metadata.entries = content.map();
  if (!content.good()) return fail("damaged metadata record");
  if (met_.insert(recordOffset_).second) metadata_.push_back(std::move(metadata));
}

void LogReader::takeEnd() {
  std::array<std::uint8_t, mcap::kMagic.size()> magic{};
  file_.read(reinterpret_cast<char*>(magic.data()), magic.size());
  ended_ = true;
  truncated_ = !file_ || magic != mcap::kMagic;
  if (!truncated_) offset_ += magic.size();
}

namespace {

std::string firstDifference(const std::string& theirs, const std::string& ours) {
  std::istringstream theirLines(theirs);
  std::istringstream ourLines(ours);
  std::string theirLine;
  std::string ourLine;
  int line = 0;
  do {
    ++line;
    if (!std::getline(theirLines, theirLine)) theirLine = "(end)";
    if (!std::getline(ourLines, ourLine)) ourLine = "(end)";
  } while (theirLine == ourLine && theirLine != "(end)");
  return "schema line " + std::to_string(line) + " is \"" + theirLine + "\", expected \"" +
         ourLine + '"';
}

// "a, b, c and 4 more"
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kShown = 4;
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, names.size()); ++i)
    text += (i > 0 ? ", " : "") + names[i];
  if (names.size() > kShown) text += " and " + std::to_string(names.size() - kShown) + " more";
  return text;
}

}  // namespace

Status learnSchema(const LogMessage& message, const std::string& name, const std::string& ours) {
  const LogSchema& schema = message.schema();
  const std::string start = "topic " + message.topic() + " (" + schema.name + "): ";
  if (message.channel->messageEncoding != "ros1")
    return Error{start + "encoded as " + message.channel->messageEncoding + ", not ros1"};
  schema.translation = nullptr;
  if (schema.text == ours) return Done{};
  const std::string other =
      start + "recorded with another field list; " + firstDifference(schema.text, ours);
  if (schema.name != name) return Error{other};
  auto translation = SchemaTranslation::make(name, schema.text, ours);
  if (!translation) return Error{other};
  schema.translation = std::make_shared<const SchemaTranslation>(std::move(*translation));
  return Done{};
}

std::vector<std::string> LogReader::notes() const {
  std::vector<std::string> notes;
  for (const auto& [id, schema] : schemas_) {
    if (!schema.translation) continue;
    const auto& defaulted = schema.translation->defaulted();
    const auto& leftOut = schema.translation->leftOut();
    std::string note = schema.name + ": recorded with another field list";
    if (!defaulted.empty()) note += "; not recorded, set to the default: " + listed(defaulted);
    if (!leftOut.empty()) note += "; recorded, no longer known: " + listed(leftOut);
    notes.push_back(std::move(note));
  }
  return notes;
}

}  // namespace kelpie
