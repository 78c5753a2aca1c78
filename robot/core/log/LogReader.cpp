// SPDX-License-Identifier: Apache-2.0
#include "robot/core/log/LogReader.h"

#include <algorithm>
#include <cerrno>
#include <sstream>
#include <utility>

#include "robot/core/Checksum.h"
#include "robot/core/log/ChunkBuffer.h"

namespace kelpie {

using mcap::ContentReader;
using mcap::Op;

namespace {

// Writers make chunks of about a megabyte; a chunk that says more than this is not believed.
constexpr std::uint64_t kMaxChunk = 256U << 20;

// Of 1.2 s: "1.200".
std::string secondsText(TimeUs time) {
  const std::string digits = std::to_string(time.seconds());
  return digits.substr(0, digits.size() - 3);
}

// Those that MCAP has names for; any other name is a damaged one.
bool isCompression(const std::string& name) { return name == "zstd" || name == "lz4"; }

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

// The record being taken is damaged: the first reason stays until it is passed over.
void LogReader::spoil(const std::string& what) {
  if (spoilt_.empty()) spoilt_ = what;
}

bool LogReader::next(LogMessage& message) {
  Record record;
  while (error_.empty() && !ended_) {
    const bool isMessage = readRecord(record) && take(record, message);
    if (!spoilt_.empty()) passOver();
    if (!isMessage) continue;
    meet(message.time);
    if (message.time < from_) continue;
    from_ = kFromStart;
    return true;
  }
  return false;
}

void LogReader::meet(TimeUs time) {
  for (auto gap = gaps_.rbegin(); gap != gaps_.rend() && !gap->following; ++gap)
    gap->following = time;
  lastTime_ = time;
}

// What overlaps the gap before is one with it, as is what goes on from it.
void LogReader::addGap(std::uint64_t from, std::uint64_t to) {
  if (dataEnded_) return;  // indexes only
  LogGap gap{from, to, spoilt_, lastTime_, {}};
  const auto isOne = [&](const LogGap& before) {
    const bool goesOn = before.to == gap.from && !before.following;
    return goesOn || (before.from < gap.to && gap.from < before.to);
  };
  for (; !gaps_.empty() && isOne(gaps_.back()); gaps_.pop_back()) {
    const std::uint64_t min = std::min(gaps_.back().from, gap.from);
    const std::uint64_t max = std::max(gaps_.back().to, gap.to);
    gap = gaps_.back();
    gap.from = min;
    gap.to = max;
  }
  gaps_.push_back(gap);
}

// Goes on behind the damaged record if a record begins there, else where the next one does. Where
// no record begins that may be inside the record before, whose length may be what is damaged.
void LogReader::passOver() {
  chunk_.clear();
  chunkAt_ = 0;
  const LogScan scan(file_, fileSize_);
  std::optional<std::uint64_t> there;
  if (offset_ > recordOffset_ && scan.sound(offset_)) there = offset_;
  const bool headless = offset_ == recordOffset_;
  if (!there) there = nextSound(scan, (headless ? before_ : recordOffset_) + 1);
  if (there) addGap(*there < recordOffset_ ? before_ : recordOffset_, *there);
  spoilt_.clear();
  goTo(there.value_or(recordOffset_));
  if (!there) cutOff();
}

// Before the first chunk or message nobody knows whether the log has chunks.
std::optional<std::uint64_t> LogReader::nextSound(const LogScan& scan, std::uint64_t from) const {
  if (chunkCounts_.chunks > 0 || !index_.chunks.empty()) return scan.next(from, ScanFor::outside);
  if (!lastTime_)
    if (const auto chunk = scan.next(from, ScanFor::chunks)) return chunk;
  return scan.next(from, ScanFor::any);
}

void LogReader::goTo(std::uint64_t offset) {
  offset_ = offset;
  file_.clear();
  file_.seekg(static_cast<std::streamoff>(offset));
}

void LogReader::seek(TimeUs time) {
  if (!error_.empty()) return;
  if (indexState_ == IndexState::unread)
    indexState_ = readIndex() ? IndexState::read : IndexState::none;
  goTo(indexState_ == IndexState::read ? index_.placeOf(time) : mcap::kMagic.size());
  chunk_.clear();
  chunkAt_ = 0;
  truncated_ = false;
  ended_ = false;
  dataEnded_ = false;
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
    if (spoilt_.empty()) continue;
    spoilt_.clear();  // the log is read without the index
    return false;
  }
  index_.sort();
  return !index_.chunks.empty();
}

void LogReader::cutOff() {
  truncated_ = true;
  ended_ = true;
}

bool LogReader::readRecord(Record& record) {
  inChunk_ = chunkAt_ < chunk_.size();
  if (inChunk_) return readChunkRecord(record);
  before_ = whole_ ? offset_ : recordOffset_;
  whole_ = false;
  recordOffset_ = offset_;
  return readFileRecord(record);
}

bool LogReader::readFileRecord(Record& record) {
  if (offset_ == fileSize_) {
    cutOff();
    return false;
  }
  std::array<std::uint8_t, mcap::kRecordHead> head{};
  file_.read(reinterpret_cast<char*>(head.data()), head.size());
  ContentReader content(head.data() + 1, head.size() - 1);
  const auto length = content.number<std::uint64_t>();
  // Code 0 does not exist: a file system that lost power leaves zeros.
  if (!file_ || head[0] == 0 || length > fileSize_ - offset_ - head.size()) {
    spoil("no record begins there");
    return false;
  }
  growTo(record_, static_cast<std::size_t>(length));
  record_.resize(static_cast<std::size_t>(length));
  file_.read(reinterpret_cast<char*>(record_.data()), static_cast<std::streamsize>(length));
  if (!file_) {
    spoil("cannot be read");
    return false;
  }
  offset_ += head.size() + length;
  record = {static_cast<Op>(head[0]), record_.data(), record_.size()};
  return true;
}

bool LogReader::readChunkRecord(Record& record) {
  ContentReader content(chunk_.data() + chunkAt_, chunk_.size() - chunkAt_);
  record = content.record();
  chunkAt_ = chunk_.size() - content.left();
  if (content.good() && record.op != Op::chunk) return true;
  spoil(content.good() ? "a chunk inside a chunk" : "damaged chunk");
  return false;
}

// True when the record is a message.
bool LogReader::take(const Record& record, LogMessage& message) {
  const ContentReader content(record.data, record.size);
  if (!inChunk_ && record.op != Op::messageIndex && record.op <= Op::dataEnd) strange_ = 0;
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
    case Op::messageIndex: takeMessageIndex(content); break;
    case Op::attachment: takeAttachment(record); break;
    case Op::metadata: takeMetadata(content); break;
    case Op::dataEnd: takeDataEnd(record); break;
    case Op::footer: takeEnd(record); break;
    default: takeOther(record);
  }
}

