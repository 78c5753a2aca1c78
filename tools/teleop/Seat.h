// SPDX-License-Identifier: Apache-2.0
// The driver's end of the line: waits for the agent in a thread of its own and answers each of its
// views with what the keys ask for, typed at a screen or written down beforehand. Keys that were
// written down come with the first view of their time or later, so that the same keys drive the
// same way every time. Ends when the agent hangs up or leave() is called.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "robot/host/world/Connection.h"
#include "tools/teleop/Driver.h"
#include "tools/teleop/Keys.h"
#include "tools/teleop/Screen.h"

namespace kelpie::teleop {

class Seat {
 public:
  // `screen` may be null: then nothing is typed and nothing drawn.
  Seat(host::Listener listener, std::vector<TimedKey> keys, Screen* screen);
  ~Seat();
  Seat(const Seat&) = delete;
  Seat& operator=(const Seat&) = delete;

  // These are for another thread than the seat's own.
  bool over() const { return over_; }  // the driver has quit, the terminal or the agent is gone
  void note(const std::string& line);  // something to show
  std::string leave();                 // ends the thread; what went wrong on the line, if anything

 private:
  void run();
  std::optional<host::Connection> agent();
  bool serve(host::Connection& agent);
  Status answer(host::Connection& agent);
  void hearKeys();
  void pressDue();
  void draw();
  int inputOfKeys() const { return screen_ == nullptr ? -1 : screen_->input(); }

  host::Listener listener_;
  std::vector<TimedKey> keys_;
  std::size_t nextKey_ = 0;
  Screen* screen_;
  Driver driver_;
  std::string typed_;  // not yet taken apart
  std::unique_ptr<host::DriverView> view_ = std::make_unique<host::DriverView>();
  std::vector<std::uint8_t> body_;
  std::string trouble_;
  std::chrono::steady_clock::time_point drawn_;
  std::atomic<bool> over_{false};
  std::atomic<bool> left_{false};
  std::mutex mutex_;  // of the note
  std::string note_;
  std::thread thread_;  // the last member: it starts when all others are there
};

}  // namespace kelpie::teleop
