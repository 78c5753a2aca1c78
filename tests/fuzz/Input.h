// SPDX-License-Identifier: Apache-2.0
// What a fuzz target does with the bytes that libFuzzer gives it: take them apart, put them into a
// file, lay them over a sound one. require() ends the program, which is libFuzzer's finding.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace kelpie::fuzz {

using Bytes = std::vector<std::uint8_t>;

inline void require(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what.c_str());
  std::abort();
}

// From front to back; what is beyond the end is 0.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : at_(data), left_(size) {}

  std::size_t left() const { return left_; }
  std::uint8_t byte() {
    if (left_ == 0) return 0;
    --left_;
    return *at_++;
  }
  std::uint32_t number(int bytes) {
    std::uint32_t value = 0;
    for (int i = 0; i < bytes; ++i) value = value << 8U | byte();
    return value;
  }
  Bytes take(std::size_t count) {
    const std::size_t given = std::min(count, left_);
    const Bytes bytes(at_, at_ + given);
    at_ += given;
    left_ -= given;
    return bytes;
  }
  Bytes rest() { return take(left_); }

 private:
  const std::uint8_t* at_;
  std::size_t left_;
};

inline std::string textOf(const Bytes& bytes) { return {bytes.begin(), bytes.end()}; }

// Sound bytes with others laid over them, for formats too large to be found byte by byte: the input
// is places (three bytes), lengths (one) and what comes there.
inline void layOver(Input& input, Bytes& bytes) {
  while (input.left() > 4 && !bytes.empty()) {
    std::size_t at = input.number(3) % bytes.size();
    for (const std::uint8_t byte : input.take(std::size_t{input.byte()} + 1))
      if (at < bytes.size()) bytes[at++] = byte;
  }
}

// Where this process may write, in memory if there is such a place.
inline std::string placeOf(const std::string& name) {
  static const std::string kFolder = access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp";
  return kFolder + "/kelpie-fuzz-" + std::to_string(getpid()) + name;
}

// A file of those bytes while the object lives.
class File {
 public:
  explicit File(const Bytes& bytes, const std::string& ending = "") : name_(placeOf(ending)) {
    std::FILE* const file = std::fopen(name_.c_str(), "wb");
    require(file != nullptr && std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size(),
            name_ + " can be written");
    std::fclose(file);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() { std::remove(name_.c_str()); }

  const std::string& name() const { return name_; }

 private:
  std::string name_;
};

// A refusal is one line that begins with the file's name.
inline void requireLine(const std::string& error, const std::string& file) {
  require(error.compare(0, file.size(), file) == 0, "an error begins with the file: " + error);
  require(error.find('\n') == std::string::npos, "an error is one line: " + error);
}

}  // namespace kelpie::fuzz
