// SPDX-License-Identifier: Apache-2.0
// `kelpie recover`: what can be read of a damaged log, or of the logs that a killed match left.
#include <fmt/core.h>

#include <filesystem>
#include <memory>

#include "tools/cli/Commands.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/log/Logs.h"
#include "tools/session/MatchFolder.h"

namespace kelpie::cli {
namespace {

namespace fs = std::filesystem;

struct RecoverOptions {
  std::string source;
  std::string out;
};

void tell(const std::string& path, const Joined& joined) {
  for (const auto& lacks : joined.lacks) fmt::print("{}\n", lacks);
  if (joined.damaged > 0) fmt::print("{} messages are damaged and left out\n", joined.damaged);
  if (joined.foreign > 0)
    fmt::print("{} messages of topics that are not Kelpie's are left out\n", joined.foreign);
  fmt::print("{}: {} messages from {:.3f} to {:.3f} s\n", path, joined.messages,
             joined.first.seconds(), joined.last.seconds());
}

int recoverLog(const RecoverOptions& options) {
  if (options.out.empty())
    return fail("recover " + options.source + ": --out says where what can be read goes",
                kExitBadInput);
  if (fs::exists(options.out))
    return fail(options.out + ": is there already, and is not replaced", kExitBadInput);
  if (!canWrite(options.out)) return fail(options.out + ": cannot be written", kExitBadInput);
  const auto joined = mergeLogs({options.source}, options.out);
  if (!joined) return fail(joined.error(), kExitBadInput);
  tell(options.out, *joined);
  return kExitDone;
}

int recoverMatch(const RecoverOptions& options) {
  const std::string folder = fs::path(options.source).lexically_normal().string();
  if (!options.out.empty())
    return fail("--out is for one log; those of a match go into " + folder, kExitBadInput);
  if (isPlayedIn(folder)) return fail(folder + ": a match is being played there", kExitBadInput);
  const auto joined = joinParts(folder);
  if (!joined) return fail(joined.error(), kExitMachine);
  if (joined->empty())
    return fail(folder + ": holds no logs of a match that was killed (in its folder playing)",
                kExitBadInput);
  for (const JoinedLog& log : *joined) tell(log.path, log.holds);
  return kExitDone;
}

}  // namespace

void addRecover(CommandLine& app, int& code) {
  auto command = app.subcommand(
      "recover",
      "Write what can be read of a damaged log, or join the logs that a killed match left");
  auto options = std::make_shared<RecoverOptions>();
  command.option("SOURCE", options->source, "A log, or the folder of a match (its --out)")
      .required()
      .check(existingPath());
  command.option("--out", options->out, "The new log; nothing that is there is replaced");
  command.callback([options, &code] {
    code = fs::is_directory(options->source) ? recoverMatch(*options) : recoverLog(*options);
  });
}

}  // namespace kelpie::cli
