// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <memory>

#include "robot/core/fields/FieldCheck.h"
#include "tools/calibrate/infrared/InfraredFit.h"
#include "tools/cli/Commands.h"
#include "tools/cli/calibrate/Calibrate.h"

namespace kelpie::cli {
namespace {

using calibrate::CarpetLog;

constexpr const char* kHelp =
    R"(
The robot stands on bare carpet, nothing ahead, and holds its head as with a ball, then in other
poses that look down at the carpet: tools/calibrate/carpet does so. One round takes 10 s.

The threshold, under which a reading means that something is in the way with the ball, is 0.8 of the
mean reading in the stance with the ball. On a new carpet only the base robot is measured.

--base: the log of the base robot on the same carpet, in the same poses. Then the straight line is
fitted that makes the base robot's readings of this one's, and the threshold is the base robot's.

  kelpie play --pycode tools/calibrate/carpet --seconds 14 --no-film
  kelpie calibrate infrared out/match.mcap --out robot1.toml
  kelpie calibrate infrared robot3.mcap --base robot1.mcap --out robot3.toml
  kelpie play --params robot3.toml)";

struct InfraredOptions {
  std::string log;
  std::string base;
  std::string out;
  bool quiet() const { return out == "-"; }  // the file is all that standard output gets
};

std::string parameterFile(const body::InfraredParams& found, const InfraredOptions& options) {
  std::string from = "kelpie calibrate infrared from " + options.log;
  if (!options.base.empty()) from += ", base robot " + options.base;
  return fmt::format(
      "# {}\n[body.infrared]\ngain = {:.4f}\noffset = \"{:.2f}cm\"\nthreshold = \"{:.2f}cm\"\n",
      inOneLine(from), found.gain, found.offset, found.threshold);
}

// The threshold is measured with the base robot, which is this one where no other is named.
Status takeThreshold(const CarpetLog& log, const std::string& path, bool quiet,
                     body::InfraredParams& found) {
  const auto carpet = calibrate::carpetThreshold(log);
  if (!carpet) return Error{path + ": " + carpet.error()};
  found.threshold = carpet->threshold;
  if (!quiet)
    fmt::print(
        "carpet in the stance with a ball {:6.2f} cm, mean of {} readings\n"
        "threshold, 0.8 of it             {:6.2f} cm\n",
        carpet->carpet, carpet->readings, carpet->threshold);
  return Done{};
}

Status takeLine(const CarpetLog& own, const CarpetLog& base, const InfraredOptions& options,
                body::InfraredParams& found) {
  const auto line = calibrate::lineBetween(own, base);
  if (!line) return Error{options.log + ": " + line.error()};
  found.gain = line->gain;
  found.offset = line->offset;
  if (!options.quiet())
    fmt::print("base robot's reading = {:.4f} own {:+.2f} cm, of {} poses, {:.2f} cm left\n",
               line->gain, line->offset, line->poses, line->rms);
  return Done{};
}

// What was found; `lacks` is what of the logs could not be read.
Expected<body::InfraredParams> infraredOf(const InfraredOptions& options, std::string& lacks) {
  const auto own = calibrate::readCarpet(options.log);
  if (!own) return Error{own.error()};
  if (!own->lacks.empty()) lacks = options.log + ": " + own->lacks;
  body::InfraredParams found = own->infrared;
  Status done = Done{};
  if (options.base.empty()) {
    done = takeThreshold(*own, options.log, options.quiet(), found);
  } else {
    const auto base = calibrate::readCarpet(options.base);
    if (!base) return Error{base.error()};
    if (!base->lacks.empty()) lacks = options.base + ": " + base->lacks;
    done = takeThreshold(*base, options.base, options.quiet(), found);
    if (done) done = takeLine(*own, *base, options, found);
  }
  if (!done) return Error{done.error()};
  std::string why;
  if (!verify(found, &why)) return Error{"what fits best is no robot's: " + why};
  return found;
}

int calibrateInfrared(const InfraredOptions& options) {
  for (const auto& input : {options.log, options.base}) {
    const Status target = checkOut(options.out, input);
    if (!target) return fail(target.error(), kExitBadInput);
  }
  std::string lacks;
  const auto found = infraredOf(options, lacks);
  if (!found) return fail(found.error(), kExitBadInput);
  const Status written = writeParameterFile(options.out, parameterFile(*found, options));
  if (!written) return fail(written.error(), kExitBadInput);
  if (lacks.empty()) return kExitDone;
  return fail(lacks + "; calibrated with the rest", kExitBadInput);
}

}  // namespace

void addCalibrateInfrared(CommandLine& command, int& code) {
  auto infrared = command.subcommand(
      "infrared", "When something is in the way, by the infrared of a robot's head");
  auto options = std::make_shared<InfraredOptions>();
  infrared.option("LOG", options->log, "Log of a robot that looks at bare carpet").required();
  infrared.option("--base", options->base, "Log of the base robot, for the line between the two");
  infrared.option("--out", options->out,
                  "The file of parameters to write, for --params; - for standard output");
  infrared.footer(kHelp);
  infrared.callback([options, &code] { code = calibrateInfrared(*options); });
}

}  // namespace kelpie::cli
