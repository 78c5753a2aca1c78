// SPDX-License-Identifier: Apache-2.0
// The recorded logs that the studio shows, each as a file with an index of chunks, from which a
// page reads what it needs and no more. A log without one (cut off, damaged, or written record by
// record) is copied whole into a folder of its own, which goes with the shelf. Fails for what is no
// log at all.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "tools/cli/RunDirectory.h"

namespace kelpie::studio {

struct ShelvedLog {
  std::string name;  // of the file, as the user knows it
  std::string path;  // where it is read
  std::uint64_t bytes = 0;
  std::vector<std::string> notes;  // what of it could not be read
};

class LogShelf {
 public:
  Status add(const std::string& path);
  // All logs of a folder; none is no error. The error is the first one's; the others are added.
  Status addFolder(const std::string& folder);
  // Those of a match that was played in the folder: joined, or the parts that it left when it was
  // killed.
  Status addMatch(const std::string& folder);
  void clear() { logs_.clear(); }
  const std::vector<ShelvedLog>& logs() const { return logs_; }
  // A file of the shelf's own.
  std::string temporary(const std::string& name) const { return own_.path(name.c_str()); }

 private:
  Status addWhole(const std::string& path);

  cli::RunDirectory own_;
  std::vector<ShelvedLog> logs_;
  std::size_t copies_ = 0;
};

}  // namespace kelpie::studio
