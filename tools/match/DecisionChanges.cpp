// SPDX-License-Identifier: Apache-2.0
#include "tools/match/DecisionChanges.h"

#include <algorithm>

#include "tools/match/TraceWords.h"

namespace kelpie::match {
namespace {

// The first step that was decided otherwise, numbers apart; the number of steps when none was.
std::size_t firstChange(const Trace& before, const Trace& now) {
  std::size_t i = 0;
  while (i < before.size() && i < now.size() && before[i].layer == now[i].layer &&
         before[i].module.view() == now[i].module.view() &&
         before[i].branch.view() == now[i].branch.view() &&
         before[i].reason.view() == now[i].reason.view())
    ++i;
  return i;
}

}  // namespace

std::string DecisionChanges::take(bool driven, const Command& command) {
  const Trace& now = command.trace;
  const std::string instead = insteadOf(driven, command);
  const std::size_t at = firstChange(before_, now);
  const bool same = at == now.size() && at == before_.size();
  const bool first = !known_;
  known_ = true;
  before_ = now;
  reported_ = reported_ || !now.empty() || !instead.empty();
  if (!first && same && instead == instead_) return {};
  instead_ = instead;
  return words(now, at);
}

std::string DecisionChanges::words(const Trace& now, std::size_t at) const {
  if (!instead_.empty()) return instead_;
  if (now.empty()) return "no reason given";
  const std::string reason = reasonOf(now[std::min(at, now.size() - 1)]);
  return chainOf(now) + (reason.empty() ? "" : " - " + reason);
}

}  // namespace kelpie::match
