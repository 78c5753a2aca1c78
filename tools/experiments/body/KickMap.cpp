// SPDX-License-Identifier: Apache-2.0
// How right the kick map of the behaviours is (pycode/data/kick_map.py) on physical models that it
// was not learnt on: kicks of free balls at random places of its grid and of held ones, by a robot
// that stands, and by one that walks until it kicks. What the map says against what happens.
#include <cmath>
#include <fstream>
#include <mutex>
#include <sstream>

#include "robot/core/Random.h"
#include "robot/host/OnCores.h"
#include "tools/cli/DataFolder.h"
#include "tools/experiments/harness/Experiment.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/harness/Trace.h"
#include "tools/learn/kick/KickMapFile.h"
#include "tools/learn/motion/BallInHold.h"
#include "tools/learn/walk/WalkLearner.h"

namespace kelpie::experiments {
namespace {

using learn::KickFrom;

constexpr double kStep = 0.002;            // s, of the physics
constexpr std::uint64_t kUnseen = 700000;  // seeds of models that no search and no map has seen
constexpr std::size_t kPlaces = 24;        // of each kick, on each model, left and right in turn
constexpr std::size_t kHolds = 6;          // on each model
constexpr double kLikely = 0.5;            // a chance from which a kick's way is judged
constexpr double kSurest = 2.0;            // deg and cm: as kick_table.py, SD_FLOOR
constexpr std::size_t kBins = 5;           // of equal chances

// What was said and what happened.
struct Compared {
  learn::KickCell said;
  learn::Kicked kicked;
  Point2<Robot> place;  // as the motion begins; of a held ball nowhere
  WalkRequest walk;     // until then
  bool went() const { return kicked.distance > learn::kBallGoes; }
};

// One kick, for --traces.
struct KickRow {
  MotionKind motion = MotionKind::none;
  std::int32_t from = 0;
  std::int32_t model = 0;  // its seed
  double x = 0.0;
  double y = 0.0;
  double forward = 0.0;
  double left = 0.0;
  Angle turn;
  double chance = 0.0;
  Angle saidDirection;
  double saidDistance = 0.0;
  Angle direction;
  double distance = 0.0;

  template <int = 0>
  static constexpr auto fields() {
    using P = KickRow;
    return fieldList(
        field("motion", &P::motion), field("from", &P::from), field("model", &P::model),
        field("x_cm", &P::x, "cm"), field("y_cm", &P::y, "cm"),
        field("forward_cm_s", &P::forward, "cm/s"), field("left_cm_s", &P::left, "cm/s"),
        field("turn_deg_s", &P::turn, "rad"), field("chance", &P::chance),
        field("said_deg", &P::saidDirection, "rad"), field("said_cm", &P::saidDistance, "cm"),
        field("direction_deg", &P::direction, "rad"), field("distance_cm", &P::distance, "cm"));
  }
};

struct Job {
  const learn::KickGrid* grid = nullptr;
  bool right = false;  // the mirrored kick
  std::uint64_t seed = 0;
  std::size_t model = 0;
};

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
    std::vector<std::optional<Compared>> all(jobs_.size());
    host::onCores(jobs_.size(), [&](std::size_t i) {
      all[i] = run(jobs_[i]);
      tell();
    });
    Json json;
    for (const learn::KickGrid& grid : map_)
      json[nameOf(grid)] =
          figuresOf(comparedOf(all, [&](const Job& job) { return job.grid == &grid; }));
    for (const KickFrom from : {KickFrom::standing, KickFrom::walking})
      json[from == KickFrom::walking ? "free_walking" : "free_standing"] =
          figuresOf(comparedOf(all, [&](const Job& job) { return job.grid->from == from; }));
    trace(all);
    return json;
  }

 private:
  // In trials: each is a share of the kicks.
  void tell() {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::size_t done = ++done_ * models_.size() / jobs_.size();
    if (request_.progress) request_.progress(static_cast<int>(done), request_.trials);
  }

  static std::string nameOf(const learn::KickGrid& grid) {
    constexpr std::array<const char*, learn::kKickFroms> kFroms{"_standing", "_walking", "_held"};
    return std::string(actuator::kMotionNames[static_cast<std::size_t>(grid.motion)]) +
           kFroms[static_cast<std::size_t>(grid.from)];
  }

  void addJobs() {
    std::uint64_t seed = 1000 * request_.seed;
    for (const learn::KickGrid& grid : map_)
      for (std::size_t model = 0; model < models_.size(); ++model) {
        const std::size_t count = grid.from == KickFrom::hold ? kHolds : kPlaces;
        for (std::size_t i = 0; i < count; ++i)
          jobs_.push_back({&grid, i % 2 == 1 && grid.from != KickFrom::hold, ++seed, model});
      }
  }

