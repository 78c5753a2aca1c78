// SPDX-License-Identifier: Apache-2.0
// Writing to a medium that may be full, broken or pulled out: files that are on it for certain.
#pragma once

#include <filesystem>
#include <string>

#include "robot/core/Expected.h"

namespace kelpie::stick {

// Written, on the medium, and read back from there.
Status writeSynced(const std::string& path, const std::string& bytes);

// With those above it.
Status makeFolder(const std::filesystem::path& folder);

// The names in a folder. Some file systems cannot sync one; there the files' own sync must do.
void syncFolder(const std::filesystem::path& folder);

// All that was written to the file system on which the folder is.
Status syncFileSystem(const std::filesystem::path& folder);

// "PATH: No space left on device", of the last call of the system.
Error systemError(const std::string& path);

}  // namespace kelpie::stick
