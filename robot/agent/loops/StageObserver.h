// SPDX-License-Identifier: Apache-2.0
// Called when a stage begins and ends, so that a bench can count what each stage costs. The loops
// do not read a clock themselves.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace kelpie::agent {

enum class Stage : std::uint8_t { body, vision, gps, behaviour, actuator };
constexpr std::size_t kStageCount = 5;
constexpr std::array<const char*, kStageCount> kStageNames = {"body", "vision", "gps", "behaviour",
                                                              "actuator"};

class StageObserver {
 public:
  virtual ~StageObserver() = default;
  virtual void begin(Stage) {}
  virtual void end(Stage) {}
  virtual void beginFrame() {}
  virtual void endFrame() {}
};

}  // namespace kelpie::agent
