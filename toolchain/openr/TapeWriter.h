// SPDX-License-Identifier: Apache-2.0
// A tape that toolchain/emulate plays to the emulated image: per record one byte of kind, length of
// input and of output as little-endian 32-bit numbers, the input, the output. Kinds, with what is
// answered:
//   c  AgentConfig: the stages begin         s  AgentConfig: the loops begin, with a fresh image
//   f  FrameInput, FrameOutput               p  PowerReport
//   m  MotionInput, MotionOutput             n  MotionInput without its command, Answer
//                                            i  Moment, FrameOutput
#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "robot/core/fields/Encoding.h"

namespace kelpie::tape {

class TapeWriter {
 public:
  explicit TapeWriter(const std::string& path) : file_(path, std::ios::binary) {}

  template <class In, class Out>
  void put(char kind, const In& input, const Out& output) {
    encoded(input, input_);
    encoded(output, output_);
    record(kind);
  }
  // Nothing is answered to it.
  template <class In>
  void put(char kind, const In& input) {
    encoded(input, input_);
    output_.clear();
    record(kind);
  }
  bool close() {
    file_.close();
    return file_.good();
  }

 private:
  template <class T>
  static void encoded(const T& value, std::vector<std::uint8_t>& bytes) {
    bytes.clear();
    encode(value, bytes);
  }
  void record(char kind) {
    file_.put(kind);
    number(input_.size());
    number(output_.size());
    bytes(input_);
    bytes(output_);
  }
  void number(std::size_t value) {
    for (unsigned shift = 0; shift < 32; shift += 8)
      file_.put(static_cast<char>((value >> shift) & 0xffU));
  }
  void bytes(const std::vector<std::uint8_t>& data) {
    file_.write(reinterpret_cast<const char*>(data.data()),
                static_cast<std::streamsize>(data.size()));
  }

  std::ofstream file_;
  std::vector<std::uint8_t> input_;
  std::vector<std::uint8_t> output_;
};

}  // namespace kelpie::tape
