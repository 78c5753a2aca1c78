// SPDX-License-Identifier: Apache-2.0
#include "tools/viewer/Frames.h"

#include <algorithm>
#include <cmath>

namespace kelpie::viewer {
namespace {

foxglove::Vector3 vector(double x, double y, double z) {
  foxglove::Vector3 v;
  v.set_x(x);
  v.set_y(y);
  v.set_z(z);
  return v;
}

foxglove::Quaternion quaternion(double x, double y, double z, double w) {
  foxglove::Quaternion q;
  q.set_x(x);
  q.set_y(y);
  q.set_z(z);
  q.set_w(w);
  return q;
}

foxglove::FrameTransform between(TimeUs time, const std::string& parent, const std::string& child) {
  foxglove::FrameTransform transform;
  *transform.mutable_timestamp() = stampOf(time);
  transform.set_parent_frame_id(parent);
  transform.set_child_frame_id(child);
  return transform;
}

}  // namespace

std::string robotName(TeamColour team, std::uint8_t player) {
  return (team == TeamColour::red ? "red" : "blue") + std::to_string(player);
}

std::string trueFrame(const std::string& robot) { return robot + "/true"; }
std::string believedFrame(const std::string& robot) { return robot + "/believed"; }
std::string cameraFrame(const std::string& robot) { return robot + "/camera"; }

foxglove::Vector3 inBody(const Point3<Robot>& p) {
  return vector(metres(p.y), metres(-p.x), metres(p.z));
}

foxglove::Vector3 inBody(const Point2<Robot>& p, double z) { return inBody({p.x, p.y, z}); }

foxglove::Vector3 inMap(const Point2<Field>& p, double z) {
  return vector(metres(p.x), metres(p.y), metres(z));
}

google::protobuf::Timestamp stampOf(TimeUs time) {
  constexpr std::int64_t kSecond = 1000000;
  google::protobuf::Timestamp stamp;
  stamp.set_seconds(time.us / kSecond);
  stamp.set_nanos(static_cast<std::int32_t>(time.us % kSecond * 1000));
  return stamp;
}

foxglove::Quaternion turned(Angle heading) {
  return quaternion(0.0, 0.0, std::sin(0.5 * heading.rad()), std::cos(0.5 * heading.rad()));
}

// The largest of the four squares is at least a quarter, so that nothing small is divided by.
foxglove::Quaternion rotationOf(const std::array<double, 9>& a) {
  const std::array<double, 4> squares = {1.0 + a[0] - a[4] - a[8], 1.0 - a[0] + a[4] - a[8],
                                         1.0 - a[0] - a[4] + a[8], 1.0 + a[0] + a[4] + a[8]};
  const auto largest = std::max_element(squares.begin(), squares.end()) - squares.begin();
  const double r = std::sqrt(squares[static_cast<std::size_t>(largest)]);
  const double s = 0.5 / r;
  switch (largest) {
    case 0: return quaternion(0.5 * r, s * (a[1] + a[3]), s * (a[2] + a[6]), s * (a[7] - a[5]));
    case 1: return quaternion(s * (a[1] + a[3]), 0.5 * r, s * (a[5] + a[7]), s * (a[2] - a[6]));
    case 2: return quaternion(s * (a[2] + a[6]), s * (a[5] + a[7]), 0.5 * r, s * (a[3] - a[1]));
    default: return quaternion(s * (a[7] - a[5]), s * (a[2] - a[6]), s * (a[3] - a[1]), 0.5 * r);
  }
}

std::array<double, 9> cameraAxesInBody(const CameraPose& camera) {
  const auto& a = camera.axes;
  return {a[3], a[4], a[5], -a[0], -a[1], -a[2], a[6], a[7], a[8]};
}

foxglove::Pose poseOf(const Pose2& pose) {
  foxglove::Pose result;
  *result.mutable_position() = inMap(pose.position);
  *result.mutable_orientation() = turned(pose.heading);
  return result;
}

foxglove::Pose poseAt(const foxglove::Vector3& position) {
  foxglove::Pose result;
  *result.mutable_position() = position;
  result.mutable_orientation()->set_w(1.0);
  return result;
}

foxglove::FrameTransform bodyTransform(TimeUs time, const std::string& frame, const Pose2& pose) {
  foxglove::FrameTransform transform = between(time, kMapFrame, frame);
  *transform.mutable_translation() = inMap(pose.position);
  *transform.mutable_rotation() = turned(pose.heading);
  return transform;
}

foxglove::FrameTransform cameraTransform(TimeUs time, const std::string& robot,
                                         const CameraPose& camera) {
  foxglove::FrameTransform transform = between(time, believedFrame(robot), cameraFrame(robot));
  *transform.mutable_translation() = inBody(camera.position);
  *transform.mutable_rotation() = rotationOf(cameraAxesInBody(camera));
  return transform;
}

}  // namespace kelpie::viewer
