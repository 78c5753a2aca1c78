// SPDX-License-Identifier: Apache-2.0
#include "robot/host/RecordingSource.h"

#include <utility>

#include "robot/core/log/LogTopics.h"
#include "robot/net/GameControlData.h"

namespace kelpie::host {

RecordingSource::RecordingSource(std::string log, LogReader reader)
    : log_(std::move(log)), reader_(std::move(reader)), frame_(std::make_unique<FrameInput>()) {}

Expected<RecordingSource> RecordingSource::open(const std::string& log) {
  auto reader = LogReader::open(log);
  if (!reader) return Error{reader.error()};
  return RecordingSource(log, std::move(*reader));
}

Expected<bool> RecordingSource::next(WorldEvent& event) {
  LogMessage message;
  while (reader_.next(message)) {
    event.step = WorldStep{};
    const bool sensors = message.topic() == kMotionInputTopic;
    if (message.topic() == kPlaneFrameTopic)
      return Error{log_ + ": holds class planes, no images of a camera that OPEN-R could give; " +
                   "kelpie replay reads them"};
    if (message.topic() == kPictureFrameTopic)
      return Error{log_ + ": holds pictures in place of images; record with --images all to go " +
                   "through OPEN-R again, or use kelpie replay"};
    if (!sensors && message.topic() != kFrameInputTopic) continue;
    const Status taken = sensors ? takeSensors(message, event) : takeImage(message, event);
    if (!taken) return Error{log_ + ": " + taken.error()};
    event.step.control = control_;
    return true;
  }
  if (!reader_.status()) return Error{reader_.status().error()};
  if (const std::string lacks = reader_.lacks(); !lacks.empty()) return Error{log_ + ": " + lacks};
  return false;
}

Status RecordingSource::takeSensors(const LogMessage& message, WorldEvent& event) {
  const Status read = decodeAs(message, motion_);
  if (!read) return read;
  std::string why;
  if (!verify(motion_, &why)) return Error{"damaged sensors: " + why};
  if (motion_.time.us < kTicksPerMessage * kTickUs)
    return Error{"sensor ticks before the robot's time began"};
  event.step.time = motion_.time;
  event.step.sensorsPresent = true;
  event.step.firstTick = static_cast<std::uint32_t>(motion_.time.us / kTickUs) - kTicksPerMessage;
  for (std::size_t i = 0; i < kTicksPerMessage; ++i)
    event.step.sensors[i] = rawOf(motion_.sensors[i]);
  event.step.batteryCurrent = motion_.batteryCurrent;
  event.step.batteryCharge = motion_.batteryCharge;
  sensorsSeen_ = true;
  if (waiting_ > 0) {
    event.step.vectorsDone = 1;
    --waiting_;
  }
  return Done{};
}

Status RecordingSource::takeImage(const LogMessage& message, WorldEvent& event) {
  if (!sensorsSeen_) return Error{"an image comes before all sensors: not a log of an agent"};
  const Status read = decodeAs(message, *frame_);
  if (!read) return read;
  event.step.time = {frame_->time.us + kExposureUs / 2};
  event.step.imagePresent = true;
  event.image = frame_->image;
  control_ = net::packetOf(net::controlFrom(frame_->game));
  return Done{};
}

Status RecordingSource::reply(const AgentReply& reply) {
  waiting_ += static_cast<std::uint32_t>(reply.vectors.size());
  return Done{};
}

}  // namespace kelpie::host
