// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/FrameVision.h"

#include <memory>

#include "robot/agent/log/FrameMessages.h"
#include "robot/core/fields/FieldCheck.h"
#include "tools/cli/log/Logs.h"
#include "tools/picture/PngFile.h"
#include "vision/pixels/ClassPicture.h"

namespace kelpie::studio {
namespace {

struct Frame {
  std::unique_ptr<agent::AgentConfig> config = std::make_unique<agent::AgentConfig>();
  std::unique_ptr<FrameInput> input = std::make_unique<FrameInput>();
};

// The configuration stands at the beginning of a log.
Status readConfig(LogReader& reader, agent::AgentConfig& config) {
  LogMessage message;
  while (reader.next(message))
    if (message.topic() == kConfigTopic) return decodeAs(message, config);
  return Error{"the log holds no configuration"};
}

Expected<Frame> frameAt(const std::string& log, TimeUs time) {
  auto reader = LogReader::open(log);
  if (!reader) return Error{reader.error()};
  Frame frame;
  const Status configured = readConfig(*reader, *frame.config);
  if (!configured) return Error{configured.error()};
  reader->seek(time);
  LogMessage message;
  while (reader->next(message) && !(time < message.time)) {
    if (!agent::isFrameInput(message.topic()) || message.time < time) continue;
    const Status read = cli::decodeForPeople(message, *frame.input);
    std::string why;
    if (!read) return Error{read.error()};
    if (!verify(*frame.input, &why)) return Error{"the frame is damaged: " + why};
    return frame;
  }
  return Error{"the log holds no image at that time"};
}

}  // namespace

Status drawClasses(const std::string& log, TimeUs time, const std::string& out) {
  const auto frame = frameAt(log, time);
  if (!frame) return Error{frame.error()};
  const auto plane = std::make_unique<vision::ClassPlane>();
  vision::classifyWhole(frame->input->image, frame->config->calibration, *plane);
  cv::Mat picture(kImageHeight, kImageWidth, CV_8UC3);
  for (std::size_t i = 0; i < plane->size(); ++i) {
    const vision::Rgb c = vision::kColourPalette[(*plane)[i]];
    picture.ptr<cv::Vec3b>()[i] = {c.b, c.g, c.r};
  }
  return picture::writePng(out, picture);
}

}  // namespace kelpie::studio
