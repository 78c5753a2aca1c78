// SPDX-License-Identifier: Apache-2.0
// A match without images (tools/percepts): the one process that plays it, and what of a session it
// cannot do.
#pragma once

#include <string>
#include <vector>

#include "tools/cli/RunDirectory.h"
#include "tools/session/SessionOptions.h"

namespace kelpie::cli {

// An error names in one line what such a match does not have.
Status mayBePercepts(const SessionOptions& options);

std::vector<std::string> perceptCommand(const SessionOptions& options,
                                        const RunDirectory& runDirectory);

}  // namespace kelpie::cli
