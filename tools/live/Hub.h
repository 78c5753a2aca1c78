// SPDX-License-Identifier: Apache-2.0
// Messages for who watches, by the Foxglove WebSocket protocol v1 (github.com/foxglove/ws-protocol,
// docs/spec.md): tells each peer which channels there are, and sends it those that it subscribes.
// A peer that does not keep up loses messages, is told so, and holds nobody up.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "robot/core/Time.h"
#include "robot/core/log/LogWriter.h"
#include "tools/web/Site.h"

namespace kelpie::live {

class Hub : public web::Room {
 public:
  static constexpr std::size_t kMaxWaiting = 4U << 20;  // bytes for a peer before it loses some

  // `session` tells this match from others, also those of other servers: the time of its start.
  Hub(std::string name, std::int64_t session) : name_(std::move(name)), session_(session) {}

  const char* protocol() const override { return "foxglove.websocket.v1"; }
  void enter(web::Peer& peer) override;
  void hear(web::Peer& peer, const std::string& text) override;
  void leave(web::Peer& peer) override;

  bool hasPeers() const { return !peers_.empty(); }
  bool isOffered(const std::string& topic) const { return byTopic_.count(topic) > 0; }
  // Offers a topic; with `keepsLast` its last message is sent to who subscribes later. Of a topic
  // all messages are of one type.
  void offer(const std::string& topic, const ReadyType& type, bool keepsLast);
  // Of a topic that is offered. Nobody may want it.
  void publish(const std::string& topic, TimeUs time, const void* bytes, std::size_t size);
  // A line for whoever looks at a viewer's log.
  void say(const std::string& line);
  // There is another match now: nothing is offered any more.
  void restart();

 private:
  struct Channel {
    std::string topic;
    ReadyType type;
    bool keepsLast = false;
    TimeUs lastTime;
    std::string last;
    bool sent = false;  // `last` is a message
  };
  using Id = std::uint32_t;
  struct Watcher {
    std::map<Id, Id> subscriptions;  // by channel
    std::size_t lost = 0;
  };
  std::string infoText() const;
  std::string offerText(Id first) const;
  void subscribe(web::Peer& peer, Watcher& watcher, Id subscription, Id channel);
  void send(web::Peer& peer, Watcher& watcher, Id channel, TimeUs time, const void* bytes,
            std::size_t size);

  std::string name_;
  std::int64_t session_;
  std::vector<Channel> channels_;  // an id is its place and never used twice
  Id firstOffered_ = 0;            // those before were of a match before
  std::map<std::string, Id> byTopic_;
  std::map<web::Peer*, Watcher> peers_;
};

}  // namespace kelpie::live
