// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <memory>

#include "tools/calibrate/lag/LagEstimate.h"
#include "tools/cli/Commands.h"
#include "tools/cli/calibrate/Calibrate.h"

namespace kelpie::cli {
namespace {

constexpr const char* kHelp =
    R"(
How much older the camera's images are than their stamps, or the joints' angles than theirs (then
below 0), from any log of an agent whose head turned over beacons and goals; images need not be
kept. Every robot finds it while it plays; one that begins with what was found has its first seconds
right, too.

  kelpie play --pycode tools/calibrate/looking --seconds 22 --no-film
  kelpie calibrate time out/match.mcap --out robot3.toml
  kelpie play --params robot3.toml)";

struct TimeOptions {
  std::string log;
  std::string out;
};

// Twice the sd: sightings of one landmark share some of their errors.
std::string parameterFile(const calibrate::LagEstimate& found, const std::string& log) {
  return fmt::format("# {}\n[gps.lag]\ninitial = \"{:.4f}s\"\ninitialSd = \"{:.4f}s\"\n",
                     inOneLine("kelpie calibrate time from " + log), found.seconds, 2.0 * found.sd);
}

int calibrateTime(const TimeOptions& options) {
  const Status target = checkOut(options.out, options.log);
  if (!target) return fail(target.error(), kExitBadInput);
  const auto found = calibrate::estimateLag(options.log);
  if (!found) return fail(found.error(), kExitBadInput);
  if (options.out != "-")
    fmt::print("images are {:.1f} +- {:.1f} ms older than their stamps, by {} of {} frames\n",
               1e3 * found->seconds, 1e3 * found->sd, found->compared, found->frames);
  const Status written = writeParameterFile(options.out, parameterFile(*found, options.log));
  if (!written) return fail(written.error(), kExitBadInput);
  if (found->lacks.empty()) return kExitDone;
  return fail(options.log + ": " + found->lacks + "; calibrated with the rest", kExitBadInput);
}

}  // namespace

void addCalibrateTime(CommandLine& command, int& code) {
  auto time = command.subcommand(
      "time", "How much older images are than their stamps, from a log in which the head turned");
  auto options = std::make_shared<TimeOptions>();
  time.option("LOG", options->log, "Log of an agent").required();
  time.option("--out", options->out,
              "The file of parameters to write, for --params; - for standard output");
  time.footer(kHelp);
  time.callback([options, &code] { code = calibrateTime(*options); });
}

}  // namespace kelpie::cli
