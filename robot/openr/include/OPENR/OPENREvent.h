// SPDX-License-Identifier: Apache-2.0
// Why a life-cycle method of an object is called (openr.md 5.1; openr-measured.md 2: where it is
// declared, its order and its types). 12 bytes with the robot's 32-bit pointers.
#pragma once

#include "OPENR/OPENR.h"
#include "OPENR/ObjcommEvent.h"

class OSystemEvent {
 public:
  OSystemEvent(OReason reason, void* param, std::size_t paramSize)
      : reason_(reason), param_(param), paramSize_(paramSize) {}
  OReason Reason() const { return reason_; }
  const void* Param() const { return param_; }
  std::size_t ParamSize() const { return paramSize_; }

 private:
  OReason reason_;
  void* param_;
  std::size_t paramSize_;
};
