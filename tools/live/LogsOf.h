// SPDX-License-Identifier: Apache-2.0
// The logs in a folder.
#pragma once

#include <string>
#include <vector>

namespace kelpie::live {

// Their paths, in alphabetical order; none of a folder that is not there.
std::vector<std::string> logsOf(const std::string& folder);

}  // namespace kelpie::live
