// SPDX-License-Identifier: Apache-2.0
// The behaviours of the teams of a match as files that may be read and changed: Python files of
// each team's folder, nothing else, and nothing that a link leads to elsewhere.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "robot/core/Expected.h"

namespace kelpie::studio {

struct BehaviourFile {
  std::string team;
  std::string path;  // below the team's folder
};

class Behaviours {
 public:
  // The folder of each team, by its name.
  explicit Behaviours(std::map<std::string, std::string> folders) : folders_(std::move(folders)) {}

  bool none() const { return folders_.empty(); }
  std::vector<BehaviourFile> list() const;
  Expected<std::string> read(const BehaviourFile& file) const;
  // Only a file that is there.
  Status write(const BehaviourFile& file, const std::string& text) const;

 private:
  Expected<std::string> placeOf(const BehaviourFile& file) const;
  std::map<std::string, std::string> folders_;
};

}  // namespace kelpie::studio
