// SPDX-License-Identifier: Apache-2.0
#include "tests/data/record/RecordedVision.h"

#include <algorithm>
#include <cmath>

#include "robot/body/Camera.h"
#include "vision/Vision.h"
#include "vision/pixels/PlaneImage.h"

namespace kelpie::recorded {
namespace {

// How far vision may be from the truth. Of a goal what shows of it is measured, so that its middle
// may be half a mouth, 40 cm, from that of what shows.
struct Tolerance {
  double headingDeg;
  double share;  // of the distance
  double cm;     // or that much, if it is more
};

Tolerance toleranceOf(const SeenThing& thing) {
  if (thing.what == "ball") return {3.0, 0.15, 4.0};
  if (thing.what.find("beacon") != std::string::npos) return {3.0, 0.2, 15.0};
  if (thing.what.find("goal") != std::string::npos)
    return {std::max(8.0, Angle::rad(std::atan2(40.0, thing.distance)).deg()), 0.3, 30.0};
  return {10.0, 0.35, 25.0};  // a robot
}

constexpr double kRandomised = 2.0;         // times as far in a randomised world
constexpr double kRandomisedTurnDeg = 3.0;  // and that much more to the side, for a late image
constexpr double kElevationDeg = 3.0;       // of the ball

Status readImage(const Scene& scene, const std::string& folder, Image& image) {
  const std::string path = pictureFile(folder, scene);
  if (scene.frame) return readFrame(path, image);
  const auto plane = std::make_unique<vision::ClassPlane>();
  const Status read = readPlane(path, *plane);
  if (read) vision::imageOf(*plane, image);
  return read;
}

}  // namespace

RecordedVision::RecordedVision()
    : onFrames_(std::make_unique<vision::VisionState>()),
      onPlanes_(std::make_unique<vision::VisionState>(*vision::loadCalibration("nominal", "none"))),
      input_(std::make_unique<FrameInput>()) {}

Expected<Percepts> RecordedVision::look(const Scene& scene, const std::string& folder) {
  *input_ = scene.input;
  const Status read = readImage(scene, folder, input_->image);
  if (!read) return Error{read.error()};
  const BodyState body = body::step(*input_, {});
  return vision::step({*input_, body}, {}, scene.frame ? *onFrames_ : *onPlanes_);
}

std::vector<Found> foundIn(const Percepts& seen) {
  std::vector<Found> all;
  if (seen.ball.present)
    all.push_back({"ball", seen.ball.distance, seen.ball.heading, seen.ball.elevation});
  for (const LandmarkPercept& mark : seen.landmarks)
    all.push_back({nameOf(mark.kind), mark.distance, mark.heading, mark.elevation});
  for (const RobotPercept& robot : seen.robots)
    all.push_back({nameOf(robot.team), robot.distance, robot.heading, robot.elevation});
  return all;
}

bool isNear(const Found& found, const SeenThing& thing, bool randomised) {
  if (found.what != thing.what) return false;
  Tolerance tolerance = toleranceOf(thing);
  double elevationDeg = kElevationDeg;
  if (randomised) {
    elevationDeg = kRandomised * kElevationDeg + kRandomisedTurnDeg;
    tolerance = {kRandomised * tolerance.headingDeg + kRandomisedTurnDeg,
                 kRandomised * tolerance.share, kRandomised * tolerance.cm};
  }
  if (found.what == "ball" && (found.elevation - thing.elevation).abs().deg() > elevationDeg)
    return false;
  return (found.heading - thing.heading).abs().deg() <= tolerance.headingDeg &&
         std::fabs(found.distance - thing.distance) <=
             std::max(tolerance.cm, tolerance.share * thing.distance);
}

bool finds(const Percepts& seen, const SeenThing& thing, bool randomised) {
  const std::vector<Found> all = foundIn(seen);
  return std::any_of(all.begin(), all.end(),
                     [&](const Found& found) { return isNear(found, thing, randomised); });
}

}  // namespace kelpie::recorded
