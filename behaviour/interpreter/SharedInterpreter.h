// SPDX-License-Identifier: Apache-2.0
// One interpreter that several hosts of one thread use; the last of them ends it. A counter of its
// own, since std::shared_ptr wants more of the C++ library than the robot's object has.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "behaviour/interpreter/Interpreter.h"

namespace kelpie::behaviour {

class SharedInterpreter {
 public:
  explicit SharedInterpreter(std::unique_ptr<Interpreter> one) : held_(new Held{std::move(one)}) {}
  SharedInterpreter(const SharedInterpreter& other) : held_(other.held_) { ++held_->users; }
  SharedInterpreter& operator=(const SharedInterpreter&) = delete;
  ~SharedInterpreter() {
    if (--held_->users == 0) delete held_;
  }

  Interpreter* operator->() const { return held_->interpreter.get(); }
  std::size_t users() const { return held_->users; }

 private:
  struct Held {
    std::unique_ptr<Interpreter> interpreter;
    std::size_t users = 1;
  };
  Held* held_;
};

}  // namespace kelpie::behaviour
