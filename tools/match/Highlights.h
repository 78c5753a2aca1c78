// SPDX-License-Identifier: Apache-2.0
// The few moments that stand for a match.
#pragma once

#include "tools/match/Happenings.h"

namespace kelpie::match {

// At most `count` of them, no two close to each other, in the order of time: goals first, then what
// is next in weight, of each kind the first before its repetitions. Where there are fewer the rest
// are moments at even times, as far as possible from those chosen. `all` is in the order of time,
// from the first frame to the last; fewer frames than `count` give as many moments as frames.
std::vector<Happening> chooseHighlights(const std::vector<Happening>& all, std::size_t count);

}  // namespace kelpie::match
