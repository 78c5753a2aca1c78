// SPDX-License-Identifier: Apache-2.0
#include "robot/agent/FrameMessages.h"

#include <memory>

#include "vision/PlaneImage.h"

namespace kelpie::agent {

bool isFrameInput(const std::string& topic) {
  return topic == kFrameInputTopic || topic == kPlaneFrameTopic;
}

Status decodeFrameInput(const LogMessage& message, FrameInput& input) {
  if (message.topic() != kPlaneFrameTopic) return decodeAs(message, input);
  const auto frame = std::make_unique<PlaneFrame>();
  const Status read = decodeAs(message, *frame);
  if (!read) return read;
  vision::ClassPlane plane{};
  const Status whole = decodePlane(frame->plane, vision::kColourClassCount, plane);
  if (!whole)
    return Error{"topic " + message.topic() + ", byte " + std::to_string(message.offset) + ": " +
                 whole.error()};
  vision::imageOf(plane, frame->image);
  input = *frame;
  return Done{};
}

}  // namespace kelpie::agent
