// SPDX-License-Identifier: Apache-2.0
#include "tests/AllocationCount.h"

#include <cstdlib>
#include <new>

namespace {
bool counting = false;
int allocations = 0;
}  // namespace

void* operator new(std::size_t size) {
  if (counting) ++allocations;
  void* memory = std::malloc(size);
  if (memory == nullptr) std::abort();
  return memory;
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace kelpie {

void startCountingAllocations() {
  allocations = 0;
  counting = true;
}

int stopCountingAllocations() {
  counting = false;
  return allocations;
}

}  // namespace kelpie
