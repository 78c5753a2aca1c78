// SPDX-License-Identifier: Apache-2.0
// What a robot decides, told only where it is decided otherwise than in the frame before. Reasons
// whose numbers alone differ are the same.
#pragma once

#include <string>

#include "robot/core/types/Command.h"

namespace kelpie::match {

class DecisionChanges {
 public:
  // "forward: play > grab_dribble: aim - the gap is 12 deg to the left"; empty: no change.
  std::string take(bool driven, const Command& command);
  bool any() const { return known_; }          // a decision at all
  bool reported() const { return reported_; }  // a reason at all

 private:
  std::string words(const Trace& now, std::size_t at) const;

  bool known_ = false;
  bool reported_ = false;
  Trace before_;
  std::string instead_;
};

}  // namespace kelpie::match
