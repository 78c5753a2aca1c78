// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/RefusedBlobs.h"

#include <memory>

#include "vision/Refusal.h"
#include "vision/Scene.h"
#include "vision/ball/BallFinder.h"
#include "vision/beacon/BeaconFinder.h"
#include "vision/goal/GoalFinder.h"
#include "vision/pink/PinkFinder.h"
#include "vision/robot/RobotFinder.h"

namespace kelpie::studio {
namespace {

using vision::Blob;
using vision::BlobBuffer;
using vision::Scene;

// Those of finders that look at blobs.
VisionCounts refusalsIn(const Scene& scene, const vision::VisionParams& params,
                        vision::VisionState& state) {
  VisionCounts counts;
  vision::Landmarks landmarks;
  const auto found = std::make_unique<Percepts>();
  findBeacons(scene, params.beacon, counts, landmarks, state.judgedBeacons);
  findGoals(scene, params.goal, counts, landmarks, found->gaps, state.judgedGoals);
  (void)findBall(scene, params.ball, counts, state.judgedBalls);
  findRobots(scene, params.robot, counts, found->robots, state.judgedRobots);
  findPinkPatches(scene, landmarks, params.pink, counts, found->pinkPatches);
  return counts;
}

std::vector<std::string> lessOften(const VisionCounts& all, const VisionCounts& without) {
  std::vector<std::string> reasons;
  for (std::size_t i = 0; i < vision::kRefusalCount; ++i)
    if (without.refused[i] < all.refused[i]) reasons.emplace_back(vision::kRefusalNames[i].name);
  return reasons;
}

}  // namespace

std::vector<RefusedBlob> refusedBlobs(const FrameInput& input, const BodyState& body,
                                      const Percepts& percepts, const vision::VisionParams& params,
                                      vision::VisionState& state) {
  const vision::Sampler sampler(input.image, state.tables, state.classes);
  const vision::HorizonFrame frame = vision::horizonFrameOf(body.camera);
  const double middle = 0.5 * (body.horizon.atLeft + body.horizon.atRight);
  const vision::Lattice lattice(frame, frame.fromImage({frame.lens.principalX, middle}).v);
  auto blobs = std::make_unique<BlobBuffer>(state.blobs);
  const Scene scene{sampler, *blobs,  body,       percepts.fieldEdges,
                    frame,   lattice, state.runs, params.field};
  const VisionCounts all = refusalsIn(scene, params, state);
  std::vector<RefusedBlob> refused;
  for (Blob& blob : *blobs) {
    const Blob whole = blob;
    blob.colour = vision::ColourClass::none;  // its place stays: runs name blobs by number
    const auto reasons = lessOften(all, refusalsIn(scene, params, state));
    blob = whole;
    if (!reasons.empty()) refused.push_back({whole, reasons});
  }
  return refused;
}

}  // namespace kelpie::studio
