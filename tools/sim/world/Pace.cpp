// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/world/Pace.h"

#include <algorithm>
#include <thread>

namespace kelpie::sim {
namespace {

constexpr std::chrono::milliseconds kStall{200};
constexpr std::chrono::milliseconds kAsk{5};  // while it stands

// Image number i is there at i / 30 s, in whole microseconds.
bool isImage(TimeUs time) {
  const std::int64_t i = (time.us * 30 + 999999) / 1000000;
  return i * 1000000 / 30 == time.us;
}

}  // namespace

void Pace::setSpeed(double speed) {
  speed_ = speed;
  begun_ = false;
}

void Pace::resume() {
  paused_ = false;
  images_ = 0;
  begun_ = false;
}

void Pace::step(int images) {
  paused_ = true;
  images_ += images;
}

bool Pace::mayPass(TimeUs now) {
  if (!paused_) return true;
  if (images_ == 0) return false;
  if (isImage(now)) --images_;
  return true;
}

void Pace::await(TimeUs now, const std::function<void()>& hear,
                 const std::function<bool()>& stopped) {
  hear();
  while (!mayPass(now) && !(stopped && stopped())) {
    std::this_thread::sleep_for(kAsk);
    hear();
  }
  if (!paused_ && speed_ > 0.0) keepTime(now);
}

// After a stall (a script that hung) time goes on from there; it does not catch up.
void Pace::keepTime(TimeUs now) {
  const auto clock = Clock::now();
  if (!begun_) {
    begun_ = true;
    since_ = clock;
    from_ = now;
  }
  const double gone = static_cast<double>(now.us - from_.us) / speed_;
  const auto due = since_ + std::chrono::microseconds(static_cast<std::int64_t>(gone));
  const auto late = clock - due;
  if (late > kStall) since_ += late;
  std::this_thread::sleep_until(due);
}

}  // namespace kelpie::sim
