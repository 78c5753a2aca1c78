// SPDX-License-Identifier: Apache-2.0
// The messages of a match's logs, as they come, to those who watch. Viewers get them as
// tools/viewer makes them, in the time of the clock on the wall; the studio gets them as they are,
// in the match's time, on topics that name the robot:
//
//   /live/red-1/frame/output      of a robot's log
//   /live/world/truth, .../event  of whichever log told of them first
//
// A log that is read late, because frames come faster than they can be converted, is caught up with
// by leaving frames out of what viewers get.
#pragma once

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
  // `start`: when the match's time was 0. The hubs must outlive the relay.
  Relay(TimeUs start, Hub& viewers, Hub& studio);
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
    bool leftOut = false;  // the input of the frame whose output comes next
  };
  void passOn(Source& source, std::size_t log, const LogMessage& message);
  void convert(Source& source, const LogMessage& message, bool late);

  Hub& viewers_;
  Hub& studio_;
  HubSink sink_;
  viewer::SharedWorld world_;
  std::deque<Source> sources_;                  // each stays where it is
  std::map<std::string, std::size_t> tellers_;  // of each of the world's topics
};

}  // namespace kelpie::live
