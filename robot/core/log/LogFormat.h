// SPDX-License-Identifier: Apache-2.0
// The parts of the MCAP container that writer and reader share (mcap.dev/spec): the magic, record
// codes, and little-endian numbers, strings and maps inside a record. A record is one code byte,
// eight bytes of length and that many bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace kelpie {

using LogMap = std::map<std::string, std::string>;

namespace mcap {

constexpr std::array<std::uint8_t, 8> kMagic = {0x89, 'M', 'C', 'A', 'P', 0x30, '\r', '\n'};
constexpr std::size_t kRecordHead = 9;    // code and length
constexpr std::size_t kMessageHead = 22;  // channel, sequence, log time, publish time
constexpr std::size_t kFooter = 20;       // where the summary and its offsets start, checksum

enum class Op : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  messageIndex = 0x07,
  chunkIndex = 0x08,
  attachment = 0x09,
  attachmentIndex = 0x0a,
  statistics = 0x0b,
  metadata = 0x0c,
  metadataIndex = 0x0d,
  summaryOffset = 0x0e,
  dataEnd = 0x0f,
};

// Appends records to a buffer.
class RecordWriter {
 public:
  explicit RecordWriter(std::vector<std::uint8_t>& out) : out_(out) {}

  void begin(Op op) {
    number(op);
    number(std::uint64_t{0});
    start_ = out_.size();
  }
  // Fills in the length.
  void end() {
    const std::uint64_t length = out_.size() - start_;
    std::memcpy(out_.data() + start_ - sizeof length, &length, sizeof length);
  }
  std::size_t contentStart() const { return start_; }

  template <class T>
  void number(T value) {
    bytes(&value, sizeof value);
  }
  void string(std::string_view text) {
    number(static_cast<std::uint32_t>(text.size()));
    bytes(text.data(), text.size());
  }
  void map(const LogMap& entries);
  void bytes(const void* from, std::size_t count) {
    const auto* first = static_cast<const std::uint8_t*>(from);
    out_.insert(out_.end(), first, first + count);
  }

 private:
  std::vector<std::uint8_t>& out_;
  std::size_t start_ = 0;
};

struct Record {
  Op op{};
  const std::uint8_t* data = nullptr;
  std::size_t size = 0;
};

// Takes a record's content, or records one behind the other, apart. Past the end everything is 0 or
// empty and good() is false.
class ContentReader {
 public:
  ContentReader(const std::uint8_t* data, std::size_t size) : at_(data), left_(size) {}

  bool good() const { return good_; }
  const std::uint8_t* data() const { return at_; }
  std::size_t left() const { return left_; }

  template <class T>
  T number() {
    T value{};
    if (const std::uint8_t* from = take(sizeof value)) std::memcpy(&value, from, sizeof value);
    return value;
  }
  std::string string() {
    const std::size_t size = number<std::uint32_t>();
    const std::uint8_t* from = take(size);
    return from == nullptr ? std::string() : std::string(from, from + size);
  }
  LogMap map();
  Record record() {
    Record record;
    record.op = number<Op>();
    const auto length = number<std::uint64_t>();
    record.data = take(length);
    record.size = record.data == nullptr ? 0 : static_cast<std::size_t>(length);
    return record;
  }
  // nullptr when fewer are left.
  const std::uint8_t* take(std::uint64_t count) {
    if (count > left_) good_ = false;
    if (!good_) return nullptr;
    const std::uint8_t* from = at_;
    at_ += count;
    left_ -= static_cast<std::size_t>(count);
    return from;
  }

 private:
  const std::uint8_t* at_;
  std::size_t left_;
  bool good_ = true;
};

}  // namespace mcap
}  // namespace kelpie
