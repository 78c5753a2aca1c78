// SPDX-License-Identifier: Apache-2.0
#include "gps/PinkUpdate.h"

#include <algorithm>

#include "gps/Modes.h"
#include "gps/PinkMap.h"
#include "gps/Update.h"

namespace kelpie::gps {
namespace {

// Keeps the heaviest of all that are offered: M (N + 1) modes can be more than there is room for.
void offer(const PoseMode& mode, Modes& best) {
  if (best.push_back(mode)) return;
  PoseMode* lightest =
      std::min_element(best.begin(), best.end(),
                       [](const PoseMode& a, const PoseMode& b) { return a.weight < b.weight; });
  if (lightest->weight < mode.weight) *lightest = mode;
}

Measurement headingOf(const PinkPercept& percept, Point2<Field> landmark, const Pose2& pose,
                      const GpsParams& params) {
  const double away = std::max(50.0, distance(landmark, pose.position));
  Measurement m;
  m.landmark = landmark;
  m.useHeading = true;
  m.heading = percept.heading;
  m.headingVariance = std::max(params.gates.headingVarianceFactor * percept.headingVariance,
                               maths::square(params.pinks.minSightSd.rad())) +
                      maths::square(params.pinks.mapSd / away);
  return m;
}

// What is left of it is worth asking a mode that knows its distance from the patch.
bool fits(const PinkPercept& percept, const PoseMode& mode, Point2<Field> landmark,
          const PinkParams& params) {
  return mayHangOnWall(percept.elevation, distance(mode.pose.position, landmark), params);
}

double area(const PinkPercept& percept) {
  return (percept.box.right - percept.box.left) * (percept.box.bottom - percept.box.top);
}

// Sightings in a row that no mode foretold mean that the robot is elsewhere.
void judge(double corrected, double copies, const GpsParams& params, GpsState& state) {
  const bool explained = corrected > params.modes.explainedShare * (copies + corrected);
  std::uint32_t& unexplained = state.pinks.unexplained;
  unexplained = explained ? 0 : unexplained + 1;
}

}  // namespace

PinkLandmarks knownPinks(const PinkState& state, const PinkParams& params) {
  PinkLandmarks known;
  for (const PinkLandmark& landmark : state.map)
    if (landmark.weight >= params.minWeight) known.push_back(landmark);
  return known;
}

bool updateByPink(const PinkPercept& percept, const GpsParams& params, GpsState& state) {
  if (!usable(percept)) {
    state.count(Refusal::pinkNotFinite);
    return false;
  }
  const PinkLandmarks known = knownPinks(state.pinks, params.pinks);
  if (known.empty()) return false;
  Modes best;
  double corrected = 0.0;
  double copies = 0.0;
  for (const PoseMode& mode : state.modes) {
    PoseMode copy = mode;
    copy.weight *= params.modes.noiseWeight;
    copies += copy.weight;
    offer(copy, best);
    for (const PinkLandmark& landmark : known) {
      if (!fits(percept, mode, landmark.position, params.pinks)) continue;
      PoseMode moved = mode;
      moved.weight /= static_cast<double>(known.size());
      update(moved, headingOf(percept, landmark.position, mode.pose, params),
             params.modes.determinant);
      corrected += moved.weight;
      offer(moved, best);
    }
  }
  judge(corrected, copies, params, state);
  state.modes = best;
  return true;
}

void updateByPatches(const FixedVector<PinkPercept, 8>& patches, const GpsParams& params,
                     GpsState& state) {
  FixedVector<PinkPercept, 8> sorted = patches;
  for (std::size_t i = 1; i < sorted.size(); ++i)
    for (std::size_t j = i; j > 0 && area(sorted[j - 1]) < area(sorted[j]); --j)
      std::swap(sorted[j - 1], sorted[j]);
  const std::size_t most = std::min<std::size_t>(sorted.size(), params.pinks.maxPatches);
  for (std::size_t i = 0; i < most; ++i)
    if (updateByPink(sorted[i], params, state)) tidy(params, state);
}

}  // namespace kelpie::gps
