// SPDX-License-Identifier: Apache-2.0
// Places and directions as the viewers have them: metres, and quaternions. Their frames are
//
//   map             the red team's field: origin and axes as those of Field, z up
//   red2/believed   the body of a robot where it believes to be: origin as that of Robot, but x
//                   ahead, y to the left, since viewers draw a pose as an arrow along its x axis
//   red2/true       the same where it really is
//   red2/camera     as Camera; a child of red2/believed
//
// (robot/core/types/Geometry.h says the frames behind them.)
#pragma once

#include <array>
#include <string>

#include "foxglove/Frames.pb.h"
#include "robot/body/FieldDescription.h"
#include "robot/core/Time.h"
#include "robot/core/types/Percepts.h"

namespace kelpie::viewer {

constexpr const char* kMapFrame = "map";

std::string robotName(TeamColour team, std::uint8_t player);  // "red2"
std::string trueFrame(const std::string& robot);
std::string believedFrame(const std::string& robot);
std::string cameraFrame(const std::string& robot);

constexpr double metres(double cm) { return 0.01 * cm; }
// What is given in the frame Robot, in the frame of the body.
foxglove::Vector3 inBody(const Point3<Robot>& p);
foxglove::Vector3 inBody(const Point2<Robot>& p, double z = 0.0);
foxglove::Vector3 inMap(const Point2<Field>& p, double z = 0.0);

google::protobuf::Timestamp stampOf(TimeUs time);

// Turned so far about z.
foxglove::Quaternion turned(Angle heading);
// The rotation whose columns these axes are, row by row, each of length one and square to the
// others.
foxglove::Quaternion rotationOf(const std::array<double, 9>& axes);
// Columns are the camera's axes in the body's frame.
std::array<double, 9> cameraAxesInBody(const CameraPose& camera);
foxglove::Pose poseOf(const Pose2& pose);
foxglove::Pose poseAt(const foxglove::Vector3& position);

foxglove::FrameTransform bodyTransform(TimeUs time, const std::string& frame, const Pose2& pose);
foxglove::FrameTransform cameraTransform(TimeUs time, const std::string& robot,
                                         const CameraPose& camera);

// From a team's own field to the red team's.
class MapFrame {
 public:
  MapFrame(const body::FieldDescription& field, TeamColour team)
      : width_(field.width), length_(field.length), turned_(team == TeamColour::blue) {}

  Point2<Field> point(Point2<Field> p) const {
    return turned_ ? Point2<Field>{width_ - p.x, length_ - p.y} : p;
  }
  Point2<Field> direction(Point2<Field> p) const { return turned_ ? p * -1.0 : p; }
  Pose2 pose(const Pose2& p) const {
    return {point(p.position), turned_ ? p.heading + Angle::deg(180.0) : p.heading};
  }

 private:
  double width_;
  double length_;
  bool turned_;
};

}  // namespace kelpie::viewer
