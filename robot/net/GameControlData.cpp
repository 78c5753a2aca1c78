// SPDX-License-Identifier: Apache-2.0
#include "robot/net/GameControlData.h"

#include <cstring>

namespace kelpie::net {
namespace {

constexpr char kHeader[] = {'R', 'G', 'm', 'e'};
constexpr std::uint32_t kLongest = 86400;        // s
constexpr std::uint32_t kLongestPenalty = 3600;  // s
constexpr std::uint32_t kHighestScore = 255;
constexpr std::uint32_t kLastState = 4;
constexpr std::uint32_t kLastPenalty = 9;

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

TeamColour otherThan(TeamColour team) {
  return team == TeamColour::red ? TeamColour::blue : TeamColour::red;
}

// Keeps the first thing that cannot be. There are as many bytes as the words asked for.
class Reader {
 public:
  explicit Reader(const std::uint8_t* bytes) : at_(bytes) {}

  std::uint32_t word() {
    std::uint32_t word = 0;
    for (const unsigned shift : {0U, 8U, 16U, 24U})
      word |= static_cast<std::uint32_t>(*at_++) << shift;
    return word;
  }
  std::uint32_t upTo(std::uint32_t highest, ControlRefusal reason) {
    const std::uint32_t value = word();
    refuse(value > highest, reason);
    return value;
  }
  void refuse(bool so, ControlRefusal reason) {
    if (so && !refusal_) refusal_ = reason;
  }
  ControlTeam team() {
    ControlTeam team;
    team.number = word();
    team.colour = fromWire(upTo(1, ControlRefusal::teamColour));
    team.score = upTo(kHighestScore, ControlRefusal::score);
    for (ControlPlayer& player : team.players) {
      const std::uint32_t penalty = upTo(kLastPenalty, ControlRefusal::penalty);
      player.penalty = static_cast<ControlPenalty>(penalty & 0xffU);
      player.secondsLeft = upTo(kLongestPenalty, ControlRefusal::penaltyTime);
    }
    return team;
  }
  std::optional<ControlRefusal> refusal_;

 private:
  const std::uint8_t* at_;
};

const ControlTeam& teamOf(const GameControlData& control, TeamColour team) {
  return control.teams[control.teams[0].colour == team ? 0 : 1];
}

}  // namespace

std::vector<std::uint8_t> encodeControl(const GameControlData& control) {
  Writer out;
  out.put(kGameControlVersion);
  out.put(static_cast<std::uint32_t>(control.state));
  out.put(control.firstHalf ? 1U : 0U);
  out.put(wireColour(control.kickOff));
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

std::optional<ControlRefusal> decodeControl(const std::uint8_t* bytes, std::size_t size,
                                            GameControlData& control) {
  if (size != kGameControlSize) return ControlRefusal::size;
  if (std::memcmp(bytes, kHeader, sizeof kHeader) != 0) return ControlRefusal::header;
  Reader in(bytes + sizeof kHeader);
  if (in.word() != kGameControlVersion) return ControlRefusal::version;
  GameControlData got;
  got.state = static_cast<PlayState>(in.upTo(kLastState, ControlRefusal::state) & 0xffU);
  got.firstHalf = in.upTo(1, ControlRefusal::half) == 1;
  got.kickOff = fromWire(in.upTo(1, ControlRefusal::kickOffTeam));
  got.secondsLeft = in.upTo(kLongest, ControlRefusal::secondsLeft);
  got.dropInTeam = fromWire(in.upTo(1, ControlRefusal::dropInTeam));
  got.dropInSeconds = in.word();
  in.refuse(got.dropInSeconds > kLongest && got.dropInSeconds != kNoDropIn,
            ControlRefusal::dropInTime);
  for (ControlTeam& team : got.teams) team = in.team();
  in.refuse(got.teams[0].colour == got.teams[1].colour, ControlRefusal::teamColour);
  if (!in.refusal_) control = got;
  return in.refusal_;
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
  game.kickOff = control.kickOff == team &&
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
