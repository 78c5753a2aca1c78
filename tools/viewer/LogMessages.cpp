// SPDX-License-Identifier: Apache-2.0
#include "tools/viewer/LogMessages.h"

#include <algorithm>

#include "robot/agent/log/FrameMessages.h"
#include "robot/core/fields/FieldCheck.h"
#include "robot/core/log/LogTopics.h"
#include "tools/picture/Jpeg.h"

namespace kelpie::viewer {
namespace {

constexpr int kQuality = 85;  // of images that the log keeps whole

template <class T>
bool readSound(const LogMessage& message, T& value) {
  return decodeAs(message, value) && verify(value, nullptr);
}

}  // namespace

bool SharedWorld::isTold(const std::string& topic, TimeUs time, std::size_t log) {
  const auto [told, fresh] = told_.try_emplace(topic, Told{time, log});
  if (fresh || told->second.time < time) {
    told->second = {time, log};
    return true;
  }
  return told->second.log == log;
}

bool SharedWorld::enter(const std::string& robot) {
  world_.drawnElsewhere(robot);
  return robots_.insert(robot).second;
}

Status LogMessages::take(const LogMessage& message) {
  const std::string& topic = message.topic();
  if (topic == kConfigTopic) return configure(message);
  bool sound = true;
  if (agent::isFrameInput(topic)) sound = inputKnown_ = takeInput(message);
  if (topic == kFrameOutputTopic) sound = takeOutput(message);
  if (topic == sim::kTruthTopic) sound = takeTruth(message);
  if (topic == sim::kEventTopic) sound = takeEvent(message);
  damaged_ += sound ? 0 : 1;
  return Done{};
}

Status LogMessages::configure(const LogMessage& message) {
  const auto config = std::make_unique<agent::AgentConfig>();
  const Status read = decodeAs(message, *config);
  if (!read) return read;
  robot_.emplace(config->team, config->player, config->field, world_.start(), world_.sink());
  if (!world_.enter(robot_->robot()))
    return Error{"is of " + robot_->robot() + ", as another of the logs is"};
  world_.messages().field(message.time, config->field);
  return Done{};
}

bool LogMessages::takeInput(const LogMessage& message) {
  jpeg_.clear();
  if (message.topic() == kPictureFrameTopic) {
    if (!decodeAs(message, *input_)) return false;
    jpeg_.assign(input_->jpeg.begin(), input_->jpeg.end());
    return true;
  }
  if (!agent::decodeFrameInput(message, *input_)) return false;
  jpeg_ = picture::jpegOf(input_->image, kQuality);
  return true;
}

// Without a configuration nobody knows whose frame it is.
bool LogMessages::takeOutput(const LogMessage& message) {
  if (!inputKnown_) return true;  // it was damaged, and counted
  const bool whole = robot_ && readSound(message, *output_) &&
                     verify(static_cast<const FrameInput&>(*input_), nullptr);
  inputKnown_ = false;
  if (!whole) return false;
  if (world_.messages().isPlaced(robot_->robot())) robot_->drawAtTruth();
  robot_->frame(*input_, jpeg_, *output_);
  ++frames_;
  return true;
}

bool LogMessages::takeTruth(const LogMessage& message) {
  sim::TruthFrame truth;
  if (!readSound(message, truth)) return false;
  if (!world_.isTold(message.topic(), message.time, number_)) return true;
  world_.messages().truth(truth);
  ++truths_;
  return true;
}

bool LogMessages::takeEvent(const LogMessage& message) {
  sim::MatchEvent event;
  if (!readSound(message, event)) return false;
  if (world_.isTold(message.topic(), message.time, number_)) world_.messages().event(event);
  return true;
}

}  // namespace kelpie::viewer
