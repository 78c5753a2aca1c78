// SPDX-License-Identifier: Apache-2.0
// Starts and ends CPython, cut off from the machine: no environment, no site, no search for a
// standard library (of which only `encodings` is needed), fixed hashes, no signal handlers. Its
// memory is counted.
#pragma once

#include <string>
#include <vector>

#include "behaviour/interpreter/Heap.h"
#include "robot/core/Expected.h"

namespace kelpie::behaviour {

class Interpreter {
 public:
  // `searchPaths`: where `encodings` is, if it is not frozen.
  explicit Interpreter(const std::vector<std::string>& searchPaths);
  ~Interpreter();
  Interpreter(const Interpreter&) = delete;
  Interpreter& operator=(const Interpreter&) = delete;

  const std::string& error() const { return error_; }  // empty when it runs
  Heap& heap() { return heap_; }

 private:
  Heap heap_;
  std::string error_;
};

}  // namespace kelpie::behaviour
