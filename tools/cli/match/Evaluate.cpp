// SPDX-License-Identifier: Apache-2.0
// `kelpie evaluate` becomes the program kelpie-experiments, which has the options and the figures.
#include <unistd.h>

#include <string>
#include <vector>

#include "tools/cli/Commands.h"
#include "tools/cli/Process.h"

namespace kelpie::cli {
namespace {

// Returns only when the program cannot be started.
int becomeExperiments(std::vector<std::string> words) {
  const std::string program = programFolder() + "/kelpie-experiments";
  if (access(program.c_str(), X_OK) != 0)
    return fail("the experiments are not built yet: tools/build host kelpie-experiments",
                kExitBadInput);
  words.insert(words.begin(), program);
  return fail(becomeProgram(std::move(words)), kExitBadInput);
}

}  // namespace

void addEvaluate(CommandLine& app, int& code) {
  auto command = app.subcommand("evaluate", "Measure: one JSON object of plain figures");
  command.readNothing();
  command.callback([command, &code] { code = becomeExperiments(command.unread()); });
}

}  // namespace kelpie::cli
