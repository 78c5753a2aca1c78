// SPDX-License-Identifier: Apache-2.0
// All of Python's memory comes from a malloc of its own, which counts (toolchain/python-openr).
#include "behaviour/interpreter/Heap.h"

extern "C" {
#include "behaviour/frozen/Steps.h"
}

namespace kelpie::behaviour {

struct Heap::Hooks {};

Heap::Heap() = default;

Heap::~Heap() = default;

void Heap::count() {}

std::size_t Heap::used() const { return kelpieHeapUsed(); }

void Heap::limit(std::size_t bytes) { kelpieLimitHeap(bytes); }

}  // namespace kelpie::behaviour
