// SPDX-License-Identifier: Apache-2.0
// How right the kick map of the behaviours is (pycode/lib/kick_map.py) on physical models that it
// was not learnt on: kicks of free balls at random places of its grid and of held ones, by a robot
// that stands, and by one that walks until it kicks. What the map says against what happens.
#include <cmath>
#include <fstream>
#include <sstream>

#include "robot/core/Random.h"
#include "robot/host/OnCores.h"
#include "tools/experiments/harness/Experiment.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/learn/HeldBall.h"
#include "tools/learn/KickMapFile.h"
#include "tools/learn/WalkLearner.h"

namespace kelpie::experiments {
namespace {

constexpr double kStep = 0.002;            // s, of the physics
constexpr std::uint64_t kUnseen = 700000;  // seeds of models that no search and no map has seen
constexpr std::size_t kPlaces = 24;        // of each kick, on each model and side
constexpr std::size_t kHolds = 6;          // on each model
constexpr double kLikely = 0.5;            // a chance from which a kick's way is judged
constexpr double kSurest = 2.0;            // deg and cm: as kick_table.py, SD_FLOOR
constexpr std::size_t kBins = 5;           // of equal chances

// What was said and what happened.
struct Told {
  learn::KickCell said;
  learn::Kicked kicked;
  bool went() const { return kicked.distance > learn::kBallGoes; }
};

struct Job {
  const learn::KickGrid* grid = nullptr;
  bool right = false;  // the mirrored kick
  bool walks = false;
  std::uint64_t seed = 0;
  std::size_t model = 0;
};

// Slow enough to kick from: the last steps up to the ball.
WalkRequest lastSteps(Random& random) {
  WalkRequest walk;
  walk.forward = random.uniform(5.0, 20.0);
  walk.left = random.uniform(-5.0, 5.0);
  walk.turn = random.uniform(-0.3, 0.3);
  return walk;
}

// How far the robot gets from asking until the motion begins: two vectors are in flight and the
// step is finished first.
constexpr double kUntilKick = 0.19;  // s

Point2<Robot> asKicked(Point2<Robot> place, const WalkRequest& walk) {
  const Angle turn = Angle::rad(0.5 * walk.turn * kUntilKick);
  const double forward = walk.forward * kUntilKick;
  const double left = walk.left * kUntilKick;
  const Point2<Robot> moved{place.x + left, place.y - forward};
  return {moved.x * turn.cos() + moved.y * turn.sin(), moved.y * turn.cos() - moved.x * turn.sin()};
}

class Judge {
 public:
  Judge(const Request& request, learn::KickMap map) : request_(request), map_(std::move(map)) {
    models_ = learn::variedModels(request.seed + kUnseen, request.trials, kStep);
  }

  Json judge() {
    standing_.resize(models_.size());
    host::onCores(models_.size(), [&](std::size_t i) {
      standing_[i] = learn::standingStart(models_[i], request_.seed + i);
    });
    addJobs();
    std::vector<std::optional<Told>> all(jobs_.size());
    host::onCores(jobs_.size(), [&](std::size_t i) { all[i] = run(jobs_[i]); });
    Json json;
    for (const learn::KickGrid& grid : map_)
      for (const bool walks : {false, true}) {
        std::vector<Told> told;
        for (std::size_t i = 0; i < jobs_.size(); ++i)
          if (all[i] && jobs_[i].grid == &grid && jobs_[i].walks == walks) told.push_back(*all[i]);
        if (!told.empty()) json[nameOf(grid, walks)] = figuresOf(told);
      }
    addTogether(all, json);
    return json;
  }

 private:
  static std::string nameOf(const learn::KickGrid& grid, bool walks) {
    const std::string name = actuator::kMotionNames[static_cast<std::size_t>(grid.motion)];
    return name + (grid.held ? "_held" : walks ? "_walking" : "_standing");
  }

  void addJobs() {
    std::uint64_t seed = 1000 * request_.seed;
    for (const learn::KickGrid& grid : map_)
      for (std::size_t model = 0; model < models_.size(); ++model)
        for (const bool right : {false, true})
          for (const bool walks : {false, true}) {
            if (grid.held && (right || walks)) continue;
            for (std::size_t i = 0; i < (grid.held ? kHolds : kPlaces); ++i)
              jobs_.push_back({&grid, right, walks, ++seed, model});
          }
  }

  std::optional<Told> run(const Job& job) const {
    if (job.grid->held) return held(job);
    Random random(job.seed);
    const Point2<Robot> place{random.uniform(-job.grid->aside.back(), job.grid->aside.back()),
                              random.uniform(job.grid->ahead.front(), job.grid->ahead.back())};
    const MotionKind motion =
        job.right ? learn::mirrored(job.grid->motion) : job.grid->motion;
    if (!job.walks) return answer(job, place, learn::kickFrom(place, motion, standing_[job.model]));
    const WalkRequest walk = lastSteps(random);
    const auto walking = learn::walkingStart(models_[job.model], job.seed, walk,
                                             30 + static_cast<int>(random.index(16)));
    return answer(job, asKicked(place, walk), learn::kickAtOnce(place, motion, walking));
  }

