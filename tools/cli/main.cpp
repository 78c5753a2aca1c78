// SPDX-License-Identifier: Apache-2.0
// kelpie: play, replay, look at, measure.
#include <fmt/core.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "tools/cli/Commands.h"
#include "tools/cli/Process.h"
#include "tools/cli/Usage.h"
#include "tools/cli/WholeFile.h"

namespace kelpie::cli {

int complain(const std::string& message, int code) {
  fmt::print(stderr, "kelpie: {}\n", message);
  return code;
}

bool onTerminal() { return isatty(STDERR_FILENO) != 0; }

namespace {

bool writeInto(const std::string& path, const std::string& text) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return false;
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  return std::fclose(file) == 0 && written;
}

}  // namespace

bool canWrite(const std::string& path) {
  if (path == "-") return true;
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return false;
  if (isDevice(path)) return access(path.c_str(), W_OK) == 0;
  const auto cut = path.rfind('/');
  const std::string folder = cut == std::string::npos ? "." : path.substr(0, cut + 1);
  return !path.empty() && access(folder.c_str(), W_OK | X_OK) == 0;
}

bool writeWhole(const std::string& path, const std::string& text) {
  if (path == "-") return std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (isDevice(path)) return writeInto(path, text);
  const std::string part = path + ".part";
  std::FILE* file = std::fopen(part.c_str(), "wb");
  if (file == nullptr) return false;
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  const bool closed = std::fclose(file) == 0;
  const Status whole = written && closed ? Status(Done{}) : Error{path};
  return putInPlace(whole, part, path).ok();
}

}  // namespace kelpie::cli

int main(int argc, char** argv) {
  kelpie::cli::useTargetMaths(argv);
  CLI::App app{
      "Kelpie makes the AIBO ERS-7 play soccer. Start with `kelpie play`: one robot in the\n"
      "simulated world looks for the ball and scores; then look at out/match.png, or replay,\n"
      "film and measure what it did.",
      "kelpie"};
  app.require_subcommand(1);
  app.footer("Exit codes: 0 done, 1 the check failed, 2 usage or bad input.");
  int code = kelpie::cli::kDone;
  kelpie::cli::addPlay(app, code);
  kelpie::cli::addReplay(app, code);
  kelpie::cli::addInfo(app, code);
  kelpie::cli::addImport(app, code);
  kelpie::cli::addCompress(app, code);
  kelpie::cli::addShow(app, code);
  kelpie::cli::addEvaluate(app, code);
  kelpie::cli::addFilm(app, code);
  kelpie::cli::addBench(app, code);
  kelpie::cli::addCalibrate(app, code);
  try {
    bool done = false;  // after help, or a mistake in the options
    const int usage = kelpie::cli::parseOptions(app, argc, argv, done);
    return done ? usage : code;
  } catch (const std::exception& error) {
    return kelpie::cli::complain(error.what(), kelpie::cli::kBadInput);
  }
}
