// SPDX-License-Identifier: Apache-2.0
// Four opponents wander about; four robots walk among them with panning heads and see one
// or another. How well a robot knows the four by itself, and with the messages of the others;
// beside that the thesis' choice of a filter by the angle alone, and the tracker of 2003.
#include "gps/players/Opponents.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robot/body/Camera.h"
#include "tools/experiments/baselines/Opponents2003.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/harness/Trials.h"
#include "tools/experiments/players/Player.h"

namespace kelpie::experiments {
namespace {

constexpr std::size_t kPlayers = kTeammates + 1;
constexpr int kFrames = 900;
constexpr int kSettled = 150;          // frames until errors count
constexpr double kSpeed = 20.0;        // cm/s, of the opponents
constexpr double kFoundWithin = 40.0;  // cm
constexpr double kOnRobot = 35.0;      // cm; a filter so near an opponent sits on it

using Places = std::vector<Point2<Field>>;

struct Tally {
  Values error;
  Values seen;  // of those seen within the last second
  Values separation;
  Share found;
  Share merged;  // frames in which two filters sat on one robot
};

std::pair<std::size_t, double> nearest(Point2<Field> at, const Places& places) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (distance(at, places[i]) < distance(at, places[best])) best = i;
  }
  return {best, distance(at, places[best])};
}

Places placesOf(const WorldModel& world) {
  Places places;
  for (const OpponentEstimate& o : world.opponents) places.push_back(o.position);
  return places;
}

void addSeparation(const Places& filters, const Places& opponents, Tally& tally) {
  double smallest = 1e9;
  bool merged = false;
  for (std::size_t i = 0; i < filters.size(); ++i) {
    for (std::size_t k = i + 1; k < filters.size(); ++k) {
      smallest = std::min(smallest, distance(filters[i], filters[k]));
      const auto a = nearest(filters[i], opponents);
      const auto b = nearest(filters[k], opponents);
      merged = merged || (a.first == b.first && a.second < kOnRobot && b.second < kOnRobot);
    }
  }
  if (filters.size() > 1) tally.separation.push_back(smallest);
  tally.merged.count(merged);
}

void addErrors(const WorldModel& world, const Places& opponents, Tally& tally) {
  const Places filters = placesOf(world);
  for (const OpponentEstimate& o : world.opponents) {
    const double error = nearest(o.position, opponents).second;
    tally.error.push_back(error);
    if (o.secondsSinceSeen < 1.0) tally.seen.push_back(error);
  }
  for (const Point2<Field>& opponent : opponents)
    tally.found.count(!filters.empty() && nearest(opponent, filters).second < kFoundWithin);
  addSeparation(filters, opponents, tally);
}

struct Match {
  std::vector<Player> players;
  std::vector<Wanderer> opponents;
  std::vector<Random> minds;
  std::vector<WalkSpeed> speeds;
  Radio radio;
};

Match matchOf(std::uint64_t seed, const gps::OpponentParams& params) {
  Random random(seed);
  Match match{{}, {}, {}, std::vector<WalkSpeed>(kPlayers), Radio(kPlayers, random.next())};
  for (std::size_t i = 0; i < kPlayers; ++i) {
    const Pose2 pose{{random.uniform(60, 300), random.uniform(60, 480)},
                     Angle::rad(random.uniform(-maths::kPi, maths::kPi))};
    match.players.emplace_back(pose, static_cast<std::uint8_t>(i + 1), random.next());
    match.players.back().believe(pose, 5.0, Angle::deg(3.0));
    match.players.back().params.players.opponents = params;
    match.minds.emplace_back(random.next());
  }
  for (std::size_t i = 0; i < kOpponents; ++i) {
    match.opponents.emplace_back(
        Point2<Field>{60.0 + 80.0 * static_cast<double>(i), random.uniform(60, 480)},
        random.next());
  }
  return match;
}

// A random walk, drawn again every two seconds on average; at the edge back to the middle.
WalkSpeed mindOf(Player& player, Random& random, WalkSpeed speed) {
  const Point2<Field> p = player.truth.pose().position;
  const bool atEdge = p.x < 30 || p.x > 330 || p.y < 30 || p.y > 510;
  if (atEdge) {
    const Angle home = player.bearingOf({180.0, 270.0});
    return {std::fabs(home.deg()) < 60.0 ? 18.0 : 0.0, 0.0, home.rad() > 0.0 ? 0.9 : -0.9};
  }
  if (!random.chance(1.0 / 60.0)) return speed;
  return {random.uniform(0.0, 20.0), random.uniform(-8.0, 8.0), random.uniform(-0.5, 0.5)};
}

