// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/log/Logs.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>

#include "robot/agent/log/FrameMessages.h"
#include "robot/core/log/LogTopics.h"
#include "tools/cli/Progress.h"
#include "tools/cli/Version.h"
#include "tools/cli/WholeFile.h"
#include "tools/picture/Jpeg.h"
#include "tools/sim/bodies/Randomisation.h"

namespace kelpie::cli {
namespace {

constexpr int kPictureQuality = 65;  // 2.5 KB; at 50 the blocks show when enlarged

// Reads one log ahead by one message.
struct Source {
  std::string path;
  LogReader reader;
  LogMessage message;
  bool more = false;

  void advance() { more = reader.next(message); }
};

template <class T>
Status copyAs(const LogMessage& message, LogWriter& out) {
  const auto value = std::make_unique<T>();
  const Status read = decodeAs(message, *value);
  if (read) out.write(message.topic(), message.time, *value);
  return read;
}

struct TopicCopy {
  const char* topic;
  Status (*copy)(const LogMessage&, LogWriter&);
};
constexpr std::array<TopicCopy, 11> kCopies = {{
    {kConfigTopic, copyAs<agent::AgentConfig>},
    {kFrameInputTopic, copyAs<FrameInput>},
    {kPlaneFrameTopic, copyAs<PlaneFrame>},
    {kPictureFrameTopic, copyAs<PictureFrame>},
    {kFrameOutputTopic, copyAs<FrameOutput>},
    {kMotionInputTopic, copyAs<MotionInput>},
    {kMotionOutputTopic, copyAs<MotionOutput>},
    {sim::kTruthTopic, copyAs<sim::TruthFrame>},
    {sim::kEventTopic, copyAs<sim::MatchEvent>},
    {sim::kRandomisedTopic, copyAs<sim::RandomisedWorld>},
    {"/unlike", copyAs<sim::RandomisedWorld>},  // as older logs have it
}};

// The source whose next message is the oldest; the first of equals, so that order is kept.
Source* oldest(std::vector<Source>& sources) {
  Source* best = nullptr;
  for (auto& source : sources)
    if (source.more && (best == nullptr || source.message.time < best->message.time))
      best = &source;
  return best;
}

std::size_t megabytesRead(const std::vector<Source>& sources) {
  std::uint64_t bytes = 0;
  for (const auto& source : sources) bytes += source.reader.offset();
  return static_cast<std::size_t>(bytes / 1000000);
}

// Copies a message, or not: one that does not decode is left out of the log, as are those of
// foreign topics and most of a truth that is thinned.
Status take(const LogMessage& message, ThinTruth* thin, LogWriter& out, Joined& joined) {
  const bool thinned = thin != nullptr && message.topic() == sim::kTruthTopic;
  const Expected<bool> copied = thinned ? thin->write(message, out) : copyMessage(message, out);
  if (!copied) ++joined.damaged;
  if (copied && !*copied && !thinned) ++joined.foreign;
  if (!copied || !*copied) return Done{};
  joined.first = joined.messages == 0 ? message.time : std::min(joined.first, message.time);
  joined.last = joined.messages == 0 ? message.time : std::max(joined.last, message.time);
  ++joined.messages;
  return out.status();
}

Status closeJoined(const std::vector<Source>& sources, LogWriter& out, Joined& joined) {
  for (const auto& source : sources) {
    if (!source.reader.status()) return source.reader.status();
    for (const auto& metadata : source.reader.metadata())
      out.metadata(metadata.name, metadata.entries);
    const std::string lacks = source.reader.lacks();
    if (!lacks.empty()) joined.lacks.push_back(source.path + ": " + lacks);
  }
  return out.close();
}

Status joinInto(std::vector<Source>& sources, std::size_t megabytes, bool thinTruth, LogWriter& out,
                Joined& joined) {
  Progress progress("log", "MB");
  ThinTruth thin;
  for (auto& source : sources) source.advance();
  for (Source* next = oldest(sources); next != nullptr; next = oldest(sources)) {
    const Status taken = take(next->message, thinTruth ? &thin : nullptr, out, joined);
    if (!taken) return taken;
    next->advance();
    progress(megabytesRead(sources), megabytes);
  }
  return closeJoined(sources, out, joined);
}

}  // namespace

LogOptions playLogOptions() {
  LogOptions options = defaultLogOptions();
  options.chunkUs = 400000;
  return options;
}

Expected<bool> copyMessage(const LogMessage& message, LogWriter& out) {
  for (const auto& entry : kCopies) {
    if (message.topic() != entry.topic) continue;
    const Status copied = entry.copy(message, out);
    return copied ? Expected<bool>(true) : Error{copied.error()};
  }
  return false;
}

Expected<LogFile> LogFile::create(const std::string& path, const agent::AgentConfig& config,
                                  const LogMap& parameterNotes, ImagesKept images,
                                  const LogOptions& options) {
  auto writer = LogWriter::open(path, options);
  if (!writer) return Error{writer.error()};
  writer->metadata("version", versionNotes());
  writer->metadata("parameters", parameterNotes);
  writeConfig(config, images, *writer);
  LogFile file(std::move(*writer), images);
  if (images == ImagesKept::planes) file.thin_ = std::make_unique<ThinFrames>(config.calibration);
  return Expected<LogFile>(std::move(file));
}

// The images that are made of planes again are of other colours than the robot's own.
void LogFile::writeConfig(const agent::AgentConfig& config, ImagesKept images, LogWriter& out) {
  if (images != ImagesKept::planes) return out.write(kConfigTopic, TimeUs{}, config);
  const auto nominal = std::make_unique<agent::AgentConfig>(config);
  if (const auto colours = vision::loadCalibration("nominal", "none"))
    nominal->calibration = *colours;
  out.write(kConfigTopic, TimeUs{}, *nominal);
}

void LogFile::motion(const MotionInput& input, const MotionOutput& output) {
  if (images_ <= ImagesKept::planes) return;
  writer_.write(kMotionInputTopic, input.time, input);
  writer_.write(kMotionOutputTopic, input.time, output);
}

bool LogFile::keepsImage(const FrameInput& input) {
  const double now = input.time.seconds();
  if (images_ == ImagesKept::none) return false;
  if (images_ == ImagesKept::all || now < kAllImagesSeconds) return true;
  if (now < nextImage_) return false;
  nextImage_ = now + kOneImageSeconds;
  return true;
}

void LogFile::drawPicture(const Image& image) {
  const auto jpeg = picture::jpegOf(image, kPictureQuality);
  picture_->jpeg.resize(std::min(jpeg.size(), JpegBytes::kCapacity));
  std::copy_n(jpeg.begin(), picture_->jpeg.size(), picture_->jpeg.begin());
}

void LogFile::frame(const FrameInput& input, const FrameOutput& output) {
  if (thin_) return thin_->write(input, output, writer_);
  if (keepsImage(input)) {
    writer_.write(kFrameInputTopic, input.time, input);
  } else {
    static_cast<FrameInput&>(*picture_) = input;
    if (images_ == ImagesKept::some) drawPicture(input.image);
    writer_.write(kPictureFrameTopic, input.time, *picture_);
  }
  writer_.write(kFrameOutputTopic, input.time, output);
}

bool hasImage(const LogMessage& message) {
  if (message.topic() != kPictureFrameTopic) return true;
  const auto frame = std::make_unique<PictureFrame>();
  return decodeAs(message, *frame).ok() && frame->jpeg.size() > 0;
}

Status decodeForPeople(const LogMessage& message, FrameInput& input) {
  if (message.topic() != kPictureFrameTopic) return agent::decodeFrameInput(message, input);
  const auto frame = std::make_unique<PictureFrame>();
  const Status read = decodeAs(message, *frame);
  if (!read) return read;
  frame->image = input.image;
  if (frame->jpeg.size() > 0 &&
      !picture::imageOfJpeg(frame->jpeg.begin(), frame->jpeg.size(), frame->image))
    return Error{"topic " + message.topic() + ", byte " + std::to_string(message.offset) +
                 ": no picture of 208 x 160 pixels"};
  input = *frame;
  return Done{};
}

void tellNotes(const LogReader& reader) {
  for (const auto& note : reader.notes()) fmt::print(stderr, "kelpie: {}\n", note);
}

Expected<Joined> mergeLogs(const std::vector<std::string>& logs, const std::string& out,
                           bool thinTruth) {
  std::vector<Source> sources;
  std::uint64_t bytes = 0;
  for (const auto& path : logs) {
    std::error_code ignored;
    bytes += std::filesystem::file_size(path, ignored);
    auto reader = LogReader::open(path);
    if (!reader) return Error{reader.error()};
    sources.push_back({path, std::move(*reader), {}, false});
  }
  const std::string part = out + ".part";
  auto writer = LogWriter::open(part);
  if (!writer) return Error{putInPlace(Error{writer.error()}, part, out).error()};
  Joined joined;
  const auto megabytes = static_cast<std::size_t>(bytes / 1000000);
  const Status placed =
      putInPlace(joinInto(sources, megabytes, thinTruth, *writer, joined), part, out);
  if (!placed) return Error{placed.error()};
  return joined;
}

}  // namespace kelpie::cli
