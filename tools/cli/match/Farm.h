// SPDX-License-Identifier: Apache-2.0
// The farm is a Python program (tools/farm) that the program kelpie becomes.
#pragma once

#include <string>
#include <vector>

namespace kelpie::cli {

// With these words behind `kelpie farm`. Returns only when it cannot be started: the exit code.
int becomeFarm(std::vector<std::string> words);

}  // namespace kelpie::cli
