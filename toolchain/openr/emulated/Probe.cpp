// SPDX-License-Identifier: Apache-2.0
// The door through which toolchain/emulate drives the stages in the emulated image: encoded inputs
// in, encoded outputs out, by the code of the image itself. Not part of the robot's object. Every
// function answers the size of what it wrote, 0 when it could not read what it was given.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <new>
#include <string>

#include "robot/agent/log/LoggedTypes.h"
#include "robot/agent/loops/AgentLoops.h"
#include "robot/agent/loops/FrameLoop.h"
#include "robot/agent/loops/MotionLoop.h"
#include "toolchain/openr/AgentTape.h"

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

// The loops as the object has them, and the last frame that they made.
struct EmulatedLoops : kelpie::agent::LogSink {
  EmulatedLoops(const AgentConfig& config, const std::string& scripts)
      : loops(config, scripts, *this) {}
  void frame(const kelpie::FrameInput&, const kelpie::FrameOutput& output) override {
    made = &output;
  }

  kelpie::agent::AgentLoops loops;
  const kelpie::FrameOutput* made = nullptr;
  kelpie::MotionInput input;
  kelpie::tape::Moment moment;
  kelpie::tape::Answer answer;
};

alignas(8) std::uint8_t buffer[kBufferBytes];
Emulated* emulated = nullptr;
EmulatedLoops* loops = nullptr;

// The behaviours inside, or those of the zip that lies where kelpieFile said.
const char* scripts() { return std::fopen("", "rb") != nullptr ? "PYCODE.ZIP" : ""; }

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

std::uint32_t kelpieConfigure(std::uint32_t size) {
  auto* const config = new AgentConfig;
  if (!kelpie::decode(buffer, size, *config)) return 0;
  emulated = new Emulated(*config, scripts());
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

// What passes between the OPEN-R object and its loops.
std::uint32_t kelpieLoops(std::uint32_t size) {
  auto* const config = new AgentConfig;
  if (!kelpie::decode(buffer, size, *config)) return 0;
  loops = new EmulatedLoops(*config, scripts());
  return 1;
}

std::uint32_t kelpiePower(std::uint32_t size) {
  kelpie::agent::PowerReport report;
  if (loops == nullptr || !kelpie::decode(buffer, size, report)) return 0;
  loops->loops.power(report);
  return 1;
}

std::uint32_t kelpieSensors(std::uint32_t size) {
  if (loops == nullptr || !kelpie::decode(buffer, size, loops->input)) return 0;
  loops->answer.motion = loops->loops.motion(loops->input);
  loops->answer.motors = loops->loops.motors();
  return answer(loops->answer);
}

std::uint32_t kelpieImage(std::uint32_t size) {
  if (loops == nullptr || !kelpie::decode(buffer, size, loops->moment)) return 0;
  const kelpie::tape::Moment& moment = loops->moment;
  loops->loops.camera(moment.image, moment.exposed, moment.number);
  return answer(*loops->made);
}
}
