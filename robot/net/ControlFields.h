// SPDX-License-Identifier: Apache-2.0
// How the fields of a game controller's packet are read, whatever its version: bytes in their
// order, little endian, and what cannot be brought to the nearest that can. There are as many bytes
// as are asked for; who calls has compared the size.
#pragma once

#include <algorithm>
#include <array>

#include "robot/net/ControlTypes.h"

namespace kelpie::net {

class ControlBytes {
 public:
  explicit ControlBytes(const std::uint8_t* bytes) : at_(bytes) {}

  std::uint8_t byte() { return *at_++; }
  std::uint16_t half() {
    const std::uint16_t low = byte();
    return static_cast<std::uint16_t>(low | (byte() << 8U));
  }
  std::uint32_t word() {
    const std::uint32_t low = half();
    return low | (static_cast<std::uint32_t>(half()) << 16U);
  }
  void skip(std::size_t bytes) { at_ += bytes; }

 private:
  const std::uint8_t* at_;
};

constexpr std::int32_t kLongestHalf = 86400;     // s
constexpr std::uint32_t kLongestPenalty = 3600;  // s
constexpr std::uint32_t kHighestScore = 255;

// A half that has run over counts 0.
inline std::uint32_t secondsFrom(std::int32_t reported) {
  return static_cast<std::uint32_t>(std::clamp(reported, 0, kLongestHalf));
}

inline TeamColour otherThan(TeamColour team) {
  return team == TeamColour::red ? TeamColour::blue : TeamColour::red;
}

// Blue is 0 and red 1 in all versions; later ones have more, which no robot of four legs wears.
inline void setColours(std::array<std::uint32_t, 2> reported, GameControlData& control) {
  const bool firstIsRed = (reported[0] == 1) != (reported[1] == 1)
                              ? reported[0] == 1
                              : reported[1] == 0 && reported[0] != 0;
  control.coloursGiven = reported[0] != reported[1] && (reported[0] <= 1 || reported[1] <= 1);
  control.teams[0].colour = firstIsRed ? TeamColour::red : TeamColour::blue;
  control.teams[1].colour = otherThan(control.teams[0].colour);
}

}  // namespace kelpie::net
