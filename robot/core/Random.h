// SPDX-License-Identifier: Apache-2.0
// Seeded random numbers, the same on every machine: xoshiro256** (Blackman and Vigna, 2018) seeded
// by splitmix64. A generator is a member of the state that uses it; nobody shares one.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "robot/core/Maths.h"

namespace kelpie {

class Random {
 public:
  explicit Random(std::uint64_t seed = 1) {
    for (auto& word : state_) word = splitMix(seed);
  }

  std::uint64_t next() {
    const std::uint64_t result = rotated(state_[1] * 5, 7) * 9;
    const std::uint64_t t = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= t;
    state_[3] = rotated(state_[3], 45);
    return result;
  }

  // Uniform in [0, 1).
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  // Uniform in 0 .. count - 1, count >= 1; the bias is below 2^-32 for the counts in use.
  std::uint32_t index(std::uint32_t count) {
    return static_cast<std::uint32_t>(((next() >> 32) * count) >> 32);
  }
  bool chance(double probability) { return uniform() < probability; }
  // Normal with mean 0 and standard deviation 1 (Box and Muller; the second value is dropped so
  // that the state stays four words).
  double gaussian() {
    const double u = 1.0 - uniform();
    return std::sqrt(-2.0 * maths::log(u)) * maths::cos(2.0 * maths::kPi * uniform());
  }
  double gaussian(double mean, double sd) { return mean + sd * gaussian(); }

 private:
  static std::uint64_t rotated(std::uint64_t x, int k) { return (x << k) | (x >> (64 - k)); }
  static std::uint64_t splitMix(std::uint64_t& seed) {
    seed += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = seed;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }

  std::array<std::uint64_t, 4> state_{};
};

}  // namespace kelpie
