// SPDX-License-Identifier: Apache-2.0
#include "robot/core/log/LogWriter.h"

#include <algorithm>
#include <utility>

#include "robot/core/Checksum.h"

namespace kelpie {
namespace {

using mcap::Op;
using mcap::RecordWriter;

// A channel is defined anew once in so many chunks. Definitions would take 5 KB of each chunk of
// 13 KB of a log of class planes.
constexpr std::uint32_t kDefinitionsEvery = 16;

// The container counts nanoseconds from 0 up; the message itself keeps the exact stamp.
std::uint64_t nanoseconds(TimeUs time) {
  return time.us > 0 ? static_cast<std::uint64_t>(time.us) * 1000 : 0;
}

}  // namespace

Expected<LogWriter> LogWriter::open(const std::string& path, const LogOptions& options,
                                    std::string_view profile) {
  std::unique_ptr<ChunkCompressor> compressor;
  if (options.chunks && !options.compression.empty()) {
    compressor = makeCompressor(options.compression);
    if (compressor == nullptr) return Error{path + ": no compressor for " + options.compression};
  }
  auto output = LogOutput::open(path);
  if (!output) return Error{output.error()};
  LogWriter writer(std::move(*output), options, std::move(compressor));
  RecordWriter record(writer.buffer_);
  record.bytes(mcap::kMagic.data(), mcap::kMagic.size());
  record.begin(Op::header);
  record.string(profile);
  record.string("kelpie");
  record.end();
  writer.output_.write(writer.buffer_);
  const Status started = writer.status();
  if (!started) return Error{started.error()};
  return Expected<LogWriter>(std::move(writer));
}

LogWriter::LogWriter(LogOutput output, LogOptions options,
                     std::unique_ptr<ChunkCompressor> compressor)
    : output_(std::move(output)),
      options_(std::move(options)),
      compressor_(std::move(compressor)) {}

LogWriter& LogWriter::operator=(LogWriter&& other) noexcept {
  if (this == &other) return *this;
  close();
  output_ = std::move(other.output_);
  options_ = std::move(other.options_);
  compressor_ = std::move(other.compressor_);
  chunk_ = std::move(other.chunk_);
  packing_ = std::move(other.packing_);
  summary_ = std::move(other.summary_);
  channels_ = std::move(other.channels_);
  schemas_ = std::move(other.schemas_);
  chunkNumber_ = other.chunkNumber_;
  buffer_ = std::move(other.buffer_);
  return *this;
}

LogWriter::~LogWriter() { close(); }

// 0: not in the log yet.
std::uint16_t LogWriter::schemaId(const std::string& name) const {
  const auto found = std::find_if(schemas_.begin(), schemas_.end(),
                                  [&](const Schema& known) { return known.name == name; });
  return found == schemas_.end() ? 0 : static_cast<std::uint16_t>(found - schemas_.begin() + 1);
}

std::uint16_t LogWriter::addSchema(const std::string& name, std::string_view encoding,
                                   std::string_view text) {
  const auto id = static_cast<std::uint16_t>(schemas_.size() + 1);
  schemas_.push_back({name, {}});
  std::vector<std::uint8_t>& bytes = schemas_.back().record;
  RecordWriter record(bytes);
  record.begin(Op::schema);
  record.number(id);
  record.string(name);
  record.string(encoding);
  record.string(text);
  record.end();
  ++summary_.schemaCount;
  summary_.schemas.insert(summary_.schemas.end(), bytes.begin(), bytes.end());
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
  return id;
}

const LogWriter::Channel& LogWriter::addChannel(std::string_view topic, SchemaOf schema,
                                                std::uint16_t schemaNumber,
                                                std::string_view encoding) {
  const auto id = static_cast<std::uint16_t>(channels_.size() + 1);
  std::vector<std::uint8_t> bytes;
  RecordWriter record(bytes);
  record.begin(Op::channel);
  record.number(id);
  record.number(schemaNumber);
  record.string(topic);
  record.string(encoding);
  record.map({});
  record.end();
  summary_.messageCounts.push_back(0);
  summary_.channels.insert(summary_.channels.end(), bytes.begin(), bytes.end());
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
  const auto& schemaRecord = schemas_[schemaNumber - 1U].record;
  bytes.insert(bytes.begin(), schemaRecord.begin(), schemaRecord.end());
  channels_.push_back(
      {std::string(topic), schema, id, schemaNumber, std::move(bytes), chunkNumber_});
  return channels_.back();
}

const LogWriter::Channel* LogWriter::refuse(const Channel& channel, const std::string& name) {
  flush();
  output_.fail("topic " + channel.topic + " holds " + schemas_[channel.schemaId - 1U].name +
               ", not " + name);
  return nullptr;
}

const LogWriter::Channel* LogWriter::channelFor(std::string_view topic, SchemaOf schema) {
  if (!output_.good()) return nullptr;
  for (const Channel& channel : channels_) {
    if (channel.topic != topic) continue;
    return channel.schema.text == schema.text ? &channel : refuse(channel, schema.name());
  }
  const std::string name = schema.name();
  const std::uint16_t known = schemaId(name);
  const std::uint16_t id = known != 0 ? known : addSchema(name, "ros1msg", schema.text());
  return &addChannel(topic, schema, id, "ros1");
}

const LogWriter::Channel* LogWriter::channelFor(std::string_view topic, const ReadyType& type) {
  if (!output_.good()) return nullptr;
  for (const Channel& channel : channels_) {
    if (channel.topic != topic) continue;
    const bool same =
        channel.schema.text == nullptr && schemas_[channel.schemaId - 1U].name == type.name;
    return same ? &channel : refuse(channel, type.name);
  }
  const std::uint16_t known = schemaId(type.name);
  const std::uint16_t id =
      known != 0 ? known : addSchema(type.name, type.schemaEncoding, type.schema);
  return &addChannel(topic, {nullptr, nullptr}, id, type.messageEncoding);
}

void LogWriter::write(std::string_view topic, TimeUs time, const ReadyType& type,
                      const std::string& bytes) {
  buffer_.clear();
  const Channel* channel = channelFor(topic, type);
  if (channel == nullptr) return;
  const std::size_t start = beginMessage(*channel, time);
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
  endMessage(*channel, start, time);
}

std::size_t LogWriter::beginMessage(const Channel& channel, TimeUs time) {
  const std::size_t start = buffer_.size();
  RecordWriter record(buffer_);
  record.begin(Op::message);
  record.number(channel.id);
  record.number(summary_.messageCounts[channel.id - 1U]);  // sequence
  record.number(nanoseconds(time));
  record.number(nanoseconds(time));
  return start;
}

void LogWriter::endMessage(const Channel& channel, std::size_t start, TimeUs time) {
  const std::uint64_t length = buffer_.size() - start - mcap::kRecordHead;
  std::memcpy(buffer_.data() + start + 1, &length, sizeof length);
  const std::uint64_t stamp = nanoseconds(time);
  if (options_.chunks) {
    gather(channels_[channel.id - 1U], start, stamp);
  } else {
    output_.write(buffer_);
  }
  if (output_.good()) summary_.count(channel.id, stamp);
}

void LogWriter::gather(Channel& channel, std::size_t start, std::uint64_t time) {
  if (chunk_.spanWith(time) >= nanoseconds({options_.chunkUs})) closeChunk();
  if (channel.definedIn / kDefinitionsEvery != chunkNumber_ / kDefinitionsEvery) {
    buffer_.insert(buffer_.begin(), channel.definition.begin(), channel.definition.end());
    start += channel.definition.size();
    channel.definedIn = chunkNumber_;
  }
  chunk_.add(buffer_, start, channel.id, time);
  if (chunk_.records().size() >= options_.chunkBytes) closeChunk();
  if (compressor_ && !packing_.empty() && compressor_->ready()) writeChunk();
}

// The chunk goes to be compressed, and to the file when that is done. Should the one before not be
// done yet, this waits for it: the log never holds more than two chunks in memory.
void LogWriter::closeChunk() {
  if (!output_.good() || chunk_.empty()) return;
  writeChunk();
  ++chunkNumber_;
  std::swap(chunk_, packing_);
  packing_.seal();
  if (compressor_) {
    compressor_->start(packing_.records());
  } else {
    writeChunk();
  }
}

void LogWriter::writeChunk() {
  if (packing_.empty()) return;
  const Status packed = compressor_ ? compressor_->finish(packing_.records()) : Status(Done{});
  if (!packed) output_.fail(packed.error());
  std::vector<std::uint8_t> records;
  packing_.write(options_.compression, output_.bytes(), records, summary_.chunkIndexes);
  output_.write(records);
  ++summary_.chunkCount;
  packing_.clear();
}

void LogWriter::flush() {
  closeChunk();
  writeChunk();
}

void LogWriter::metadata(const std::string& name, const LogMap& entries) {
  writeChunk();
  const std::uint64_t offset = output_.bytes();
  buffer_.clear();
  RecordWriter record(buffer_);
  record.begin(Op::metadata);
  record.string(name);
  record.map(entries);
  record.end();
  const std::uint64_t size = buffer_.size();
  output_.write(buffer_);
  if (!output_.good()) return;
  ++summary_.metadataCount;
  RecordWriter index(summary_.metadataIndexes);
  index.begin(Op::metadataIndex);
  index.number(offset);
  index.number(size);
  index.string(name);
  index.end();
}

void LogWriter::attachment(const std::string& name, const std::string& mediaType,
                           const std::vector<std::uint8_t>& data) {
  writeChunk();
  const std::uint64_t offset = output_.bytes();
  buffer_.clear();
  RecordWriter record(buffer_);
  record.begin(Op::attachment);
  record.number(summary_.lastTime);
  record.number(summary_.lastTime);
  record.string(name);
  record.string(mediaType);
  record.number(static_cast<std::uint64_t>(data.size()));
  record.bytes(data.data(), data.size());
  const std::size_t start = record.contentStart();
  record.number(crc32(buffer_.data() + start, buffer_.size() - start));
  record.end();
  const std::uint64_t size = buffer_.size();
  output_.write(buffer_);
  if (!output_.good()) return;
  ++summary_.attachmentCount;
  RecordWriter index(summary_.attachmentIndexes);
  index.begin(Op::attachmentIndex);
  for (const std::uint64_t value : {offset, size, summary_.lastTime, summary_.lastTime})
    index.number(value);
  index.number(static_cast<std::uint64_t>(data.size()));
  index.string(name);
  index.string(mediaType);
  index.end();
}

Status LogWriter::close() {
  if (!output_.isOpen()) return status();
  flush();
  if (output_.good()) output_.write(summary_.end(output_.bytes()));
  output_.close();
  return status();
}

}  // namespace kelpie
