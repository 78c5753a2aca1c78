// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/FrameVision.h"

#include <algorithm>
#include <cctype>
#include <memory>
#include <nlohmann/json.hpp>

#include "robot/agent/log/FrameMessages.h"
#include "robot/core/fields/FieldCheck.h"
#include "tools/cli/log/Logs.h"
#include "tools/match/ClassDrawing.h"
#include "tools/picture/PngFile.h"
#include "tools/studio/RefusedBlobs.h"
#include "vision/Vision.h"

namespace kelpie::studio {
namespace {

using nlohmann::json;

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

// "ballFewEdges" as "ball few edges".
std::string wordsOf(const std::string& name) {
  std::string words;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z') words += ' ';
    words += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return words;
}

// Upright in the image, around a box that is upright to the horizon.
json boxOf(const vision::HorizonFrame& frame, const vision::LevelBox& box) {
  double left = kImageWidth, top = kImageHeight, right = 0.0, bottom = 0.0;
  for (const double u : {box.left, box.right})
    for (const double v : {box.top, box.bottom}) {
      const PixelPoint p = frame.toImage({u, v});
      left = std::min(left, p.x);
      right = std::max(right, p.x);
      top = std::min(top, p.y);
      bottom = std::max(bottom, p.y);
    }
  return {std::max(left, 0.0), std::max(top, 0.0), std::min<double>(right, kImageWidth),
          std::min<double>(bottom, kImageHeight)};
}

}  // namespace

Expected<std::string> refusedJson(const std::string& log, TimeUs time) {
  const auto frame = frameAt(log, time);
  if (!frame) return Error{frame.error()};
  const FrameInput& input = *frame->input;
  const auto state = std::make_unique<vision::VisionState>(frame->config->calibration);
  const BodyState body = body::step(input, frame->config->body);
  const auto percepts =
      std::make_unique<Percepts>(vision::step({input, body}, frame->config->vision, *state));
  const vision::HorizonFrame level = vision::horizonFrameOf(body.camera);
  json list = json::array();
  for (const RefusedBlob& one : refusedBlobs(input, body, *percepts, frame->config->vision, *state))
    for (const std::string& reason : one.reasons)
      list.push_back({{"kind", vision::kColourNames[static_cast<std::size_t>(one.blob.colour)]},
                      {"reason", wordsOf(reason)},
                      {"box", boxOf(level, one.blob.box)}});
  return list.dump();
}

Status drawClasses(const std::string& log, TimeUs time, const std::string& out) {
  const auto frame = frameAt(log, time);
  if (!frame) return Error{frame.error()};
  const auto tables = std::make_unique<vision::PixelTables>(frame->config->calibration);
  tables->follow(vision::advanced(frame->input->light));
  return picture::writePng(out, match::drawClasses(frame->input->image, *tables));
}

}  // namespace kelpie::studio
