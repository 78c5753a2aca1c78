// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <cmath>
#include <memory>

#include "tools/calibrate/colour/Shift.h"
#include "tools/cli/Commands.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/calibrate/Calibrate.h"

namespace kelpie::cli {
namespace {

constexpr const char* kHeader = "date,dog,mac_low4,n,My,Cy,Mu,Cu,Mv,Cv\n";

constexpr const char* kHelp =
    R"(
Hold the same papers before the robot and before the base robot, whose colour table is used, and
write one row for each paper: date, the robot's name, the last four bytes of its hardware address,
the base robot's name, the paper's, then for each channel a pixel's value seen by the robot (0..255)
and the mean of the base robot's. At least two papers that differ in each channel.

  date,dog,mac_low4,base_dog,paper,y_dog,y_base_mean,u_dog,u_base_mean,v_dog,v_base_mean
  2005-07-12,r1,c6240000,b1,white,150,157.2,128,127.1,126,128.4

Here u is Cr and v is Cb, as everywhere in the 2005 release. The result has a gain M and an offset C
for each channel: base = M * robot + C. `kelpie calibrate ring nominal --shift pairs.csv --robot r1
--out ring_r1.kt` folds it into a ring table.)";

struct ShiftOptions {
  std::string samples;
  std::string out;
};

double fourDigits(double value) { return std::round(value * 1e4) / 1e4; }

std::string rowText(const calibrate::ShiftRow& row) {
  std::string text = fmt::format("{},{},{},{}", row.date, row.dog, row.mac, row.samples);
  for (const auto& channel : row.shift)
    text += fmt::format(",{},{}", fourDigits(channel.gain), fourDigits(channel.offset));
  return text + "\n";
}

int calibrateShift(const ShiftOptions& options) {
  if (sameFile(options.out, options.samples))
    return fail(options.out + ": is the input itself", kExitBadInput);
  const auto rows = calibrate::fitShifts(options.samples);
  if (!rows) return fail(rows.error(), kExitBadInput);
  std::string text = kHeader;
  for (const auto& row : *rows) text += rowText(row);
  if (!writeWhole(options.out, text))
    return fail(options.out + ": cannot be written", kExitBadInput);
  return kExitDone;
}

}  // namespace

void addShiftOptions(CommandLine& command, ShiftChoice& choice) {
  const auto samples = command.option("--shift", choice.samples,
                                      "CSV of pairs of robot and base (see calibrate shift): fold "
                                      "the robot's shift into the table");
  command.option("--robot", choice.robot, "Its name or address in that file").needs(samples);
  command.option("--date", choice.date, "Its date, when it stands there twice").needs(samples);
}

Expected<vision::RobotShift> chosenShift(const ShiftChoice& choice) {
  if (choice.samples.empty()) return vision::RobotShift{};
  const auto rows = calibrate::fitShifts(choice.samples);
  if (!rows) return Error{rows.error()};
  const calibrate::ShiftRow* found = nullptr;
  for (const auto& row : *rows) {
    if (!choice.robot.empty() && choice.robot != row.dog && choice.robot != row.mac) continue;
    if (!choice.date.empty() && choice.date != row.date) continue;
    if (found != nullptr)
      return Error{choice.samples + ": several robots fit: give --robot, and --date"};
    found = &row;
  }
  if (found == nullptr) return Error{choice.samples + ": no robot '" + choice.robot + "'"};
  return found->shift;
}

void addCalibrateShift(CommandLine& command, int& code) {
  auto shift =
      command.subcommand("shift", "Straight lines from each robot's colours to the base robot's");
  auto options = std::make_shared<ShiftOptions>();
  shift
      .option("INPUT", options->samples,
              "CSV: date,dog,mac_low4,base_dog,paper,y_dog,y_base_mean,u_...,v_...")
      .required();
  shift.footer(kHelp);
  options->out = "-";
  shift.option("--out", options->out, "CSV of gains and offsets, - for standard output");
  shift.callback([options, &code] { code = calibrateShift(*options); });
}

}  // namespace kelpie::cli
