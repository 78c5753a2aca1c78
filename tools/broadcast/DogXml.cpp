// SPDX-License-Identifier: Apache-2.0
#include "tools/broadcast/DogXml.h"

#include <fmt/format.h>

#include "robot/body/Ers7.h"
#include "robot/body/Legs.h"
#include "tools/broadcast/Player.h"

namespace kelpie::broadcast {
namespace {

constexpr double kCm = 0.01;  // m

struct Vec {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

std::string text(const Vec& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

// Writes the elements of one robot, in the torso's axes: right, ahead, up.
class Writer {
 public:
  Writer(TeamColour team, int player)
      : name_(slotName(team, player)), uniform_(team == TeamColour::red ? "red" : "blue") {}

  std::string all() {
    out_ +=
        fmt::format("<body name=\"{0}\" pos=\"0 0 -9\">\n<freejoint name=\"{0}_free\"/>\n", name_);
    trunk();
    for (std::size_t i = 0; i < kLegCount; ++i) leg(static_cast<LegId>(i));
    head();
    return out_ + "</body>\n";
  }

 private:
  void open(const Vec& at) { out_ += fmt::format("<body pos=\"{}\">\n", text(at)); }
  void close() { out_ += "</body>\n"; }
  void hinge(Joint joint, const Vec& axis) {
    out_ += fmt::format("<joint name=\"{}_{}\" type=\"hinge\" axis=\"{}\"/>\n", name_, index(joint),
                        text(axis));
  }
  void shape(const char* type, const Vec& at, const Vec& half, const std::string& material,
             const Vec& euler = {}) {
    out_ += fmt::format("<geom type=\"{}\" pos=\"{}\" size=\"{}\" euler=\"{}\" material=\"{}\"/>\n",
                        type, text(at), text(half), text(euler), material);
  }
  void bar(const Vec& from, const Vec& to, double radius, const std::string& material) {
    out_ += fmt::format("<geom type=\"capsule\" fromto=\"{} {}\" size=\"{}\" material=\"{}\"/>\n",
                        text(from), text(to), radius, material);
  }
  void ball(const Vec& at, double radius, const std::string& material) {
    shape("sphere", at, {radius, 0.0, 0.0}, material);
  }

  void trunk() {
    shape("ellipsoid", {0.0, 0.008, -0.004}, {0.040, 0.050, 0.043}, "shell");   // chest
    shape("ellipsoid", {0.0, -0.065, 0.004}, {0.046, 0.110, 0.040}, "shell");   // back
    shape("box", {0.0, -0.065, -0.018}, {0.030, 0.075, 0.022}, "joint");        // belly
    shape("ellipsoid", {0.0, -0.065, 0.016}, {0.049, 0.080, 0.036}, uniform_);  // uniform
    shape("box", {0.0, 0.046, -0.006}, {0.018, 0.010, 0.020}, "joint");         // chest light
    bar({0.0, -0.165, 0.020}, {0.0, -0.190, 0.052}, 0.006, "joint");            // tail
    ball({0.0, -0.192, 0.056}, 0.008, "shell");
  }

  void leg(LegId id) {
    const bool front = body::isFront(id);
    const bool right = id == LegId::rightFront || id == LegId::rightHind;
    const double side = right ? 1.0 : -1.0;
    const double ahead = front ? 1.0 : -1.0;
    const auto joint = [&](std::size_t n) { return static_cast<Joint>(firstJoint(id) + n); };
    open({side * 0.5 * kCm * body::kBodyWidth, front ? 0.0 : -kCm * body::kBodyLength, 0.0});
    hinge(joint(0), {1.0, 0.0, 0.0});
    hinge(joint(1), {0.0, -side, 0.0});
    const Vec knee{side * kCm * body::kKneeOut, ahead * kCm * body::kKneeForward,
                   -kCm * body::kUpperLeg};
    bar({-side * 0.025, 0.0, 0.0}, {-side * 0.004, 0.0, 0.0}, 0.019, "joint");
    shape("ellipsoid", {side * 0.003, 0.0, -0.004}, {0.019, 0.028, 0.031}, uniform_);
    bar({0.0, 0.0, -0.02}, {0.85 * knee.x, 0.85 * knee.y, 0.85 * knee.z}, 0.0155, "shell");
    ball(knee, 0.0135, "joint");
    open(knee);
    hinge(joint(2), {ahead, 0.0, 0.0});
    lowerLeg(front, ahead);
    close();
    close();
  }

  void lowerLeg(bool front, double ahead) {
    const double length = kCm * (front ? body::kLowerLegFront : body::kLowerLegHind);
    const double paw = 0.013;
    bar({0.0, -0.005 * ahead, -0.010}, {0.0, -0.002 * ahead, -0.55 * length}, 0.0150, "shell");
    bar({0.0, 0.0, -0.5 * length}, {0.0, 0.0, paw - length}, 0.0095, "joint");
    shape("ellipsoid", {0.0, 0.004, paw - length}, {0.014, 0.018, paw}, "paw");
    if (front) shape("ellipsoid", {0.0, -0.011, -0.030}, {0.013, 0.014, 0.024}, "shell");  // cowl
  }

  void head() {
    const double neck = kCm * body::kNeckLength;
    open({0.0, -kCm * body::kNeckBehindShoulder, kCm * body::kNeckAboveShoulder});
    hinge(Joint::neckTilt, {1.0, 0.0, 0.0});
    bar({}, {0.0, 0.0, 0.8 * neck}, 0.013, "joint");
    shape("ellipsoid", {0.0, 0.0, 0.3 * neck}, {0.020, 0.020, 0.022}, "shell");
    open({0.0, 0.0, neck});
    hinge(Joint::headPan, {0.0, 0.0, 1.0});
    hinge(Joint::headNod, {1.0, 0.0, 0.0});
    shape("ellipsoid", {0.0, 0.020, 0.012}, {0.041, 0.052, 0.036}, "shell");
    shape("ellipsoid", {0.0, 0.050, 0.000}, {0.030, 0.034, 0.026}, "shell");
    shape("ellipsoid", {0.0, 0.060, 0.007}, {0.027, 0.026, 0.018}, "visor");
    shape("ellipsoid", {0.0, 0.000, 0.034}, {0.026, 0.030, 0.016}, uniform_);
    ball({0.0, 0.082, -0.004}, 0.006, "visor");  // nose
    for (const double side : {-1.0, 1.0})        // ears
      shape("ellipsoid", {side * 0.043, 0.000, 0.004}, {0.007, 0.016, 0.030}, "ear",
            {0.0, side * -12.0, 0.0});
    open({0.0, 0.040, -0.0175});
    hinge(Joint::mouth, {1.0, 0.0, 0.0});
    shape("ellipsoid", {0.0, 0.018, -0.006}, {0.018, 0.024, 0.008}, "shell");
    close();
    close();
    close();
  }

  std::string name_;
  std::string uniform_;
  std::string out_;
};

}  // namespace

std::string dogXml(TeamColour team, int player) { return Writer(team, player).all(); }

}  // namespace kelpie::broadcast