  static std::optional<Told> answer(const Job& job, Point2<Robot> place,
                                    const learn::KickRun& run) {
    const bool swapped = job.right && learn::mirrored(job.grid->motion) != job.grid->motion;
    Told told{learn::cellAt(*job.grid, {swapped ? -place.x : place.x, place.y}), run.kicked};
    if (swapped) told.said.direction = -told.said.direction;
    if (!run.counts || told.said.runs == 0) return std::nullopt;
    return told;
  }

  std::optional<Told> held(const Job& job) const {
    learn::KickAim hold;
    hold.held = true;
    hold.ball = {0.0, learn::kHeldAhead};
    hold.scatter = 0.6;
    const auto start = learn::beforeKick(hold, models_[job.model], job.seed);
    const MotionKind motion = job.grid->motion;
    return Told{job.grid->window.whole,
                learn::tryKick(actuator::standardMotions()[motion], motion, start)};
  }

  // Mean off, root of the mean square, and how often within one and two standard deviations: 0.68
  // and 0.95 if the map is as sure as it may be.
  static void addOff(const std::string& name, const Values& off, const Values& sds, Json& json) {
    Share one;
    Share two;
    for (std::size_t i = 0; i < off.size(); ++i) {
      const double sd = std::fmax(sds[i], kSurest);
      one.count(std::fabs(off[i]) <= sd);
      two.count(std::fabs(off[i]) <= 2.0 * sd);
    }
    json[name + "_off"] = mean(off);
    json[name + "_rms"] = rms(off);
    json[name + "_said_sd"] = rms(sds);
    json[name + "_within_sd_share"] = one.value();
    json[name + "_within_two_sd_share"] = two.value();
  }

  // How far the share of balls that went is from the chances told, in bins of chances.
  static double calibrationError(const std::vector<Told>& told) {
    double error = 0.0;
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      double said = 0.0;
      double went = 0.0;
      for (const Told& one : told) {
        const double share = one.said.went * static_cast<double>(kBins);
        if (std::min(static_cast<std::size_t>(share), kBins - 1) != bin) continue;
        said += one.said.went;
        went += one.went() ? 1.0 : 0.0;
      }
      error += std::fabs(said - went) / static_cast<double>(told.size());
    }
    return error;
  }

  static Json figuresOf(const std::vector<Told>& told) {
    Share went;
    Share right;
    Share fell;
    Values chances;
    Values direction;
    Values directionSd;
    Values distance;
    Values distanceSd;
    double brier = 0.0;
    for (const Told& one : told) {
      went.count(one.went());
      right.count((one.said.went >= kLikely) == one.went());
      fell.count(one.kicked.fell);
      chances.push_back(one.said.went);
      brier += maths::square(one.said.went - (one.went() ? 1.0 : 0.0)) /
               static_cast<double>(told.size());
      if (!one.went() || one.said.went < kLikely) continue;
      direction.push_back((one.kicked.direction - one.said.direction).deg());
      directionSd.push_back(one.said.directionSd.deg());
      distance.push_back(one.kicked.distance - one.said.distance);
      distanceSd.push_back(one.said.distanceSd);
    }
    Json json{{"runs", told.size()},
              {"went_share", went.value()},
              {"said_share", mean(chances)},
              {"right_share", right.value()},
              {"chance_off_share", calibrationError(told)},
              {"brier", brier},
              {"fell_share", fell.value()}};
    addOff("direction_deg", direction, directionSd, json);
    addOff("distance_cm", distance, distanceSd, json);
    return json;
  }

  void addTogether(const std::vector<std::optional<Told>>& all, Json& json) const {
    for (const bool walks : {false, true}) {
      std::vector<Told> told;
      for (std::size_t i = 0; i < jobs_.size(); ++i)
        if (all[i] && jobs_[i].walks == walks && !jobs_[i].grid->held) told.push_back(*all[i]);
      json[walks ? "free_walking" : "free_standing"] = figuresOf(told);
    }
  }

  const Request& request_;
  learn::KickMap map_;
  std::vector<sim::PhysicsParams> models_;
  std::vector<learn::KickStart> standing_;
  std::vector<Job> jobs_;
};

Expected<Json> kickMap(const Request& request) {
  const std::string path = std::string(KELPIE_SOURCE_DIR) + "/pycode/lib/kick_map.py";
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  auto map = learn::readKickMap(text.str());
  if (!map) return Error{path + ": " + map.error()};
  return Judge(request, std::move(*map)).judge();
}

const Registration kKickMap("kick-map", "how right the kick map is on models it was not learnt on",
                            {Option::trials, Option::seed}, 12, kickMap);

}  // namespace
}  // namespace kelpie::experiments
