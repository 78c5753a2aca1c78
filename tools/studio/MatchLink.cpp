// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/MatchLink.h"

#include <utility>

namespace kelpie::studio {
namespace {

constexpr std::size_t kMaxOrders = 1000;  // that nobody has taken
constexpr std::size_t kMaxLines = 1000;

}  // namespace

Status MatchLink::order(const sim::LiveOrder& order) {
  const Status checked = sim::checkOrder(field_, robots_, order);
  if (!checked) return checked;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (orders_.size() >= kMaxOrders) return Error{"the match hears no more orders"};
  orders_.push_back(sim::wordsFor(order));
  return Done{};
}

std::string MatchLink::nextOrder() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (orders_.empty()) return {};
  std::string next = std::move(orders_.front());
  orders_.pop_front();
  return next;
}

void MatchLink::say(const std::string& line) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (lines_.size() < kMaxLines) lines_.push_back(line);
}

std::vector<std::string> MatchLink::takeLines() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(lines_, {});
}

}  // namespace kelpie::studio
