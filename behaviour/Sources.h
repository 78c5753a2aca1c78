// SPDX-License-Identifier: Apache-2.0
// Which state the behaviours' files are in, to notice an edit: a number for each file, made of its
// time, size and permissions. Hidden files are no behaviours: editors keep their locks in them.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace kelpie::behaviour {

// By path within the folder, or the name of the one zip.
using SourceStamps = std::map<std::string, std::uint64_t>;

// Never throws; a folder that is not there holds nothing.
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
