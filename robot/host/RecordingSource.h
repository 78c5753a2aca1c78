// SPDX-License-Identifier: Apache-2.0
// A recorded log as the source of events: its sensor ticks and images pass the OPEN-R services and
// the agent's object again, in the order in which the robot got them. What the agent commands goes
// nowhere; vectors end as they would on the robot, one with every sensor message. Needs a log with
// motion inputs and images: imported frames and class planes are replayed without OPEN-R (kelpie
// replay). A log that lacks its end is an error after its last whole event.
#pragma once

#include <memory>
#include <string>

#include "robot/core/log/LogReader.h"
#include "robot/host/Source.h"

namespace kelpie::host {

class RecordingSource : public Source {
 public:
  static Expected<RecordingSource> open(const std::string& log);

  Expected<bool> next(WorldEvent& event) override;
  Status reply(const AgentReply& reply) override;

 private:
  RecordingSource(std::string log, LogReader reader);
  Status takeSensors(const LogMessage& message, WorldEvent& event);
  Status takeImage(const LogMessage& message, WorldEvent& event);

  std::string log_;
  LogReader reader_;
  std::unique_ptr<FrameInput> frame_;  // of the image read last; on the heap because of its size
  MotionInput motion_;
  ControlPacket control_;      // that tells what the robot knew of the match
  std::uint32_t waiting_ = 0;  // vectors sent and not yet ended
  bool sensorsSeen_ = false;
};

}  // namespace kelpie::host
