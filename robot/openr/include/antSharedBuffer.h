// SPDX-License-Identifier: Apache-2.0
// Memory that an object shares with the robot's network: what is sent or received must lie in such
// (openr.md 5.7). It has an address only while it is mapped.
#pragma once

#include "antTypes.h"

class antSharedBuffer {
 public:
  antSharedBuffer() = default;
  // For the system: `memory` stays its own.
  antSharedBuffer(void* memory, uint32 size) : size_(size), cookie_(memory) {}

  antError Map() {
    base_ = cookie_;
    return base_ == nullptr ? ANT_FAIL : ANT_SUCCESS;
  }
  antError UnMap() {
    base_ = nullptr;
    return ANT_SUCCESS;
  }
  void* GetAddress() { return base_; }
  uint32 GetSize() { return size_; }

 private:
  [[maybe_unused]] MemoryRegionID region_ = UNDEF;
  void* base_ = nullptr;
  uint32 size_ = 0;
  void* cookie_ = nullptr;
};
