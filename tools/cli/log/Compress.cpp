// SPDX-License-Identifier: Apache-2.0
// A log with class planes in place of images, a fifteenth of the size, with the outputs
// that the stages make of them: a recording small enough to keep, and to compare with later.
#include <fmt/core.h>

#include <filesystem>
#include <memory>

#include "robot/agent/log/FrameMessages.h"
#include "robot/agent/loops/FrameLoop.h"
#include "tools/cli/Commands.h"
#include "tools/cli/Process.h"
#include "tools/cli/Progress.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/log/Logs.h"
#include "tools/cli/log/ThinLog.h"
#include "tools/cli/options/Config.h"
#include "vision/pixels/PlaneImage.h"

namespace kelpie::cli {
namespace {

struct CompressOptions {
  std::string log;
  std::string out;
  std::string pycode = defaultScripts();
};

// Takes a log's messages one by one and writes the smaller log.
class Compressor {
 public:
  Compressor(LogWriter& out, std::string scripts) : out_(out), scripts_(std::move(scripts)) {}

  Status take(const LogMessage& message) {
    if (message.topic() == kConfigTopic) return configure(message);
    if (agent::isFrameInput(message.topic())) return frame(message);
    if (message.topic() == kFrameOutputTopic) return Done{};  // of the images: made again here
    const auto copied = copyMessage(message, out_);
    return copied ? Status(Done{}) : Error{copied.error()};
  }
  std::size_t frames() const { return frames_; }
  double bytesPerFrame() const {
    return static_cast<double>(bytes_) / static_cast<double>(frames_);
  }

 private:
  Status configure(const LogMessage& message) {
    const auto config = std::make_unique<agent::AgentConfig>();
    const Status read = decodeAs(message, *config);
    if (!read) return read;
    tables_ = std::make_unique<vision::PixelTables>(config->calibration);
    const auto nominal = vision::loadCalibration("nominal", "none");
    if (!nominal) return Error{nominal.error()};
    config->calibration = *nominal;
    config->behaviour.reload = false;
    out_.write(kConfigTopic, message.time, *config);
    loop_ = std::make_unique<agent::FrameLoop>(*config, scripts_);
    return loop_->scriptError().empty() ? Status(Done{}) : Error{loop_->scriptError()};
  }
  Status frame(const LogMessage& message) {
    if (!loop_) return Error{message.topic() + " comes before " + kConfigTopic};
    const Status read = decodeForPeople(message, *frame_);
    if (!read) return read;
    vision::ClassPlane plane{};
    tables_->follow(vision::advanced(frame_->light));
    vision::classifyWhole(frame_->image, *tables_, plane);
    encodePlane(plane, frame_->plane);
    vision::imageOf(plane, frame_->image);
    frame_->light = {};  // the plane's own colours are those that the table was made for
    out_.write(kPlaneFrameTopic, message.time, *frame_);
    out_.write(kFrameOutputTopic, message.time, loop_->step(*frame_, silent_));
    bytes_ += encodedSize(*frame_);
    ++frames_;
    return Done{};
  }

  LogWriter& out_;
  std::string scripts_;
  std::unique_ptr<vision::PixelTables> tables_;  // of the recorded images
  std::unique_ptr<agent::FrameLoop> loop_;
  std::unique_ptr<PlaneFrame> frame_ = std::make_unique<PlaneFrame>();
  agent::StageObserver silent_;
  std::size_t frames_ = 0;
  std::size_t bytes_ = 0;
};

struct Outcome {
  std::string lacks;  // a complaint when not all of the log could be read
};

Expected<Outcome> compressInto(const CompressOptions& options, const std::string& part) {
  auto reader = LogReader::open(options.log);
  if (!reader) return Error{reader.error()};
  auto writer = LogWriter::open(part);
  if (!writer) return Error{writer.error()};
  Compressor compressor(*writer, options.pycode);
  LogMessage message;
  Progress progress("compress", "MB");
  std::error_code ignored;
  const auto bytes = std::filesystem::file_size(options.log, ignored);
  while (reader->next(message)) {
    if (interrupted()) return Error{"interrupted"};
    progress(reader->offset() / 1000000, bytes / 1000000);
    const Status taken = compressor.take(message);
    if (!taken) return Error{options.log + ": " + taken.error()};
  }
  if (!reader->status()) return Error{reader->status().error()};
  tellNotes(*reader);
  if (compressor.frames() == 0) return Error{options.log + ": holds no frames of an agent"};
  for (const auto& metadata : reader->metadata()) writer->metadata(metadata.name, metadata.entries);
  writer->metadata("compressed", {{"frames", std::to_string(compressor.frames())}});
  const Status closed = writer->close();
  if (!closed) return Error{closed.error()};
  fmt::print("{}: {} frames, {:.2f} KB a frame (an image has {:.1f})\n", options.out,
             compressor.frames(), compressor.bytesPerFrame() / 1024.0, 3.0 * kImagePixels / 1024.0);
  const std::string lacks = reader->lacks();
  if (lacks.empty()) return Outcome{};
  return Outcome{
      fmt::format("{}: {}; all whole frames are in {}", options.log, lacks, options.out)};
}

int compress(const CompressOptions& options) {
  catchInterrupts();
  if (isDevice(options.out)) return fail(options.out + ": not a plain file", kExitBadInput);
  if (sameFile(options.log, options.out))
    return fail(options.out + ": is the log itself", kExitBadInput);
  if (isThinned(options.log))
    return fail(options.log + ": keeps class planes already", kExitBadInput);
  const Status scripts = checkScripts(options.pycode);
  if (!scripts) return fail(scripts.error(), kExitBadInput);
  const std::string part = options.out + ".part";
  const auto outcome = compressInto(options, part);
  const Status done = outcome ? Status(Done{}) : Error{outcome.error()};
  const Status placed = putInPlace(done, part, options.out);
  if (!placed) return fail(placed.error(), kExitBadInput);
  return outcome->lacks.empty() ? kExitDone : fail(outcome->lacks, kExitBadInput);
}

}  // namespace

void addCompress(CommandLine& app, int& code) {
  auto command = app.subcommand(
      "compress", "A log with class planes in place of images, and what the stages make of them");
  auto options = std::make_shared<CompressOptions>();
  command.option("LOG", options->log, "The log").required();
  command.option("--out", options->out, "The log to write").required();
  command.option("--pycode", options->pycode, "Behaviours (default: pycode/)")
      .check(existingPath());
  command.callback([options, &code] { code = compress(*options); });
}

}  // namespace kelpie::cli
