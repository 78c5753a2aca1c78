// SPDX-License-Identifier: Apache-2.0
// The messages of a match's logs, as they come, to those who watch. Viewers get them as
// tools/viewer makes them, in the time of the clock on the wall; the studio gets them as they are,
// in the match's time, on topics that name the robot:
//
//   /live/red-1/frame/output      of a robot's log
//   /live/world/truth, .../event  of whichever log told of them first
//
// Viewers get thirty frames a second of each robot at most, so that a match that goes faster than
// the clock does not wait for what nobody can see; and a log that is read late is caught up with by
// leaving frames out.
#pragma once

#include <chrono>
#include <deque>
#include <map>
#include <optional>
#include <string>

#include "tools/live/Hub.h"
#include "tools/viewer/LogMessages.h"

namespace kelpie::live {

// The clock on the wall, since 1970.
TimeUs wallTime();

// Messages for viewers that go to a hub.
class HubSink : public viewer::MessageSink {
 public:
  explicit HubSink(Hub& hub) : hub_(hub) {}
  void take(const std::string& topic, TimeUs time,
            const google::protobuf::Message& message) override;

 private:
  Hub& hub_;
  std::string bytes_;
};

class Relay {
 public:
  using Clock = std::chrono::steady_clock;
  // `start`: when the match's time was 0. Between two frames of a robot that viewers get is at
  // least `pause`. The hubs must outlive the relay.
  Relay(TimeUs start, Hub& viewers, Hub& studio, Clock::duration pause = {});
  Relay(const Relay&) = delete;
  Relay& operator=(const Relay&) = delete;

  // A log of which messages will come; its number.
  std::size_t addLog();
  // `late`: there are many more behind it.
  void take(std::size_t log, const LogMessage& message, bool late);

 private:
  struct Source {
    std::string robot;  // "red-1"; empty until its configuration has come
    viewer::LogMessages messages;
    bool leftOut = false;          // the input of the frame whose output comes next
    Clock::time_point frameDue{};  // the next that viewers get, by the clock on the wall
    Clock::time_point truthDue{};  // so
  };
  void passOn(Source& source, std::size_t log, const LogMessage& message);
  void convert(Source& source, const LogMessage& message, bool late);
  bool isDue(Clock::time_point& due, bool late) const;

  Hub& viewers_;
  Hub& studio_;
  Clock::duration pause_;
  HubSink sink_;
  viewer::SharedWorld world_;
  std::deque<Source> sources_;                  // each stays where it is
  std::map<std::string, std::size_t> tellers_;  // of each of the world's topics
};

}  // namespace kelpie::live
