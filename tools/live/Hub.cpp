// SPDX-License-Identifier: Apache-2.0
#include "tools/live/Hub.h"

#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "tools/cli/JsonText.h"
#include "tools/live/Base64.h"

namespace kelpie::live {
namespace {

using nlohmann::json;

constexpr std::uint8_t kMessageData = 1;  // opcode of a binary message from the server
constexpr int kInfo = 0;                  // levels of a status message
constexpr int kWarning = 1;

std::string statusText(int level, const std::string& line) {
  return cli::jsonText({{"op", "status"}, {"level", level}, {"message", line}});
}

// Empty where there is no text of that name.
std::string wordIn(const json& message, const char* key) {
  const auto found = message.find(key);
  return found != message.end() && found->is_string() ? found->get<std::string>() : std::string();
}

// Opcode, subscription, time in ns, and the message: numbers in little endian, as here.
std::shared_ptr<const std::string> frameOf(std::uint32_t subscription, TimeUs time,
                                           const void* bytes, std::size_t size) {
  constexpr std::size_t kHead = 1 + sizeof(std::uint32_t) + sizeof(std::uint64_t);
  const auto frame = std::make_shared<std::string>(kHead + size, '\0');
  const std::uint64_t ns = static_cast<std::uint64_t>(time.us) * 1000;
  (*frame)[0] = static_cast<char>(kMessageData);
  std::memcpy(frame->data() + 1, &subscription, sizeof subscription);
  std::memcpy(frame->data() + 1 + sizeof subscription, &ns, sizeof ns);
  std::memcpy(frame->data() + kHead, bytes, size);
  return frame;
}

// A larger one would be another's when it is cut.
bool isId(const json& value) {
  return value.is_number_unsigned() &&
         value.get<std::uint64_t>() <= std::numeric_limits<std::uint32_t>::max();
}

// The numbers of a list of them; anything else in it is left out.
std::vector<std::uint32_t> numbersIn(const json& message, const char* key) {
  std::vector<std::uint32_t> numbers;
  const json list = message.value(key, json::array());
  for (const json& each : list)
    if (isId(each)) numbers.push_back(each.get<std::uint32_t>());
  return numbers;
}

}  // namespace

// A viewer that connects again to another match, or to another server, must know.
std::string Hub::infoText() const {
  return cli::jsonText({{"op", "serverInfo"},
                        {"name", name_},
                        {"capabilities", json::array()},
                        {"metadata", json::object()},
                        {"sessionId", std::to_string(session_)}});
}

std::string Hub::offerText(Id first) const {
  json channels = json::array();
  for (Id id = first; id < channels_.size(); ++id) {
    const Channel& channel = channels_[id];
    const bool bytes = channel.type.schemaEncoding == "protobuf";
    channels.push_back({{"id", id},
                        {"topic", channel.topic},
                        {"encoding", channel.type.messageEncoding},
                        {"schemaName", channel.type.name},
                        {"schema", bytes ? base64(channel.type.schema) : channel.type.schema},
                        {"schemaEncoding", channel.type.schemaEncoding}});
  }
  return cli::jsonText({{"op", "advertise"}, {"channels", channels}});
}

void Hub::enter(web::Peer& peer) {
  peers_[&peer];
  peer.sayText(infoText());
  peer.sayText(offerText(firstOffered_));
}

void Hub::leave(web::Peer& peer) { peers_.erase(&peer); }

void Hub::hear(web::Peer& peer, const std::string& text) {
  const json message = json::parse(text, nullptr, false);
  const std::string op = message.is_object() ? wordIn(message, "op") : "";
  Watcher& watcher = peers_[&peer];
  if (op == "subscribe") {
    const json wanted = message.value("subscriptions", json::array());
    for (const json& each : wanted)
      if (each.is_object() && isId(each.value("id", json())) &&
          isId(each.value("channelId", json())))
        subscribe(peer, watcher, each["id"].get<Id>(), each["channelId"].get<Id>());
    return;
  }
  if (op == "unsubscribe") {
    for (const Id subscription : numbersIn(message, "subscriptionIds"))
      for (auto i = watcher.subscriptions.begin(); i != watcher.subscriptions.end();)
        i = i->second == subscription ? watcher.subscriptions.erase(i) : std::next(i);
    return;
  }
  peer.sayText(statusText(kWarning, "this server hears subscribe and unsubscribe only"));
}

void Hub::subscribe(web::Peer& peer, Watcher& watcher, Id subscription, Id channel) {
  if (channel < firstOffered_ || channel >= channels_.size())
    return peer.sayText(statusText(kWarning, "no channel " + std::to_string(channel)));
  if (!watcher.subscriptions.emplace(channel, subscription).second) return;
  const Channel& wanted = channels_[channel];
  if (wanted.sent)
    send(peer, watcher, channel, wanted.lastTime, wanted.last.data(), wanted.last.size());
}

void Hub::offer(const std::string& topic, const ReadyType& type, bool keepsLast) {
  const auto id = static_cast<Id>(channels_.size());
  if (!byTopic_.emplace(topic, id).second) return;
  channels_.push_back({topic, type, keepsLast, {}, {}, false});
  for (auto& [peer, watcher] : peers_) peer->sayText(offerText(id));
}

void Hub::publish(const std::string& topic, TimeUs time, const void* bytes, std::size_t size) {
  const auto found = byTopic_.find(topic);
  if (found == byTopic_.end()) return;
  Channel& channel = channels_[found->second];
  if (channel.keepsLast) {
    channel.last.assign(static_cast<const char*>(bytes), size);
    channel.lastTime = time;
    channel.sent = true;
  }
  for (auto& [peer, watcher] : peers_)
    if (watcher.subscriptions.count(found->second) > 0)
      send(*peer, watcher, found->second, time, bytes, size);
}

void Hub::send(web::Peer& peer, Watcher& watcher, Id channel, TimeUs time, const void* bytes,
               std::size_t size) {
  if (peer.waiting() > kMaxWaiting) {
    ++watcher.lost;
    return;
  }
  if (watcher.lost > 0) {
    peer.sayText(statusText(kWarning, std::to_string(watcher.lost) +
                                          " messages were left out: this viewer is slower than "
                                          "the match"));
    watcher.lost = 0;
  }
  peer.sayBytes(frameOf(watcher.subscriptions[channel], time, bytes, size));
}

void Hub::say(const std::string& line) {
  for (auto& [peer, watcher] : peers_) peer->sayText(statusText(kInfo, line));
}

void Hub::restart() {
  json gone = json::array();
  for (Id id = firstOffered_; id < channels_.size(); ++id) gone.push_back(id);
  ++session_;
  firstOffered_ = static_cast<Id>(channels_.size());
  byTopic_.clear();
  for (auto& [peer, watcher] : peers_) {
    watcher.subscriptions.clear();
    peer->sayText(cli::jsonText({{"op", "unadvertise"}, {"channelIds", gone}}));
    peer->sayText(infoText());
    peer->sayText(offerText(firstOffered_));
  }
}

}  // namespace kelpie::live
