// SPDX-License-Identifier: Apache-2.0
// Which Kelpie this is, for a user and for logs. Two programs with the same field lists read each
// other's logs; the commit tells whether they also give the same outputs.
#pragma once

#include <string>

#include "robot/core/log/LogFormat.h"

namespace kelpie::cli {

// A hash over topic, name and schema of everything that a log may hold, sixteen hexadecimal digits.
std::string fieldListVersion();
// "kelpie 0.1, commit 1b70443-dirty, field lists 0123456789abcdef"
std::string versionLine();
// The version as metadata of a log: version, commit, field_lists.
LogMap versionNotes();

}  // namespace kelpie::cli
