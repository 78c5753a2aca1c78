// SPDX-License-Identifier: Apache-2.0
// Where Kelpie's own behaviours and teams are: beside the programs, a link to the tree.
#pragma once

#include <filesystem>
#include <string>

namespace kelpie::cli {

inline std::string ownFolder() {
  const std::filesystem::path programs = std::filesystem::canonical("/proc/self/exe").parent_path();
  return std::filesystem::canonical(programs / "../share/kelpie").string();
}

}  // namespace kelpie::cli
