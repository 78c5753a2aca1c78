// SPDX-License-Identifier: Apache-2.0
#include "tools/live/Relay.h"

#include <chrono>
#include <memory>

#include "robot/agent/log/FrameMessages.h"
#include "robot/core/log/LogTopics.h"
#include "tools/sim/bodies/Randomisation.h"
#include "tools/sim/world/Truth.h"
#include "tools/viewer/Schemas.h"

namespace kelpie::live {
namespace {

// Of what is told once a viewer that comes later is told, too.
bool staysTrue(const std::string& topic) {
  return topic == "/field" || topic == "/field/points" || topic == "/score";
}

bool isOfWorld(const std::string& topic) {
  return topic == sim::kTruthTopic || topic == sim::kEventTopic || topic == sim::kRandomisedTopic;
}

std::string robotOf(const LogMessage& configuration) {
  const auto config = std::make_unique<agent::AgentConfig>();
  if (!decodeAs(configuration, *config)) return {};
  return std::string(config->team == TeamColour::red ? "red" : "blue") + "-" +
         std::to_string(config->player);
}

}  // namespace

TimeUs wallTime() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return {std::chrono::duration_cast<std::chrono::microseconds>(now).count()};
}

void HubSink::take(const std::string& topic, TimeUs time,
                   const google::protobuf::Message& message) {
  if (!hub_.isOffered(topic))
    hub_.offer(topic, viewer::readyTypeOf(*message.GetDescriptor()), staysTrue(topic));
  message.SerializeToString(&bytes_);
  hub_.publish(topic, time, bytes_.data(), bytes_.size());
}

Relay::Relay(TimeUs start, Hub& viewers, Hub& studio, Clock::duration pause)
    : viewers_(viewers), studio_(studio), pause_(pause), sink_(viewers), world_(start, sink_) {}

std::size_t Relay::addLog() {
  const std::size_t number = sources_.size();
  sources_.push_back({{}, viewer::LogMessages(number, world_)});
  return number;
}

void Relay::take(std::size_t log, const LogMessage& message, bool late) {
  Source& source = sources_[log];
  if (message.topic() == kConfigTopic) source.robot = robotOf(message);
  passOn(source, log, message);
  convert(source, message, late);
}

void Relay::passOn(Source& source, std::size_t log, const LogMessage& message) {
  const std::string& topic = message.topic();
  const bool world = isOfWorld(topic);
  if (world && tellers_.emplace(topic, log).first->second != log) return;
  if (!world && source.robot.empty()) return;
  const std::string place = "/live/" + (world ? "world" : source.robot) + topic;
  if (!studio_.isOffered(place)) {
    const LogSchema& schema = message.schema();
    studio_.offer(place, {schema.name, schema.encoding, schema.text, "ros1"},
                  topic == kConfigTopic);
  }
  studio_.publish(place, message.time, message.data, message.size);
}

bool Relay::isDue(Clock::time_point& due, bool late) const {
  const auto now = Clock::now();
  if (late || !viewers_.hasPeers() || now < due) return false;
  due = now + pause_;
  return true;
}

// What a second log of one robot says, of an agent that was started again, goes on where the first
// ended: nobody is drawn twice.
void Relay::convert(Source& source, const LogMessage& message, bool late) {
  const std::string& topic = message.topic();
  if (agent::isFrameInput(topic)) source.leftOut = !isDue(source.frameDue, late);
  const bool frame = agent::isFrameInput(topic) || topic == kFrameOutputTopic;
  if (frame && source.leftOut) return;
  if (topic == sim::kTruthTopic && !isDue(source.truthDue, late)) return;
  (void)source.messages.take(message);
}

}  // namespace kelpie::live
