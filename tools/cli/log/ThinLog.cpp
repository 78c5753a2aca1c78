// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/log/ThinLog.h"

#include <cstring>

#include "robot/core/log/LogTopics.h"
#include "tools/sim/world/Truth.h"
#include "vision/pixels/ClassPicture.h"

namespace kelpie::cli {
namespace {

constexpr unsigned kLeftOut = 52 - 12;  // binary digits of a number's fraction

double shortened(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  bits = bits >> kLeftOut << kLeftOut;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

// A limit that is no short number itself stays what it is.
template <class T>
void shorten(T& value, double min, double max) {
  if constexpr (std::is_same_v<T, double>) {
    const double shorter = shortened(value);
    if (shorter >= min && shorter <= max) value = shorter;
  } else if constexpr (std::is_same_v<T, Angle>) {
    const Angle shorter = Angle::rad(shortened(value.rad()));
    if (shorter.deg() >= min && shorter.deg() <= max) value = shorter;
  } else if constexpr (IsText<T>::value) {
    return;
  } else if constexpr (kIsSequence<T>) {
    for (auto& item : value) shorten(item, min, max);
  } else if constexpr (HasFields<T>::value) {
    forEachField(value, [](const auto& f, auto& member) { shorten(member, f.min, f.max); });
  }
}

template <class T>
void shorten(T& value) {
  forEachField(value, [](const auto& f, auto& member) { shorten(member, f.min, f.max); });
}

// What stands in whole frames only.
void leaveOut(FrameOutput& output) {
  const BallPercept ball = output.percepts.ball;
  output.percepts = {};
  output.percepts.ball = ball;
  WorldModel& world = output.world;
  world.modes.clear();
  world.second = {};
  world.obstacles = {};
  world.pinkMap.clear();
  world.message = {};
  world.counts = {};
}

void leaveOut(FrameInput& input) {
  const JointAngles joints = input.sensors.joints;
  input.sensors = {};
  input.sensors.joints = joints;
  input.headRate = {};
  input.light = {};
  input.lastCommand = {};  // it stands in the output of the frame before
  input.team.clear();
}

}  // namespace

ThinFrames::ThinFrames(const vision::VisionCalibration& calibration)
    : tables_(std::make_unique<vision::PixelTables>(calibration)) {}

void ThinFrames::writeWhole(const FrameInput& input, const CameraLight& light, LogWriter& out) {
  static_cast<FrameInput&>(*plane_) = input;
  plane_->light = {};  // the plane's own colours are those that the table was made for
  vision::ClassPlane plane{};
  tables_->follow(light);
  vision::classifyWhole(input.image, *tables_, plane);
  encodePlane(plane, plane_->plane);
  shorten(*plane_);
  out.write(kPlaneFrameTopic, input.time, *plane_);
}

void ThinFrames::writeRest(const FrameInput& input, LogWriter& out) {
  static_cast<FrameInput&>(*rest_) = input;
  leaveOut(*rest_);
  shorten(*rest_);
  out.write(kPictureFrameTopic, input.time, *rest_);
}

void ThinFrames::write(const FrameInput& input, const FrameOutput& output, LogWriter& out) {
  *output_ = output;
  if (input.frame % kPlaneEvery == 0) {
    writeWhole(input, output.percepts.light, out);
  } else {
    writeRest(input, out);
    leaveOut(*output_);
  }
  shorten(*output_);
  out.write(kFrameOutputTopic, input.time, *output_);
}

Expected<bool> ThinTruth::write(const LogMessage& message, LogWriter& out) {
  if (seen_++ % kTruthEvery != 0) return false;
  sim::TruthFrame truth;
  const Status read = decodeAs(message, truth);
  if (!read) return Error{read.error()};
  shorten(truth);
  out.write(message.topic(), message.time, truth);
  return true;
}

bool isThinned(const std::string& log) {
  auto reader = LogReader::open(log);
  if (!reader) return false;
  bool plane = false;
  bool picture = false;
  LogMessage message;
  for (std::uint32_t frames = 0; frames <= kPlaneEvery && reader->next(message);) {
    plane = plane || message.topic() == kPlaneFrameTopic;
    picture = picture || message.topic() == kPictureFrameTopic;
    frames += message.topic() == kFrameOutputTopic ? 1 : 0;
  }
  return plane && picture;
}

}  // namespace kelpie::cli
