// SPDX-License-Identifier: Apache-2.0
// Time stamps come from the robot (or the simulated world) only; no stage reads a clock.
#pragma once

#include <cstdint>

namespace kelpie {

struct TimeUs {
  std::int64_t us = 0;

  double seconds() const { return static_cast<double>(us) * 1e-6; }
  static TimeUs fromSeconds(double s) { return {static_cast<std::int64_t>(s * 1e6 + 0.5)}; }
  bool operator==(TimeUs o) const { return us == o.us; }
  bool operator<(TimeUs o) const { return us < o.us; }
  bool operator<=(TimeUs o) const { return us <= o.us; }
};

inline TimeUs operator+(TimeUs a, TimeUs b) { return {a.us + b.us}; }
inline TimeUs operator-(TimeUs a, TimeUs b) { return {a.us - b.us}; }

constexpr double kFrameSeconds = 1.0 / 30.0;  // camera frame
constexpr double kTickSeconds = 0.008;        // joint and sensor tick
constexpr int kTicksPerMessage = 4;           // ticks in one sensor or command vector
constexpr std::int64_t kTickUs = 8000;
constexpr std::int64_t kExposureUs = 33333;  // of one image, from the first column to the last

}  // namespace kelpie
