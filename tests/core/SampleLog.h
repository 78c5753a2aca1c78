// SPDX-License-Identifier: Apache-2.0
// Writes a small log of everything a log can hold, with random content.
#pragma once

#include <memory>
#include <string>

#include "robot/core/log/LogWriter.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/FrameOutput.h"
#include "tests/core/RandomValue.h"

namespace kelpie {

template <class T>
void writeRandom(LogWriter& log, const char* topic, TimeUs time, Random& random) {
  const auto value = std::make_unique<T>();
  randomise(*value, random);
  log.write(topic, time, *value);
}

inline Status writeSampleLog(const std::string& path, int frames) {
  auto log = LogWriter::open(path);
  if (!log) return Error{log.error()};
  Random random(1);
  log->metadata("kelpie", {{"seed", "1"}, {"robot", "sample"}});
  log->attachment("parameters.toml", "application/toml", {'[', 'a', ']', '\n'});
  for (int i = 0; i < frames; ++i) {
    const TimeUs time{33333 * i};
    writeRandom<FrameInput>(*log, "input", time, random);
    writeRandom<FrameOutput>(*log, "output", time, random);
    writeRandom<MotionInput>(*log, "motion_input", time, random);
    writeRandom<MotionOutput>(*log, "motion_output", time, random);
  }
  return log->close();
}

}  // namespace kelpie
