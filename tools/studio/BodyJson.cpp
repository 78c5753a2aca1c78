// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/BodyJson.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "robot/body/Ers7.h"
#include "robot/body/FieldDescription.h"
#include "robot/body/Legs.h"
#include "robot/core/types/CameraModel.h"
#include "robot/core/types/FrameInput.h"

namespace kelpie::studio {
namespace {

using nlohmann::json;

struct Vec {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};
constexpr int kFixed = -1;

json listOf(const Vec& v) { return {v.x, v.y, v.z}; }

json shape(const char* kind, const char* paint, const Vec& centre, const Vec& size) {
  return {{"kind", kind}, {"paint", paint}, {"centre", listOf(centre)}, {"size", listOf(size)}};
}

struct Turn {
  int joint = kFixed;
  Vec axis = {1.0, 0.0, 0.0};
};

json link(const std::string& name, const std::string& parent, const Vec& origin, const Turn& turn,
          const std::vector<json>& shapes) {
  return {{"name", name},
          {"parent", parent},
          {"origin", listOf(origin)},
          {"axis", listOf(turn.axis)},
          {"joint", turn.joint},
          {"sign", 1},
          {"shapes", shapes}};
}

int number(Joint joint) { return static_cast<int>(index(joint)); }

json trunk() {
  constexpr double kWide = 9.0;
  constexpr double kHigh = 7.5;
  constexpr double kBeyond = 2.5;  // the shoulder axes, ahead and behind
  const double middle = -0.5 * body::kBodyLength;
  json shapes = {
      shape("box", "shell", {0.0, middle, -0.6}, {kWide, body::kBodyLength + 2.0 * kBeyond, kHigh}),
      shape("box", "uniform", {0.0, middle, 0.5 * kHigh - 0.4},
            {kWide - 2.0, body::kBodyLength - 1.0, 1.0})};
  for (const double side : {-1.0, 1.0})
    shapes.push_back(shape("box", "uniform", {side * 0.5 * kWide, middle, -0.2},
                           {0.6, body::kBodyLength - 3.0, kHigh - 2.5}));
  return link("trunk", "", {}, {}, shapes);
}

void addHead(json& links) {
  constexpr Vec kAcross{1.0, 0.0, 0.0};
  links.push_back(link(
      "neck", "trunk", {0.0, -body::kNeckBehindShoulder, body::kNeckAboveShoulder},
      {number(Joint::neckTilt), kAcross},
      {shape("box", "dark", {0.0, 0.0, 0.5 * body::kNeckLength}, {2.6, 2.6, body::kNeckLength})}));
  links.push_back(link("pan", "neck", {0.0, 0.0, body::kNeckLength},
                       {number(Joint::headPan), {0.0, 0.0, 1.0}}, {}));
  std::vector<json> head = {
      shape("sphere", "shell", {0.0, 0.8, 1.0}, {7.0, 7.4, 6.4}),
      shape("box", "shell", {0.0, 0.5 * body::kFaceLength, -0.6},
            {5.0, body::kFaceLength - 1.0, 4.6}),
      shape("box", "dark", {0.0, body::kFaceLength - 0.6, -0.4}, {4.2, 1.0, 3.2})};
  for (const double side : {-1.0, 1.0})
    head.push_back(shape("box", "dark", {side * 3.6, -0.6, 1.4}, {0.8, 2.0, 4.4}));
  links.push_back(link("head", "pan", {}, {number(Joint::headNod), kAcross}, head));
  // Hinge and size as physics.md section 10 has them.
  links.push_back(link("jaw", "head", {0.0, 4.0, -1.75}, {number(Joint::mouth), kAcross},
                       {shape("box", "dark", {0.0, 2.05, -1.0}, {3.6, 4.1, 1.0})}));
}

void addTail(json& links) {
  links.push_back(link("tail pan", "trunk", {0.0, -body::kBodyLength - 2.0, 2.0},
                       {number(Joint::tailPan), {0.0, 0.0, 1.0}}, {}));
  links.push_back(link("tail", "tail pan", {}, {number(Joint::tailTilt), {-1.0, 0.0, 0.0}},
                       {shape("box", "dark", {0.0, -2.5, 0.0}, {0.8, 5.0, 0.8})}));
}

// As the physical body's legs are turned (tools/sim/physics/RobotXml.cpp), and tested against
// footPosition().
void addLeg(LegId id, json& links) {
  const bool front = body::isFront(id);
  const bool right = id == LegId::rightFront || id == LegId::rightHind;
  const double side = right ? 1.0 : -1.0;
  const double ahead = front ? 1.0 : -1.0;
  const auto joint = [&](std::size_t n) { return static_cast<int>(firstJoint(id) + n); };
  const std::string name = std::string(right ? "right" : "left") + (front ? " front" : " hind");
  const double length = front ? body::kLowerLegFront : body::kLowerLegHind;
  const Vec shoulder{side * 0.5 * body::kBodyWidth, front ? 0.0 : -body::kBodyLength, 0.0};
  const Vec knee{side * body::kKneeOut, ahead * body::kKneeForward, -body::kUpperLeg};
  links.push_back(link(name + " rotator", "trunk", shoulder, {joint(0), {1.0, 0.0, 0.0}},
                       {shape("sphere", "dark", {-0.6 * side, 0.0, 0.0}, {4.2, 4.6, 4.6})}));
  links.push_back(
      link(name + " thigh", name + " rotator", {}, {joint(1), {0.0, -side, 0.0}},
           {shape("box", "uniform", {0.5 * knee.x + 0.3 * side, 0.5 * knee.y, 0.45 * knee.z},
                  {2.6, 4.0, body::kUpperLeg})}));
  links.push_back(
      link(name + " shin", name + " thigh", knee, {joint(2), {ahead, 0.0, 0.0}},
           {shape("box", "shell", {0.0, -0.4 * ahead, -0.4 * length}, {2.4, 3.0, 0.8 * length}),
            shape("sphere", "dark", {0.0, 0.0, body::kPawRadius - length},
                  {2.0 * body::kPawRadius, 2.0 * body::kPawRadius, 2.0 * body::kPawRadius})}));
}

}  // namespace

std::string bodyJson() {
  json links = json::array({trunk()});
  addHead(links);
  addTail(links);
  for (std::size_t i = 0; i < kLegCount; ++i) addLeg(static_cast<LegId>(i), links);
  const Lens lens;
  const auto opening = [&lens](std::size_t pixels) {
    return 2.0 * std::atan(0.5 * static_cast<double>(pixels) / lens.focalLength);
  };
  const json camera = {{"link", "head"},
                       {"origin", listOf({0.0, body::kFaceLength, -body::kCameraDrop})},
                       {"opening_rad", {opening(kImageWidth), opening(kImageHeight)}}};
  return json({{"links", links}, {"camera", camera}, {"ball_radius", body::kBallRadius}}).dump();
}

}  // namespace kelpie::studio
