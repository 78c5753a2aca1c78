// SPDX-License-Identifier: Apache-2.0
// The parts of `kelpie calibrate`, one file each, as subcommands of the command they are given.
#pragma once

#include <string>

#include "robot/core/Expected.h"
#include "tools/cli/options/CommandLine.h"
#include "vision/colour/RingTable.h"

namespace kelpie::cli {

void addCalibrateBody(CommandLine& command, int& code);
void addCalibrateFast(CommandLine& command, int& code);
void addCalibrateInfrared(CommandLine& command, int& code);
void addCalibrateKicks(CommandLine& command, int& code);
void addCalibrateLight(CommandLine& command, int& code);
void addCalibrateMotion(CommandLine& command, int& code);
void addCalibrateRing(CommandLine& command, int& code);
void addCalibrateColour(CommandLine& command, int& code);
void addCalibrateShift(CommandLine& command, int& code);
void addCalibrateTime(CommandLine& command, int& code);
void addCalibrateWalk(CommandLine& command, int& code);

// Whether `out` may be written: a plain file or none yet, and not the very input.
Status checkTarget(const std::string& out, const std::string& input);

// The same of what may also be left out (empty) or standard output ("-"), before it takes minutes.
Status checkOut(const std::string& out, const std::string& input);

// A file of parameters, for --params; empty: none, "-": standard output, which then gets nothing
// else.
Status writeParameterFile(const std::string& out, const std::string& text);
// For its comment: a name of a file may hold a line break.
std::string inOneLine(std::string text);

// Which robot's shift is folded into a ring table; none when `samples` is empty.
struct ShiftChoice {
  std::string samples;  // CSV of pairs of robot and base
  std::string robot;    // name or hardware address of a row; may be empty when there is only one
  std::string date;
};

void addShiftOptions(CommandLine& command, ShiftChoice& choice);
Expected<vision::RobotShift> chosenShift(const ShiftChoice& choice);

}  // namespace kelpie::cli
