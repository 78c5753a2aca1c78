// SPDX-License-Identifier: Apache-2.0
// The names of CLI11 for declarations: to include the library costs 5 s of compiling, which only
// the files that define options pay.
#pragma once

namespace CLI {
class App;
class Validator;
}  // namespace CLI
