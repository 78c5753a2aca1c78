// SPDX-License-Identifier: Apache-2.0
#include "robot/stick/PieceReader.h"

#include <algorithm>

namespace kelpie::stick {

bool PieceReader::open(const char* path) {
  at_ = 0;
  filled_ = 0;
  hash_ = {};
  startPart();
  fault_ = StickFault::none;
  return files_.open(path) || fail(StickFault::missing);
}

void PieceReader::startPart() {
  crc_ = {};
  partBytes_ = 0;
}

bool PieceReader::fail(StickFault fault) {
  if (fault_ == StickFault::none) fault_ = fault;
  return false;
}

// False at the end, and on an error, which is then the fault.
bool PieceReader::refill() {
  const std::int32_t got = files_.read(piece_.data(), piece_.size());
  at_ = 0;
  filled_ = got > 0 ? static_cast<std::size_t>(got) : 0;
  if (got < 0) return fail(StickFault::unreadable);
  return got > 0;
}

bool PieceReader::take(void* to, std::size_t count) {
  auto* next = static_cast<std::uint8_t*>(to);
  while (count > 0) {
    if (at_ == filled_ && !refill()) return fail(StickFault::cutShort);
    const std::size_t now = std::min(count, filled_ - at_);
    const std::uint8_t* from = piece_.data() + at_;
    if (next != nullptr) {
      std::memcpy(next, from, now);
      next += now;
    }
    crc_.add(from, now);
    hash_.add(from, now);
    at_ += now;
    partBytes_ += static_cast<std::uint32_t>(now);
    count -= now;
  }
  return true;
}

bool PieceReader::skip(std::uint32_t count) { return take(nullptr, count); }

bool PieceReader::atEnd() {
  if (fault_ != StickFault::none) return false;
  if (at_ < filled_ || refill()) return fail(StickFault::tooLong);
  return fault_ == StickFault::none;
}

}  // namespace kelpie::stick
