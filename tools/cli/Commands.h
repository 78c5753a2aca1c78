// SPDX-License-Identifier: Apache-2.0
// The subcommands of `kelpie`, one file each. Every add...() registers its options and what to run;
// `code` is the exit code (Terminal.h).
#pragma once

#include "tools/cli/Terminal.h"
#include "tools/cli/options/CommandLine.h"

namespace kelpie::cli {

void addPlay(CommandLine& app, int& code);
void addNewTeam(CommandLine& app, int& code);
void addGameController(CommandLine& app, int& code);
void addTeleop(CommandLine& app, int& code);
void addReplay(CommandLine& app, int& code);
void addInfo(CommandLine& app, int& code);
void addRecover(CommandLine& app, int& code);
void addImport(CommandLine& app, int& code);
void addCompress(CommandLine& app, int& code);
void addStudio(CommandLine& app, int& code);
void addShow(CommandLine& app, int& code);
void addWhy(CommandLine& app, int& code);
void addTree(CommandLine& app, int& code);
void addVectors(CommandLine& app, int& code);
void addEvaluate(CommandLine& app, int& code);
void addExport(CommandLine& app, int& code);
void addFilm(CommandLine& app, int& code);
void addBench(CommandLine& app, int& code);
void addLeague(CommandLine& app, int& code);
void addFarm(CommandLine& app, int& code);
void addValue(CommandLine& app, int& code);
void addCalibrate(CommandLine& app, int& code);
void addMotion(CommandLine& app, int& code);
void addStick(CommandLine& app, int& code);
void addEmon(CommandLine& app, int& code);

}  // namespace kelpie::cli
