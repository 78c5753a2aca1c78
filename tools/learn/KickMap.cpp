// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/KickMap.h"

#include <atomic>
#include <cmath>
#include <mutex>

#include "robot/core/Random.h"
#include "robot/host/OnCores.h"
#include "tools/learn/HeldBall.h"
#include "tools/learn/KickLearner.h"
#include "tools/learn/WalkLearner.h"

namespace kelpie::learn {
namespace {

constexpr double kPhysicsStep = 0.002;  // s, shorter by itself while a ball touches the robot
constexpr double kPushed = 1.0;         // cm: a ball that rests so far from its place is not there
constexpr int kHeldRuns = 4;            // times as many as a place of the free ball has
constexpr double kHeldScatter = 0.6;    // cm to each side, before it is held

// Kicks that send a ball the same way, mirrored, from a place that is mirrored.
bool isItsOwnMirror(MotionKind motion) { return mirrored(motion) == motion; }

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

// Of a kick that is its own mirror image the places to the right alone.
KickGrid emptyGrid(MotionKind motion, const KickMapPlan& plan) {
  KickGrid grid;
  grid.motion = motion;
  grid.aside = steps(isItsOwnMirror(motion) ? 0.0 : -plan.aside, plan.aside, plan.step);
  grid.ahead = steps(plan.nearest, plan.furthest, plan.step);
  return grid;
}

KickGrid heldGrid(MotionKind motion) {
  KickGrid grid;
  grid.motion = motion;
  grid.held = true;
  grid.aside = grid.ahead = {0.0};
  return grid;
}

// The left one of each pair; what strikes from the hold, and what strikes a free ball.
KickMap emptyMap(const KickMapPlan& plan) {
  KickMap map;
  for (const MotionKind free :
       {MotionKind::kickForward, MotionKind::headSwipeLeft, MotionKind::upennLeft})
    map.push_back(emptyGrid(free, plan));
  for (const MotionKind held : {MotionKind::hardForward, MotionKind::wedge,
                                MotionKind::headSwipeLeft, MotionKind::upennLeft})
    map.push_back(heldGrid(held));
  return map;
}

std::vector<KickStart> heldStarts(const std::vector<sim::PhysicsParams>& models, int count,
                                  std::uint64_t seed) {
  KickAim hold;
  hold.held = true;
  hold.ball = {0.0, kHeldAhead};
  hold.scatter = kHeldScatter;
  std::vector<KickStart> starts(static_cast<std::size_t>(count));
  host::onCores(starts.size(), [&](std::size_t i) {
    starts[i] = beforeKick(hold, models[i % models.size()], seed + i);
  });
  return starts;
}

// Everything that is run, in one list: onCores shares it out.
struct Job {
  std::size_t grid = 0;
  std::size_t cell = 0;
  std::size_t trial = 0;
};

class Learner {
 public:
  Learner(const KickMapPlan& plan, const KickMapTold& told)
      : plan_(plan), told_(told), map_(emptyMap(plan)) {
    models_ = variedModels(firstModelOf(plan), plan.trials, kPhysicsStep);
  }

  KickMap learn() {
    standing_.resize(models_.size());
    host::onCores(models_.size(), [&](std::size_t i) {
      standing_[i] = standingStart(models_[i], firstModelOf(plan_) + i);
    });
    held_ = heldStarts(models_, plan_.trials * kHeldRuns, firstModelOf(plan_));
    const std::vector<Job> jobs = allJobs();
    std::vector<KickRun> runs(jobs.size());
    host::onCores(jobs.size(), [&](std::size_t i) {
      if (!goesOn()) return;
      runs[i] = run(jobs[i], i);
      tell(jobs.size());
    });
    if (!goesOn()) return {};
    sumUp(jobs, runs);
    return std::move(map_);
  }

 private:
  std::vector<Job> allJobs() {
    std::vector<Job> jobs;
    for (std::size_t g = 0; g < map_.size(); ++g) {
      KickGrid& grid = map_[g];
      grid.cells.resize(grid.aside.size() * grid.ahead.size());
      const auto trials = grid.held ? held_.size() : static_cast<std::size_t>(plan_.trials);
      for (std::size_t cell = 0; cell < grid.cells.size(); ++cell)
        for (std::size_t trial = 0; trial < trials; ++trial) jobs.push_back({g, cell, trial});
    }
    return jobs;
  }

  KickRun run(const Job& job, std::uint64_t number) const {
    const KickGrid& grid = map_[job.grid];
    const actuator::MotionData& motion = actuator::standardMotions()[grid.motion];
    if (grid.held) return {tryKick(motion, grid.motion, held_[job.trial]), true};
    Random random(firstModelOf(plan_) ^ (number << 20U));
    const double half = 0.5 * plan_.step;
    const Point2<Robot> place{
        grid.aside[job.cell % grid.aside.size()] + random.uniform(-half, half),
        grid.ahead[job.cell / grid.aside.size()] + random.uniform(-half, half)};
    return kickFrom(place, grid.motion, standing_[job.trial % standing_.size()]);
  }

  bool goesOn() const { return goesOn_.load(); }
  void tell(std::size_t all) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!told_(++done_, all)) goesOn_ = false;
  }

  void sumUp(const std::vector<Job>& jobs, const std::vector<KickRun>& runs) {
    for (std::size_t g = 0; g < map_.size(); ++g) {
      std::vector<std::vector<KickRun>> ofCells(map_[g].cells.size());
      std::vector<Kicked> all;
      for (std::size_t i = 0; i < jobs.size(); ++i) {
        if (jobs[i].grid != g) continue;
        ofCells[jobs[i].cell].push_back(runs[i]);
        if (runs[i].counts) all.push_back(runs[i].kicked);
      }
      for (std::size_t cell = 0; cell < ofCells.size(); ++cell) {
        const bool middle = map_[g].aside[cell % map_[g].aside.size()] == 0.0;
        if (middle && isItsOwnMirror(map_[g].motion)) addMirrorImages(ofCells[cell]);
        map_[g].cells[cell] = cellOf(ofCells[cell]);
      }
      map_[g].window = windowOf(map_[g]);
      map_[g].way = spreadOf(all).way;
      map_[g].frames = framesOf(map_[g].motion);
    }
  }

  static double framesOf(MotionKind motion) {
    return std::ceil(ticksOf(actuator::standardMotions()[motion]) * kTickSeconds * 30.0);
  }

  const KickMapPlan& plan_;
  const KickMapTold& told_;
  KickMap map_;
  std::vector<sim::PhysicsParams> models_;
  std::vector<KickStart> standing_;
  std::vector<KickStart> held_;
  std::mutex mutex_;
  std::size_t done_ = 0;
  std::atomic<bool> goesOn_{true};
};

}  // namespace

KickRun kickFrom(Point2<Robot> place, MotionKind motion, const KickStart& standing) {
  const KickStart start = withBallAt(place, standing);
  const Point2<Robot> lies = robotFromField(start.pose, start.ball);
  if (start.walker->failed() || (lies - place).norm() > kPushed) return {{}, false};
  return {tryKick(actuator::standardMotions()[motion], motion, start), true};
}

KickRun kickAtOnce(Point2<Robot> place, MotionKind motion, const KickStart& start) {
  const KickStart with = withBallJustAt(place, start);
  const Kicked kicked = tryKick(actuator::standardMotions()[motion], motion, with);
  return {kicked, !with.walker->failed()};
}

KickMap learnKickMap(const KickMapPlan& plan, const KickMapTold& told) {
  return Learner(plan, told).learn();
}

}  // namespace kelpie::learn
