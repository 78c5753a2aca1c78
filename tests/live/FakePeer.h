// SPDX-License-Identifier: Apache-2.0
// Somebody at the other end of a WebSocket that is none: keeps what is said to it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tools/web/Site.h"

namespace kelpie::live {

class FakePeer : public web::Peer {
 public:
  void sayText(std::string text) override { texts.push_back(nlohmann::json::parse(text)); }
  void sayBytes(std::shared_ptr<const std::string> bytes) override { frames.push_back(*bytes); }
  std::size_t waiting() const override { return waits; }

  // The texts with that operation.
  std::vector<nlohmann::json> said(const std::string& op) const {
    std::vector<nlohmann::json> found;
    for (const auto& text : texts)
      if (text.at("op") == op) found.push_back(text);
    return found;
  }
  // The names of the topics that it was offered and that were not taken back.
  std::vector<std::string> topics() const;
  // The channel of a topic; fails where there is none.
  std::uint32_t channelOf(const std::string& topic) const;

  std::vector<nlohmann::json> texts;
  std::vector<std::string> frames;
  std::size_t waits = 0;

 private:
  std::vector<nlohmann::json> channels() const;
};

inline std::vector<nlohmann::json> FakePeer::channels() const {
  std::vector<nlohmann::json> open;
  for (const auto& text : texts) {
    if (text.at("op") == "unadvertise") open.clear();
    if (text.at("op") == "advertise")
      for (const auto& channel : text.at("channels")) open.push_back(channel);
  }
  return open;
}

inline std::vector<std::string> FakePeer::topics() const {
  std::vector<std::string> names;
  for (const auto& channel : channels()) names.push_back(channel.at("topic"));
  return names;
}

inline std::uint32_t FakePeer::channelOf(const std::string& topic) const {
  for (const auto& channel : channels())
    if (channel.at("topic") == topic) return channel.at("id");
  throw std::out_of_range(topic + " is not offered");
}

inline std::string subscribing(std::uint32_t subscription, std::uint32_t channel) {
  return nlohmann::json({{"op", "subscribe"},
                         {"subscriptions", {{{"id", subscription}, {"channelId", channel}}}}})
      .dump();
}

}  // namespace kelpie::live
