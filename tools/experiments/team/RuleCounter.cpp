// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/team/RuleCounter.h"

#include <algorithm>
#include <string_view>

namespace kelpie::experiments {
namespace {

constexpr const char* kAny = "*";

bool fits(const std::string& wanted, std::string_view said) {
  if (wanted.empty() || wanted.back() != '*') return wanted == said;
  const std::string_view begin = std::string_view(wanted).substr(0, wanted.size() - 1);
  return said.substr(0, begin.size()) == begin;
}

}  // namespace

RuleCounter::RuleCounter(const std::vector<Rule>& rules)
    : plays_(rules.size()), held_(rules.size(), false) {
  for (const Rule& rule : rules) {
    std::vector<Wanted> wanted;
    for (const std::string& step : rule.steps) wanted.push_back(wantedOf(step));
    rules_.push_back(std::move(wanted));
  }
}

RuleCounter::Wanted RuleCounter::wantedOf(const std::string& step) {
  Wanted wanted{kAny, kAny, kAny};
  const std::size_t branch = step.find('/');
  wanted.module = step.substr(0, branch);
  if (branch == std::string::npos) return wanted;
  const std::size_t reason = step.find('/', branch + 1);
  wanted.branch = step.substr(branch + 1, reason - branch - 1);
  if (reason != std::string::npos) wanted.reason = step.substr(reason + 1);
  return wanted;
}

bool RuleCounter::holds(const Wanted& wanted, const Trace& trace) {
  return std::any_of(trace.begin(), trace.end(), [&](const TraceStep& step) {
    return fits(wanted.module, step.module.view()) && fits(wanted.branch, step.branch.view()) &&
           fits(wanted.reason, step.reason.view());
  });
}

void RuleCounter::beginRobot() { std::fill(held_.begin(), held_.end(), false); }

void RuleCounter::frame(const Trace& trace) {
  for (std::size_t i = 0; i < rules_.size(); ++i) {
    const bool now = std::any_of(rules_[i].begin(), rules_[i].end(),
                                 [&](const Wanted& wanted) { return holds(wanted, trace); });
    plays_[i].frames += now ? 1 : 0;
    plays_[i].times += now && !held_[i] ? 1 : 0;
    held_[i] = now;
  }
}

}  // namespace kelpie::experiments
