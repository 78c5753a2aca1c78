// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/baselines/Opponents2003.h"

#include <algorithm>
#include <cmath>

#include "gps/players/Information.h"
#include "gps/players/Opponents.h"
#include "gps/pose/Predict.h"

namespace kelpie::gps {
namespace {

using Filters = std::array<OpponentFilter, kOpponents>;
using Shares = std::array<double, kOpponents>;

void startAll(const PlayersContext& context, Filters& filters) {
  for (std::size_t i = 0; i < filters.size(); ++i) {
    filters[i] = OpponentFilter{};
    filters[i].known = true;
    filters[i].belief = informationOf(startPlace(i, context));
  }
}

void passTime(double elapsed, double walkNoise, Filters& filters) {
  for (OpponentFilter& filter : filters) {
    Place place = placeOf(filter.belief);
    place.covariance += walkNoise * elapsed * Matrix2::Identity();
    filter.belief = informationOf(place);
    filter.secondsSinceSeen += elapsed;
  }
}

// The likelihood of the sighting under each filter, made to sum to 1.
Shares sharesOf(const Place& seen, const Filters& filters) {
  Shares shares{};
  double sum = 0.0;
  for (std::size_t i = 0; i < filters.size(); ++i) {
    const Place place = placeOf(filters[i].belief);
    const Matrix2 spread = place.covariance + seen.covariance;
    shares[i] = std::exp(-0.5 * mahalanobisSquared(place, seen)) / std::sqrt(spread.determinant());
    sum += shares[i];
  }
  for (double& share : shares) share = sum > 0.0 ? share / sum : 1.0 / kOpponents;
  return shares;
}

void see(const Place& seen, Filters& filters) {
  const Shares shares = sharesOf(seen, filters);
  for (std::size_t i = 0; i < filters.size(); ++i) {
    Information part = informationOf(seen);
    for (double& value : part.matrix) value *= shares[i];
    for (double& value : part.vector) value *= shares[i];
    add(part, filters[i].belief);
  }
  const auto best = std::max_element(shares.begin(), shares.end()) - shares.begin();
  filters[static_cast<std::size_t>(best)].secondsSinceSeen = 0.0;
}

}  // namespace

void stepOpponents2003(const GpsIn& in, const PoseMode& pose, const PlayersContext& context,
                       Opponents& opponents) {
  const OpponentParams& p = context.players.opponents;
  if (!opponents.started) startAll(context, opponents.filters);
  opponents.started = true;
  passTime(elapsedOf(in.input), p.walkNoise, opponents.filters);
  for (const RobotPercept& percept : in.percepts.robots) {
    if (percept.team == in.input.game.team) continue;
    const Place seen = sightingOf(percept, pose, p.varianceFactor);
    if (0.5 * seen.covariance.trace() < p.maxVariance) see(seen, opponents.filters);
  }
}

}  // namespace kelpie::gps
