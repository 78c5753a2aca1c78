// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/world/Stranger.h"

#include <fmt/core.h>

#include <utility>

#include "robot/core/fields/Encoding.h"
#include "tools/sim/world/Setup.h"

namespace kelpie::sim {
namespace {

constexpr int kMaxLives = 20;  // one that dies at once, again and again, is let in no more
constexpr int kMaxLines = 20;  // nor is everything said that goes wrong with it
constexpr std::uint32_t kMaxBody = 1U << 16;  // bytes; the largest reply has 6 kB

host::ConnectionParams lineParams() {
  host::ConnectionParams params;
  params.peer = "the agent";
  params.maxBody = kMaxBody;
  return params;
}

}  // namespace

Expected<Stranger> Stranger::open(const std::string& socket, const host::AgentHello& robot,
                                  double limit) {
  auto listener = host::Listener::open(socket);
  if (!listener) return Error{listener.error()};
  return Expected<Stranger>(Stranger(std::move(*listener), robot, limit));
}

bool Stranger::look(double seconds) {
  if (present() || lives_ >= kMaxLives) return false;
  if (!caller_ && listener_.isCalled(seconds)) {
    auto connection = listener_.accept(0.0, lineParams());
    if (connection) caller_ = std::make_unique<host::GuardedLine>(std::move(*connection));
  }
  if (!caller_) return false;
  const auto type = caller_->receive(body_, seconds);
  if (!type) {
    turnAway(type.error() + " before its hello");
  } else if (*type) {
    **type == host::MessageType::hello ? greet() : turnAway("its first message is no hello");
  }
  return present();
}

// Who says that it is another robot's agent was given the wrong socket.
void Stranger::greet() {
  host::AgentHello hello;
  std::string why;
  if (!decode(body_.data(), body_.size(), hello) || !verify(hello, &why))
    return turnAway("its hello does not say a team and a player 1 to 4");
  if (hello.team != robot_.team || hello.player != robot_.player)
    return turnAway("its hello is that of " + nameOf(hello));
  line_ = std::move(caller_);
  lost_ = false;
  owed_ = 0;
  late_ = false;
  vectorsDone = 0;
  if (++lives_ > 1 || told_ > 0) tell("is there");
}

void Stranger::absent(double waited) {
  if (present() || told_ > 0) return;
  tell(fmt::format("has {} within {:g} s; its robot stands",
                   caller_ ? "come, but not said hello" : "not come", waited));
}

void Stranger::send(host::MessageType type, const std::vector<std::uint8_t>& body) {
  if (line_) line_->send(type, body);
}

Expected<bool> Stranger::hearOne(double seconds,
                                 const std::function<void(const host::AgentReply&)>& obey) {
  const auto type = line_->receive(body_, seconds);
  if (!type) return Error{type.error()};
  if (!*type) return false;
  if (**type != host::MessageType::reply)
    return Error{fmt::format("{} message where reply was expected", host::messageName(**type))};
  host::AgentReply reply;
  std::string why;
  if (!decode(body_.data(), body_.size(), reply)) return Error{"its reply cannot be decoded"};
  if (!verify(reply, &why)) return Error{"its reply is refused: " + why};
  --owed_;
  obey(reply);
  return true;
}

void Stranger::hear(TimeUs now, bool waits,
                    const std::function<void(const host::AgentReply&)>& obey) {
  if (!present() || owed_ == 0) return;
  const bool asked = waits && !late_;
  auto heard = hearOne(asked ? limit_ : 0.0, obey);
  if (asked && heard && !*heard) beLate(now);
  while (late_ && owed_ > 0 && heard && *heard) heard = hearOne(0.0, obey);
  if (owed_ == 0) late_ = false;
  if (!heard) lose(fmt::format("{} at {:.1f} s", heard.error(), now.seconds()));
}

void Stranger::beLate(TimeUs now) {
  late_ = true;
  if (timesLate_++ == 0)
    tell(
        fmt::format("has not answered within {:g} s at {:.1f} s; whenever it is late, the match "
                    "goes on without it until it answers",
                    limit_, now.seconds()));
}

void Stranger::turnAway(const std::string& why) {
  caller_.reset();
  tell(why + "; its robot stands");
}

// The line stays, for a thread that may be sending.
void Stranger::lose(const std::string& why) {
  lost_ = true;
  line_->hangUp();
  tell(why + "; its robot stands");
  if (lives_ >= kMaxLives)
    news_.push_back(title() + fmt::format("has come {} times, and is let in no more", lives_));
}

void Stranger::tell(const std::string& line) {
  if (++told_ <= kMaxLines) news_.push_back(title() + line);
}

std::string Stranger::title() const { return "agent " + nameOf(robot_) + ": "; }

std::vector<std::string> Stranger::takeNews() { return std::exchange(news_, {}); }

std::optional<std::string> Stranger::lateness() const {
  if (timesLate_ < 2) return std::nullopt;
  return title() + fmt::format("was late {} times", timesLate_);
}

}  // namespace kelpie::sim
