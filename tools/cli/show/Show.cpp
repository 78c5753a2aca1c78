// SPDX-License-Identifier: Apache-2.0
// One frame of a log or of a folder of images, run through body and vision again and drawn.
#include <fmt/core.h>

#include <filesystem>
#include <memory>

#include "robot/agent/log/FrameMessages.h"
#include "robot/core/fields/FieldCheck.h"
#include "tools/calibrate/Images.h"
#include "tools/cli/Commands.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/log/Logs.h"
#include "tools/cli/log/Recording.h"
#include "tools/cli/log/ThinLog.h"
#include "tools/cli/options/Config.h"
#include "tools/cli/show/Sheet.h"
#include "tools/match/TraceWords.h"
#include "tools/picture/FileNames.h"
#include "tools/picture/JpegFile.h"
#include "tools/picture/PngFile.h"
#include "vision/Vision.h"

namespace kelpie::cli {
namespace {

using namespace match;

namespace fs = std::filesystem;

struct ShowOptions {
  std::string source;
  std::uint32_t frame = 0;
  std::string out;
  ConfigOptions config;
};

struct Shot {
  std::unique_ptr<FrameInput> input = std::make_unique<FrameInput>();
  std::unique_ptr<agent::AgentConfig> config = std::make_unique<agent::AgentConfig>();
  bool configured = false;
  bool pictureOnly = false;      // vision sees a JPEG picture in place of the image
  std::vector<std::string> why;  // of its decision, where the source is a log with outputs
  std::uint32_t frames = 0;      // in the source
  std::string lacks;             // what of the log could not be read
};

Error noSuchFrame(const ShowOptions& options, const Shot& shot) {
  const std::string rest = shot.lacks.empty() ? "" : "; " + shot.lacks;
  if (shot.frames == 0) return {options.source + ": holds no frames of an agent" + rest};
  return {fmt::format("{}: no frame {}, there are {} (0 to {}){}", options.source, options.frame,
                      shot.frames, shot.frames - 1, rest)};
}

Status takeMessage(const LogMessage& message, const ShowOptions& options, Shot& shot) {
  if (message.topic() == kConfigTopic) {
    shot.configured = true;
    return decodeAs(message, *shot.config);
  }
  if (message.topic() == kFrameOutputTopic && shot.frames == options.frame + 1) {
    const auto output = std::make_unique<FrameOutput>();
    if (decodeAs(message, *output))
      shot.why = reasonLines(shot.input->drive.present, output->command);
    return Done{};
  }
  if (!agent::isFrameInput(message.topic())) return Done{};
  if (!shot.configured) return Error{message.topic() + " comes before " + kConfigTopic};
  if (shot.frames++ != options.frame) return Done{};
  shot.pictureOnly = message.topic() == kPictureFrameTopic;
  return decodeForPeople(message, *shot.input);
}

Error noImageOf(const ShowOptions& options) {
  const std::uint32_t before = options.frame / kPlaneEvery * kPlaneEvery;
  return {fmt::format("{}: keeps no image of frame {}; it does of {} and {}", options.source,
                      options.frame, before, before + kPlaneEvery)};
}

Expected<Shot> fromLog(const ShowOptions& options) {
  if (options.frame % kPlaneEvery != 0 && isThinned(options.source)) return noImageOf(options);
  auto reader = LogReader::open(options.source);
  if (!reader) return Error{reader.error()};
  Shot shot;
  LogMessage message;
  while (reader->next(message)) {
    const Status taken = takeMessage(message, options, shot);
    if (!taken) return Error{options.source + ": " + taken.error()};
  }
  if (!reader->status()) return Error{reader->status().error()};
  tellNotes(*reader);
  shot.lacks = reader->lacks();
  if (options.frame >= shot.frames) return noSuchFrame(options, shot);
  const Status applied = applyConfig(options.config, *shot.config);
  if (!applied) return Error{applied.error()};
  return shot;
}

Expected<Shot> fromFolder(const ShowOptions& options) {
  const auto recording = readRecording(options.source);
  if (!recording) return Error{recording.error()};
  const auto& rows = recording->rows;
  Shot shot;
  shot.frames = static_cast<std::uint32_t>(rows.size());
  const std::uint32_t n = options.frame;
  if (n >= shot.frames) return noSuchFrame(options, shot);
  const auto image = calibrate::readImage(recording->files[n]);
  if (!image) return Error{image.error()};
  *shot.input = frameInput(n, rows[n], n > 0 ? &rows[n - 1] : nullptr);
  shot.input->image = *image;
  const auto config = makeConfig(options.config);
  if (!config) return Error{config.error()};
  *shot.config = *config;
  return shot;
}

cv::Mat sheetOf(const ShowOptions& options, const Shot& shot) {
  const auto output = std::make_unique<FrameOutput>();
  const auto state = std::make_unique<vision::VisionState>(shot.config->calibration);
  output->body = body::step(*shot.input, shot.config->body);
  output->percepts = vision::step({*shot.input, output->body}, shot.config->vision, *state);
  const auto title =
      fmt::format("{}: frame {} (of 0 to {}), {:.2f} s{}",
                  fs::path(options.source).filename().string(), options.frame, shot.frames - 1,
                  shot.input->time.seconds(), shot.pictureOnly ? ", seen in its JPEG picture" : "");
  return drawSheet({title, *shot.input, *output, *state, shot.why});
}

bool isJpeg(const std::string& path) {
  const std::string ending = picture::endingOf(path);
  return ending == ".jpg" || ending == ".jpeg";
}

bool isPicture(const std::string& path) {
  const std::string ending = picture::endingOf(path);
  return ending.empty() || ending == ".png" || isJpeg(path);
}

Status draw(const ShowOptions& options, const Shot& shot) {
  std::string why;
  if (!verify(*shot.input, &why))
    return Error{fmt::format("{}: frame {} is damaged: {}", options.source, options.frame, why)};
  const bool png = !isJpeg(options.out);
  const cv::Mat sheet = sheetOf(options, shot);
  return png ? picture::writePng(options.out, sheet) : picture::writeJpeg(options.out, sheet);
}

int show(const ShowOptions& options) {
  if (isDevice(options.out)) return fail(options.out + ": not a plain file", kExitBadInput);
  if (sameFile(options.source, options.out))
    return fail(options.out + ": is the log itself", kExitBadInput);
  if (!isPicture(options.out))
    return fail(options.out + ": show writes .png and .jpg", kExitBadInput);
  std::error_code error;
  const auto shot =
      fs::is_directory(options.source, error) ? fromFolder(options) : fromLog(options);
  if (!shot) return fail(shot.error(), kExitBadInput);
  const Status drawn = draw(options, *shot);
  if (!drawn) return fail(drawn.error(), kExitBadInput);
  fmt::print("{}\n", options.out);
  return shot->lacks.empty() ? kExitDone : fail(options.source + ": " + shot->lacks, kExitBadInput);
}

}  // namespace

void addShow(CommandLine& app, int& code) {
  auto command = app.subcommand("show", "A picture of one frame and all that vision made of it");
  auto options = std::make_shared<ShowOptions>();
  command.option("SOURCE", options->source, "A log, or a folder as for import").required();
  command.option("--frame", options->frame, "Which frame, from 0").showDefault();
  command.option("--out", options->out, "The picture to write, .png or .jpg").required();
  addConfigOptions(command, options->config);
  command.callback([options, &code] { code = show(*options); });
}

}  // namespace kelpie::cli
