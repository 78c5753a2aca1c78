// SPDX-License-Identifier: Apache-2.0
#include "gps/players/TeamBall.h"

#include "gps/ball/BallMotion.h"

namespace kelpie::gps {
namespace {

struct Group {
  unsigned members = 0;  // one bit for each witness
  std::uint8_t size = 0;
  Place place;
};

bool in(unsigned members, std::size_t index) { return ((members >> index) & 1U) != 0U; }

bool agree(unsigned members, const Witnesses& witnesses, double gate) {
  for (std::size_t i = 0; i < witnesses.size(); ++i) {
    for (std::size_t k = i + 1; k < witnesses.size(); ++k) {
      if (!in(members, i) || !in(members, k)) continue;
      if (mahalanobisSquared(witnesses[i].place, witnesses[k].place) > gate) return false;
    }
  }
  return true;
}

Group groupOf(unsigned members, const Witnesses& witnesses) {
  Group group;
  group.members = members;
  for (std::size_t i = 0; i < witnesses.size(); ++i) {
    if (!in(members, i)) continue;
    group.place = group.size == 0 ? witnesses[i].place : productOf(group.place, witnesses[i].place);
    ++group.size;
  }
  return group;
}

bool better(const Group& a, const Group& b) {
  if (a.size != b.size) return a.size > b.size;
  return a.place.covariance.trace() < b.place.covariance.trace();
}

void addWitness(const Witness& witness, const TeamBallParams& params, Witnesses& list) {
  if (witness.secondsSinceSeen > params.keep) return;
  if (0.5 * witness.place.covariance.trace() > params.maxVariance) return;
  list.push_back(witness);
  list.back().place.covariance += params.witnessNoise * Matrix2::Identity();
}

}  // namespace

Witness witnessOf(const TeamMessage& message, const PlayersContext& context) {
  BallHypothesis ball;
  const SharedBall& said = message.ball;
  ball.mean = {said.position.x, said.position.y, said.velocity.x, said.velocity.y};
  roll(ball, message.age, context.ball);
  const double growth = context.players.teamBall.growth * message.age;
  return {{Vector2(ball.mean[0], ball.mean[1]),
           matrixOf(said.covariance) + growth * Matrix2::Identity()},
          {ball.mean[2], ball.mean[3]},
          said.secondsSinceSeen + message.age};
}

Witnesses witnessesOf(const BallEstimate& own, const Teammates& mates,
                      const PlayersContext& context) {
  const TeamBallParams& params = context.players.teamBall;
  Witnesses list;
  if (own.present) {
    addWitness({{vectorOf(own.position), matrixOf(own.fieldCovariance)},
                own.velocity,
                own.secondsSinceSeen},
               params, list);
  }
  for (const Teammate& mate : mates) {
    if (!mate.present || !mate.last.ball.present) continue;
    addWitness(witnessOf(mate.last, context), params, list);
  }
  return list;
}

TeamBall fused(const Witnesses& witnesses, const TeamBallParams& params) {
  TeamBall ball;
  if (witnesses.empty()) return ball;
  Group best;
  for (unsigned members = 1; members < (1U << witnesses.size()); ++members) {
    if (!agree(members, witnesses, params.gate)) continue;
    const Group group = groupOf(members, witnesses);
    if (best.size == 0 || better(group, best)) best = group;
  }
  ball.present = true;
  ball.position = pointOf(best.place.mean);
  ball.covariance = rowsOf(best.place.covariance);
  ball.witnesses = best.size;
  ball.outvoted = static_cast<std::uint8_t>(witnesses.size() - best.size);
  ball.secondsSinceSeen = params.keep;
  double surest = 0.0;
  for (std::size_t i = 0; i < witnesses.size(); ++i) {
    if (!in(best.members, i)) continue;
    const double spread = witnesses[i].place.covariance.trace();
    if (surest == 0.0 || spread < surest) {
      surest = spread;
      ball.velocity = witnesses[i].velocity;
    }
    if (witnesses[i].secondsSinceSeen < ball.secondsSinceSeen)
      ball.secondsSinceSeen = witnesses[i].secondsSinceSeen;
  }
  return ball;
}

}  // namespace kelpie::gps
