// SPDX-License-Identifier: Apache-2.0
#include "tools/stick/Behaviours.h"

#include "tools/cli/DataFolder.h"
#include "tools/stick/Programs.h"

namespace kelpie::stick {

Expected<std::string> zipBehaviours(const std::string& folder) {
  const auto scratch = ScratchFolder::make();
  if (!scratch) return Error{scratch.error()};
  const std::string zip = scratch->path() + "/PYCODE.ZIP";
  const std::string maker = cli::dataFolder() + "/toolchain/make-pyzip";
  const auto made = runProgram({"/usr/bin/python3", maker, zip, "--pycode", folder});
  if (!made) return Error{made.error()};
  return readWhole(zip);
}

}  // namespace kelpie::stick
