// SPDX-License-Identifier: Apache-2.0
// What cmake/commit.cmake writes at each build: the source tree that a program was built from.
#pragma once

namespace kelpie::cli {

const char* projectVersion();  // "0.1"
const char* sourceCommit();    // "1b70443", "1b70443-dirty" or "unknown"

}  // namespace kelpie::cli
