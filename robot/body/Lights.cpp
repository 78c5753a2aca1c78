// SPDX-License-Identifier: Apache-2.0
#include "robot/body/Lights.h"

namespace kelpie::body {
namespace {

constexpr std::uint32_t kStates = kLightRed | kLightGreen | kLightBlue;
constexpr std::uint32_t kTeams = kLightBackFront | kLightBackRear;
constexpr std::uint32_t kFailed = 1U << (kFirstFaceLight + 11U);
constexpr std::uint32_t kPair = 3;
constexpr double kFaultHalfPeriods = 4.0;  // 1/s
constexpr std::uint32_t kRoles = ((1U << (2U * (kRoleCount - 1U))) - 1U) << kFirstFaceLight;

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
  if (role == Role::none) return 0;
  return kPair << (kFirstFaceLight + 2U * (static_cast<std::uint32_t>(role) - 1U));
}

std::uint32_t faultLights(std::uint32_t number, TimeUs time) {
  const std::uint32_t shown = number < kFaceLights ? number : kFaceLights;
  const std::uint32_t face = ((1U << shown) - 1U) << kFirstFaceLight;
  // Not by a division of 64 bits, which the robot's object would want of the SDK.
  const auto halves = static_cast<std::int32_t>(time.seconds() * kFaultHalfPeriods);
  return face | (halves % 2 == 0 ? kLightRed : 0U);
}

std::uint32_t lightsOf(Rest rest) {
  constexpr std::uint32_t k11 = 1U << (kFirstFaceLight + 10U);
  switch (rest) {
    case Rest::none: return 0;
    case Rest::paused: return k11 | k11 << 1U;
    case Rest::batteryLow: return k11 << 2U;
    case Rest::powerless: return k11 << 2U | k11 << 3U;
    case Rest::blind: break;
  }
  return k11 << 3U;
}

std::uint32_t lightsOf(Fallback fallback) { return fallback == Fallback::none ? 0U : kFailed; }

std::uint32_t lights(const GameState& game, Rest rest) {
  return lights(game, Role::none, 0) | lightsOf(rest);
}

std::uint32_t lights(const GameState& game, Role role, std::uint32_t asked) {
  return (asked & ~(kStates | kTeams | kRoles | kFailed)) | lightsOf(game.state, game.penalised) |
         lightsOf(game.team) | lightsOf(role);
}

}  // namespace kelpie::body
