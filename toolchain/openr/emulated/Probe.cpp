// SPDX-License-Identifier: Apache-2.0
// The door through which toolchain/emulate drives the stages in the emulated image: encoded inputs
// in, encoded outputs out, by the code of the image itself. Not part of the robot's object. Every
// function answers the size of what it wrote, 0 when it could not read what it was given.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <new>

#include "robot/agent/FrameLoop.h"
#include "robot/agent/LoggedTypes.h"
#include "robot/agent/MotionLoop.h"

namespace {

using kelpie::agent::AgentConfig;

// More than a FrameInput with its image (99 KB) and than an AgentConfig (180 KB) take.
constexpr std::size_t kBufferBytes = 512U << 10U;

struct Emulated {
  Emulated(const AgentConfig& config, const char* scripts)
      : frames(config, scripts), motion(config) {}

  kelpie::agent::FrameLoop frames;
  kelpie::agent::MotionLoop motion;
  kelpie::FrameInput frameInput;
  kelpie::MotionInput motionInput;
  kelpie::agent::StageObserver silent;
};

alignas(8) std::uint8_t buffer[kBufferBytes];
Emulated* emulated = nullptr;

template <class T>
std::uint32_t answer(const T& output) {
  const std::size_t size = kelpie::encodedSize(output);
  if (size > kBufferBytes) return 0;
  kelpie::encodeTo(output, buffer);
  return static_cast<std::uint32_t>(size);
}

}  // namespace

extern "C" {

// Where input is put and output is found.
std::uint8_t* kelpieBuffer() { return buffer; }

// The behaviours inside play, or those of the zip that lies where kelpieFile said.
std::uint32_t kelpieConfigure(std::uint32_t size) {
  auto* const config = new AgentConfig;
  if (!kelpie::decode(buffer, size, *config)) return 0;
  emulated = new Emulated(*config, std::fopen("", "rb") != nullptr ? "PYCODE.ZIP" : "");
  return 1;
}

std::uint32_t kelpieFrame(std::uint32_t size) {
  if (emulated == nullptr || !kelpie::decode(buffer, size, emulated->frameInput)) return 0;
  return answer(emulated->frames.step(emulated->frameInput, emulated->silent));
}

std::uint32_t kelpieMotion(std::uint32_t size) {
  if (emulated == nullptr || !kelpie::decode(buffer, size, emulated->motionInput)) return 0;
  return answer(emulated->motion.step(emulated->motionInput, emulated->silent));
}
}
