// SPDX-License-Identifier: Apache-2.0
#include "robot/agent/log/FrameMessages.h"

#include <memory>

#include "vision/pixels/PlaneImage.h"

namespace kelpie::agent {

bool isFrameInput(const std::string& topic) {
  return topic == kFrameInputTopic || topic == kPlaneFrameTopic || topic == kPictureFrameTopic;
}

namespace {

Status decodePictureFrame(const LogMessage& message, FrameInput& input) {
  const auto frame = std::make_unique<PictureFrame>();
  const Status read = decodeAs(message, *frame);
  if (!read) return read;
  frame->image = input.image;
  input = *frame;
  return Done{};
}

Status decodePlaneFrame(const LogMessage& message, FrameInput& input) {
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

}  // namespace

Status decodeFrameInput(const LogMessage& message, FrameInput& input) {
  if (message.topic() == kPlaneFrameTopic) return decodePlaneFrame(message, input);
  if (message.topic() == kPictureFrameTopic) return decodePictureFrame(message, input);
  return decodeAs(message, input);
}

}  // namespace kelpie::agent
