// SPDX-License-Identifier: Apache-2.0
// The target of a request, "/logs/0?time=12", taken apart.
#pragma once

#include <string>

#include "tools/web/Site.h"

namespace kelpie::web {

// %41 is A. What is no such triple stays as it is.
std::string decoded(const std::string& text);
// Fills in path and query.
void readTarget(const std::string& target, Request& request);

}  // namespace kelpie::web
