// SPDX-License-Identifier: Apache-2.0
// kelpie: play, replay, look at, measure.
#include <fcntl.h>

#include <cstdio>
#include <exception>
#include <iostream>

#include "tools/cli/Commands.h"
#include "tools/cli/Process.h"
#include "tools/cli/options/Usage.h"

namespace {

// Whoever starts us with a closed standard input, output or error would have our sockets take its
// number, and words be written into them.
void openStandardFiles() {
  for (int file = 0; file <= 2; ++file)
    if (fcntl(file, F_GETFD) < 0) (void)open("/dev/null", O_RDWR);
}

// What was said may be lost after all, on a full disk for one: then it has failed.
int afterWords(int code) {
  std::cout.flush();
  const bool said = std::cout.good() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (said) return code;
  return kelpie::cli::fail("standard output cannot be written", kelpie::cli::kExitMachine);
}

}  // namespace

int main(int argc, char** argv) {
  openStandardFiles();
  kelpie::cli::useTargetMaths(argv);
  kelpie::cli::ProgramLine app{
      "Kelpie makes the AIBO ERS-7 play soccer. Start with `kelpie play`: one robot in the\n"
      "simulated world looks for the ball and scores; then look at out/match.png, or replay,\n"
      "film and measure what it did.",
      "kelpie"};
  app.requireSubcommand();
  app.footer(
      "Exit codes: 0 done, 1 a check failed, 2 wrong use or input, 3 the machine failed (disk,\n"
      "memory, a process that died), 130 interrupted.");
  int code = kelpie::cli::kExitDone;
  kelpie::cli::addPlay(app, code);
  kelpie::cli::addNewTeam(app, code);
  kelpie::cli::addGameController(app, code);
  kelpie::cli::addTeleop(app, code);
  kelpie::cli::addStudio(app, code);
  kelpie::cli::addReplay(app, code);
  kelpie::cli::addInfo(app, code);
  kelpie::cli::addRecover(app, code);
  kelpie::cli::addImport(app, code);
  kelpie::cli::addCompress(app, code);
  kelpie::cli::addShow(app, code);
  kelpie::cli::addWhy(app, code);
  kelpie::cli::addTree(app, code);
  kelpie::cli::addVectors(app, code);
  kelpie::cli::addEvaluate(app, code);
  kelpie::cli::addExport(app, code);
  kelpie::cli::addFilm(app, code);
  kelpie::cli::addBench(app, code);
  kelpie::cli::addLeague(app, code);
  kelpie::cli::addFarm(app, code);
  kelpie::cli::addValue(app, code);
  kelpie::cli::addCalibrate(app, code);
  kelpie::cli::addMotion(app, code);
  kelpie::cli::addStick(app, code);
  kelpie::cli::addEmon(app, code);
  try {
    bool done = false;  // after help, or a mistake in the options
    const int usage = kelpie::cli::parseOptions(app, argc, argv, done);
    return afterWords(done ? usage : code);
  } catch (const std::exception& error) {
    return kelpie::cli::fail(error.what(), kelpie::cli::kExitBadInput);
  }
}
