// SPDX-License-Identifier: Apache-2.0
// What moved in a match, as functions of time, from the logs of its robots: places of all by the
// world's truth, joints of those whose log is there, steps that are made up for the others and
// between joints that are far apart in time. Without a truth, as in a recording of a real robot,
// its robot is where it believes to be, and so is the ball. All on the red team's field. Holds no
// images.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "robot/body/FieldDescription.h"
#include "robot/core/Expected.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/FrameOutput.h"
#include "tools/broadcast/Stage.h"
#include "tools/sim/world/Truth.h"

namespace kelpie::broadcast {

// One robot's joints at a time. A log of which little was kept has them twice a second.
struct JointSample {
  double seconds = 0.0;
  JointAngles joints;
};

// How its body feels in each frame.
struct FrameSample {
  double seconds = 0.0;
  Stance stance;
  bool holds = false;  // the ball, under its chin
};

// One robot's place at a time, and how far it has come until then.
struct PlaceSample {
  double seconds = 0.0;
  Pose2 pose;
  Stance stance;
  double way = 0.0;  // cm
};

struct BallSample {
  double seconds = 0.0;
  Point2<Field> place;
  bool there = true;
};

class Course {
 public:
  // The first that tells of a time tells of it for all. Times must not fall.
  void addTruth(const sim::TruthFrame& truth);
  void addEvent(const sim::MatchEvent& event);
  void addJoints(const Player& player, const JointSample& sample);
  void addFrame(const Player& player, const FrameSample& sample);
  // For a match without a truth.
  void addBelief(const Player& player, double seconds, const WorldModel& world);

  std::set<Player> players() const;
  bool empty() const { return places_.empty(); }
  Tableau at(double seconds) const;
  const std::vector<sim::MatchEvent>& events() const { return events_; }
  // Of each frame of a robot's log.
  std::vector<double> frameTimes(const Player& player) const;
  // Who has the ball: feels it, or has it before its chest; nobody, or of several the nearest.
  const Actor* holderOf(const Tableau& tableau, double seconds) const;

 private:
  void addPlace(const Player& player, PlaceSample sample);
  JointAngles jointsAt(const Player& player, const PlaceSample& place, double seconds) const;

  std::map<Player, std::vector<PlaceSample>> places_;
  std::map<Player, std::vector<JointSample>> joints_;
  std::map<Player, std::vector<FrameSample>> frames_;
  std::vector<BallSample> ball_;
  std::vector<sim::MatchEvent> events_;
};

// Reads what can be read of the logs; the first is the one that is watched. What cannot be read of
// them is in `lacks`, a line for each. An error where one is no log, two are of one robot, or
// `stopped` says true.
struct ReadCourse {
  Course course;
  std::vector<std::string> lacks;
};
Expected<ReadCourse> readCourse(const std::vector<std::string>& logs,
                                const std::function<bool()>& stopped = {});

}  // namespace kelpie::broadcast
