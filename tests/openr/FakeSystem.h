// SPDX-License-Identifier: Apache-2.0
// A system that keeps the posted messages instead of delivering them.
#pragma once

#include <vector>

#include "robot/host/primitives/RobotPrimitives.h"

namespace kelpie::openr {

// Names of objects that exist only as names.
inline OID objectOf(int number) {
  static char places[32];
  return OID(places + number);
}

class FakeSystem : public host::RobotPrimitives {
 public:
  void post(const OServiceEntry& to, const Message& message) override {
    posted.push_back({to, message});
  }
  OStatus registerService(const OServiceEntry&, const char* name) override {
    services.emplace_back(name);
    return oSUCCESS;
  }
  void reportStatus(OStatus status) override { statuses.push_back(status); }
  OID self() const override { return objectOf(7); }
  SystemTime time() const override { return {12, 345678}; }
  void print(int level, const char* line) override { lines.emplace_back(level, line); }

  using RobotPrimitives::tellPower;

  struct Posted {
    OServiceEntry to;
    Message message;
  };
  std::vector<Posted> posted;
  std::vector<std::string> services;
  std::vector<OStatus> statuses;
  std::vector<std::pair<int, std::string>> lines;
};

}  // namespace kelpie::openr
