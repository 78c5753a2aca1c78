// SPDX-License-Identifier: Apache-2.0
// The state of the behaviours' files, to notice an edit: a number for each file, made of its time,
// size and permissions. Hidden files do not count: editors keep their locks in them. Fails where an
// edit keeps all three, as within one tick of the file system's clock.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace kelpie::behaviour {

// The keys are paths within the folder, or the name of the one zip.
using SourceStamps = std::map<std::string, std::uint64_t>;

// Never throws; a missing folder holds no files.
SourceStamps sourceStamps(const std::string& scripts);

struct SourceChanges {
  std::vector<std::string> edited;  // new ones too
  std::vector<std::string> gone;
};
SourceChanges changesBetween(const SourceStamps& before, const SourceStamps& now);

// "a.py, b.py, c.py and 4 more"
std::string listed(const std::vector<std::string>& files);

bool isZip(const std::string& scripts);

}  // namespace kelpie::behaviour
