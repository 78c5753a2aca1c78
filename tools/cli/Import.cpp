// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <memory>

#include "robot/agent/Replay.h"
#include "robot/core/LogWriter.h"
#include "tools/calibrate/Images.h"
#include "tools/cli/Commands.h"
#include "tools/cli/Config.h"
#include "tools/cli/Recording.h"
#include "tools/cli/WholeFile.h"

namespace kelpie::cli {
namespace {

struct ImportOptions {
  std::string folder;
  std::string out;
  ConfigOptions config;
};

Status writeFrames(const std::vector<std::string>& files, const std::vector<RecordedRow>& rows,
                   LogWriter& log) {
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto image = calibrate::readImage(files[i]);
    if (!image) return Error{image.error()};
    FrameInput input =
        frameInput(static_cast<std::uint32_t>(i), rows[i], i > 0 ? &rows[i - 1] : nullptr);
    input.image = *image;
    log.write(kFrameInputTopic, input.time, input);
  }
  return Done{};
}

Status importFolder(const ImportOptions& options, const std::string& part) {
  const auto files = listFrames(options.folder + "/frames");
  if (!files) return Error{files.error()};
  const std::string table = options.folder + "/sensors.csv";
  const auto rows = readSensorRows(table);
  if (!rows) return Error{rows.error()};
  if (rows->size() != files->size())
    return Error{fmt::format("{}: {} rows for {} frames", table, rows->size(), files->size())};
  const auto config = makeConfig(options.config);
  if (!config) return Error{config.error()};
  auto log = LogWriter::open(part);
  if (!log) return Error{log.error()};
  log->metadata("kelpie", {{"imported", std::to_string(files->size()) + " frames"}});
  log->write(kConfigTopic, TimeUs{}, *config);
  const Status frames = writeFrames(*files, *rows, *log);
  return frames ? log->close() : frames;
}

int import(const ImportOptions& options) {
  if (isDevice(options.out)) return complain(options.out + ": not a plain file", kBadInput);
  const std::string part = options.out + ".part";
  const Status done = putInPlace(importFolder(options, part), part, options.out);
  if (!done) return complain(done.error(), kBadInput);
  fmt::print("{}\n", options.out);
  return kDone;
}

}  // namespace

void addImport(CLI::App& app, int& code) {
  auto* command = app.add_subcommand(
      "import", "A log of foreign recordings: frames/NNNNNN.yuv|png and sensors.csv");
  auto options = std::make_shared<ImportOptions>();
  command->add_option("DIR", options->folder, "Folder with frames/ and sensors.csv")->required();
  command->add_option("--out", options->out, "The log to write")->required();
  addConfigOptions(*command, options->config);
  command->callback([options, &code] { code = import(*options); });
}

}  // namespace kelpie::cli
