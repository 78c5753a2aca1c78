// SPDX-License-Identifier: Apache-2.0
// Names an endpoint of the robot's network. 8 bytes with the robot's 32-bit pointers.
#pragma once

#include "antTypes.h"

class antModuleRef {
 public:
  antModuleRef() = default;
  antModuleRef(void* module, uint32 index) : module_(module), index_(index) {}
  bool operator==(const antModuleRef& other) const {
    return module_ == other.module_ && index_ == other.index_;
  }

 private:
  void* module_ = nullptr;
  uint32 index_ = 0;
};
