// SPDX-License-Identifier: Apache-2.0
#include "actuator/walk/WalkSet.h"

namespace kelpie::actuator {
namespace {

constexpr std::array<WalkSet WalkSets::*, kWalkKindCount> kSets{
    &WalkSets::normal, &WalkSets::fast, &WalkSets::turning, &WalkSets::dribble,
    &WalkSets::back,   &WalkSets::low,  &WalkSets::weak};

WalkSet WalkSets::*memberOf(WalkKind kind) {
  const auto i = static_cast<std::size_t>(kind);
  return kSets[i < kSets.size() ? i : 0];
}

template <class S>
void mix(const S& from, double share, S& to) {
  forEachField(to, [&](const auto& f, auto& member) {
    using Member = std::decay_t<decltype(member)>;
    const Member& old = from.*(f.member);
    if constexpr (HasFields<Member>::value) {
      mix(old, share, member);
    } else if constexpr (!std::is_enum_v<Member>) {
      member = old + (member - old) * share;
    }
  });
}

}  // namespace

const WalkSet& walkSet(const WalkSets& sets, WalkKind kind) { return sets.*memberOf(kind); }
WalkSet& walkSet(WalkSets& sets, WalkKind kind) { return sets.*memberOf(kind); }

WalkSet mixed(const WalkSet& from, const WalkSet& to, double share) {
  WalkSet result = to;
  if (share < 1.0) mix(from, share, result);
  return result;
}

}  // namespace kelpie::actuator
