// SPDX-License-Identifier: Apache-2.0
#include "robot/net/TeamRadio.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "robot/net/TeamPacket.h"

namespace kelpie::net {
namespace {

void count(std::uint16_t& number, std::uint32_t more = 1) {
  constexpr std::uint32_t kMax = std::numeric_limits<std::uint16_t>::max();
  number = static_cast<std::uint16_t>(std::min(kMax, number + more));
}

bool restarted(const MateClock& clock, std::int64_t ahead, TimeUs now) {
  const double jump = TimeUs{ahead - clock.min}.seconds();
  const double silent = TimeUs{now.us - clock.heard.us}.seconds();
  return jump > kRestart || jump < -kRestart || silent > kRestart;
}

// Numbers wrap round and leave out 0.
int stepTo(std::uint16_t number, const MateClock& clock) {
  const auto ahead = static_cast<std::uint16_t>(number - clock.number);
  return ahead < 0x8000 ? ahead : ahead - 0x10000;
}

// Why a sound packet of a mate is of no use; else the clock has learnt from it.
std::optional<RadioRefusal> follow(TeamPacket& packet, TimeUs now, MateClock& clock,
                                   RadioCounts& counts) {
  const std::int64_t ahead = now.us - packet.made.us;
  if (!clock.known || restarted(clock, ahead, now)) clock = {true, 0, ahead, now};
  const int step = clock.number == 0 ? 1 : stepTo(packet.message.number, clock);
  if (step <= 0) return RadioRefusal::doubled;
  clock.min = std::min(clock.min, ahead);
  const double underWay = kQuickest + TimeUs{ahead - clock.min}.seconds();
  if (underWay > kLatest) return RadioRefusal::late;
  count(counts.lost, static_cast<std::uint32_t>(step - 1));
  clock.number = packet.message.number;
  clock.heard = now;
  packet.message.age = underWay;
  return std::nullopt;
}

void keep(const TeamMessage& message, FixedVector<TeamMessage, kTeammates>& messages) {
  const auto same = [&](const TeamMessage& m) { return m.player == message.player; };
  auto* const old = std::find_if(messages.begin(), messages.end(), same);
  if (old != messages.end())
    *old = message;
  else
    messages.push_back(message);
}

}  // namespace

void hear(const RadioPacket& bytes, TimeUs now, TeamColour team, std::uint8_t player,
          RadioState& state, FixedVector<TeamMessage, kTeammates>& messages) {
  TeamPacket packet;
  std::optional<RadioRefusal> refusal = decode(bytes, packet);
  if (!refusal && packet.team != team) refusal = RadioRefusal::otherTeam;
  if (!refusal && packet.message.player == player) refusal = RadioRefusal::echo;
  if (!refusal)
    refusal =
        follow(packet, now, state.mates[packet.message.player - std::size_t{1}], state.counts);
  if (refusal) return count(state.counts.refused[static_cast<std::size_t>(*refusal)]);
  count(state.counts.heard);
  keep(packet.message, messages);
}

}  // namespace kelpie::net
