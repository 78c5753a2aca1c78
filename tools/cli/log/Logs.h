// SPDX-License-Identifier: Apache-2.0
// Logs of an agent: writing one while it plays, and joining it with the world's.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "robot/agent/AgentConfig.h"
#include "robot/agent/log/LogSink.h"
#include "robot/agent/log/LoggedTypes.h"
#include "robot/core/log/LogReader.h"
#include "robot/core/log/LogWriter.h"
#include "tools/cli/log/ThinLog.h"

namespace kelpie::cli {

// Which camera images a log keeps; the others become JPEG pictures of 2.5 KB (an image, full of
// noise, compresses to no less than 70 KB). With `some` a match of ten minutes takes 160 MB. With
// `none` there are neither images nor pictures nor the motion loop's messages: what the robot knew,
// decided and did in each frame, for experiments. With `planes` there are class planes, and what
// ThinLog.h says: ten minutes of play take 16 MB.
enum class ImagesKept : std::uint8_t { none, planes, some, all };
constexpr double kAllImagesSeconds = 20.0;  // of the beginning, with `some`
constexpr double kOneImageSeconds = 5.0;    // afterwards one in so many

// Writes each input and output as it passes. Its first error stays in status().
class LogFile : public agent::LogSink {
 public:
  static Expected<LogFile> create(const std::string& path, const agent::AgentConfig& config,
                                  const LogMap& parameterNotes, ImagesKept images,
                                  const LogOptions& options = defaultLogOptions());

  void motion(const MotionInput& input, const MotionOutput& output) override;
  void frame(const FrameInput& input, const FrameOutput& output) override;
  Status status() const { return writer_.status(); }
  Status close() { return writer_.close(); }

 private:
  LogFile(LogWriter writer, ImagesKept images) : writer_(std::move(writer)), images_(images) {}
  static void writeConfig(const agent::AgentConfig& config, ImagesKept images, LogWriter& out);
  bool keepsImage(const FrameInput& input);
  void drawPicture(const Image& image);

  LogWriter writer_;
  ImagesKept images_;
  double nextImage_ = kAllImagesSeconds + kOneImageSeconds;  // s
  std::unique_ptr<PictureFrame> picture_ = std::make_unique<PictureFrame>();
  std::unique_ptr<ThinFrames> thin_;  // with `planes`
};

// Of a log that is written while a match is played: a process that is killed loses half a second.
LogOptions playLogOptions();

// Copies a message of a topic that we know; false for any other, which is left out.
Expected<bool> copyMessage(const LogMessage& message, LogWriter& out);

// As agent::decodeFrameInput, with the picture as the image where the image was not kept. Where
// there is no picture either the image is left as it was.
Status decodeForPeople(const LogMessage& message, FrameInput& input);
// Whether a frame's input that was decoded so has an image, a class plane or a picture of its own.
bool hasImage(const LogMessage& message);

// Tells the user which messages were read by translation from other field lists.
void tellNotes(const LogReader& reader);

// What a joined log holds, and what was left out of it.
struct Joined {
  std::size_t messages = 0;
  TimeUs first, last;
  std::size_t damaged = 0;         // messages that do not decode
  std::size_t foreign = 0;         // messages of topics that are not Kelpie's
  std::vector<std::string> lacks;  // "LOG: what of it could not be read"
};

// Joins logs by time, with their metadata, into `out`, written whole or not at all; what a cut-off
// log still holds is taken, as is all that is undamaged. Beside frames of `planes` the truth is
// thinned alike.
Expected<Joined> mergeLogs(const std::vector<std::string>& logs, const std::string& out,
                           bool thinTruth = false);

}  // namespace kelpie::cli
