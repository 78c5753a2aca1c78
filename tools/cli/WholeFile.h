// SPDX-License-Identifier: Apache-2.0
// Files appear whole or not at all: they are written under another name first.
#pragma once

#include <string>

#include "robot/core/Expected.h"

namespace kelpie::cli {

// Something that is there but no plain file: a device, a pipe, a folder. Never replaced.
bool isDevice(const std::string& path);
bool sameFile(const std::string& a, const std::string& b);
// Ends the writing of `part`: it becomes `out` when that went well, and is removed when it did not.
Status putInPlace(const Status& written, const std::string& part, const std::string& out);

// Whether writeWhole may succeed: asked before minutes of work.
bool canWrite(const std::string& path);
// Writes a file whole or not at all; "-" is standard output, a device is written into.
bool writeWhole(const std::string& path, const std::string& text);

}  // namespace kelpie::cli
