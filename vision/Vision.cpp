// SPDX-License-Identifier: Apache-2.0
#include "vision/Vision.h"

#include "vision/BallFinder.h"
#include "vision/BeaconFinder.h"
#include "vision/FieldEdge.h"
#include "vision/GoalFinder.h"
#include "vision/LinePoints.h"
#include "vision/Obstacles.h"
#include "vision/PinkFinder.h"
#include "vision/Refusal.h"
#include "vision/RobotFinder.h"
#include "vision/Scene.h"
#include "vision/Together.h"

namespace kelpie::vision {

Percepts step(const VisionIn& in, const VisionParams& params, VisionState& state) {
  Percepts out;
  Sampler sampler(in.input.image, state.calibration, state.distances, state.classes);
  sampler.reset();
  const Level level = levelOf(in.body.camera);
  const Horizon& horizon = in.body.horizon;
  const double middle = 0.5 * (horizon.atLeft + horizon.atRight);
  const Lattice lattice(level, level.fromImage({body::kPrincipalX, middle}).v);
  const auto found = findBlobs(sampler, lattice, state.runs, state.blobs);
  out.counts.sampledPixels = found.samples;
  out.counts.runs = static_cast<std::uint32_t>(state.runs.size());
  out.counts.blobs = static_cast<std::uint32_t>(state.blobs.size());
  for (std::uint32_t i = 0; i < found.lost && i < 1000; ++i)
    refuse(out.counts, Refusal::bufferFull);
  out.fieldEdges =
      findFieldEdges(sampler, in.body.camera, params.scan, params.fieldEdge, out.counts);

  const Scene scene{sampler, state.blobs, in.body, out.fieldEdges, level, lattice, state.runs};
  findBeacons(scene, params.beacon, out.counts, out.landmarks);
  findGoals(scene, params.goal, out.counts, out.landmarks, out.gaps);
  keepOneGoal(out);
  out.ball = findBall(scene, params.ball, out.counts);
  findRobots(scene, params.robot, out.counts, out.robots);
  findPinkPatches(scene, out.landmarks, params.pink, out.counts, out.pinkPatches);
  const Obstacles obstacles = findObstacles(scene, params.obstacle, out.counts);
  out.obstacles = obstacles.points;
  out.obstaclesAhead = obstacles.ahead;
  findLinePoints(scene, params.line, out);
  return out;
}

}  // namespace kelpie::vision
