// SPDX-License-Identifier: Apache-2.0
// Vision on a recorded scene, as the camera loop calls it, and whether it found what a person sees
// there. A class plane is seen as in a compressed log (vision/pixels/PlaneImage.h): noise and
// shading are gone, and with them places between pixels.
#pragma once

#include <memory>

#include "robot/core/types/Percepts.h"
#include "tests/data/record/SceneFile.h"
#include "vision/VisionState.h"

namespace kelpie::recorded {

class RecordedVision {
 public:
  RecordedVision();

  // Reads the scene's picture in that folder. An error says what is wrong with it.
  Expected<Percepts> look(const Scene& scene, const std::string& folder);

 private:
  std::unique_ptr<vision::VisionState> onFrames_;
  std::unique_ptr<vision::VisionState> onPlanes_;
  std::unique_ptr<FrameInput> input_;
};

// A percept in the words and numbers of a scene.
struct Found {
  std::string what;
  double distance = 0.0;  // cm
  Angle heading;
  Angle elevation;
};
std::vector<Found> foundIn(const Percepts& seen);

// Whether it is that thing, as near as it should be. In a randomised world the body leans and the
// image is late in a way that the robot does not know of.
bool isNear(const Found& found, const SeenThing& thing, bool randomised);
bool finds(const Percepts& seen, const SeenThing& thing, bool randomised);

}  // namespace kelpie::recorded
