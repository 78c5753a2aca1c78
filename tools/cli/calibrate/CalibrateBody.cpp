// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <filesystem>
#include <memory>

#include "robot/core/fields/FieldCheck.h"
#include "tools/calibrate/body/BodyEstimate.h"
#include "tools/calibrate/body/BodyModel.h"
#include "tools/calibrate/body/ResidualPicture.h"
#include "tools/calibrate/distance/SizeFit.h"
#include "tools/cli/Commands.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/calibrate/Calibrate.h"
#include "tools/picture/FileNames.h"
#include "vision/VisionParams.h"

namespace kelpie::cli {
namespace {

using calibrate::BodyEstimate;
using calibrate::Estimated;
using calibrate::kUnknownKinds;
using calibrate::SightKind;

constexpr const char* kHelp =
    R"(
The robot stands on the field of its configuration and looks round in stops of 0.3 s and more, low
and high, with its neck bent in several ways: tools/calibrate/looking does so. Frames in which the
head moves are not used, so that neither the shutter nor late images matter. At least two beacons or
goals and some lines in view, and ten stops; twenty seconds are plenty.

Said of each parameter: its value and the standard deviation; one that the log cannot tell better
than robots differ among themselves stays as the log's robot had it. The neck's offset stands for
the body's tilt as well, which turns the camera in the same way. The play of the neck and the
shutter's read-out are seen in a moving head only and stay as they are.

A folder of measured sizes (ball_radius.csv, beacon_height_lab.csv, goal_height.csv) tells the focal
length, and what the camera adds to the size of each object (edgeBias, blur), which vision then
takes away again.

