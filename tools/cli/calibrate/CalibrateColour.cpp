// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <filesystem>
#include <memory>

#include "tools/calibrate/colour/KernelTrainer.h"
#include "tools/calibrate/colour/Labels.h"
#include "tools/calibrate/colour/Surfaces.h"
#include "tools/calibrate/colour/TablePicture.h"
#include "tools/cli/Commands.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/calibrate/Calibrate.h"
#include "tools/cli/options/Usage.h"
#include "tools/picture/FileNames.h"
#include "vision/colour/VisionCalibration.h"

namespace kelpie::cli {
namespace {

using calibrate::LabelledPixels;

constexpr double kHeldOut = 0.25;

struct ColourOptions {
  std::string input;
  std::string out;
  std::string picture;
  std::string ring = "nominal";
  std::string note;
  std::uint64_t seed = 1;
};

constexpr const char* kHelp =
    R"(
A .csv holds one labelled pixel a row, Y, Cr, Cb in 0..255, already corrected for the ring effect:
  Y,Cr,Cb,class
  74,191,99,orange
  18,127,128,black

A .txt holds one labelled box a line: an image (208 x 160, .png, .yuv or .bin, its path relative to
the .txt), left, top, right, bottom in pixels (right and bottom exclusive), class; # begins a
comment:
  shots/goal.png 40 20 90 60 blue

A quarter of the pixels is held out to judge by; the printed table has a row for each labelled class
and a column for what the new colour table makes of it.

Beside the table a file of parameters is written, TABLE.toml: what carpet (green), lines (white),
blue, yellow and pink look like in the light of the labels. The two go together: with both the
table follows the light, with the table alone it stays as it is.
  kelpie calibrate colour labels.csv --out my.tab
  kelpie play --colour-table my.tab --params my.tab.toml
)";

// A table, and what its surfaces look like in its light, if that is known.
struct LitTable {
  vision::ColourTable table;
  Expected<vision::LightParams> light;
};

// The classes by name, and by the numbers that the 2005 release gave them.
std::string help() {
  std::string numbers;
  for (std::uint8_t id = 0; id < vision::kColourClassCount; ++id) {
    const auto colour = vision::classOf2005(id);
    if (colour != vision::ColourClass::none)
      numbers += fmt::format("{} {}, ", id, vision::kColourNames[vision::index(colour)]);
  }
  return fmt::format("{}\nClasses: {}\nor by number: {}others up to\n12 and 127 none", kHelp,
                     calibrate::colourClassList(), numbers);
}

bool endsIn(const std::string& path, const char* extension) {
  return picture::endingOf(path) == extension;
}

Expected<LabelledPixels> readLabels(const ColourOptions& options) {
  if (endsIn(options.input, ".csv")) return calibrate::readLabelledCsv(options.input);
  const auto ring = vision::loadRingTable(options.ring);
  if (!ring) return Error{ring.error()};
  return calibrate::readRegions(options.input, *ring);
}

void printConfusion(const calibrate::Confusion& confusion) {
  fmt::print("{:>10}", "labelled");
  for (const char* name : vision::kColourNames) fmt::print("{:>10}", name);
  fmt::print("{:>8}\n", "right");
  for (std::size_t i = 0; i < confusion.size(); ++i) {
    int all = 0;
    for (const int count : confusion[i]) all += count;
    if (all == 0) continue;
    fmt::print("{:>10}", vision::kColourNames[i]);
    for (const int count : confusion[i]) fmt::print("{:>10}", count);
    fmt::print("{:>8.3f}\n", static_cast<double>(confusion[i][i]) / all);
  }
}

// Judges on a part held out, then trains on everything.
Expected<LitTable> train(const ColourOptions& options, std::string& provenance) {
  const auto pixels = readLabels(options);
  if (!pixels) return Error{pixels.error()};
  Random random(options.seed);
  const auto split = calibrate::splitLabelled(*pixels, kHeldOut, random);
  if (split.heldOut.empty())
    return Error{fmt::format("{}: {} labelled pixels, too few to hold some out to judge by",
                             options.input, pixels->size())};
  const calibrate::TableBits bits;
  const calibrate::KernelParams kernel;
  const auto judged = trainClasses(split.training, kernel, bits);
  const auto confusion = confusionOf(judged, split.heldOut);
  printConfusion(confusion);
  const auto summary = fmt::format(
      "{} labelled pixels; bumps {:.0f} levels wide, ball {:.1f}, balance {:.2f}; {:.3f} of "
      "{} held out are right",
      pixels->size(), kernel.width, kernel.ballCost, kernel.balance,
      calibrate::accuracyOf(confusion), split.heldOut.size());
  fmt::print("{}\n", summary);
  provenance += "; " + summary;
  return LitTable{robotTable(trainClasses(*pixels, kernel, bits)), calibrate::surfacesOf(*pixels)};
}

Expected<LitTable> makeTable(const ColourOptions& options, std::string& provenance) {
  if (endsIn(options.input, ".csv") || endsIn(options.input, ".txt"))
    return train(options, provenance);
  const auto calibration = vision::loadCalibration(options.input, "none");
  if (!calibration) return Error{calibration.error()};
  if (options.input == "nominal") return LitTable{calibration->colour, vision::LightParams{}};
  return LitTable{calibration->colour, Error{"a table does not tell what its surfaces look like"}};
}

std::string surfaceText(const vision::LightParams& light, const std::string& heading) {
  std::string text = "# " + inOneLine(heading) + "\n[vision.light]\nfollow = true\n";
  for (const auto& surface : calibrate::kLitSurfaces) {
    const vision::SurfaceColour& colour = light.*surface.member;
    text += fmt::format(
        "\n[vision.light.{}]\ny = \"{:.0f}levels\"\ncr = \"{:.0f}levels\"\ncb = "
        "\"{:.0f}levels\"\n",
        surface.name, colour.y, colour.cr, colour.cb);
  }
  return text;
}

// One of an earlier table under the same name would go with this one and be wrong.
Status takeAway(const std::string& file) {
  std::error_code error;
  const bool was = std::filesystem::remove(file, error);
  if (error) return Error{file + ": is of another table, and cannot be removed"};
  if (was) fmt::print("{}: removed, it was of another table\n", file);
  return Done{};
}

std::string surfaceFileOf(const std::string& table) { return table + ".toml"; }

Status writeSurfaces(const Expected<vision::LightParams>& light, const std::string& out) {
  const std::string file = surfaceFileOf(out);
  if (light)
    return writeParameterFile(file, surfaceText(*light, "kelpie calibrate colour, of " + out));
  fmt::print("{}: so with this table the light is not followed\n", light.error());
  return takeAway(file);
}

// An option that has nothing to act on is a slip: reported, not passed over.
Status checkUse(const CommandLine& colour, const std::string& input) {
  const bool boxes = endsIn(input, ".txt");
  if (colour.count("--ring") > 0 && !boxes)
    return Error{"--ring: only for a .txt of boxes in images, not for " + input};
  if (colour.count("--seed") > 0 && !boxes && !endsIn(input, ".csv"))
    return Error{"--seed: only for labelled pixels (.csv or .txt), not for " + input};
  return Done{};
}

int calibrateColour(const ColourOptions& options) {
  for (const auto& path : {options.out, options.picture, surfaceFileOf(options.out)}) {
    const Status target = checkTarget(path, options.input);
    if (!target) return fail(target.error(), kExitBadInput);
  }
  std::string provenance = "kelpie calibrate colour from " + options.input;
  const auto made = makeTable(options, provenance);
  if (!made) return fail(made.error(), kExitBadInput);
  if (!options.note.empty()) provenance += "; " + options.note;
  // The picture first: a command that fails leaves an earlier table as it was.
  if (!options.picture.empty()) {
    const Status drawn = calibrate::writeTablePicture(made->table, options.picture);
    if (!drawn) return fail(drawn.error(), kExitBadInput);
    fmt::print("{}\n", options.picture);
  }
  const std::string part = options.out + ".part";
  const Status saved =
      putInPlace(saveColourTable(made->table, part, provenance), part, options.out);
  if (!saved) return fail(saved.error(), kExitBadInput);
  fmt::print("{}\n", options.out);
  const Status written = writeSurfaces(made->light, options.out);
  return written ? kExitDone : fail(written.error(), kExitBadInput);
}

}  // namespace

void addCalibrateColour(CommandLine& command, int& code) {
  auto colour =
      command.subcommand("colour", "Colour table from labelled pixels, or from another table");
  auto options = std::make_shared<ColourOptions>();
  colour
      .option("INPUT", options->input,
              ".csv: Y,Cr,Cb,class; .txt: lines \"image left top right bottom class\"; or "
              "\"nominal\", a 128^3 table of 2005, or a table of ours")
      .required();
  colour.option("--out", options->out, "The colour table to write").required();
  colour.option("--picture", options->picture, "PNG of slices through the table");
  colour.option("--ring", options->ring, "Correction of the images of a .txt").showDefault();
  colour.option("--seed", options->seed, "Of the part held out to judge by")
      .check(inRange(0.0, kLargestSeed))
      .showDefault();
  colour.option("--note", options->note, "Robot, venue, date: kept in the table");
  colour.footer(help());
  colour.callback([options, colour, &code] {
    const Status used = checkUse(colour, options->input);
    code = used ? calibrateColour(*options) : fail(used.error(), kExitBadInput);
  });
}

}  // namespace kelpie::cli
