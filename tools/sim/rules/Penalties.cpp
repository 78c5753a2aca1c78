// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/rules/Penalties.h"

#include <algorithm>

namespace kelpie::sim {
namespace {

// Beyond the carpet, so that nobody on it walks into them; the room ends at 60 cm (kCapacity).
constexpr double kOffCarpet = 30.0;  // cm
constexpr double kWaitApart = 45.0;  // cm between robots that wait
constexpr double kStray = 30.0;      // cm
constexpr double kInside = 15.0;     // cm from the side line, where a robot comes back
constexpr double kApart = 40.0;      // cm from others there

}  // namespace

double PenaltyState::secondsLeft(std::size_t player, TimeUs now) const {
  return of[player].off ? std::max(0.0, (of[player].until - now).seconds()) : 0.0;
}

Pose2 waitingPlace(const body::FieldDescription& field, const ScenePlayer& player) {
  const double back = (player.number - 0.5) * kWaitApart;
  const double y = 0.5 * field.length + (player.team == TeamColour::red ? -back : back);
  return {{-field.sideFringe - kOffCarpet, y}, Angle::deg(0.0)};
}

Pose2 returnPlace(const body::FieldDescription& field, const MatchScene& scene,
                  std::size_t player) {
  const bool left = scene.ball.position.x > 0.5 * field.width;
  const double in = field.borderWidth + kInside;
  const double back = scene.players[player].team == TeamColour::red ? -kApart : kApart;
  Pose2 place{{left ? in : field.width - in, 0.5 * field.length}, Angle::deg(left ? 0.0 : 180.0)};
  for (std::size_t i = 0; i < 4 && !isFree(scene, place.position, kApart, player); ++i)
    place.position.y += back;
  return place;
}

PenaltyOut step(const MatchScene& scene, PlayState play, const body::FieldDescription& field,
                PenaltyState& state) {
  PenaltyOut out;
  for (std::size_t i = 0; i < scene.players.size(); ++i) {
    Penalty& penalty = state.of[i];
    if (!penalty.off) continue;
    const bool over = penalty.until <= scene.time && play != PlayState::set;
    const Point2<Field> waits = waitingPlace(field, scene.players[i]).position;
    if (over || play == PlayState::initial) {
      penalty.off = false;
      out.back.push_back(i);
    } else if (distance(scene.players[i].pose.position, waits) > kStray) {
      out.stray.push_back(i);
    }
  }
  return out;
}

}  // namespace kelpie::sim
