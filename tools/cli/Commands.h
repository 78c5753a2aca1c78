// SPDX-License-Identifier: Apache-2.0
// The subcommands of `kelpie`, one file each. Every add...() registers its options and what to run;
// `code` is the exit code: 0 done, 1 the check failed, 2 usage or bad input.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace kelpie::cli {

constexpr int kDone = 0;
constexpr int kCheckFailed = 1;
constexpr int kBadInput = 2;

void addPlay(CLI::App& app, int& code);
void addReplay(CLI::App& app, int& code);
void addInfo(CLI::App& app, int& code);
void addImport(CLI::App& app, int& code);
void addCompress(CLI::App& app, int& code);
void addShow(CLI::App& app, int& code);
void addEvaluate(CLI::App& app, int& code);
void addFilm(CLI::App& app, int& code);
void addBench(CLI::App& app, int& code);
void addCalibrate(CLI::App& app, int& code);

// Prints "kelpie: message" to standard error and returns `code`.
int complain(const std::string& message, int code);
// Whether progress may be drawn: standard error is a terminal.
bool onTerminal();
// Whether writeWhole may succeed: asked before minutes of work.
bool canWrite(const std::string& path);
// Writes a file whole or not at all; "-" is standard output, a device is written into.
bool writeWhole(const std::string& path, const std::string& text);

}  // namespace kelpie::cli
