// SPDX-License-Identifier: Apache-2.0
// A private temporary folder of a running match: socket, result and the two halves of the log. It
// goes with the object. A process that is killed leaves its folder behind; the next one to make a
// folder removes it, since nobody holds its lock any more.
#pragma once

#include <string>

namespace kelpie::cli {

class RunDirectory {
 public:
  RunDirectory();
  ~RunDirectory();
  RunDirectory(const RunDirectory&) = delete;
  RunDirectory& operator=(const RunDirectory&) = delete;

  bool ready() const { return !folder_.empty(); }
  std::string path(const char* name) const { return folder_ + "/" + name; }

 private:
  std::string folder_;
  int lock_ = -1;  // file descriptor of the folder, locked as long as it is in use
};

}  // namespace kelpie::cli
