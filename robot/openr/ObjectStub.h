// SPDX-License-Identifier: Apache-2.0
// What the system needs to know of an object: how many services it has, and which function takes
// the message for each selector. The stub generator writes the same as ObjectEntryTable on the
// robot. Selectors: 0..3 life cycle, then Control and Ready of each subject, Connect and Notify of
// each observer, all Controls first (openr.md section 1).
#pragma once

#include <OPENR/OObject.h>

#include "robot/openr/System.h"

namespace kelpie::openr {

struct ObjectEntry {
  Selector selector;
  void (*method)(OObject& self, const Message& message);
};

struct ObjectStub {
  OObject* object = nullptr;
  const char* name = "";
  Selector subjects = 0;
  Selector observers = 0;
  const ObjectEntry* entries = nullptr;
  std::size_t entryCount = 0;

  static constexpr Selector kFirst = 4;
  Selector control(Selector subject) const { return kFirst + subject; }
  Selector ready(Selector subject) const { return kFirst + subjects + subject; }
  Selector connect(Selector observer) const { return kFirst + 2 * subjects + observer; }
  Selector notify(Selector observer) const { return connect(observer) + observers; }
};

}  // namespace kelpie::openr
