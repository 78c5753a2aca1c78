// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/physics/RobotXml.h"

#include <fmt/format.h>

#include "robot/body/Ers7.h"
#include "robot/body/Legs.h"
#include "tools/sim/physics/Units.h"

namespace kelpie::sim {
namespace {

constexpr double kBeyondLimit =
    3.0;  // deg, of the hardware's stop over the soft limit (openr.md 5.6)
constexpr double kPawRadius = kCm * body::kPawRadius;
constexpr double kShinRadius = 0.012;
// The front cowl rolls on the carpet 25 mm behind the forearm's line (facts-2005 section 2.4).
// What the ball feels of a forearm (physics.md section 11).
constexpr double kForearmRadius = 0.018;

struct Vec {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

std::string text(const Vec& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

// Writes one robot's elements.
class Writer {
 public:
  Writer(std::size_t robot, const PhysicsParams& params)
      : prefix_(fmt::format("r{}_", robot)), bit_(robotBit(robot)), params_(params) {}

  std::string trunk() {
    open("trunk", {0.0, 0.0, 0.12});
    out_ += fmt::format("<freejoint name=\"{}free\"/>\n", prefix_);
    const MassParams& mass = params_.mass;
    inertial({0.0, -mass.trunkBehind, -0.01}, mass.trunk, {0.10, 0.20, 0.08});
    out_ += fmt::format("<site name=\"{}imu\" pos=\"0 -0.06 0\"/>\n", prefix_);
    // The chest is 48 mm ahead of the shoulder axis (physics.md section 10).
    box("trunk", {0.0, -0.065, -0.01}, {0.045, 0.085, 0.04});
    box("chest", {0.0, 0.014, -0.005}, {0.035, 0.034, 0.04});
    for (std::size_t i = 0; i < kLegCount; ++i) leg(static_cast<LegId>(i));
    head();
    close();
    return out_;
  }

 private:
  void open(const std::string& name, const Vec& at) {
    out_ += fmt::format("<body name=\"{}{}\" pos=\"{}\">\n", prefix_, name, text(at));
  }
  void close() { out_ += "</body>\n"; }
  void inertial(const Vec& at, double mass, const Vec& size) {
    out_ += fmt::format("<inertial pos=\"{}\" mass=\"{}\" diaginertia=\"{}\"/>\n", text(at), mass,
                        boxInertia(mass, size.x, size.y, size.z));
  }
  std::string touches(unsigned others) const {
    const ContactParams& contact = params_.contact;
    return fmt::format(
        "contype=\"{}\" conaffinity=\"{}\" friction=\"{} 0.005 0.0001\" condim=\"3\" "
        "solref=\"{} 1\"",
        bit_, others & ~bit_, contact.plastic, contact.time);
  }
  void box(const std::string& name, const Vec& at, const Vec& half) {
    out_ += fmt::format("<geom name=\"{}{}\" type=\"box\" pos=\"{}\" size=\"{}\" {}/>\n", prefix_,
                        name, text(at), text(half), touches(kAllBits));
  }
  void sphere(const std::string& name, const Vec& at, double radius) {
    out_ += fmt::format("<geom name=\"{}{}\" type=\"sphere\" pos=\"{}\" size=\"{}\" {}/>\n",
                        prefix_, name, text(at), radius, touches(kAllBits));
  }
  void capsule(const std::string& name, const Vec& from, const Vec& to, double radius,
               unsigned others = kAllBits) {
    out_ += fmt::format("<geom name=\"{}{}\" type=\"capsule\" fromto=\"{} {}\" size=\"{}\" {}/>\n",
                        prefix_, name, text(from), text(to), radius, touches(others));
  }
  void hinge(Joint joint, const Vec& axis) {
    const std::size_t j = index(joint);
    const Servo servo = servoOf(j, params_.servo);
    const body::JointRange range = body::kJointRanges[j];
    out_ += fmt::format(
        "<joint name=\"{}{}\" type=\"hinge\" axis=\"{}\" damping=\"{}\" armature=\"{}\" "
        "limited=\"true\" range=\"{} {}\"/>\n",
        prefix_, j, text(axis), servo.stall / servo.noLoad, params_.servo.armature,
        range.min - kBeyondLimit, range.max + kBeyondLimit);
  }

  void leg(LegId id) {
    const bool front = body::isFront(id);
    const bool right = id == LegId::rightFront || id == LegId::rightHind;
    const double side = right ? 1.0 : -1.0;
    const double ahead = front ? 1.0 : -1.0;
    const auto joint = [&](std::size_t n) { return static_cast<Joint>(firstJoint(id) + n); };
    const std::string name = fmt::format("{}", index(id));
    open("upper" + name,
         {side * 0.5 * kCm * body::kBodyWidth, front ? 0.0 : -kCm * body::kBodyLength, 0.0});
    hinge(joint(0), {1.0, 0.0, 0.0});
    hinge(joint(1), {0.0, -side, 0.0});
    const Vec knee{side * kCm * body::kKneeOut, ahead * kCm * body::kKneeForward,
                   -kCm * body::kUpperLeg};
    inertial({0.5 * knee.x, 0.5 * knee.y, 0.5 * knee.z}, params_.mass.upperLeg, {0.03, 0.03, 0.08});
    capsule("thigh" + name, {}, knee, 0.015);
    open("lower" + name, knee);
    hinge(joint(2), {ahead, 0.0, 0.0});
    lowerLeg(id, front, ahead);
    close();
    close();
  }

  void lowerLeg(LegId id, bool front, double ahead) {
    const std::string name = fmt::format("{}", index(id));
    const double length = kCm * (front ? body::kLowerLegFront : body::kLowerLegHind);
    inertial({0.0, 0.0, -0.5 * length}, params_.mass.lowerLeg, {0.025, 0.025, length});
    capsule("shin" + name, {}, {0.0, 0.0, -0.6 * length}, kShinRadius);
    sphere("paw" + name, {0.0, 0.0, kPawRadius - length}, kPawRadius);
    if (!front) return;
    constexpr double kBehind = kCm * body::kCowlBehind;
    capsule("cowl" + name, {0.0, -0.8 * ahead * kBehind, -kCm * body::kCowlBegins},
            {0.0, -ahead * kBehind, -kCm * body::kCowlEnds}, kCm * body::kCowlRadius);
    capsule("forearm" + name, {0.0, 0.0, -0.02}, {0.0, 0.0, -0.055}, kForearmRadius, kBallBit);
  }

  void head() {
    const MassParams& mass = params_.mass;
    open("neck", {0.0, -kCm * body::kNeckBehindShoulder, kCm * body::kNeckAboveShoulder});
    hinge(Joint::neckTilt, {1.0, 0.0, 0.0});
    const double neck = kCm * body::kNeckLength;
    inertial({0.0, 0.0, 0.5 * neck}, mass.neck, {0.03, 0.03, neck});
    capsule("neck", {}, {0.0, 0.0, 0.8 * neck}, 0.0117);
    open("head", {0.0, 0.0, neck});
    hinge(Joint::headPan, {0.0, 0.0, 1.0});
    hinge(Joint::headNod, {1.0, 0.0, 0.0});
    inertial({0.0, 0.03, 0.005}, mass.head, {0.07, 0.11, 0.07});
    sphere("skull", {0.0, 0.01, 0.01}, 0.033);
    capsule("chin", {0.0, 0.03, -0.006}, {0.0, kCm * body::kFaceLength - 0.02, -0.006}, 0.024);
    jaw(mass.jaw);
    close();
    close();
  }

  // 41 x 36 x 10 mm, its top 5 mm below a hinge 40 mm ahead of the nod axis and 17.5 mm below it
  // (physics.md section 10).
  void jaw(double mass) {
    open("jaw", {0.0, 0.040, -0.0175});
    hinge(Joint::mouth, {1.0, 0.0, 0.0});
    inertial({0.0, 0.02, -0.01}, mass, {0.036, 0.041, 0.01});
    box("jaw", {0.0, 0.0205, -0.010}, {0.018, 0.0205, 0.005});
    close();
  }

  std::string prefix_;
  unsigned bit_;
  const PhysicsParams& params_;
  std::string out_;
};

}  // namespace

std::string boxInertia(double mass, double x, double y, double z) {
  const double share = mass / 12.0;
  return fmt::format("{} {} {}", share * (y * y + z * z), share * (x * x + z * z),
                     share * (x * x + y * y));
}

Servo servoOf(std::size_t joint, const ServoParams& params) {
  switch (static_cast<Joint>(joint)) {
    case Joint::neckTilt: return params.neckTilt;
    case Joint::headPan: return params.headPan;
    case Joint::headNod: return params.headNod;
    case Joint::mouth: return params.mouth;
    default: break;
  }
  Servo servo = params.leg;
  if ((joint - index(Joint::leftFrontRotator)) % 3 == 1) servo.kp *= params.shoulderGain;
  return servo;
}

std::string robotXml(std::size_t robot, const PhysicsParams& params) {
  return Writer(robot, params).trunk();
}

std::string servosXml(std::size_t robot, const ServoParams& params) {
  std::string out;
  for (std::size_t j = 0; j < kServoCount; ++j) {
    const Servo servo = servoOf(j, params);
    out += fmt::format(
        "<general name=\"r{0}_{1}\" joint=\"r{0}_{1}\" gaintype=\"fixed\" biastype=\"affine\" "
        "gainprm=\"{2}\" biasprm=\"0 -{2} 0\" forcelimited=\"true\" forcerange=\"-{3} {3}\"/>\n",
        robot, j, servo.kp, servo.stall);
  }
  return out;
}

}  // namespace kelpie::sim
