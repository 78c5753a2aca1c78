// SPDX-License-Identifier: Apache-2.0
// The names of CLI11 for declarations: the library takes long to compile, and only the files that
// define options include it.
#pragma once

namespace CLI {
class App;
class Validator;
}  // namespace CLI
