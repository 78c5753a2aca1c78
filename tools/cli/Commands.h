// SPDX-License-Identifier: Apache-2.0
// The subcommands of `kelpie`, one file each. Every add...() registers its options and what to run;
// `code` is the exit code (Terminal.h).
#pragma once

#include "tools/cli/CommandLine.h"
#include "tools/cli/Terminal.h"

namespace kelpie::cli {

void addPlay(CLI::App& app, int& code);
void addGameController(CLI::App& app, int& code);
void addTeleop(CLI::App& app, int& code);
void addReplay(CLI::App& app, int& code);
void addInfo(CLI::App& app, int& code);
void addRecover(CLI::App& app, int& code);
void addImport(CLI::App& app, int& code);
void addCompress(CLI::App& app, int& code);
void addShow(CLI::App& app, int& code);
void addWhy(CLI::App& app, int& code);
void addTree(CLI::App& app, int& code);
void addVectors(CLI::App& app, int& code);
void addEvaluate(CLI::App& app, int& code);
void addFilm(CLI::App& app, int& code);
void addBench(CLI::App& app, int& code);
void addLeague(CLI::App& app, int& code);
void addCalibrate(CLI::App& app, int& code);
void addMotion(CLI::App& app, int& code);
void addStick(CLI::App& app, int& code);
void addEmon(CLI::App& app, int& code);

}  // namespace kelpie::cli
