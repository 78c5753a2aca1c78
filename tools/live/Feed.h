// SPDX-License-Identifier: Apache-2.0
// Where the messages of a live match come from: something that is asked again and again, and hands
// on what has come since.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "tools/live/LogTail.h"
#include "tools/live/Relay.h"

namespace kelpie::live {

constexpr std::chrono::milliseconds kFramePause{
    25};  // a little less than a frame takes by the clock

class Feed {
 public:
  virtual ~Feed() = default;
  virtual void poll() = 0;
};

// A match that is being played: its processes' logs grow in FOLDER/playing. When a new match
// begins in the folder the hubs begin anew. A match that was killed leaves its `playing` there.
class FolderFeed : public Feed {
 public:
  // `held`: whether somebody plays in the folder, not only did; asked while there is a `playing`.
  FolderFeed(std::string folder, Hub& viewers, Hub& studio, std::function<bool()> held = {});
  void poll() override;
  // Whether a match is being played, as far as the last poll saw.
  bool playing() const { return playing_; }

 private:
  struct Follower {
    LogTail tail;
    std::size_t log;
  };
  void look();
  void follow(Follower& follower);
  void begin();
  void end();

  std::string folder_;
  Hub& viewers_;
  Hub& studio_;
  std::function<bool()> held_;
  std::unique_ptr<Relay> relay_;
  std::vector<Follower> followers_;
  std::set<std::string> known_;     // names of the files that are followed
  std::uint64_t folderNumber_ = 0;  // of FOLDER/playing: another one is another match
  std::chrono::steady_clock::time_point nextLook_;
  bool playing_ = false;
  bool begunBefore_ = false;
};

// Recorded logs, played by the clock, once, from when somebody watches.
class PlaybackFeed : public Feed {
 public:
  static Expected<std::unique_ptr<PlaybackFeed>> open(const std::vector<std::string>& logs,
                                                      Hub& viewers, Hub& studio);
  void poll() override;
  bool ended() const { return ended_; }

 private:
  using Clock = std::chrono::steady_clock;
  struct Source {
    LogReader reader;
    std::size_t log = 0;
    LogMessage message;
    bool more = false;
  };
  PlaybackFeed(Hub& viewers, Hub& studio)
      : viewers_(viewers), studio_(studio), relay_(wallTime(), viewers, studio, kFramePause) {}
  Source* oldest();
  TimeUs timeAt(Clock::time_point now) const;

  Hub& viewers_;
  Hub& studio_;
  Relay relay_;
  std::vector<std::unique_ptr<Source>> sources_;
  std::optional<Clock::time_point> start_;
  TimeUs first_;
  bool ended_ = false;
};

}  // namespace kelpie::live