Places move(std::vector<Wanderer>& opponents) {
  Places places;
  for (const Wanderer& o : opponents) places.push_back(o.position);
  for (std::size_t i = 0; i < opponents.size(); ++i) {
    opponents[i].step(kSpeed, places);
    places[i] = opponents[i].position;
  }
  return places;
}

// One robot's opponents as the tracker of 2003 has them, beside its own.
class Tracker2003 {
 public:
  void step(const Player& player, const WorldModel& own) {
    const gps::PlayersContext context{player.params.field, player.params.players,
                                      player.params.ball};
    gps::stepOpponents2003({player.input, player.percepts, body::step(player.input, {}).camera},
                           own.modes[0], context, *opponents_);
    world_->opponents = gps::extractOpponents(*opponents_);
  }
  const WorldModel& world() const { return *world_; }

 private:
  std::unique_ptr<gps::Opponents> opponents_ = std::make_unique<gps::Opponents>();
  std::unique_ptr<WorldModel> world_ = std::make_unique<WorldModel>();
};

struct Tallies {
  Tally alone;
  Tally shared;
  Tally of2003;
};

void playMatch(Match match, Tallies& tallies) {
  Tracker2003 tracker;
  for (int frame = 0; frame < kFrames; ++frame) {
    const Places opponents = move(match.opponents);
    match.radio.pass();
    for (std::size_t i = 0; i < kPlayers; ++i) {
      Player& player = match.players[i];
      match.speeds[i] = mindOf(player, match.minds[i], match.speeds[i]);
      player.walk(match.speeds[i]);
      player.turnHead(1.1 * maths::sin(0.07 * frame + static_cast<double>(i)));
      player.seeLandmarks();
      player.seeOpponents(opponents);
      player.input.team = match.radio.receive(i);
      if (i == 0) {
        const WorldModel world = player.stepAlone();
        tracker.step(player, world);
        if (frame >= kSettled) addErrors(world, opponents, tallies.alone);
        if (frame >= kSettled) addErrors(tracker.world(), opponents, tallies.of2003);
      }
      const WorldModel world = player.step();
      match.radio.send(i, world.message);
      if (i == 0 && frame >= kSettled) addErrors(world, opponents, tallies.shared);
    }
  }
}

void put(Json& json, const std::string& name, const Tally& tally) {
  json[name + "_cm"] = mean(tally.error);
  json[name + "_just_seen_cm"] = mean(tally.seen);
  json[name + "_median_cm"] = percentile(tally.error, 0.5);
  json[name + "_found_share"] = tally.found.value();
  json[name + "_merged_share"] = tally.merged.value();
  json[name + "_separation_cm"] = mean(tally.separation);
}

Expected<Json> opponents(const Request& request) {
  Tallies own, byAngle;
  Random seeds(request.seed);
  const gps::OpponentParams ours;
  // Matched by the angle alone, filters never joined, a missed one as sure as before.
  gps::OpponentParams thesis = ours;
  thesis.matchGate = thesis.joinDistance = thesis.missedNoise = 0.0;
  eachTrial(request, [&](const Trial&) {
    const std::uint64_t seed = seeds.next();
    playMatch(matchOf(seed, ours), own);
    playMatch(matchOf(seed, thesis), byAngle);
  });
  Json json;
  put(json, "single", own.alone);
  put(json, "shared", own.shared);
  json["separation_cm"] = mean(own.shared.separation);
  json["merged_share"] = own.shared.merged.value();
  json["found_share"] = own.shared.found.value();
  put(json, "angle_alone_single", byAngle.alone);
  put(json, "angle_alone_shared", byAngle.shared);
  put(json, "of_2003_single", own.of2003);
  return json;
}

const Registration kOpponents("opponents",
                              "four opponents wander about: the filters of one robot and of a team",
                              {Option::trials, Option::seed}, 20, opponents);

}  // namespace
}  // namespace kelpie::experiments
