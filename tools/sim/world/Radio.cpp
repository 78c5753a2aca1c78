// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/world/Radio.h"

#include <algorithm>

namespace kelpie::sim {

Radio::Radio(const RadioParams& params, std::size_t robots, std::uint64_t seed)
    : params_(params), random_(seed), inboxes_(robots), deaf_(robots, false) {}

void Radio::send(std::size_t from, const RadioPacket& packet, TimeUs now,
                 const std::vector<Point2<Field>>& places) {
  for (std::size_t to = 0; to < inboxes_.size(); ++to) {
    if (to == from) continue;
    // Drawn for everybody, so that who is near changes nothing for the others.
    const bool lost = random_.chance(params_.loss);
    const double late = params_.delay + random_.uniform(0.0, params_.jitter);
    if (lost || deaf_[to] || distance(places[from], places[to]) > params_.range) continue;
    inboxes_[to].push_back({TimeUs{now.us + TimeUs::fromSeconds(late).us}, packet});
  }
}

RadioPackets Radio::take(std::size_t to, TimeUs now) {
  std::vector<Flying>& inbox = inboxes_[to];
  std::stable_sort(inbox.begin(), inbox.end(),
                   [](const Flying& a, const Flying& b) { return a.arrives.us < b.arrives.us; });
  RadioPackets packets;
  auto one = inbox.begin();
  for (; one != inbox.end() && one->arrives.us <= now.us; ++one) packets.push_back(one->packet);
  inbox.erase(inbox.begin(), one);
  return packets;
}

}  // namespace kelpie::sim
