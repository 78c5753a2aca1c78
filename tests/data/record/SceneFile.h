// SPDX-License-Identifier: Apache-2.0
// The recorded scenes of tests/data: what camera and body delivered, and what a person sees in the
// picture. A class plane is kept as a PNG file in the colours that viewers draw the classes in, a
// frame as one grey PNG file: Y, below it Cr, below that Cb. scenes.toml has the rest. Of the body
// only what vision needs is kept: no frame here can be replayed by a whole robot.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/ObjectPercepts.h"
#include "vision/pixels/ClassMemory.h"

namespace kelpie::recorded {

struct SeenThing {
  std::string what;       // "ball", "blue goal", "pink on blue beacon", "red robot"
  double distance = 0.0;  // cm on the ground, from the robot frame's origin
  Angle heading;
  Angle elevation;         // of the ball only
  bool cut = false;        // by the image's border
  bool hidden = false;     // a fifth of it or more, by something before it
  bool nameable = false;   // enough of it shows that a person names it at once, and vision should
  bool foundOnce = false;  // vision found it when the scene was recorded
};

struct Scene {
  std::string name;    // of its file too, without the ending
  bool frame = false;  // a frame, or else a class plane
  bool randomised = false;
  FrameInput input;  // no image of a class plane
  std::vector<SeenThing> things;
};

const char* nameOf(LandmarkKind mark);
const char* nameOf(TeamColour robot);

// How a test names it.
inline void PrintTo(const Scene& scene, std::ostream* out) { *out << scene.name; }

// What is wrong with the file, with its line; every scene needs every number.
Expected<std::vector<Scene>> readScenes(const std::string& folder);
Status writeScenes(const std::string& folder, const std::vector<Scene>& scenes);

std::string pictureFile(const std::string& folder, const Scene& scene);
Status readPlane(const std::string& path, vision::ClassPlane& plane);
Status writePlane(const std::string& path, const vision::ClassPlane& plane);
Status readFrame(const std::string& path, Image& image);
Status writeFrame(const std::string& path, const Image& image);

}  // namespace kelpie::recorded
