// SPDX-License-Identifier: Apache-2.0
// Counts the memory that Python has of the system, and while a script runs refuses to let it have
// more than a limit: the script gets a MemoryError. Small objects come out of arenas, which Python
// asks for whole (256 KB on the robot, 1 MB on a PC), so that counting costs next to nothing; one
// arena more than the limit is given to the error itself, which says where it was. One per process,
// as the interpreter; lives longer than that. Heap.cpp hooks Python's allocators, where the C
// library knows a block's size; frozen/Heap.cpp has the robot's, whose malloc counts.
#pragma once

#include <cstddef>
#include <memory>

namespace kelpie::behaviour {

class Heap {
 public:
  Heap();
  ~Heap();
  Heap(const Heap&) = delete;
  Heap& operator=(const Heap&) = delete;

  // From now on; called before Python starts, but after it has chosen allocators.
  void count();
  std::size_t used() const;  // bytes, of what was asked for since
  void limit(std::size_t bytes);

 private:
  struct Hooks;

  std::unique_ptr<Hooks> hooks_;
};

class HeapLimit {
 public:
  HeapLimit(Heap& heap, std::size_t bytes) : heap_(heap) { heap_.limit(bytes); }
  ~HeapLimit() { heap_.limit(static_cast<std::size_t>(-1)); }
  HeapLimit(const HeapLimit&) = delete;
  HeapLimit& operator=(const HeapLimit&) = delete;

 private:
  Heap& heap_;
};

}  // namespace kelpie::behaviour
