// SPDX-License-Identifier: Apache-2.0
#include "vision/Vision.h"

#include <algorithm>
#include <cmath>

#include "robot/core/fields/Emptied.h"
#include "vision/Refusal.h"
#include "vision/Scene.h"
#include "vision/ball/BallFinder.h"
#include "vision/beacon/BeaconFinder.h"
#include "vision/edge/FieldEdge.h"
#include "vision/goal/GoalFinder.h"
#include "vision/light/LightFollower.h"
#include "vision/light/LightSightings.h"
#include "vision/line/LinePoints.h"
#include "vision/pink/PinkFinder.h"
#include "vision/robot/Obstacles.h"
#include "vision/robot/RobotFinder.h"

namespace kelpie::vision {
namespace {

// False where a joint or the stance was NaN or absurd: rows and columns made from it lie anywhere
// in memory.
bool poseIsInRange(const BodyState& body) {
  constexpr double kMaxTurn = 10.0;       // rad over an image
  constexpr double kFarthest = 100.0;     // cm from the robot to its camera, three times an ERS-7
  constexpr double kFarthestRow = 1.1e4;  // px, a little beyond the horizon's limit
  constexpr double kMaxAxis = 1.000001;   // of length one, as far as rounding lets them be
  const auto within = [](double value, double max) { return std::fabs(value) <= max; };
  const Point3<Robot>& at = body.camera.position;
  const auto& axes = body.camera.axes;
  const auto& turn = body.camera.turn;
  return within(at.x, kFarthest) && within(at.y, kFarthest) && within(at.z, kFarthest) &&
         std::all_of(axes.begin(), axes.end(), [&](double a) { return within(a, kMaxAxis); }) &&
         std::all_of(turn.begin(), turn.end(), [&](double t) { return within(t, kMaxTurn); }) &&
         within(body.horizon.atLeft, kFarthestRow) && within(body.horizon.atRight, kFarthestRow);
}

}  // namespace

void stepInto(Percepts& out, const VisionIn& in, const VisionParams& params, VisionState& state) {
  makeEmpty(out);
  out.light = advanced(in.input.light);
  state.judgedBalls.clear();
  state.judgedBeacons.clear();
  state.judgedGoals.clear();
  state.judgedRobots.clear();
  if (!poseIsInRange(in.body)) {
    refuse(out.counts, Refusal::poseOutOfRange);
    return;
  }
  state.tables.follow(out.light);
  Sampler sampler(in.input.image, state.tables, state.classes);
  sampler.reset();
  const HorizonFrame frame = horizonFrameOf(in.body.camera);
  const Horizon& horizon = in.body.horizon;
  const double middle = 0.5 * (horizon.atLeft + horizon.atRight);
  const Lattice lattice(frame, frame.fromImage({frame.lens.principalX, middle}).v);
  const auto found = findBlobs(sampler, lattice, state.runs, state.blobs);
  out.counts.sampledPixels = found.samples;
  out.counts.runs = static_cast<std::uint32_t>(state.runs.size());
  out.counts.blobs = static_cast<std::uint32_t>(state.blobs.size());
  constexpr std::uint32_t kMaxCounted = 1000;  // of what did not fit, in an image
  for (std::uint32_t i = 0; i < found.lost && i < kMaxCounted; ++i)
    refuse(out.counts, Refusal::bufferFull);
  out.fieldEdges = findFieldEdges(sampler, lattice, params.scan, params.fieldEdge, out.counts);

  const Scene scene{sampler, state.blobs, in.body,    out.fieldEdges,
                    frame,   lattice,     state.runs, params.field};
  findBeacons(scene, params.beacon, out.counts, out.landmarks, state.judgedBeacons);
  findGoals(scene, params.goal, out.counts, out.landmarks, out.gaps, state.judgedGoals);
  out.ball = findBall(scene, params.ball, out.counts, state.judgedBalls);
  findRobots(scene, params.robot, out.counts, out.robots, state.judgedRobots);
  findPinkPatches(scene, out.landmarks, params.pink, out.counts, out.pinkPatches);
  const Obstacles obstacles = findObstacles(scene, params.obstacle, out.counts);
  copyUsed(out.obstacles, obstacles.points);
  out.obstaclesAhead = obstacles.ahead;
  findLinePoints(scene, params.line, out);
  if (params.light.follow && isWhole(out.light))
    learnLight(seenLight(scene, out, params.light), params.light, out.light);
}

Percepts step(const VisionIn& in, const VisionParams& params, VisionState& state) {
  Percepts out;
  stepInto(out, in, params, state);
  return out;
}

}  // namespace kelpie::vision
