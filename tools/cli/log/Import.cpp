// SPDX-License-Identifier: Apache-2.0
// A log made of somebody's own images and joint angles: their inputs, and the outputs that the
// stages make of them, so that it can be shown, filmed and checked like the log of a match.
#include <fmt/core.h>

#include <memory>

#include "gps/camera/Focal.h"
#include "gps/camera/Lag.h"
#include "gps/camera/Tilt.h"
#include "robot/agent/loops/FrameLoop.h"
#include "robot/core/log/LogTopics.h"
#include "robot/core/log/LogWriter.h"
#include "tools/calibrate/Images.h"
#include "tools/cli/Commands.h"
#include "tools/cli/Process.h"
#include "tools/cli/Progress.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/log/Recording.h"
#include "tools/cli/options/Config.h"
#include "tools/cli/show/RecordedTrack.h"
#include "tools/picture/FileNames.h"

namespace kelpie::cli {
namespace {

struct ImportOptions {
  std::string folder;
  std::string out;
  std::string pycode = defaultScripts();
  ConfigOptions config;
};

// What is believed of the camera after a frame is what the next one is read with, as the agent does
// it: else every frame's landmarks are read with the tilt that nobody knows.
class Beliefs {
 public:
  explicit Beliefs(const gps::GpsParams& params)
      : tilt_(gps::startingTilt(params.tilt)),
        focal_(gps::startingFocal(params.focal)),
        lag_(gps::startingLag(params.lag)) {}

  FrameInput inputOf(std::size_t n, RecordedTrack& track) const {
    FrameInput input = track.input(n, lag_.seconds);
    input.cameraTilt = tilt_;
    input.focalScale = focal_;
    input.imageLag = lag_;
    input.light = light_;
    return input;
  }
  void take(const FrameOutput& output) {
    tilt_ = output.world.cameraTilt;
    focal_ = output.world.focalScale;
    lag_ = output.world.imageLag;
    light_ = output.percepts.light;
  }

 private:
  CameraTilt tilt_;
  FocalScale focal_;
  ImageLag lag_;
  CameraLight light_;
};

// A terminal shows how far it is: an image takes a few ms, but an hour of them has 108000.
Status writeFrames(const Recording& recording, const gps::GpsParams& params, agent::FrameLoop& loop,
                   LogWriter& log) {
  Progress progress("import", "frames");
  agent::StageObserver silent;
  RecordedTrack track(recording.rows);
  Beliefs beliefs(params);
  const std::size_t frames = recording.rows.size();
  for (std::size_t i = 0; i < frames; ++i) {
    const auto image = calibrate::readImage(recording.files[i]);
    if (!image) return Error{image.error()};
    FrameInput input = beliefs.inputOf(i, track);
    input.image = *image;
    const FrameOutput& output = loop.step(input, silent);
    beliefs.take(output);
    log.write(kFrameInputTopic, input.time, input);
    log.write(kFrameOutputTopic, input.time, output);
    if (interrupted()) return Error{"interrupted"};
    progress(i + 1, frames);
  }
  return Done{};
}

// The log must not take the place of what it is made from.
Status checkTarget(const std::string& out, const Recording& recording, const std::string& folder) {
  std::vector<std::string> inputs = recording.files;
  inputs.push_back(picture::fileIn(folder, "sensors.csv"));
  for (const auto& input : inputs)
    if (sameFile(out, input)) return Error{out + ": is part of the recording itself"};
  return Done{};
}

Status importFolder(const ImportOptions& options, const std::string& part) {
  const auto recording = readRecording(options.folder);
  if (!recording) return Error{recording.error()};
  const Status target = checkTarget(options.out, *recording, options.folder);
  if (!target) return target;
  auto config = makeConfig(options.config);
  if (!config) return Error{config.error()};
  config->behaviour.reload = false;  // the scripts as they are now, to the recording's end
  const auto loop = std::make_unique<agent::FrameLoop>(*config, options.pycode);
  if (!loop->scriptError().empty()) return Error{loop->scriptError()};
  auto log = LogWriter::open(part);
  if (!log) return Error{log.error()};
  log->metadata("kelpie", {{"imported", std::to_string(recording->files.size()) + " frames"}});
  log->metadata("parameters", parameterNotes(options.config));
  log->write(kConfigTopic, TimeUs{}, *config);
  const Status frames = writeFrames(*recording, config->gps, *loop, *log);
  return frames ? log->close() : frames;
}

int import(const ImportOptions& options) {
  catchInterrupts();
  if (isDevice(options.out)) return fail(options.out + ": not a plain file", kExitBadInput);
  const Status scripts = checkScripts(options.pycode);
  if (!scripts) return fail(scripts.error(), kExitBadInput);
  const std::string part = options.out + ".part";
  const Status done = putInPlace(importFolder(options, part), part, options.out);
  if (!done) return fail(done.error(), kExitBadInput);
  fmt::print("{}\n", options.out);
  return kExitDone;
}

}  // namespace

void addImport(CommandLine& app, int& code) {
  auto command = app.subcommand(
      "import", "A log of your own frames and joint angles, with what the stages make of them");
  auto options = std::make_shared<ImportOptions>();
  command.option("DIR", options->folder, "Folder with frames/ and sensors.csv, see below")
      .required();
  command.option("--out", options->out, "The log to write").required();
  command.option("--pycode", options->pycode, "Behaviours (default: pycode/)")
      .check(existingPath());
  addConfigOptions(command, options->config);
  command.footer(recordingHelp());
  command.callback([options, &code] { code = import(*options); });
}

}  // namespace kelpie::cli
