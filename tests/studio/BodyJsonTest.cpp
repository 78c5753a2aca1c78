// SPDX-License-Identifier: Apache-2.0
// The body as a page gets it stands as the robot's own mathematics has it.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

#include "robot/body/Camera.h"
#include "robot/body/Ers7.h"
#include "robot/body/FieldDescription.h"
#include "robot/body/Legs.h"
#include "tools/studio/BodyJson.h"

namespace kelpie::studio {
namespace {

using nlohmann::json;
using Vec = std::array<double, 3>;
using Turn = std::array<Vec, 3>;  // rows
constexpr int kDraws = 200;

Vec vecOf(const json& list) { return {list[0], list[1], list[2]}; }

Vec turned(const Turn& m, const Vec& v) {
  Vec out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return out;
}

Turn product(const Turn& a, const Turn& b) {
  Turn out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) out[i][j] += a[i][k] * b[k][j];
  return out;
}

Vec sum(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

// About an axis of length one (Rodrigues).
Turn turnAbout(const Vec& u, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), d = 1.0 - c;
  return {{{c + u[0] * u[0] * d, u[0] * u[1] * d - u[2] * s, u[0] * u[2] * d + u[1] * s},
           {u[1] * u[0] * d + u[2] * s, c + u[1] * u[1] * d, u[1] * u[2] * d - u[0] * s},
           {u[2] * u[0] * d - u[1] * s, u[2] * u[1] * d + u[0] * s, c + u[2] * u[2] * d}}};
}

struct Frame {
  Turn turn;
  Vec origin;
};

class Body {
 public:
  Body() : body_(json::parse(bodyJson())) {
    for (const json& link : body_.at("links")) byName_[link.at("name")] = link;
  }
  const json& whole() const { return body_; }
  const std::map<std::string, json>& links() const { return byName_; }

  Frame frameOf(const std::string& name, const JointAngles& joints) const {
    const json& link = byName_.at(name);
    const std::string parent = link.at("parent");
    Frame frame{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {0, 0, 0}};
    if (!parent.empty()) frame = frameOf(parent, joints);
    const Vec origin = sum(frame.origin, turned(frame.turn, vecOf(link.at("origin"))));
    const int joint = link.at("joint");
    if (joint < 0) return {frame.turn, origin};
    const double angle =
        link.at("sign").get<double>() * joints.angle[static_cast<std::size_t>(joint)].rad();
    return {product(frame.turn, turnAbout(vecOf(link.at("axis")), angle)), origin};
  }
  Vec placeOf(const std::string& name, const Vec& point, const JointAngles& joints) const {
    const Frame frame = frameOf(name, joints);
    return sum(frame.origin, turned(frame.turn, point));
  }

