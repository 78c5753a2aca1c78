// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <filesystem>
#include <memory>

#include "tools/calibrate/Images.h"
#include "tools/calibrate/ring/RingJudge.h"
#include "tools/calibrate/ring/RingLearner.h"
#include "tools/cli/Commands.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/calibrate/Calibrate.h"
#include "tools/cli/options/Usage.h"
#include "tools/picture/FileNames.h"

namespace kelpie::cli {
namespace {

constexpr std::size_t kMaxLogImages = 40;  // images of a log; each counts as a sheet
constexpr double kTextured = 30.0;         // grey levels; carpet in uneven light has 15
constexpr int kStep = 2;                   // every second pixel in x and y
constexpr std::array<const char*, 3> kChannels = {"Y", "Cr", "Cb"};

constexpr const char* kHelp =
    R"(
A sheet is evenly coloured paper, evenly lit, that fills the image. Give sheets of at least two
colours that differ by 15 levels in each of Y, Cr, Cb: white, blue, orange and green card will do.
Images are 208 x 160: .png (RGB), .yuv (planes Y, Cr, Cb, see `kelpie import --help`) or .bin (160
rows, each 208 Y, 208 Cr, 208 Cb).

Said of each channel: the levels by which pixels differ from an even sheet, before -> after the fit,
its centre, the six coefficients; then how uneven the sheets look through the new table, through
that of 2006 and through none. Where the new one is worse a warning says so; it is written all the
same and the exit code is 0, for other sheets may speak for it.

