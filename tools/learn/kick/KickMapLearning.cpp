// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/kick/KickMapLearning.h"

#include <atomic>
#include <cmath>
#include <mutex>

#include "actuator/MotionList.h"
#include "robot/core/Random.h"
#include "robot/host/OnCores.h"
#include "tools/learn/kick/KickLearner.h"
#include "tools/learn/motion/BallInHold.h"
#include "tools/learn/walk/WalkLearner.h"

namespace kelpie::learn {
namespace {

constexpr double kPhysicsStep = 0.002;  // s, shorter by itself while a ball touches the robot
constexpr int kStarts = 4;              // held and walking robots of each model
constexpr double kHeldScatter = 0.6;    // cm to each side, before it is held

// From a place in the middle such a kick does to the right what it does to the left.
void addMirrorImages(std::vector<KickRun>& runs) {
  const std::size_t count = runs.size();
  for (std::size_t i = 0; i < count; ++i) {
    KickRun image = runs[i];
    image.kicked.direction = -image.kicked.direction;
    runs.push_back(image);
  }
}

std::vector<double> steps(double from, double to, double step) {
  std::vector<double> values;
  for (int i = 0; from + i * step <= to + 1e-9; ++i) values.push_back(from + i * step);
  return values;
}

KickGrid emptyGrid(MotionKind motion, KickFrom from, const KickMapPlan& plan) {
  KickGrid grid;
  grid.motion = motion;
  grid.from = from;
  grid.lateral = {0.0};
  grid.ahead = {0.0};
  if (from != KickFrom::hold) {
    grid.lateral = steps(isItsOwnMirror(motion) ? 0.0 : -plan.lateral, plan.lateral, plan.step);
    grid.ahead = steps(plan.nearest, plan.furthest, plan.step);
  }
  grid.cells.resize(grid.lateral.size() * grid.ahead.size());
  grid.frames = std::ceil(ticksOf(actuator::standardMotions()[motion]) * kTickSeconds * 30.0);
  return grid;
}

// The left one of each pair.
KickMap emptyMap(const KickMapPlan& plan) {
  KickMap map;
  for (const KickFrom from : {KickFrom::standing, KickFrom::walking, KickFrom::hold})
    for (const KickAim& aim : kicks()) {
      const actuator::ListedMotion& kick = actuator::listed(aim.motion);
      if (from == KickFrom::hold ? kick.held : kick.free)
        map.push_back(emptyGrid(aim.motion, from, plan));
    }
  return map;
}

// One run of all, so that onCores can share them out.
struct Job {
  std::size_t grid = 0;
  std::size_t cell = 0;
  std::size_t trial = 0;
};

// Robots about to kick, the models in turn.
struct Starts {
  std::vector<KickStart> standing;
  std::vector<KickStart> holding;
  std::vector<KickStart> walking;
  std::vector<WalkRequest> walks;
};

class Learner {
 public:
  Learner(const KickMapPlan& plan, const KickMapListener& listener)
      : plan_(plan), listener_(listener), map_(emptyMap(plan)), seed_(firstModelOf(plan)) {}

  KickMap learn() {
    const std::vector<Job> jobs = allJobs();
    makeStarts(jobs.size());
    std::vector<KickRun> runs(jobs.size());
    host::onCores(jobs.size(), [&](std::size_t i) {
      if (!goesOn_) return;
      runs[i] = run(jobs[i], i);
      tell(1, jobs.size());
    });
    if (!goesOn_) return {};
    for (std::size_t g = 0; g < map_.size(); ++g) sumUp(g, jobs, runs);
    return std::move(map_);
  }

 private:
  void makeStarts(std::size_t jobs) {
    const auto models = variedModels(seed_, plan_.trials, kPhysicsStep);
    KickAim hold;
    hold.held = true;
    hold.ball = {0.0, kHeldAhead};
    hold.scatter = kHeldScatter;
    Starts& s = starts_;
    s.standing.resize(models.size());
    host::onCores(models.size(),
                  [&](std::size_t i) { s.standing[i] = standingStart(models[i], seed_ + i); });
    const std::size_t count = models.size() * kStarts;
    s.holding.resize(count);
    s.walking.resize(count);
    s.walks.resize(count);
    host::onCores(count, [&](std::size_t i) {
      tell(0, jobs);
      if (!goesOn_) return;
      Random random(seed_ + i);
      const LastSteps last = drawLastSteps(random);
      s.holding[i] = beforeKick(hold, models[i % models.size()], seed_ + i);
      s.walking[i] = walkingStart(s.standing[i % models.size()], last.walk, last.messages);
      s.walks[i] = last.walk;
    });
  }

  std::vector<Job> allJobs() const {
    std::vector<Job> jobs;
    for (std::size_t g = 0; g < map_.size(); ++g) {
      const bool held = map_[g].from == KickFrom::hold;
      const auto trials = static_cast<std::size_t>(plan_.trials * (held ? kStarts : 1));
      for (std::size_t cell = 0; cell < map_[g].cells.size(); ++cell)
        for (std::size_t trial = 0; trial < trials; ++trial) jobs.push_back({g, cell, trial});
    }
    return jobs;
  }

  KickRun run(const Job& job, std::uint64_t number) const {
    const KickGrid& grid = map_[job.grid];
    if (grid.from == KickFrom::hold)
      return {tryKick(actuator::standardMotions()[grid.motion], grid.motion,
                      starts_.holding[job.trial]),
              true};
    Random random(seed_ ^ (number << 20U));
    const double half = 0.5 * plan_.step;
    const Point2<Robot> place{
        grid.lateral[job.cell % grid.lateral.size()] + random.uniform(-half, half),
        grid.ahead[job.cell / grid.lateral.size()] + random.uniform(-half, half)};
    if (grid.from == KickFrom::standing)
      return kickFrom(place, grid.motion, starts_.standing[job.trial]);
    // One of that model's.
    const std::size_t start = job.trial + starts_.standing.size() * random.index(kStarts);
    return kickInStep(place, grid.motion, starts_.walking[start], starts_.walks[start]);
  }

  void tell(std::size_t more, std::size_t all) {
    const std::lock_guard<std::mutex> lock(mutex_);
    done_ += more;
    if (!listener_(done_, all)) goesOn_ = false;
  }

  void sumUp(std::size_t g, const std::vector<Job>& jobs, const std::vector<KickRun>& runs) {
    KickGrid& grid = map_[g];
    std::vector<std::vector<KickRun>> ofCells(grid.cells.size());
    std::vector<Kicked> all;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      if (jobs[i].grid != g) continue;
      ofCells[jobs[i].cell].push_back(runs[i]);
      if (runs[i].counts) all.push_back(runs[i].kicked);
    }
    for (std::size_t cell = 0; cell < ofCells.size(); ++cell) {
      const bool middle = grid.lateral[cell % grid.lateral.size()] == 0.0;
      if (middle && isItsOwnMirror(grid.motion)) addMirrorImages(ofCells[cell]);
      grid.cells[cell] = cellOf(ofCells[cell]);
    }
    grid.window = windowOf(grid);
    grid.way = spreadOf(all).way;
  }

  const KickMapPlan& plan_;
  const KickMapListener& listener_;
  KickMap map_;
  std::uint64_t seed_;
  Starts starts_;
  std::mutex mutex_;
  std::size_t done_ = 0;
  std::atomic<bool> goesOn_{true};
};

}  // namespace

KickMap learnKickMap(const KickMapPlan& plan, const KickMapListener& listener) {
  return Learner(plan, listener).learn();
}

}  // namespace kelpie::learn
