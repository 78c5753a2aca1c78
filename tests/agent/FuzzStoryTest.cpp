// SPDX-License-Identifier: Apache-2.0
// Seeded stories in which up to nine things befall a robot at any time within ten seconds, then all
// is put right and somebody presses its head: what holds in every one of them.
#include "robot/core/Random.h"
#include "tests/agent/Story.h"

namespace kelpie::agent {
namespace {

constexpr int kParts = 4;  // for as many cores
constexpr int kStories = 75;
constexpr double kLast = 12.0;   // s, what befalls it is over
constexpr double kRight = 13.0;  // and put right
constexpr double kAsked = 18.0;  // to stand
constexpr double kCools = 46.0;  // so where heat counts on for 30 s
constexpr double kStands = 10.0;
constexpr double kSwitchesOff = 7.0;  // s at most, of which it lies down for 6

class FuzzStory : public Story, public testing::WithParamInterface<int> {
 protected:
  void begin(int seed) {
    random_ = Random(static_cast<std::uint64_t>(seed) + 1);
    events_.clear();
    rests.clear();
    messages.clear();
    readyAt = fastestHeld = 0.0;
    desk_ = Desk();
    desk_.frame.joints = desk::sprawled();
    desk_.imageEvery = 24;  // just often enough to see
    bits_ = 0;
    lowAt_ = pausedAt_ = heldFrom_ = -1.0;
    lifts_.clear();
    putDown_.clear();
    lifted_ = wasHot_ = false;
  }

  void befall(double when) {
    switch (random_.index(9)) {
      case 0:
      case 1: return pause(when);
      case 2: return jam(when);
      case 3: return lift(when);
      case 4: return press(when, random_.uniform(0.1, 0.6));
      case 5: return at(when, [this] { desk_.images = !desk_.images; });
      case 6: wasHot_ = true; return change(when, orsbBATTERY_OVER_TEMP_DISCHARGING);
      case 7:
        return at(when,
                  [this] { desk_.frame.joints[Joint::rightFrontRotator] = Angle::deg(60.0); });
      default: break;
    }
    if (lowAt_ >= 0.0 || !random_.chance(0.3)) return;
    lowAt_ = when;
    change(when, orsbBATTERY_CAPACITY_LOW);
  }

  void putRight() {
    const double end = isEitherWay(kRight) ? kRight + 0.2 : kRight;
    endPause(end);
    say(end, bits_ & orsbBATTERY_CAPACITY_LOW);
    at(kRight, [this] {
      desk_.images = true;
      desk_.lifted = false;
    });
    press(asked(), 0.3);        // for power, if it was taken
    press(asked() + 2.0, 0.3);  // for play, if nobody had asked before
  }
  double asked() const { return wasHot_ ? kCools : kAsked; }

  void tellStory(int seed) {
    begin(seed);
    press(2.0, 0.3);
    double when = random_.uniform(0.5, 7.0);
    for (int i = 0; i < 9 && when < kLast; ++i) {
      befall(when);
      when += random_.uniform(0.02, 3.0);
    }
    putRight();
    play(asked() + kStands);
  }

  void expectSafety() {
    EXPECT_LE(fastestHeld, kGentle + 0.01);
    EXPECT_EQ(system_->withoutPower, 0);
    for (const auto& call : system_->calls) {
      const bool holds = call.what.rfind("hold ", 0) == 0;
      EXPECT_LE(holds ? heldAt(call.time.seconds()) : 0U, 1U);
    }
    for (const double when : lifts_) expectSlack(when);
  }
  void expectEnd() {
    const double off = called("shut down");
    const bool held = heldFrom_ >= 0.0;
    if (lowAt_ >= 0.0) {
      ASSERT_GE(off, 0.0) << "low at " << lowAt_;
      EXPECT_LE(off, std::max(lowAt_, 0.0) + kSwitchesOff);
    }
    if (held) {
      ASSERT_GE(off, 0.0) << "held from " << heldFrom_;
      EXPECT_LE(off, heldFrom_ + 3.0 + kSwitchesOff);
    }
    if (lowAt_ < 0.0 && !held) {
      EXPECT_EQ(off, -1.0);
      EXPECT_TRUE(messages.back().plays) << body::nameOf(rests.back().rest);
    }
  }

 private:
  void change(double when, longword bit) {
    bits_ ^= bit;
    say(when, bits_);
  }
  void endPause(double when) {
    if (pausedAt_ >= 0.0 && when - pausedAt_ >= 3.1 && heldFrom_ < 0.0) heldFrom_ = pausedAt_;
    pausedAt_ = -1.0;
  }
  // Between 2.9 and 3.1 s either is right, so that no press is as long.
  bool isEitherWay(double end) const {
    return pausedAt_ >= 0.0 && std::fabs(end - pausedAt_ - 3.0) <= 0.1;
  }
  void pause(double when) {
    if (isEitherWay(when)) return;
    const bool ends = (bits_ & orsbPAUSE) != 0;
    change(when, orsbPAUSE);
    if (ends) return endPause(when);
    pausedAt_ = when;
  }
  void jam(double when) {
    at(when, [this] {
      system_->jam();
      desk_.frame.joints[Joint::leftHindKnee] = Angle::deg(110.0);
    });
    const double back = when + random_.uniform(0.05, 2.0);
    if (random_.chance(0.6)) at(back, [this] { system_->giveBack(); });
  }
  void lift(double when) {
    lifted_ = !lifted_;
    (lifted_ ? lifts_ : putDown_).push_back(when);
    at(when, [this] { desk_.lifted = !desk_.lifted; });
  }

  // Of one that played and was in the air for so long: it is slack within half a second.
  void expectSlack(double when) {
    constexpr double kSlack = 0.55;  // and a message until its gains are sent
    bool played = false;
    bool held = true;
    for (const Message& message : messages) {
      if (message.at <= when) played = message.plays;
      if (message.at > when && message.at <= when + kSlack) held = message.held != 0;
    }
    EXPECT_FALSE(played && held && carriedFor(when) > kSlack) << "lifted at " << when;
  }
  double carriedFor(double when) const {
    double down = messages.back().at;
    for (const double put : putDown_)
      if (put > when) down = std::min(down, put);
    return down - when;
  }

  Random random_;
  longword bits_ = 0;
  double lowAt_ = -1.0;
  double pausedAt_ = -1.0;  // the switch has been held since
  double heldFrom_ = -1.0;  // the first press that switches off
  bool lifted_ = false;
  bool wasHot_ = false;
  std::vector<double> lifts_;
  std::vector<double> putDown_;
};

TEST_P(FuzzStory, WhateverBefallsItItIsGentleEndsWhereItMustAndElseComesBackWhenAsked) {
  for (int story = 0; story < kStories; ++story) {
    const int seed = kParts * story + GetParam();
    SCOPED_TRACE("seed " + std::to_string(seed));
    tellStory(seed);
    expectSafety();
    expectEnd();
    if (HasFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Parts, FuzzStory, testing::Range(0, kParts));

}  // namespace
}  // namespace kelpie::agent
