// SPDX-License-Identifier: Apache-2.0
#include "robot/net/GameControlData.h"

#include <algorithm>
#include <cstring>

#include "robot/net/ControlFields.h"
#include "robot/net/LaterControl.h"

namespace kelpie::net {
namespace {

constexpr char kHeader[] = {'R', 'G', 'm', 'e'};
constexpr std::uint32_t kNobody = 2;  // kicks off

std::uint32_t wireColour(TeamColour team) { return team == TeamColour::red ? 1 : 0; }
TeamColour fromWire(std::uint32_t colour) {
  return colour == 1 ? TeamColour::red : TeamColour::blue;
}

class Writer {
 public:
  void put(std::uint32_t word) {
    for (const unsigned shift : {0U, 8U, 16U, 24U})
      bytes_.push_back(static_cast<std::uint8_t>((word >> shift) & 0xffU));
  }
  void put(const ControlTeam& team) {
    put(team.number);
    put(wireColour(team.colour));
    put(team.score);
    for (const ControlPlayer& player : team.players) {
      put(static_cast<std::uint32_t>(player.penalty));
      put(player.secondsLeft);
    }
  }
  std::vector<std::uint8_t> bytes_{kHeader, kHeader + 4};
};

ControlPenalty penaltyFrom(std::uint32_t reported) {
  const auto last = static_cast<std::uint32_t>(ControlPenalty::other);
  return static_cast<ControlPenalty>(std::min(reported, last) & 0xffU);
}

std::uint32_t penaltySeconds(std::uint32_t reported) {
  return static_cast<std::int32_t>(reported) < 0 ? 0 : std::min(reported, kLongestPenalty);
}

void readTeams(ControlBytes& in, GameControlData& got) {
  std::array<std::uint32_t, 2> colours{};
  for (std::size_t i = 0; i < 2; ++i) {
    ControlTeam& team = got.teams[i];
    team.number = in.word();
    colours[i] = in.word();
    team.score = std::min(in.word(), kHighestScore);
    for (ControlPlayer& player : team.players) {
      player.penalty = penaltyFrom(in.word());
      player.secondsLeft = penaltySeconds(in.word());
    }
  }
  setColours(colours, got);
}

std::optional<ControlRefusal> decodeVersion4(const std::uint8_t* bytes, GameControlData& control) {
  ControlBytes in(bytes + sizeof kHeader);
  if (in.word() != kGameControlVersion) return ControlRefusal::version;
  GameControlData got;
  const std::uint32_t state = in.word();
  if (state > static_cast<std::uint32_t>(PlayState::finished)) return ControlRefusal::state;
  got.state = static_cast<PlayState>(state & 0xffU);
  got.firstHalf = in.word() == 1;
  const std::uint32_t kickOff = in.word();
  got.kickOff = fromWire(kickOff);
  got.dropBall = kickOff >= kNobody;
  got.secondsLeft = secondsFrom(static_cast<std::int32_t>(in.word()));
  got.dropInTeam = fromWire(in.word());
  const std::uint32_t dropIn = in.word();
  got.dropInSeconds = dropIn > static_cast<std::uint32_t>(kLongestHalf) ? kNoDropIn : dropIn;
  readTeams(in, got);
  control = got;
  return std::nullopt;
}

const ControlTeam& teamOf(const GameControlData& control, TeamColour team) {
  return control.teams[control.teams[0].colour == team ? 0 : 1];
}

}  // namespace

std::vector<std::uint8_t> encodeControl(const GameControlData& control) {
  Writer out;
  out.put(kGameControlVersion);
  out.put(static_cast<std::uint32_t>(control.state));
  out.put(control.firstHalf ? 1U : 0U);
  out.put(control.dropBall ? kNobody : wireColour(control.kickOff));
  out.put(control.secondsLeft);
  out.put(wireColour(control.dropInTeam));
  out.put(control.dropInSeconds);
  for (const ControlTeam& team : control.teams) out.put(team);
  return out.bytes_;
}

ControlPacket packetOf(const GameControlData& control) {
  ControlPacket packet;
  for (const std::uint8_t byte : encodeControl(control)) packet.bytes.push_back(byte);
  return packet;
}

std::optional<std::uint32_t> controlVersion(const std::uint8_t* bytes, std::size_t size) {
  if (size <= sizeof kHeader || std::memcmp(bytes, kHeader, sizeof kHeader) != 0)
    return std::nullopt;
  return bytes[sizeof kHeader];  // a word's lowest byte in the old versions, a byte in the later
}

void swapColours(GameControlData& control) {
  for (ControlTeam& team : control.teams) team.colour = otherThan(team.colour);
  control.kickOff = otherThan(control.kickOff);
  control.dropInTeam = otherThan(control.dropInTeam);
}

std::optional<ControlRefusal> decodeControl(const std::uint8_t* bytes, std::size_t size,
                                            GameControlData& control) {
  if (size <= sizeof kHeader) return ControlRefusal::size;
  const auto version = controlVersion(bytes, size);
  if (!version) return ControlRefusal::header;
  for (const ControlLayout& layout : kControlLayouts) {
    if (layout.version != *version) continue;
    if (layout.size != size) return ControlRefusal::size;
    if (layout.version == 8) return decodeVersion8(bytes, control);
    if (layout.version == 18) return decodeVersion18(bytes, control);
    return decodeVersion4(bytes, control);
  }
  return ControlRefusal::version;
}

GameState gameStateFrom(const GameControlData& control, TeamColour team, std::uint8_t player) {
  const ControlTeam& own = teamOf(control, team);
  const ControlTeam& other = teamOf(control, otherThan(team));
  GameState game;
  game.state = control.state;
  game.team = team;
  game.player = player;
  if (player >= 1 && player <= kControlPlayers)
    game.penalised = own.players[player - 1U].penalty != ControlPenalty::none;
  game.ownScore = static_cast<std::uint8_t>(own.score & 0xffU);
  game.opponentScore = static_cast<std::uint8_t>(other.score & 0xffU);
  game.kickOff = control.kickOff == team && !control.dropBall &&
                 (control.state == PlayState::ready || control.state == PlayState::set);
  game.firstHalf = control.firstHalf;
  game.secondsLeft = control.secondsLeft;
  return game;
}

GameControlData controlFrom(const GameState& game) {
  GameControlData control;
  control.state = game.state;
  control.firstHalf = game.firstHalf;
  control.kickOff = game.kickOff ? game.team : otherThan(game.team);
  control.secondsLeft = static_cast<std::uint32_t>(game.secondsLeft + 0.5);
  ControlTeam& own = control.teams[0];
  ControlTeam& other = control.teams[1];
  own.colour = game.team;
  own.score = game.ownScore;
  other.colour = otherThan(game.team);
  other.score = game.opponentScore;
  // Which penalty it was is not recorded.
  if (game.penalised && game.player >= 1 && game.player <= kControlPlayers)
    own.players[game.player - 1U].penalty = ControlPenalty::requestForPickUp;
  return control;
}

}  // namespace kelpie::net
