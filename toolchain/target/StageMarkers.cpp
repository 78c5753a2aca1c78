// SPDX-License-Identifier: Apache-2.0
#include "toolchain/target/StageMarkers.h"

#include <sys/syscall.h>
#include <unistd.h>

namespace kelpie::target {
namespace {

// The counter's magic and tags: "AiB0"; a stage's number, with the high byte saying what happens.
constexpr long kMagic = 0x41694230;
constexpr long kStart = 0x000;
constexpr long kStageBegin = 0x100;
constexpr long kStageEnd = 0x200;
constexpr long kFrameBegin = 0x300;
constexpr long kFrameEnd = 0x400;

void mark(long tag) { static_cast<void>(syscall(SYS_getpriority, kMagic, tag)); }

}  // namespace

StageMarkers::StageMarkers() { mark(kStart); }
void StageMarkers::begin(agent::Stage stage) { mark(kStageBegin + static_cast<long>(stage)); }
void StageMarkers::end(agent::Stage stage) { mark(kStageEnd + static_cast<long>(stage)); }
void StageMarkers::beginFrame() { mark(kFrameBegin); }
void StageMarkers::endFrame() { mark(kFrameEnd); }

}  // namespace kelpie::target