// Only to find a chunk whose code is damaged: it looks like a record of a kind that came later.
void LogReader::takeMessageIndex(ContentReader content) {
  content.number<std::uint16_t>();  // channel
  content.take(content.number<std::uint32_t>());
  if (strange_ > 0) {
    spoilt_ = "no chunk before the index of its messages";
    addGap(strange_, recordOffset_);
    spoilt_.clear();
    strange_ = 0;
  }
  if (!content.good()) spoil("damaged index");
}

void LogReader::takeDataEnd(const Record& record) {
  if (record.size > kLongestDataEnd) return spoil("damaged record");
  dataEnded_ = true;
}

// Indexes and statistics, and what later versions of MCAP add.
void LogReader::takeOther(const Record& record) {
  if (record.op > Op::dataEnd) {
    strange_ = recordOffset_;
  } else if (!dataEnded_ && (record.op != Op::header || recordOffset_ != mcap::kMagic.size())) {
    spoil("damaged record");
  }
}

void LogReader::takeSchema(ContentReader content) {
  const auto id = content.number<std::uint16_t>();
  LogSchema schema;
  schema.name = content.string();
  schema.encoding = content.string();
  schema.text = content.string();
  if (!content.good()) return spoil("damaged schema record");
  const auto [first, added] = schemas_.emplace(id, schema);
  const LogSchema& known = first->second;
  if (!added &&
      (known.name != schema.name || known.encoding != schema.encoding || known.text != schema.text))
    twice_.insert("schema " + std::to_string(id) + " is defined twice, as " + known.name +
                  " and as another " + schema.name + "; the first counts");
}

void LogReader::takeChannel(ContentReader content) {
  const auto id = content.number<std::uint16_t>();
  LogChannel channel;
  channel.schemaId = content.number<std::uint16_t>();
  channel.topic = content.string();
  channel.messageEncoding = content.string();
  if (!content.good()) return spoil("damaged channel record");
  const auto [first, added] = channels_.emplace(id, channel);
  const LogChannel& known = first->second;
  if (!added && (known.topic != channel.topic || known.schemaId != channel.schemaId ||
                 known.messageEncoding != channel.messageEncoding))
    twice_.insert("channel " + std::to_string(id) + " is defined twice, as " + known.topic +
                  " and as another " + channel.topic + "; the first counts");
}

// Null while its definition, or that of its schema, has not been met.
const LogChannel* LogReader::channelOf(std::uint16_t id) {
  const auto found = channels_.find(id);
  if (found == channels_.end()) return nullptr;
  LogChannel& channel = found->second;
  if (channel.schemaId == 0) channel.schema = &noSchema_;
  const auto schema = schemas_.find(channel.schemaId);
  if (channel.schema == nullptr && schema != schemas_.end()) channel.schema = &schema->second;
  return channel.schema == nullptr ? nullptr : &channel;
}

// Definitions that stood in damaged bytes stand in the summary, too, and in some of the chunks.
void LogReader::harvest() {
  if (!harvests_) return;
  harvests_ = false;
  if (indexState_ == IndexState::unread)
    indexState_ = readIndex() ? IndexState::read : IndexState::none;
  goTo(offset_);
  if (indexState_ == IndexState::read) return;
  auto scout = open(path_);
  if (!scout) return;
  scout->harvests_ = false;
  LogMessage message;
  while (scout->next(message)) {
  }
  schemas_.insert(scout->schemas_.begin(), scout->schemas_.end());
  for (auto [id, channel] : scout->channels_) {
    channel.schema = nullptr;
    channels_.emplace(id, channel);
  }
}

