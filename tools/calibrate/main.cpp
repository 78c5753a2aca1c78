// SPDX-License-Identifier: Apache-2.0
// kelpie_calibrate: writes colour tables and ring tables in Kelpie's own format, with where they
// came from, and shows what such a file says about itself.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>

#include "vision/TableFile.h"
#include "vision/VisionCalibration.h"

namespace kelpie::vision {
namespace {

struct Options {
  std::string source;
  std::string out;
  std::string note;
};

int report(const std::string& error) {
  std::fprintf(stderr, "kelpie_calibrate: %s\n", error.c_str());
  return 1;
}

std::string provenance(const Options& options) {
  return "kelpie_calibrate from " + options.source +
         (options.note.empty() ? "" : "; " + options.note);
}

int writeColour(const Options& options) {
  const auto calibration = loadCalibration(options.source, "none");
  if (!calibration) return report(calibration.error());
  const Status done = saveColourTable(calibration->colour, options.out, provenance(options));
  return done ? 0 : report(done.error());
}

int writeRing(const Options& options) {
  const auto table = loadRingTable(options.source);
  if (!table) return report(table.error());
  const Status done = saveRingTable(*table, options.out, provenance(options));
  return done ? 0 : report(done.error());
}

int show(const Options& options) {
  const auto bytes = readBytes(options.source);
  if (!bytes) return report(bytes.error());
  auto file = parseTableFile(options.source, *bytes, TableKind::colour, sizeof(ColourTable));
  const bool isColour = static_cast<bool>(file);
  if (!isColour) file = parseTableFile(options.source, *bytes, TableKind::ring, sizeof(RingTable));
  if (!file) return report(file.error());
  std::printf("%s: %s table, %zu bytes, %s\n", options.source.c_str(), isColour ? "colour" : "ring",
              file->data.size(), file->provenance.c_str());
  return 0;
}

CLI::App* addWriter(CLI::App& app, const char* name, const char* what, Options& options) {
  CLI::App* command = app.add_subcommand(name, what);
  command->add_option("source", options.source)->required();
  command->add_option("out", options.out)->required();
  command->add_option("--note", options.note, "robot, venue, date");
  return command;
}

}  // namespace
}  // namespace kelpie::vision

int main(int argc, char** argv) {
  using namespace kelpie::vision;
  Options options;
  CLI::App app("Calibration files for Kelpie's vision");
  app.require_subcommand(1);
  const auto* colour = addWriter(app, "colour", "\"nominal\", a 128^3 table or ours", options);
  const auto* ring = addWriter(app, "ring", "\"none\", \"2006\" or ours", options);
  auto* shown = app.add_subcommand("show", "what a file of ours says about itself");
  shown->add_option("source", options.source)->required();
  CLI11_PARSE(app, argc, argv);
  if (colour->parsed()) return writeColour(options);
  if (ring->parsed()) return writeRing(options);
  return show(options);
}