  template <class Which>
  std::vector<Compared> comparedOf(const std::vector<std::optional<Compared>>& all,
                                   Which which) const {
    std::vector<Compared> runs;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i] && which(jobs_[i])) runs.push_back(*all[i]);
    return runs;
  }

  std::optional<Compared> run(const Job& job) const {
    if (job.grid->from == KickFrom::hold) return held(job);
    Random random(job.seed);
    const double max = job.grid->lateral.back();
    const Point2<Robot> place{random.uniform(-max, max),
                              random.uniform(job.grid->ahead.front(), job.grid->ahead.back())};
    const MotionKind other = learn::mirrored(job.grid->motion);
    const bool swapped = job.right && other != job.grid->motion;
    Compared compared;
    compared.place = place;
    compared.said = learn::cellAt(*job.grid, {swapped ? -place.x : place.x, place.y});
    if (swapped) compared.said.direction = -compared.said.direction;
    learn::LastSteps last;
    if (job.grid->from == KickFrom::walking) last = learn::drawLastSteps(random);
    compared.walk = last.walk;
    const MotionKind motion = swapped ? other : job.grid->motion;
    const learn::KickStart& standing = standing_[job.model];
    const learn::KickRun kick =
        job.grid->from == KickFrom::standing
            ? learn::kickFrom(place, motion, standing)
            : learn::kickInStep(place, motion,
                                learn::walkingStart(standing, last.walk, last.messages), last.walk);
    compared.kicked = kick.kicked;
    if (!kick.counts || compared.said.runs == 0) return std::nullopt;
    return compared;
  }

  std::optional<Compared> held(const Job& job) const {
    learn::KickAim hold;
    hold.held = true;
    hold.ball = {0.0, learn::kHeldAhead};
    hold.scatter = 0.6;
    const auto start = learn::beforeKick(hold, models_[job.model], job.seed);
    const MotionKind motion = job.grid->motion;
    Compared compared;
    compared.said = job.grid->window.whole;
    compared.kicked = learn::tryKick(actuator::standardMotions()[motion], motion, start);
    return compared;
  }

  void trace(const std::vector<std::optional<Compared>>& all) const {
    Trace<KickRow> table(request_.tracePath("kicks"));
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!all[i]) continue;
      const Job& job = jobs_[i];
      const auto& [said, kicked, place, walk] = *all[i];
      table.add({job.right ? learn::mirrored(job.grid->motion) : job.grid->motion,
                 static_cast<std::int32_t>(job.grid->from),
                 static_cast<std::int32_t>(request_.seed + kUnseen + job.model), place.x, place.y,
                 walk.forward, walk.left, Angle::rad(walk.turn), said.went, said.direction,
                 said.distance, kicked.direction, kicked.distance});
    }
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

  // How far the share of balls that went is from the reported chances, in bins of chances.
  static double calibrationError(const std::vector<Compared>& runs) {
    double error = 0.0;
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      double said = 0.0;
      double went = 0.0;
      for (const Compared& one : runs) {
        const double share = one.said.went * static_cast<double>(kBins);
        if (std::min(static_cast<std::size_t>(share), kBins - 1) != bin) continue;
        said += one.said.went;
        went += one.went() ? 1.0 : 0.0;
      }
      error += std::fabs(said - went) / static_cast<double>(runs.size());
    }
    return error;
  }

  static Json figuresOf(const std::vector<Compared>& runs) {
    Share went;
    Share right;
    Share fell;
    Values chances;
    Values direction;
    Values directionSd;
    Values distance;
    Values distanceSd;
    double brier = 0.0;
    for (const Compared& one : runs) {
      went.count(one.went());
      right.count((one.said.went >= kLikely) == one.went());
      fell.count(one.kicked.fell);
      chances.push_back(one.said.went);
      brier += maths::square(one.said.went - (one.went() ? 1.0 : 0.0)) /
               static_cast<double>(runs.size());
      if (!one.went() || one.said.went < kLikely) continue;
      direction.push_back((one.kicked.direction - one.said.direction).deg());
      directionSd.push_back(one.said.directionSd.deg());
      distance.push_back(one.kicked.distance - one.said.distance);
      distanceSd.push_back(one.said.distanceSd);
    }
    Json json{{"runs", runs.size()},
              {"went_share", went.value()},
              {"said_share", mean(chances)},
              {"right_share", right.value()},
              {"chance_off_share", calibrationError(runs)},
              {"brier", brier},
              {"fell_share", fell.value()}};
    addOff("direction_deg", direction, directionSd, json);
    addOff("distance_cm", distance, distanceSd, json);
    return json;
  }

  const Request& request_;
  learn::KickMap map_;
  std::vector<sim::PhysicsParams> models_;
  std::vector<learn::KickStart> standing_;
  std::vector<Job> jobs_;
  std::mutex mutex_;
  std::size_t done_ = 0;
};

Expected<Json> kickMap(const Request& request) {
  const std::string path = cli::dataFolder() + "/pycode/data/kick_map.py";
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  auto map = learn::readKickMap(text.str());
  if (!map) return Error{path + ": " + map.error()};
  return Judge(request, std::move(*map)).judge();
}

const Registration kKickMap("kick-map", "how right the kick map is on models it was not learnt on",
                            {Option::trials, Option::seed, Option::traces}, 12, kickMap);

}  // namespace
}  // namespace kelpie::experiments