 private:
  json body_;
  std::map<std::string, json> byName_;
};

JointAngles drawn(std::mt19937_64& random) {
  JointAngles joints;
  for (std::size_t i = 0; i < kJointCount; ++i) {
    const auto& range = body::kJointRanges[i];
    std::uniform_real_distribution<double> angle(range.min, range.max);
    joints.angle[i] = Angle::deg(angle(random));
  }
  return joints;
}

const char* const kLegs[kLegCount] = {"left front", "left hind", "right front", "right hind"};

TEST(BodyJson, FeetAreWhereTheLegsMathematicsHasThem) {
  const Body robot;
  std::mt19937_64 random(2005);
  for (int i = 0; i < kDraws; ++i) {
    const JointAngles joints = drawn(random);
    for (std::size_t leg = 0; leg < kLegCount; ++leg) {
      const auto id = static_cast<LegId>(leg);
      const auto foot = body::footPosition(id, body::legAngles(joints, id));
      const double length = body::isFront(id) ? body::kLowerLegFront : body::kLowerLegHind;
      const Vec drawnFoot =
          robot.placeOf(std::string(kLegs[leg]) + " shin", {0.0, 0.0, -length}, joints);
      EXPECT_NEAR(drawnFoot[0], foot.x, 1e-9) << kLegs[leg];
      EXPECT_NEAR(drawnFoot[1], foot.y, 1e-9) << kLegs[leg];
      EXPECT_NEAR(drawnFoot[2], foot.z, 1e-9) << kLegs[leg];
    }
  }
}

// The paw's sphere touches the tip of the lower leg.
TEST(BodyJson, ThePawsThatAreDrawnEndWhereTheFeetAre) {
  const Body robot;
  for (const char* leg : kLegs) {
    const json& shapes = robot.links().at(std::string(leg) + " shin").at("shapes");
    const json& paw = shapes.back();
    const bool front = std::string(leg).find("front") != std::string::npos;
    EXPECT_EQ(paw.at("kind"), "sphere");
    EXPECT_NEAR(vecOf(paw.at("centre"))[2] - 0.5 * vecOf(paw.at("size"))[2],
                front ? -body::kLowerLegFront : -body::kLowerLegHind, 1e-9);
  }
}

// Of a body that does not lean, in the frame whose origin is on the ground below the neck.
Vec fromTorso(const Vec& v, const Stance& stance) {
  return sum(v, {0.0, body::kNeckBehindShoulder, stance.shoulderHeight});
}

TEST(BodyJson, TheCameraIsWhereTheCamerasMathematicsHasIt) {
  const Body robot;
  const json& camera = robot.whole().at("camera");
  std::mt19937_64 random(2006);
  for (int i = 0; i < kDraws; ++i) {
    const JointAngles joints = drawn(random);
    Stance stance;
    stance.shoulderHeight = 10.0;
    const CameraPose pose = body::cameraPose(joints, stance);
    const Frame head = robot.frameOf(camera.at("link"), joints);
    const Vec eye =
        fromTorso(sum(head.origin, turned(head.turn, vecOf(camera.at("origin")))), stance);
    EXPECT_NEAR(eye[0], pose.position.x, 1e-9);
    EXPECT_NEAR(eye[1], pose.position.y, 1e-9);
    EXPECT_NEAR(eye[2], pose.position.z, 1e-9);
    // It looks along the head's y axis; its images' rows go to the right, columns down.
    const Vec right = turned(head.turn, {1, 0, 0});
    const Vec down = turned(head.turn, {0, 0, -1});
    const Vec ahead = turned(head.turn, {0, 1, 0});
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(right[k], pose.axes[3 * k], 1e-9);
      EXPECT_NEAR(down[k], pose.axes[3 * k + 1], 1e-9);
      EXPECT_NEAR(ahead[k], pose.axes[3 * k + 2], 1e-9);
    }
  }
}

TEST(BodyJson, EveryLinkHangsOnAnotherUpToTheTrunk) {
  const Body robot;
  std::set<int> joints;
  for (const auto& [name, link] : robot.links()) {
    std::string at = name;
    for (int i = 0; i < 10 && at != "trunk"; ++i) at = robot.links().at(at).at("parent");
    EXPECT_EQ(at, "trunk") << name;
    const Vec axis = vecOf(link.at("axis"));
    EXPECT_NEAR(std::hypot(axis[0], axis[1], axis[2]), 1.0, 1e-12) << name;
    const int joint = link.at("joint");
    EXPECT_LT(joint, static_cast<int>(kJointCount));
    EXPECT_TRUE(joint < 0 || joints.insert(joint).second) << name;
  }
  EXPECT_EQ(joints.size(), kJointCount);
  EXPECT_EQ(robot.links().size(), robot.whole().at("links").size());
}

TEST(BodyJson, PositiveAnglesTurnAsTheJointsAreDefined) {
  const Body robot;
  JointAngles none, turnedJoints;
  const auto moved = [&](const char* link, const Vec& point, Joint joint, double degrees) {
    turnedJoints = none;
    turnedJoints[joint] = Angle::deg(degrees);
    const Vec a = robot.placeOf(link, point, none);
    const Vec b = robot.placeOf(link, point, turnedJoints);
    return Vec{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  };
  EXPECT_GT(moved("head", {0, 8, 0}, Joint::neckTilt, 10)[2], 0.0);
  EXPECT_LT(moved("head", {0, 8, 0}, Joint::headPan, 10)[0], 0.0);  // to the left
  EXPECT_GT(moved("head", {0, 8, 0}, Joint::headNod, 10)[2], 0.0);
  EXPECT_LT(moved("jaw", {0, 4, 0}, Joint::mouth, -20)[2], 0.0);  // it opens
  EXPECT_GT(moved("tail", {0, -5, 0}, Joint::tailTilt, 10)[2], 0.0);
}

TEST(BodyJson, TheCamerasOpeningIsTheLenss) {
  const Body robot;
  const json& opening = robot.whole().at("camera").at("opening_rad");
  EXPECT_NEAR(opening[0].get<double>() * 180.0 / M_PI, 56.9, 0.2);
  EXPECT_NEAR(opening[1].get<double>() * 180.0 / M_PI, 45.2, 0.2);
  EXPECT_EQ(robot.whole().at("ball_radius"), body::kBallRadius);
}

}  // namespace
}  // namespace kelpie::studio
