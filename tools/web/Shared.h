// SPDX-License-Identifier: Apache-2.0
// What all connections of a web server have in common.
#pragma once

#include "tools/web/Guard.h"
#include "tools/web/ServerParams.h"
#include "tools/web/Site.h"

namespace kelpie::web {

// Outlives them.
struct Shared {
  ServerParams params;
  Guard guard;
  Site& site;
  std::size_t connections = 0;
};

}  // namespace kelpie::web
