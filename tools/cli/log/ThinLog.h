// SPDX-License-Identifier: Apache-2.0
// What a log keeps of a frame when the logs of all robots of a match are kept: 0.75 KB of the 110
// that a whole frame has. One frame in fifteen is whole but for its image, of which there is the
// class plane (robot/core/types/PlaneFrame.h). Of the others there is what leads from frame to
// frame: joint angles, odometry, game, pose, ball, other robots, and the Command with its reasons;
// not what vision saw, the other hypotheses, the obstacle cells, other sensors and messages. All
// numbers keep 12 binary digits of their fraction (a place on the field is 0.1 cm off at most).
// Such a log can be read, shown and filmed; it does not replay.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "robot/agent/AgentConfig.h"
#include "robot/core/log/LogReader.h"
#include "robot/core/log/LogWriter.h"
#include "robot/core/types/FrameOutput.h"
#include "robot/core/types/PictureFrame.h"
#include "robot/core/types/PlaneFrame.h"
#include "vision/pixels/PixelTables.h"

namespace kelpie::cli {

constexpr std::uint32_t kPlaneEvery = 15;  // frames
constexpr std::uint32_t kTruthEvery = 5;   // of the world's

class ThinFrames {
 public:
  explicit ThinFrames(const vision::VisionCalibration& calibration);

  void write(const FrameInput& input, const FrameOutput& output, LogWriter& out);

 private:
  void writeWhole(const FrameInput& input, const CameraLight& light, LogWriter& out);
  void writeRest(const FrameInput& input, LogWriter& out);

  std::unique_ptr<vision::PixelTables> tables_;
  std::unique_ptr<PlaneFrame> plane_ = std::make_unique<PlaneFrame>();
  std::unique_ptr<PictureFrame> rest_ = std::make_unique<PictureFrame>();
  std::unique_ptr<FrameOutput> output_ = std::make_unique<FrameOutput>();
};

// The world's truth beside such frames: one in five, its numbers as short.
class ThinTruth {
 public:
  // Whether it is one of those that are written.
  Expected<bool> write(const LogMessage& message, LogWriter& out);

 private:
  std::uint32_t seen_ = 0;
};

// Whether the frames of a log are of this kind: only then there are planes and frames without any
// image side by side. No file and no log are not.
bool isThinned(const std::string& log);

}  // namespace kelpie::cli
