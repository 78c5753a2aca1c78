// SPDX-License-Identifier: Apache-2.0
// All that viewers get of one robot, frame by frame, on topics that begin with its name ("/red2/"),
// and its frames of reference on /tf. Remembers only what it decided last. Of a frame whose sensors
// were not recorded there is no body, of one without modes there are no hypotheses: what was drawn
// before stays.
#pragma once

#include <string>
#include <vector>

#include "robot/body/FieldDescription.h"
#include "robot/core/types/FrameOutput.h"
#include "tools/match/DecisionChanges.h"
#include "tools/viewer/Beliefs.h"
#include "tools/viewer/MessageSink.h"

namespace kelpie::viewer {

class RobotMessages {
 public:
  // `start`: when the robot's time was 0.
  RobotMessages(TeamColour team, std::uint8_t player, const body::FieldDescription& field,
                TimeUs start, MessageSink& sink);

  const std::string& robot() const { return robot_; }
  // From now on the body is drawn where it really is, which somebody else tells on /tf.
  void drawAtTruth() { bodyFrame_ = trueFrame(robot_); }
  // Without a picture `jpeg` is empty.
  void frame(const FrameInput& input, const std::vector<std::uint8_t>& jpeg,
             const FrameOutput& output);

 private:
  void send(const std::string& topic, const google::protobuf::Message& message);
  void transforms(const FrameOutput& output);
  void camera(const std::vector<std::uint8_t>& jpeg, const FrameOutput& output);
  void body(const FrameInput& input);
  void beliefs(const FrameOutput& output);
  void reasons(const FrameInput& input, const FrameOutput& output);

  std::string robot_;
  TeamColour team_;
  MapFrame map_;
  TimeUs start_;
  MessageSink& sink_;
  std::string bodyFrame_;
  TimeUs now_;  // of the frame that is being sent
  match::DecisionChanges changes_;
};

}  // namespace kelpie::viewer
