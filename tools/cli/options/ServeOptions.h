// SPDX-License-Identifier: Apache-2.0
// Options of commands that serve a match to a browser or to viewers.
#pragma once

#include "tools/cli/options/CommandLine.h"
#include "tools/web/ServerParams.h"

namespace kelpie::cli {

void addServeOptions(CommandLine& command, web::ServerParams& params);

}  // namespace kelpie::cli
