// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/world/Pace.h"

#include <algorithm>
#include <thread>

namespace kelpie::sim {
namespace {

constexpr std::chrono::milliseconds kStall{200};
constexpr std::chrono::milliseconds kAsk{5};  // for orders, while it waits
constexpr double kLongest = 1e15;             // us: 30 years, of a match that all but stands

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

void Pace::pause() {
  paused_ = true;
  images_ = 0;
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
  if (images_ == 0) return false;
  if (isImage(now)) --images_;
  return true;
}

// However slowly it goes, an order to go faster is heard.
void Pace::await(TimeUs now, const std::function<void()>& hear,
                 const std::function<bool()>& stopped) {
  hear();
  for (auto left = leftUntil(now); left > left.zero(); left = leftUntil(now)) {
    if (stopped && stopped()) return;
    std::this_thread::sleep_for(std::min<Clock::duration>(left, kAsk));
    hear();
  }
}

Pace::Clock::duration Pace::leftUntil(TimeUs now) {
  if (paused_) return mayPass(now) ? Clock::duration::zero() : kAsk;
  return speed_ > 0.0 ? untilDue(now) : Clock::duration::zero();
}

// After a stall (a script that hung) time goes on from there; it does not catch up.
Pace::Clock::duration Pace::untilDue(TimeUs now) {
  const auto clock = Clock::now();
  if (!begun_) {
    begun_ = true;
    since_ = clock;
    from_ = now;
  }
  const double gone = std::min(kLongest, static_cast<double>(now.us - from_.us) / speed_);
  const auto due = since_ + std::chrono::microseconds(static_cast<std::int64_t>(gone));
  const auto late = clock - due;
  if (late > kStall) since_ += late;
  return -late;
}

}  // namespace kelpie::sim
