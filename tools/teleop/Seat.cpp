// SPDX-License-Identifier: Apache-2.0
#include "tools/teleop/Seat.h"

#include <poll.h>

#include <utility>

#include "robot/host/world/Messages.h"
#include "tools/teleop/StatusLine.h"

namespace kelpie::teleop {
namespace {

constexpr int kWaitMs = 100;  // until it looks whether it shall leave
// A picture of a large terminal has 300 KB; more than fifteen a second few terminals draw.
constexpr auto kBetweenDrawings = std::chrono::milliseconds(66);

}  // namespace

Seat::Seat(host::Listener listener, std::vector<TimedKey> keys, Screen* screen)
    : listener_(std::move(listener)), keys_(std::move(keys)), screen_(screen) {
  thread_ = std::thread([this] { run(); });
}

Seat::~Seat() { leave(); }

void Seat::note(const std::string& line) {
  const std::lock_guard<std::mutex> lock(mutex_);
  note_ = line;
}

std::string Seat::leave() {
  left_ = true;
  if (thread_.joinable()) thread_.join();
  return trouble_;
}

void Seat::run() {
  draw();
  auto connection = agent();
  while (connection && serve(*connection)) {
  }
  over_ = true;
}

// Empty when it left before an agent came.
std::optional<host::Connection> Seat::agent() {
  host::ConnectionParams params;
  params.peer = "the agent";
  while (!left_) {
    auto connection = listener_.accept(1e-3 * kWaitMs, params);
    if (connection) return std::move(*connection);
    hearKeys();
  }
  return std::nullopt;
}

// Waits for a key or a view and sees to it. False: there is no more to do.
bool Seat::serve(host::Connection& agent) {
  pollfd wanted[] = {{agent.descriptor(), POLLIN, 0}, {inputOfKeys(), POLLIN, 0}};
  if (poll(wanted, 2, kWaitMs) <= 0) return !left_;
  if (wanted[1].revents != 0) hearKeys();
  if (wanted[0].revents == 0) return true;
  const Status answered = answer(agent);
  if (answered && std::chrono::steady_clock::now() - drawn_ > kBetweenDrawings) draw();
  return answered.ok();
}

// An agent that hangs up has ended, which its watcher tells better.
Status Seat::answer(host::Connection& agent) {
  const auto type = agent.receive(body_);
  if (!type) return Error{type.error()};
  const Status read = host::readBody(*type, body_, *view_);
  if (!read) {
    trouble_ = "the agent's view: " + read.error();
    return read;
  }
  pressDue();
  return host::sendMessage(agent, host::MessageType::drive, Drive{true, driver_.next(*view_)},
                           body_);
}

void Seat::hearKeys() {
  if (screen_ == nullptr) return;
  if (!screen_->read(typed_)) {
    screen_ = nullptr;
    over_ = true;
  }
  for (char key = takeKey(typed_); key != 0; key = takeKey(typed_)) driver_.press(key);
  if (driver_.hasQuit()) over_ = true;
}

void Seat::pressDue() {
  const double now = view_->time.seconds();
  for (; nextKey_ < keys_.size() && keys_[nextKey_].seconds <= now; ++nextKey_)
    driver_.press(keys_[nextKey_].key);
}

void Seat::draw() {
  if (screen_ == nullptr) return;
  drawn_ = std::chrono::steady_clock::now();
  std::string note;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    note = note_;
  }
  if (!screen_->draw(view_->image, statusLine(*view_), note)) {
    screen_ = nullptr;
    over_ = true;
  }
}

}  // namespace kelpie::teleop
