// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/DataFolder.h"

#include <filesystem>

#include "tools/cli/Process.h"

namespace kelpie::cli {

std::string dataFolder() {
  const auto folder = std::filesystem::path(programFolder()).parent_path() / "share/kelpie";
  std::error_code error;
  const auto whole = std::filesystem::canonical(folder, error);
  return error ? folder.string() : whole.string();
}

}  // namespace kelpie::cli