bool LogReader::takeMessage(ContentReader content, LogMessage& message) {
  const auto id = content.number<std::uint16_t>();
  content.number<std::uint32_t>();  // sequence
  const auto logTime = content.number<std::uint64_t>();
  content.number<std::uint64_t>();  // publish time
  const LogChannel* channel = channelOf(id);
  if (channel == nullptr) harvest();
  if (channel == nullptr) channel = channelOf(id);
  if (!content.good() || channel == nullptr) {
    spoil(content.good() ? "message of an unknown channel" : "damaged message record");
    return false;
  }
  message.channel = channel;
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
  // Later versions may add to a record; but what a damaged length adds ends nowhere.
  const bool longer = content.left() > 0;
  if (!content.good() || (longer && (size == 0 || !LogScan(file_, fileSize_).sound(offset_))))
    return spoil("damaged chunk");
  goTo(offset_);
  unpack(compression, stored, length, size);
  if (spoilt_.empty() && checksum != 0 && checksum != crc32(chunk_.data(), chunk_.size()))
    spoil("damaged chunk: wrong checksum");
  if (!spoilt_.empty() || !error_.empty()) return chunk_.clear();
  whole_ = checksum != 0 && !longer;
  chunkAt_ = 0;
  chunkCounts_.compression = compression;
  ++chunkCounts_.chunks;
  chunkCounts_.stored += length;
  chunkCounts_.held += size;
}

// Fills chunk_ with the `size` bytes of records that `length` bytes hold.
void LogReader::unpack(const std::string& compression, const std::uint8_t* stored,
                       std::uint64_t length, std::uint64_t size) {
  const std::string says = "damaged chunk: says that it holds " + std::to_string(size) + " bytes";
  if (size > kMaxChunk) return spoil(says);
  if (compression.empty()) {
    if (size != length) return spoil(says + ", has " + std::to_string(length));
    growTo(chunk_, static_cast<std::size_t>(length));
    chunk_.assign(stored, stored + length);
    return;
  }
  if (!decompressor_ || decompresses_ != compression) decompressor_ = makeDecompressor(compression);
  if (!decompressor_ && isCompression(compression))
    return fail("compressed with " + compression + ", which we cannot read");
  if (!decompressor_) return spoil("damaged chunk: compressed in no known way");
  decompresses_ = compression;
  const Status done = decompressor_->decompress(stored, static_cast<std::size_t>(length),
                                                static_cast<std::size_t>(size), chunk_);
  if (!done) spoil("damaged chunk: " + done.error());
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
  if (!content.good()) return spoil("damaged attachment record");
  if (checksum != 0 && checksum != crc32(record.data, covered))
    return spoil("attachment " + attachment.name + ": wrong checksum");
  if (met_.insert(recordOffset_).second) attachments_.push_back(std::move(attachment));
}

void LogReader::takeMetadata(ContentReader content) {
  LogMetadata metadata;
  metadata.name = content.string();
  metadata.entries = content.map();
  if (!content.good()) return spoil("damaged metadata record");
  if (met_.insert(recordOffset_).second) metadata_.push_back(std::move(metadata));
}

// The magic behind the footer is the end of the file.
void LogReader::takeEnd(const Record& record) {
  std::array<std::uint8_t, mcap::kMagic.size()> magic{};
  const bool whole = record.size >= mcap::kFooter && offset_ + magic.size() == fileSize_ &&
                     readAt(file_, offset_, magic.data(), magic.size()) && magic == mcap::kMagic;
  if (!whole && !dataEnded_) return spoil("damaged record");
  if (!whole) return cutOff();
  ended_ = true;
  offset_ += magic.size();
}

std::string LogReader::lacks() const {
  constexpr std::size_t kShown = 2;
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, gaps_.size()); ++i)
    text += (i > 0 ? ", and " : "") + gaps_[i].text();
  if (gaps_.size() > kShown)
    text += ", and " + std::to_string(gaps_.size() - kShown) + " more damaged places";
  if (!truncated_) return text;
  return text + (text.empty() ? "" : ", and ") + "cut off at byte " + std::to_string(offset_) +
         (lastTime_ ? ", " + secondsText(*lastTime_) + " s" : "") + "; " +
         (gaps_.empty() ? "whole up to there" : "the rest is whole up to there");
}

std::string LogGap::text() const {
  std::string lost = "nothing of it was read";
  if (last && following)
    lost =
        "what was between " + secondsText(*last) + " and " + secondsText(*following) + " s is lost";
  else if (last)
    lost = "what was after " + secondsText(*last) + " s is lost";
  else if (following)
    lost = "what was before " + secondsText(*following) + " s is lost";
  return "bytes " + std::to_string(from) + " to " + std::to_string(to) + ": " + what + "; " + lost;
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
  std::vector<std::string> notes(twice_.begin(), twice_.end());
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
