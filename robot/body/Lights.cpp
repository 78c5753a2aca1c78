// SPDX-License-Identifier: Apache-2.0
#include "robot/body/Lights.h"

#include <array>

namespace kelpie::body {
namespace {

constexpr std::uint32_t kStates = kLightRed | kLightGreen | kLightBlue;
constexpr std::uint32_t kTeams = kLightBackFront | kLightBackRear;
constexpr std::uint32_t kFailed = 1U << (kFirstFaceLight + 11U);
constexpr std::uint32_t kPair = 3;
constexpr double kFaultHalfPeriods = 4.0;  // 1/s
constexpr std::uint32_t kShownRoles = 5;   // for more the face has no pairs left
constexpr std::uint32_t kRoles = ((1U << (2U * kShownRoles)) - 1U) << kFirstFaceLight;

// In the order of Rest: which of the face's lights from the 11th on, and why.
struct RestRow {
  std::uint32_t lights;
  const char* name;
};
constexpr std::array<RestRow, kRestCount> kRests = {{
    {0b0000, "it plays"},
    {0b0011, "the pause switch is pressed"},
    {0b0100, "the battery is low"},
    {0b1100, "the motors have no power"},
    {0b1000, "no image comes"},
    {0b1001, "the joints get their gains"},
    {0b0001, "it waits until a person asks it to stand"},
    {0b1010, "it is lifted"},
    {0b0101, "the battery gives too much current"},
    {0b0110, "the battery is too hot"},
    {0b0111, "the fan stands still"},
    {0b1110, "a joint does not follow"},
}};

}  // namespace

std::uint32_t lightsOf(PlayState state, bool penalised) {
  if (penalised) return kLightRed;
  switch (state) {
    case PlayState::initial: return 0;
    case PlayState::ready: return kLightBlue;
    case PlayState::set: return kLightRed | kLightGreen;
    case PlayState::playing: return kLightGreen;
    case PlayState::finished: break;
  }
  return kStates;
}

std::uint32_t lightsOf(TeamColour team) {
  return team == TeamColour::red ? kLightBackRear : kLightBackFront;
}

std::uint32_t lightsOf(Role role) {
  const auto number = static_cast<std::uint32_t>(role);
  return role == Role::none || number > kShownRoles
             ? 0U
             : kPair << (kFirstFaceLight + 2U * (number - 1U));
}

std::uint32_t faultLights(std::uint32_t number, TimeUs time) {
  const std::uint32_t shown = number < kFaceLights ? number : kFaceLights;
  const std::uint32_t face = ((1U << shown) - 1U) << kFirstFaceLight;
  // Not by a division of 64 bits, which the robot's object would want of the SDK.
  const auto halves = static_cast<std::int32_t>(time.seconds() * kFaultHalfPeriods);
  return face | (halves % 2 == 0 ? kLightRed : 0U);
}

std::uint32_t lightsOf(Rest rest) {
  return kRests[static_cast<std::size_t>(rest)].lights << (kFirstFaceLight + 10U);
}

const char* nameOf(Rest rest) { return kRests[static_cast<std::size_t>(rest)].name; }

std::uint32_t lightsOf(Fallback fallback) { return fallback == Fallback::none ? 0U : kFailed; }

std::uint32_t lights(const GameState& game, Rest rest) {
  return lights(game, Role::none, 0) | lightsOf(rest);
}

std::uint32_t lights(const GameState& game, Role role, std::uint32_t asked) {
  return (asked & ~(kStates | kTeams | kRoles | kFailed)) | lightsOf(game.state, game.penalised) |
         lightsOf(game.team) | lightsOf(role);
}

}  // namespace kelpie::body
