// SPDX-License-Identifier: Apache-2.0
#include "tools/match/BeliefWords.h"

#include <fmt/core.h>

#include "tools/match/Draw.h"
#include "tools/match/TraceWords.h"

namespace kelpie::match {

std::string sentenceOf(const MovedLandmark& moved) {
  const bool goal = moved.kind <= LandmarkKind::goalYellow;
  return fmt::format("The {}{} seems to stand {} cm off its place.", wordFor(moved.kind),
                     goal ? "" : " beacon", shortNumber(moved.offset.norm()));
}

}  // namespace kelpie::match
