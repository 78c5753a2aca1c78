// SPDX-License-Identifier: Apache-2.0
// Logs of a match as its processes write them, and two hubs with somebody at each.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <thread>

#include "robot/agent/log/LoggedTypes.h"
#include "robot/core/log/LogTopics.h"
#include "robot/core/types/FrameOutput.h"
#include "tests/core/LogFiles.h"
#include "tests/live/FakePeer.h"
#include "tools/live/Feed.h"
#include "tools/picture/Jpeg.h"
#include "tools/sim/world/Truth.h"

namespace kelpie::live {

namespace fs = std::filesystem;

inline void writeConfig(LogWriter& log, TeamColour team, std::uint8_t player) {
  const auto config = std::make_unique<agent::AgentConfig>();
  config->team = team;
  config->player = player;
  log.write(kConfigTopic, TimeUs{}, *config);
}

inline void writeFrame(LogWriter& log, std::int64_t us) {
  const auto input = std::make_unique<PictureFrame>();
  input->time = TimeUs{us};
  const auto jpeg = picture::jpegOf(input->image, 60);
  input->jpeg.resize(jpeg.size());
  std::copy(jpeg.begin(), jpeg.end(), input->jpeg.begin());
  log.write(kPictureFrameTopic, TimeUs{us}, *input);
  const auto output = std::make_unique<FrameOutput>();
  output->time = TimeUs{us};
  output->body.camera.axes = {1, 0, 0, 0, 0, 1, 0, -1, 0};
  log.write(kFrameOutputTopic, TimeUs{us}, *output);
}

inline void writeTruth(LogWriter& log, std::int64_t us) {
  sim::TruthFrame truth;
  truth.time = TimeUs{us};
  truth.robots.push_back({TeamColour::red, 1, {{100.0, 200.0}, Angle()}, {}});
  log.write(sim::kTruthTopic, TimeUs{us}, truth);
  log.write(sim::kEventTopic, TimeUs{us}, sim::MatchEvent{});
}

inline bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

class Relayed : public LogFiles {
 protected:
  Relayed() {
    viewers.enter(viewer);
    studio.enter(page);
  }
  // All messages of a log into the relay.
  static void relay(Relay& relay, const std::string& name, bool late = false) {
    const std::size_t number = relay.addLog();
    auto reader = LogReader::open(pathOf(name));
    LogMessage message;
    while (reader->next(message)) relay.take(number, message, late);
  }
  static void writeRobot(const std::string& name, TeamColour team, std::uint8_t player,
                         std::int64_t from = 0) {
    auto log = std::move(*LogWriter::open(pathOf(name), LogOptions{}));
    writeConfig(log, team, player);
    for (int i = 0; i < 3; ++i) {
      writeFrame(log, from + 33000 * i);
      writeTruth(log, from + 33000 * i);
    }
  }
  std::size_t offered(const std::string& topic) const {
    const auto topics = page.topics();
    return static_cast<std::size_t>(std::count(topics.begin(), topics.end(), topic));
  }
  void subscribeAll(Hub& hub, FakePeer& peer) {
    std::uint32_t subscription = 0;
    for (const std::string& topic : peer.topics())
      hub.hear(peer, subscribing(subscription++, peer.channelOf(topic)));
  }

  // Until it is so while the feed is asked; a fact that never comes is a failed test.
  static bool becomes(Feed& feed, const std::function<bool()>& fact) {
    for (int i = 0; i < 1000 && !fact(); ++i) {
      feed.poll();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return fact();
  }

  Hub viewers{"viewers", 1};
  Hub studio{"studio", 1};
  FakePeer viewer;
  FakePeer page;
};

}  // namespace kelpie::live
