// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/calibrate/Calibrate.h"

#include <fmt/core.h>

#include <memory>

#include "tools/cli/Commands.h"
#include "tools/cli/WholeFile.h"
#include "vision/colour/ColourTable.h"
#include "vision/colour/TableFile.h"

namespace kelpie::cli {
namespace {

int show(const std::string& path) {
  const auto bytes = vision::readBytes(path);
  if (!bytes) return fail(bytes.error(), kExitBadInput);
  auto file =
      vision::parseTableFile(path, *bytes, vision::TableKind::colour, sizeof(vision::ColourTable));
  const bool isColour = file.ok();
  if (!isColour)
    file = vision::parseTableFile(path, *bytes, vision::TableKind::ring, vision::kRingFileBytes);
  if (!file) return fail(file.error(), kExitBadInput);
  fmt::print("{}: {} table, {} bytes, {}\n", path, isColour ? "colour" : "ring", file->data.size(),
             file->provenance);
  return kExitDone;
}

}  // namespace

Status checkTarget(const std::string& out, const std::string& input) {
  if (isDevice(out)) return Error{out + ": not a plain file"};
  if (sameFile(out, input)) return Error{out + ": is the input itself"};
  return Done{};
}

void addCalibrate(CommandLine& app, int& code) {
  auto command = app.subcommand(
      "calibrate", "Make the tables of a robot's camera and a venue's light, learn walks, motions");
  command.requireSubcommand();
  addCalibrateBody(command, code);
  addCalibrateInfrared(command, code);
  addCalibrateRing(command, code);
  addCalibrateColour(command, code);
  addCalibrateShift(command, code);
  addCalibrateWalk(command, code);
  addCalibrateMotion(command, code);
  addCalibrateFast(command, code);
  addCalibrateKicks(command, code);
  auto shown = command.subcommand("show", "What a table file says about itself");
  auto path = std::make_shared<std::string>();
  shown.option("FILE", *path).required();
  shown.callback([path, &code] { code = show(*path); });
}

}  // namespace kelpie::cli
