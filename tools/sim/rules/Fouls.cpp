// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/rules/Fouls.h"

#include "tools/sim/rules/KickOff.h"

namespace kelpie::sim {
namespace {

bool lasts(bool so, TimeUs now, double longest, std::optional<TimeUs>& since) {
  if (!so) since.reset();
  if (so && !since) since = now;
  return since && (now - *since).seconds() > longest;
}

}  // namespace

const char* wordsFor(Offence offence) {
  switch (offence) {
    case Offence::ownBox: return "illegal defender";
    case Offence::leftField: return "left the field";
    case Offence::fallen: return "fallen";
    case Offence::heldTooLong: return "held the ball too long";
    case Offence::carriedTooFar: return "carried the ball too far";
    case Offence::pushing: return "pushing";
  }
  return "";
}

Fouls step(const MatchScene& scene, const body::FieldDescription& field, FoulState& state) {
  Fouls fouls;
  const body::Rules& rules = field.rules;
  for (std::size_t i = 0; i < scene.players.size(); ++i) {
    const ScenePlayer& player = scene.players[i];
    const Point2<Field> at = player.pose.position;
    const bool inBox =
        player.playing && player.number != kGoalie && inOwnGoalBox(field, player.team, at);
    const bool off = player.playing && body::carpetDistance(field, at) > 0.0;
    const bool lies = player.playing && !player.upright;
    const bool boxed = lasts(inBox, scene.time, rules.ownBoxTime, state.inBox[i]);
    const bool left = lasts(off, scene.time, rules.leavingTime, state.offCarpet[i]);
    const bool fallen = lasts(lies, scene.time, rules.fallenTime, state.lying[i]);
    if (boxed)
      fouls.push_back({i, Offence::ownBox});
    else if (left)
      fouls.push_back({i, Offence::leftField});
    else if (fallen)
      fouls.push_back({i, Offence::fallen});
  }
  return fouls;
}

}  // namespace kelpie::sim
