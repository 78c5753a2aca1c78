// SPDX-License-Identifier: Apache-2.0
// The one global of the host build (see System.h): which system the OPEN-R free functions belong
// to. Per thread, so that several agents can live in one process.
#include "robot/openr/System.h"

#include <cstdio>
#include <cstdlib>

namespace kelpie::openr {
namespace {
thread_local System* current = nullptr;
}

System& currentSystem() {
  if (current == nullptr) {
    std::fputs("OPEN-R call outside a method of an object\n", stderr);
    std::abort();
  }
  return *current;
}

SystemScope::SystemScope(System& system) : previous_(current) { current = &system; }
SystemScope::~SystemScope() { current = previous_; }

}  // namespace kelpie::openr
