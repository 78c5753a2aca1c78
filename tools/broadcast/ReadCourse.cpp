// SPDX-License-Identifier: Apache-2.0
// Reads a course from logs.
#include <algorithm>
#include <memory>
#include <optional>
#include <set>

#include "robot/agent/log/LoggedTypes.h"
#include "robot/core/log/LogReader.h"
#include "robot/core/log/LogTopics.h"
#include "tools/broadcast/Course.h"

namespace kelpie::broadcast {
namespace {

// The blue team's field is the red team's turned by half a turn.
WorldModel onRedField(WorldModel world, const body::FieldDescription& field, TeamColour team) {
  if (team == TeamColour::red) return world;
  const auto turned = [&](Point2<Field> p) {
    return Point2<Field>{field.width - p.x, field.length - p.y};
  };
  world.pose.position = turned(world.pose.position);
  world.pose.heading = world.pose.heading + Angle::deg(180.0);
  world.ball.position = turned(world.ball.position);
  return world;
}

// Takes one log's messages for the course. Of the images it takes nothing.
class Source {
 public:
  Source(Course& course, bool believes) : course_(course), believes_(believes) {}

  Status take(const LogMessage& message) {
    if (message.topic() == kConfigTopic) return configure(message);
    if (message.topic() == sim::kTruthTopic && decodeAs(message, truth_)) course_.addTruth(truth_);
    sim::MatchEvent event;
    if (message.topic() == sim::kEventTopic && decodeAs(message, event)) course_.addEvent(event);
    if (player_) takeFrame(message);
    return Done{};
  }
  const std::optional<Player>& player() const { return player_; }

 private:
  Status configure(const LogMessage& message) {
    const auto config = std::make_unique<agent::AgentConfig>();
    const Status read = decodeAs(message, *config);
    if (!read) return read;
    player_ = Player{config->team, config->player};
    field_ = config->field;
    return Done{};
  }
  void takeFrame(const LogMessage& message) {
    if (message.topic() == kFrameInputTopic && decodeAs(message, *whole_)) takeJoints(*whole_);
    if (message.topic() == kPlaneFrameTopic && decodeAs(message, *plane_)) takeJoints(*plane_);
    if (message.topic() == kPictureFrameTopic && decodeAs(message, *picture_))
      takeJoints(*picture_);
    if (message.topic() == kFrameOutputTopic && believes_ && decodeAs(message, *output_))
      course_.addBelief(*player_, output_->time.seconds(),
                        onRedField(output_->world, field_, player_->first));
  }
  // Sensors that were left out of a log are all 0, which no standing robot's joints are.
  void takeJoints(const FrameInput& input) {
    const double seconds = input.time.seconds();
    course_.addFrame(*player_, {seconds, input.stance, input.motion.feeling.ballHeld});
    const auto& angles = input.sensors.joints.angle;
    if (std::any_of(angles.begin(), angles.end(), [](Angle a) { return a.rad() != 0.0; }))
      course_.addJoints(*player_, {seconds, input.sensors.joints});
  }

  Course& course_;
  bool believes_;
  std::optional<Player> player_;
  body::FieldDescription field_;
  sim::TruthFrame truth_;
  std::unique_ptr<FrameInput> whole_ = std::make_unique<FrameInput>();
  std::unique_ptr<PlaneFrame> plane_ = std::make_unique<PlaneFrame>();
  std::unique_ptr<PictureFrame> picture_ = std::make_unique<PictureFrame>();
  std::unique_ptr<FrameOutput> output_ = std::make_unique<FrameOutput>();
};

class Reading {
 public:
  explicit Reading(const std::function<bool()>& stopped) : stopped_(stopped) {}

  // Beliefs count where no log tells a truth, which is known only when all have been read.
  Status take(const std::string& path, bool believes) {
    auto reader = LogReader::open(path);
    if (!reader) return Error{reader.error()};
    Source source(read.course, believes);
    LogMessage message;
    while (reader->next(message)) {
      const bool known = source.player().has_value();
      const Status taken = source.take(message);
      if (!taken) return Error{path + ": " + taken.error()};
      if (!known && source.player() && !believes && !players_.insert(*source.player()).second)
        return Error{path + ": is of a robot that another of the logs is of"};
      if (stopped_ && stopped_()) return Error{"interrupted"};
    }
    if (!reader->status()) return reader->status();
    const std::string lacks = reader->lacks();
    if (!lacks.empty() && !believes) read.lacks.push_back(path + ": " + lacks);
    return Done{};
  }

  ReadCourse read;

 private:
  const std::function<bool()>& stopped_;
  std::set<Player> players_;
};

}  // namespace

Expected<ReadCourse> readCourse(const std::vector<std::string>& logs,
                                const std::function<bool()>& stopped) {
  Reading reading(stopped);
  for (const bool believes : {false, true}) {
    if (believes && !reading.read.course.empty()) break;
    for (const std::string& path : logs) {
      const Status taken = reading.take(path, believes);
      if (!taken) return Error{taken.error()};
    }
  }
  return std::move(reading.read);
}

}  // namespace kelpie::broadcast
