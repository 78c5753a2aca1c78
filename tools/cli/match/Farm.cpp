// SPDX-License-Identifier: Apache-2.0
// `kelpie farm` becomes the Python program of tools/farm, which asks this program for the matches.
#include "tools/cli/match/Farm.h"

#include <unistd.h>

#include <cstdlib>

#include "tools/cli/Commands.h"
#include "tools/cli/DataFolder.h"
#include "tools/cli/Process.h"

namespace kelpie::cli {
namespace {

constexpr const char* kPython = "/usr/bin/python3";  // Debian's, which has Dask

}  // namespace

int becomeFarm(std::vector<std::string> words) {
  const std::string program = dataFolder() + "/tools/farm/main.py";
  if (access(program.c_str(), R_OK) != 0)
    return fail(
        "the farm is part of the source tree and of the package kelpie-dev, but not here: " +
            program,
        kExitBadInput);
  setenv("KELPIE_PROGRAM", (programFolder() + "/kelpie").c_str(), 0);
  words.insert(words.begin(), {kPython, program});
  return fail(becomeProgram(std::move(words)), kExitBadInput);
}

void addFarm(CommandLine& app, int& code) {
  auto command = app.subcommand("farm",
                                "Matches of two teams on many machines until it is known which "
                                "plays better");
  command.readNothing();
  command.callback([command, &code] { code = becomeFarm(command.unread()); });
}

}  // namespace kelpie::cli
