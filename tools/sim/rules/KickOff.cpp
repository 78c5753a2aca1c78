// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/rules/KickOff.h"

#include <algorithm>
#include <cmath>

namespace kelpie::sim {
namespace {

constexpr double kStillWithin = 2.0;      // cm
constexpr double kTurnedWithin = 5.0;     // deg
constexpr double kApart = 40.0;           // cm between neck bases: a robot is 32 cm long
constexpr double kKeeperFromLine = 20.0;  // cm (checklist A-4.3.1.7)

// Shares of width and length of the own field, from player 2 on. On the 2006 field the kicker's
// neck base is 45 cm from the ball, the others are 92 and 108 to 135 cm behind the half-way line.
using Places = std::array<Point2<Field>, 3>;
constexpr Places kWithKickOff{{{0.5, 0.417}, {0.2, 0.33}, {0.8, 0.33}}};
constexpr Places kWithout{{{0.5, 0.3}, {0.2, 0.25}, {0.8, 0.25}}};

Point2<Field> placeOf(const body::FieldDescription& field, std::uint8_t number, bool kicksOff) {
  if (number == kGoalie) return {0.5 * field.width, field.borderWidth + kKeeperFromLine};
  const Places& places = kicksOff ? kWithKickOff : kWithout;
  const std::size_t i = std::min<std::size_t>(number, 4) - 2;
  return {places[i].x * field.width, places[i].y * field.length};
}

bool onField(const body::FieldDescription& field, Point2<Field> p) {
  return p.x >= 0.0 && p.x <= field.width && p.y >= 0.0 && p.y <= field.length;
}

bool moved(const Pose2& before, const Pose2& now) {
  return distance(before.position, now.position) > kStillWithin ||
         std::fabs((now.heading - before.heading).deg()) > kTurnedWithin;
}

bool allLegal(const KickOffIn& in, const body::FieldDescription& field) {
  return std::all_of(in.scene.players.begin(), in.scene.players.end(),
                     [&](const ScenePlayer& player) {
                       return !player.playing || standsLegally(field, player, in.kickOff);
                     });
}

bool anyMoved(const MatchScene& scene, const KickOffState& state) {
  if (state.places.size() != scene.players.size()) return true;
  for (std::size_t i = 0; i < scene.players.size(); ++i)
    if (scene.players[i].playing && moved(state.places[i], scene.players[i].pose)) return true;
  return false;
}

}  // namespace

bool inOwnGoalBox(const body::FieldDescription& field, TeamColour team, Point2<Field> p) {
  const Point2<Field> own = ownView(field, team, p);
  return own.y < field.borderWidth + field.boxDepth &&
         std::fabs(own.x - 0.5 * field.width) < 0.5 * field.boxWidth;
}

bool standsLegally(const body::FieldDescription& field, const ScenePlayer& player,
                   TeamColour kickOff) {
  const Point2<Field> own = ownView(field, player.team, player.pose.position);
  // Who came back from a penalty stands on the half-way line, and sways.
  const bool ahead = own.y > 0.5 * field.length + kStillWithin;
  if (!player.upright || !onField(field, own) || ahead) return false;
  if (player.number != kGoalie && inOwnGoalBox(field, player.team, player.pose.position))
    return false;
  const Point2<Field> centre{0.5 * field.width, 0.5 * field.length};
  return player.team == kickOff ||
         stripeDistance(player.pose, centre) >= 0.5 * field.circleDiameter;
}

Pose2 manualPlace(const body::FieldDescription& field, const MatchScene& scene, std::size_t player,
                  TeamColour kickOff) {
  const ScenePlayer& who = scene.players[player];
  const bool kicksOff = who.team == kickOff;
  const auto facing = [&](Point2<Field> own) {
    return ownView(field, who.team, Pose2{own, Angle::deg(90.0)});
  };
  const Pose2 own = facing(placeOf(field, who.number, kicksOff));
  if (isFree(scene, own.position, kApart, player)) return own;
  for (const std::uint8_t number : {std::uint8_t{2}, std::uint8_t{3}, std::uint8_t{4}}) {
    const Pose2 other = facing(placeOf(field, number, kicksOff));
    if (isFree(scene, other.position, kApart, player)) return other;
  }
  // Between the places: 2006 has a robot's length free there.
  const Pose2 beside = facing({0.35 * field.width, 0.25 * field.length});
  return isFree(scene, beside.position, kApart, player)
             ? beside
             : facing({0.65 * field.width, 0.25 * field.length});
}

bool step(const KickOffIn& in, const body::FieldDescription& field, KickOffState& state) {
  if (!state.begun || anyMoved(in.scene, state) || !allLegal(in, field)) {
    state.begun = true;
    state.since = in.scene.time;
    state.places.clear();
    for (const ScenePlayer& player : in.scene.players) state.places.push_back(player.pose);
    return false;
  }
  return (in.scene.time - state.since).seconds() >= field.rules.readyStill;
}

}  // namespace kelpie::sim
