// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/calibrate/Calibrate.h"

#include <fmt/core.h>

#include <algorithm>
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

Status checkOut(const std::string& out, const std::string& input) {
  if (out.empty() || out == "-") return Done{};
  const Status target = checkTarget(out, input);
  if (!target) return target;
  if (!canWrite(out)) return Error{out + ": cannot be written"};
  return Done{};
}

Status writeParameterFile(const std::string& out, const std::string& text) {
  if (out.empty()) return Done{};
  if (!writeWhole(out, text)) return Error{out + ": cannot be written"};
  if (out != "-") fmt::print("{}: parameters, for --params\n", out);
  return Done{};
}

std::string inOneLine(std::string text) {
  const auto isControl = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  std::replace_if(text.begin(), text.end(), isControl, '?');
  return text;
}

void addCalibrate(CommandLine& app, int& code) {
  auto command = app.subcommand(
      "calibrate", "Make the tables of a robot's camera and a venue's light, learn walks, motions");
  command.requireSubcommand();
  addCalibrateBody(command, code);
  addCalibrateTime(command, code);
  addCalibrateLight(command, code);
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
