// SPDX-License-Identifier: Apache-2.0
// Which state the behaviours' files are in, to notice an edit: a number made of the names, times
// and sizes of all Python files of a folder, or of the one zip.
#pragma once

#include <cstdint>
#include <string>

namespace kelpie::behaviour {

// Never throws; a folder that is not there has stamp 0.
std::uint64_t sourceStamp(const std::string& scripts);

bool isZip(const std::string& scripts);

}  // namespace kelpie::behaviour