  kelpie play --pycode tools/calibrate/looking --seconds 22 --images all --no-film
  kelpie calibrate body out/match.mcap --out robot3.toml --picture residuals.png
  kelpie play --params robot3.toml)";

struct BodyOptions {
  std::string input;
  std::string out;
  std::string picture;
};

// As a file of parameters wants it: a bare number, or number and unit in quotes.
std::string valueFor(const Estimated& one) {
  const std::string unit = kUnknownKinds[one.unknown].unit;
  return unit.empty() ? fmt::format("{:.4f}", one.value)
                      : fmt::format("\"{:.3f}{}\"", one.value, unit);
}

// Lens and body in sections of their own; only what was estimated.
std::string parameterFile(const std::vector<Estimated>& unknowns, const std::string& heading) {
  const std::string kLens = "lens.";
  std::string body = "[body]\n";
  std::string lens;
  for (const Estimated& one : unknowns) {
    if (!one.observed || one.unknown >= calibrate::kBodyUnknowns) continue;
    std::string name = kUnknownKinds[one.unknown].name;
    const bool ofLens = name.rfind(kLens, 0) == 0;
    if (ofLens) name.erase(0, kLens.size());
    (ofLens ? lens : body) += fmt::format("{} = {}  # sd {:.2g}\n", name, valueFor(one), one.sd);
  }
  return "# " + inOneLine(heading) + "\n" + body + (lens.empty() ? "" : "\n[body.lens]\n" + lens);
}

// By how much a beacon's both ends are seen too far out, as vision takes it away again.
std::string beaconBiasOf(const std::vector<Estimated>& unknowns) {
  const Estimated& spread = unknowns[calibrate::kSpread];
  if (!spread.observed) return "";
  return fmt::format("\n[vision.beacon]\nedgeBias = \"{:.3f}px\"  # sd {:.2g}\n",
                     2.0 * spread.value, 2.0 * spread.sd);
}

// What this camera adds to the sizes that vision measures, as vision's parameters.
std::string biasesOf(const calibrate::SizeFit& fit) {
  const auto [ball, beacon, goal] = fit.optics;
  return fmt::format("\n[vision.ball]\nedgeBias = \"{:.3f}px\"\nblur = \"{:.3f}px\"\n", ball.edge,
                     ball.blur) +
         fmt::format("\n[vision.beacon]\nedgeBias = \"{:.3f}px\"\n", beacon.edge) +
         fmt::format("\n[vision.goal]\nedgeBias = \"{:.3f}px\"\n", goal.edge);
}

Status checkBiases(const calibrate::SizeFit& fit) {
  const auto vision = std::make_unique<vision::VisionParams>();
  vision->ball.edgeBias = fit.optics[0].edge;
  vision->ball.blur = fit.optics[0].blur;
  vision->beacon.edgeBias = fit.optics[1].edge;
  vision->goal.edgeBias = fit.optics[2].edge;
  std::string why;
  if (verify(*vision, &why)) return Done{};
  return Error{"what fits best is no camera's: " + why};
}

// What a file of parameters may hold (BodyParams::fields): a fit beyond it is no robot's.
Status checkRanges(const std::vector<Estimated>& unknowns) {
  calibrate::Numbers values = calibrate::valuesOf(body::BodyParams{});
  for (const Estimated& one : unknowns)
    if (one.observed && one.unknown < calibrate::kBodyUnknowns)
      values[one.unknown] =
          one.value / calibrate::inUnit(static_cast<calibrate::Unknown>(one.unknown));
  std::string why;
  if (verify(calibrate::paramsWith({}, values), &why)) return Done{};
  return Error{"what fits best is no robot's: " + why};
}

void tellOne(const Estimated& one) {
  const std::string unit = kUnknownKinds[one.unknown].unit;
  const std::string name = kUnknownKinds[one.unknown].name + (unit.empty() ? "" : ", " + unit);
  fmt::print("{:<21} {:9.3f} ", name, one.value);
  if (!one.observed)
    fmt::print("left as it was: the log cannot tell it\n");
  else if (one.unknown < calibrate::kBodyUnknowns)
    fmt::print("+- {:<6.3f} {:8.3f}\n", one.sd, one.recorded);
  else
    fmt::print("+- {:.3f}\n", one.sd);
}

void tell(const BodyEstimate& e) {
  fmt::print("{:.1f} s of standing, {} stops of the head, {} frames, {} landmarks\n\n", e.seconds,
             e.stops, e.frames, e.landmarkKinds);
  fmt::print("{:<21} {:>9}    {:<6} {:>8}\n", "body parameter", "found", "sd", "was");
  for (const Estimated& one : e.unknowns) {
    if (one.unknown == calibrate::kBodyUnknowns)
      fmt::print(
          "\nfound beside them; of these a file of parameters holds the beacon's ends alone\n");
    tellOne(one);
  }
  fmt::print("\n{:<18} median miss before -> after\n", "sightings");
  for (std::size_t i = 0; i < calibrate::kSightKindCount; ++i) {
    const auto kind = static_cast<SightKind>(i);
    fmt::print("{:<18} {:.2f} -> {:.2f} px\n", calibrate::nameOf(kind), medianMiss(e.before, kind),
               medianMiss(e.after, kind));
  }
}

int write(const BodyOptions& options, const std::string& text) {
  const Status written = writeParameterFile(options.out, text);
  return written ? kExitDone : fail(written.error(), kExitBadInput);
}

int fromLog(const BodyOptions& options) {
  const auto log = calibrate::readStanding(options.input);
  if (!log) return fail(log.error(), kExitBadInput);
  const auto estimate = calibrate::estimateBody(*log);
  if (!estimate) return fail(options.input + ": " + estimate.error(), kExitBadInput);
  const bool quiet = options.out == "-";  // the file is all that standard output gets
  if (!quiet) tell(*estimate);
  const Status within = checkRanges(estimate->unknowns);
  if (!within) return fail(within.error(), kExitBadInput);
  const int code = write(
      options, parameterFile(estimate->unknowns, "kelpie calibrate body from " + options.input) +
                   beaconBiasOf(estimate->unknowns));
  if (!options.picture.empty()) {
    const Status drawn = calibrate::writeResidualPicture(*estimate, options.picture);
    if (!drawn) return fail(drawn.error(), kExitBadInput);
    if (!quiet) fmt::print("{}: how far sightings lie beside, before and after\n", options.picture);
  }
  if (log->lacks.empty() || code != kExitDone) return code;
  return fail(options.input + ": " + log->lacks + "; calibrated with the rest", kExitBadInput);
}

int fromSizes(const BodyOptions& options) {
  if (!options.picture.empty())
    return fail("--picture: only for a log, not for measured sizes", kExitBadInput);
  const auto fit = calibrate::fitSizes(options.input + "/");
  if (!fit) return fail(fit.error(), kExitBadInput);
  constexpr std::array<const char*, calibrate::kSizedObjects> kNames = {"ball", "beacon", "goal"};
  const bool quiet = options.out == "-";  // the file is all that standard output gets
  for (std::size_t i = 0; i < calibrate::kSizedObjects && !quiet; ++i)
    fmt::print(
        "{:<6} {:3} measured, edge {:5.2f} px, blur {:.2f} px, error of distance {:.1f} -> {:.1f} "
        "cm\n",
        kNames[i], fit->measured[i], fit->optics[i].edge, fit->optics[i].blur, fit->before[i].rms,
        fit->after[i].rms);
  if (!quiet) fmt::print("lens.focalLength {:9.3f} +- {:.3f} px\n", fit->focalLength, fit->focalSd);
  Estimated focal;
  focal.value = fit->focalLength;
  focal.sd = fit->focalSd;
  focal.observed = true;
  for (const Status& within : {checkRanges({focal}), checkBiases(*fit)})
    if (!within) return fail(within.error(), kExitBadInput);
  return write(options, parameterFile({focal}, "kelpie calibrate body from " + options.input) +
                            biasesOf(*fit));
}

int calibrateBody(const BodyOptions& options) {
  for (const auto& path : {options.out, options.picture}) {
    const Status target = checkOut(path, options.input);
    if (!target) return fail(target.error(), kExitBadInput);
  }
  std::error_code error;
  const auto place = [&error](const std::string& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
  };
  if (!options.out.empty() && !options.picture.empty() &&
      place(options.out) == place(options.picture))
    return fail("--out and --picture: both are " + options.out, kExitBadInput);
  if (!options.picture.empty() && picture::endingOf(options.picture) != ".png")
    return fail("--picture " + options.picture + ": its name must end with .png", kExitBadInput);
  return std::filesystem::is_directory(options.input, error) ? fromSizes(options)
                                                             : fromLog(options);
}

}  // namespace

void addCalibrateBody(CommandLine& command, int& code) {
  auto body = command.subcommand(
      "body", "Lens, neck and lean of a robot from the log of one that stands and looks round");
  auto options = std::make_shared<BodyOptions>();
  body.option("INPUT", options->input,
              "Log with images, or folder of sizes measured at known distances")
      .required();
  body.option("--out", options->out,
              "The file of parameters to write, for --params; - for standard output");
  body.option("--picture", options->picture,
              "PNG of how far sightings lie beside, before and after");
  body.footer(kHelp);
  body.callback([options, &code] { code = calibrateBody(*options); });
}

}  // namespace kelpie::cli
