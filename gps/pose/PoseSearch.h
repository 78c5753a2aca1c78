// SPDX-License-Identifier: Apache-2.0
// The search of the whole field for a lost pose (thesis 2004 section 4.1.4), spread over frames so
// that no frame is dropped: a few poses of a grid are tried in each, the best of distinct places
// are kept, and these are then refined, a few in each frame. How a pose is scored and refined is
// the caller's: lines of a standing robot's map, or lines and pinks of a survey. Finds nothing that
// lies farther from the grid than what the caller's score or refinement bridges.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "robot/core/FixedVector.h"
#include "robot/core/types/Geometry.h"

namespace kelpie::gps {

struct FoundPose {
  Pose2 pose;
  double score = 0.0;  // the higher the better
};
using FoundPoses = FixedVector<FoundPose, 32>;  // best first

struct PoseSearch {
  bool running = false;
  std::uint32_t tried = 0;    // of the grid
  std::uint32_t refined = 0;  // of the found
  FoundPoses found;
};

struct PoseGrid {
  double width = 0.0;  // cm, of the part of the field that is searched
  double length = 0.0;
  std::uint32_t columns = 1;
  std::uint32_t rows = 1;
  std::uint32_t turns = 1;

  std::uint32_t size() const { return columns * rows * turns; }
  // Headings fastest, so that the poses of one frame lie together.
  Pose2 at(std::uint32_t index) const {
    const std::uint32_t place = index / turns;
    const std::uint32_t column = place % columns;
    const std::uint32_t row = place / columns;
    return {{width * (column + 0.5) / columns, length * (row + 0.5) / rows},
            Angle::rad(2.0 * maths::kPi * (index % turns) / turns)};
  }
};

struct PoseSearchPace {
  std::uint32_t triedPerFrame = 1;
  std::uint32_t refinedPerFrame = 1;
  std::size_t kept = FoundPoses::kCapacity;
};

// Keeps the best pose of each place, `max` of them; `same(a, b)` tells whether two are one.
template <typename Same>
void keepDistinct(const FoundPose& pose, std::size_t max, const Same& same, FoundPoses& found) {
  if (found.size() >= max && pose.score <= found.back().score) return;
  for (const FoundPose& other : found)
    if (other.score >= pose.score && same(other.pose, pose.pose)) return;
  const auto worse = [&](const FoundPose& other) { return same(other.pose, pose.pose); };
  FoundPose* end = std::remove_if(found.begin(), found.end(), worse);
  found.resize(std::min(static_cast<std::size_t>(end - found.begin()), max - 1));
  std::size_t at = found.size();
  found.push_back(pose);
  for (; at > 0 && found[at - 1].score < pose.score; --at) found[at] = found[at - 1];
  found[at] = pose;
}

// One frame's share of the search; true when it has come to an end. The scene gives
//   std::optional<FoundPose> tried(const Pose2& start) const;
//   FoundPose refined(const FoundPose& found) const;
//   bool same(const Pose2& a, const Pose2& b) const;
template <typename Scene>
bool stepPoseSearch(const PoseGrid& grid, const PoseSearchPace& pace, const Scene& scene,
                    PoseSearch& search) {
  const auto same = [&scene](const Pose2& a, const Pose2& b) { return scene.same(a, b); };
  search.running = true;
  if (search.tried < grid.size()) {
    const std::uint32_t end = std::min(grid.size(), search.tried + pace.triedPerFrame);
    for (; search.tried < end; ++search.tried)
      if (const auto pose = scene.tried(grid.at(search.tried)))
        keepDistinct(*pose, pace.kept, same, search.found);
    return false;
  }
  if (search.refined < search.found.size()) {
    for (std::uint32_t i = 0; i < pace.refinedPerFrame && search.refined < search.found.size();
         ++i) {
      FoundPose& pose = search.found[search.refined++];
      pose = scene.refined(pose);
    }
    return false;
  }
  // Some have met, and their order is another.
  const FoundPoses refined = search.found;
  search.found.clear();
  for (const FoundPose& pose : refined) keepDistinct(pose, pace.kept, same, search.found);
  search.running = false;
  return true;
}

}  // namespace kelpie::gps
