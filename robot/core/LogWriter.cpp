// SPDX-License-Identifier: Apache-2.0
#include "robot/core/LogWriter.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

namespace kelpie {
namespace {

using mcap::Op;
using mcap::RecordWriter;

// The container counts nanoseconds from 0 up; the message itself keeps the exact stamp.
std::uint64_t nanoseconds(TimeUs time) {
  return time.us > 0 ? static_cast<std::uint64_t>(time.us) * 1000 : 0;
}

void append(std::vector<std::uint8_t>& to, const std::vector<std::uint8_t>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

Expected<LogWriter> LogWriter::open(const std::string& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return Error{path + ": " + std::strerror(errno)};
  LogWriter writer(path, file);
  RecordWriter record(writer.buffer_);
  record.bytes(mcap::kMagic.data(), mcap::kMagic.size());
  record.begin(Op::header);
  record.string("ros1");
  record.string("kelpie");
  record.end();
  writer.flush();
  if (!writer.error_.empty()) return Error{writer.error_};
  return Expected<LogWriter>(std::move(writer));
}

LogWriter::LogWriter(std::string path, int file) : path_(std::move(path)), file_(file) {}

LogWriter::LogWriter(LogWriter&& other) noexcept : LogWriter(std::string(), -1) {
  *this = std::move(other);
}

LogWriter& LogWriter::operator=(LogWriter&& other) noexcept {
  if (this == &other) return *this;
  close();
  path_ = std::move(other.path_);
  file_ = std::exchange(other.file_, -1);
  bytes_ = other.bytes_;
  error_ = std::move(other.error_);
  channels_ = std::move(other.channels_);
  schemas_ = std::move(other.schemas_);
  buffer_ = std::move(other.buffer_);
  schemaRecords_ = std::move(other.schemaRecords_);
  channelRecords_ = std::move(other.channelRecords_);
  attachmentIndexes_ = std::move(other.attachmentIndexes_);
  metadataIndexes_ = std::move(other.metadataIndexes_);
  attachments_ = other.attachments_;
  metadata_ = other.metadata_;
  messages_ = other.messages_;
  firstTime_ = other.firstTime_;
  lastTime_ = other.lastTime_;
  return *this;
}

LogWriter::~LogWriter() { close(); }

void LogWriter::fail(const std::string& what) {
  if (!error_.empty()) return;
  error_ = path_ + ": byte " + std::to_string(bytes_) + ": " + what;
}

Status LogWriter::status() const {
  if (!error_.empty()) return Error{error_};
  return Done{};
}

// On an error the file is cut back to its last whole record.
void LogWriter::flush() {
  if (file_ < 0 || !error_.empty()) return;
  std::size_t done = 0;
  while (done < buffer_.size()) {
    const ssize_t count = ::write(file_, buffer_.data() + done, buffer_.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      fail(std::string("cannot write the log: ") + std::strerror(errno));
      if (::ftruncate(file_, static_cast<off_t>(bytes_)) != 0) return;  // the reader copes
      return;
    }
    done += static_cast<std::size_t>(count);
  }
  bytes_ += buffer_.size();
  buffer_.clear();
}

std::uint16_t LogWriter::schemaId(SchemaOf schema) {
  const std::string name = schema.name();
  const auto found = std::find(schemas_.begin(), schemas_.end(), name);
  const auto id = static_cast<std::uint16_t>(found - schemas_.begin() + 1);
  if (found != schemas_.end()) return id;
  schemas_.push_back(name);
  const std::size_t start = buffer_.size();
  RecordWriter record(buffer_);
  record.begin(Op::schema);
  record.number(id);
  record.string(name);
  record.string("ros1msg");
  record.string(schema.text());
  record.end();
  schemaRecords_.insert(schemaRecords_.end(), buffer_.begin() + static_cast<long>(start),
                        buffer_.end());
  return id;
}

LogWriter::Channel* LogWriter::channelFor(std::string_view topic, SchemaOf schema) {
  if (file_ < 0 || !error_.empty()) return nullptr;
  for (Channel& channel : channels_) {
    if (channel.topic != topic) continue;
    if (channel.schema.text == schema.text) return &channel;
    fail("topic " + channel.topic + " holds " + channel.schema.name() + ", not " + schema.name());
    return nullptr;
  }
  const std::uint16_t schemaNumber = schemaId(schema);
  channels_.push_back(
      {std::string(topic), schema, static_cast<std::uint16_t>(channels_.size() + 1), 0});
  const std::size_t start = buffer_.size();
  RecordWriter record(buffer_);
  record.begin(Op::channel);
  record.number(channels_.back().id);
  record.number(schemaNumber);
  record.string(topic);
  record.string("ros1");
  record.map({});
  record.end();
  channelRecords_.insert(channelRecords_.end(), buffer_.begin() + static_cast<long>(start),
                         buffer_.end());
  return &channels_.back();
}

std::size_t LogWriter::beginMessage(const Channel& channel, TimeUs time) {
  const std::size_t start = buffer_.size();
  RecordWriter record(buffer_);
  record.begin(Op::message);
  record.number(channel.id);
  record.number(channel.messages);
  record.number(nanoseconds(time));
  record.number(nanoseconds(time));
  return start;
}

void LogWriter::endMessage(Channel& channel, std::size_t start, TimeUs time) {
  const std::uint64_t length = buffer_.size() - start - mcap::kRecordHead;
  std::memcpy(buffer_.data() + start + 1, &length, sizeof length);
  flush();
  if (!error_.empty()) return;
  const std::uint64_t stamp = nanoseconds(time);
  firstTime_ = messages_ == 0 ? stamp : std::min(firstTime_, stamp);
  lastTime_ = std::max(lastTime_, stamp);
  ++channel.messages;
  ++messages_;
}

void LogWriter::metadata(const std::string& name, const LogMap& entries) {
  const std::uint64_t offset = bytes_;
  buffer_.clear();
  RecordWriter record(buffer_);
  record.begin(Op::metadata);
  record.string(name);
  record.map(entries);
  record.end();
  const std::uint64_t size = buffer_.size();
  flush();
  if (file_ < 0 || !error_.empty()) return;
  ++metadata_;
  RecordWriter index(metadataIndexes_);
  index.begin(Op::metadataIndex);
  index.number(offset);
  index.number(size);
  index.string(name);
  index.end();
}

void LogWriter::attachment(const std::string& name, const std::string& mediaType,
                           const std::vector<std::uint8_t>& data) {
  const std::uint64_t offset = bytes_;
  buffer_.clear();
  RecordWriter record(buffer_);
  record.begin(Op::attachment);
  record.number(lastTime_);
  record.number(lastTime_);
  record.string(name);
  record.string(mediaType);
  record.number(static_cast<std::uint64_t>(data.size()));
  record.bytes(data.data(), data.size());
  const std::size_t start = record.contentStart();
  record.number(mcap::crc32(buffer_.data() + start, buffer_.size() - start));
  record.end();
  const std::uint64_t size = buffer_.size();
  flush();
  if (file_ < 0 || !error_.empty()) return;
  ++attachments_;
  RecordWriter index(attachmentIndexes_);
  index.begin(Op::attachmentIndex);
  for (const std::uint64_t value : {offset, size, lastTime_, lastTime_}) index.number(value);
  index.number(static_cast<std::uint64_t>(data.size()));
  index.string(name);
  index.string(mediaType);
  index.end();
}

void LogWriter::addStatistics(std::vector<std::uint8_t>& out) const {
  RecordWriter record(out);
  record.begin(Op::statistics);
  record.number(messages_);
  record.number(static_cast<std::uint16_t>(schemas_.size()));
  record.number(static_cast<std::uint32_t>(channels_.size()));
  record.number(attachments_);
  record.number(metadata_);
  record.number(std::uint32_t{0});  // chunks
  record.number(firstTime_);
  record.number(lastTime_);
  record.number(static_cast<std::uint32_t>(channels_.size() * 10));  // bytes of the map
  for (const Channel& channel : channels_) {
    record.number(channel.id);
    record.number(static_cast<std::uint64_t>(channel.messages));
  }
  record.end();
}

void LogWriter::writeSummary() {
  buffer_.clear();
  RecordWriter record(buffer_);
  record.begin(Op::dataEnd);
  record.number(std::uint32_t{0});  // no checksum
  record.end();
  const std::uint64_t summary = bytes_ + buffer_.size();
  append(buffer_, schemaRecords_);
  append(buffer_, channelRecords_);
  addStatistics(buffer_);
  append(buffer_, attachmentIndexes_);
  append(buffer_, metadataIndexes_);
  record.begin(Op::footer);
  record.number(summary);
  record.number(std::uint64_t{0});  // no summary offsets
  record.number(std::uint32_t{0});  // no checksum
  record.end();
  record.bytes(mcap::kMagic.data(), mcap::kMagic.size());
  flush();
}

Status LogWriter::close() {
  if (file_ < 0) return status();
  if (error_.empty()) writeSummary();
  if (::close(file_) != 0) fail(std::strerror(errno));
  file_ = -1;
  return status();
}

}  // namespace kelpie