  kelpie calibrate ring sheets/ --out ring.kt --note "robot 3, lab, neon light"
  kelpie calibrate ring match.mcap --surface --prior 0.05 --out ring.kt    the carpet as the sheet
  kelpie calibrate show ring.kt
  kelpie play --ring ring.kt)";

struct RingOptions {
  std::string input;
  std::string out;
  std::string note;
  bool surface = false;
  double prior = 0.0;
  ShiftChoice shift;
};

// A table that is there already: "nominal", "none", "2006" or a file.
bool isTable(const std::string& input) {
  std::error_code error;
  return input == "nominal" || input == "none" || input == "2006" ||
         (std::filesystem::is_regular_file(input, error) && picture::endingOf(input) != ".mcap");
}

Expected<calibrate::RingFit> learn(const RingOptions& options) {
  const auto images = calibrate::readImages(options.input, kMaxLogImages);
  if (!images) return Error{images.error()};
  std::vector<calibrate::Sheet> sheets;
  for (const auto& [name, image] : *images)
    sheets.push_back(options.surface ? calibrate::dominantSurface(name, image, kStep)
                                     : calibrate::wholeSheet(name, image, kStep));
  calibrate::RingLearnParams params;
  // A carpet with things on it fills a part of the image only and does not show the centre.
  params.findCentre = !options.surface;
  if (options.surface) params.maxResidual = kTextured;
  params.priorShare = options.prior;
  auto fit = calibrate::learnRing(sheets, params);
  if (!fit) return Error{options.input + ": " + fit.error()};
  return fit;
}

std::string describeChannel(const calibrate::RingFit& fit, std::size_t c) {
  const auto& channel = fit.channel[c];
  return fmt::format("{}: {:.2f} -> {:.2f} levels, centre {:.1f},{:.1f}", kChannels[c],
                     channel.before, channel.after, channel.centre[0], channel.centre[1]);
}

void report(const calibrate::RingFit& fit) {
  fmt::print("{} sheets\n", fit.used.size());
  for (const auto& name : fit.leftOut) fmt::print("left out, uneven or empty: {}\n", name);
  for (std::size_t c = 0; c < 3; ++c) {
    fmt::print("{}\n", describeChannel(fit, c));
    const auto& m = fit.model.channel[c];
    fmt::print("    a1 {:.3e} b1 {:.3e} a2 {:.3e} b2 {:.3e} a3 {:.3e} b3 {:.3e}\n", m.a1, m.b1,
               m.a2, m.b2, m.a3, m.b3);
  }
}

std::string listed(const calibrate::RingVerdict& verdict,
                   const std::vector<std::size_t>& channels) {
  std::string text;
  for (const std::size_t c : channels)
    text += fmt::format("{}{} {:.2f} (2006: {:.2f}, none: {:.2f})", text.empty() ? "" : ", ",
                        kChannels[c], verdict.learnt[c], verdict.published[c], verdict.none[c]);
  return text;
}

// Says how even the sheets look through the new table, and warns where an older one does better.
std::string compare(const calibrate::RingVerdict& verdict) {
  fmt::print("unevenness of the sheets in levels: {}\n", listed(verdict, {0, 1, 2}));
  std::vector<std::size_t> worse;
  for (std::size_t c = 0; c < 3; ++c)
    if (isWorse(verdict, c)) worse.push_back(c);
  if (worse.empty()) return "";
  const std::string reported =
      "less even than before through this table: " + listed(verdict, worse);
  fail("warning: the sheets look " + reported +
           "; it is written all the same: try more sheets, even and of more colours",
       kExitDone);
  return "; " + reported;
}

Expected<vision::RingTable> makeTable(const RingOptions& options, const vision::RobotShift& shift,
                                      std::string& provenance) {
  if (isTable(options.input)) {
    const auto table = vision::loadRingTable(options.input);
    if (!table) return Error{table.error()};
    return vision::shifted(*table, shift);
  }
  const auto fit = learn(options);
  if (!fit) return Error{fit.error()};
  report(*fit);
  provenance += fmt::format("; {} sheets", fit->used.size());
  for (std::size_t c = 0; c < 3; ++c) provenance += "; " + describeChannel(*fit, c);
  provenance += compare(calibrate::compareUnevenness(fit->used, buildRingTable(fit->model)));
  return buildRingTable(fit->model, shift);
}

int calibrateRing(const RingOptions& options) {
  for (const auto& input : {options.input, options.shift.samples}) {
    const Status target = checkTarget(options.out, input);
    if (!target) return fail(target.error(), kExitBadInput);
  }
  const auto shift = chosenShift(options.shift);
  if (!shift) return fail(shift.error(), kExitBadInput);
  std::string provenance = "kelpie calibrate ring from " + options.input;
  const auto table = makeTable(options, *shift, provenance);
  if (!table) return fail(table.error(), kExitBadInput);
  if (!options.shift.samples.empty())
    provenance += "; shift of " + options.shift.robot + " from " + options.shift.samples;
  if (!options.note.empty()) provenance += "; " + options.note;
  const std::string part = options.out + ".part";
  const Status saved = putInPlace(saveRingTable(*table, part, provenance), part, options.out);
  if (!saved) return fail(saved.error(), kExitBadInput);
  fmt::print("{}\n", options.out);
  return kExitDone;
}

}  // namespace

void addCalibrateRing(CommandLine& command, int& code) {
  auto ring = command.subcommand(
      "ring", "Ring correction from images of evenly coloured sheets, or from a table");
  auto options = std::make_shared<RingOptions>();
  ring.option("INPUT", options->input,
              "Folder of .png, .yuv or .bin images or a log, each image one sheet; or "
              "\"nominal\", \"none\", \"2006\" or a table")
      .required();
  ring.option("--out", options->out, "The ring table to write").required();
  ring.flag("--surface", options->surface,
            "The images show scenes: use the surface that covers most of each");
  ring.option("--prior", options->prior,
              "Weight of the 2006 polynomial as a share of all pixels; lets sheets of one "
              "colour do")
      .check(inRange(0.0, 10.0));
  ring.option("--note", options->note, "Robot, venue, date: kept in the table");
  addShiftOptions(ring, options->shift);
  ring.footer(kHelp);
  ring.callback([options, ring, &code] {
    const bool idle = isTable(options->input) && ring.count("--surface") + ring.count("--prior");
    code = idle ? fail(options->input + ": is a table: --surface and --prior are for images",
                       kExitBadInput)
                : calibrateRing(*options);
  });
}

}  // namespace kelpie::cli
