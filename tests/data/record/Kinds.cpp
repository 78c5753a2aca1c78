// SPDX-License-Identifier: Apache-2.0
#include "tests/data/record/Kinds.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "tests/data/record/SceneFile.h"
#include "vision/pixels/ClassPicture.h"

namespace kelpie::recorded {
namespace {

using experiments::ObjectKind;
using experiments::TrueObject;
using experiments::ViewParams;

constexpr int kSpeck = 40;  // pixels: what shows less is no example of a cut or hidden thing

template <class Fits>
int count(const Candidate& c, ObjectKind kind, Fits&& fits) {
  return static_cast<int>(
      std::count_if(c.objects.begin(), c.objects.end(),
                    [&](const TrueObject& o) { return o.kind == kind && fits(o); }));
}

bool showsNothing(const Candidate& c) {
  return std::none_of(c.objects.begin(), c.objects.end(),
                      [](const TrueObject& o) { return o.inView; });
}

bool ballBetween(const Candidate& c, double nearest, double farthest) {
  return count(c, ObjectKind::ball, [&](const TrueObject& o) {
           return o.toSee && !o.cut && o.distance >= nearest && o.distance <= farthest;
         }) > 0;
}

bool showsLandmark(const Candidate& c, LandmarkKind mark, double farthest) {
  return std::any_of(c.objects.begin(), c.objects.end(), [&](const TrueObject& o) {
    return (o.kind == ObjectKind::goal || o.kind == ObjectKind::beacon) && o.landmark == mark &&
           o.toSee && !o.cut && o.distance <= farthest;
  });
}

bool showsRobot(const Candidate& c, TeamColour team) {
  return count(c, ObjectKind::robot, [&](const TrueObject& o) {
           return o.toSee && o.team == team && o.distance < 150.0;
         }) > 0;
}

bool isHidden(const TrueObject& o) {
  return o.pixels >= kSpeck && o.pixels >= 0.4 * o.pixelsAlone && o.pixels <= 0.8 * o.pixelsAlone;
}

// Of a ball at that distance, as a disc in the middle of the image.
double discPixels(double distance) {
  constexpr double kRadiusPx = 4.2 * 192.0;  // at 1 cm
  return maths::kPi * maths::square(kRadiusPx / distance);
}

bool ballIsCut(const Candidate& c) {
  return count(c, ObjectKind::ball, [](const TrueObject& o) {
           return o.cut && o.pixels >= kSpeck && o.pixels <= 0.8 * discPixels(o.distance);
         }) > 0;
}

bool ballIsHidden(const Candidate& c) {
  return count(c, ObjectKind::ball, [](const TrueObject& o) { return !o.cut && isHidden(o); }) > 0;
}

bool ballUnderTheChin(const Candidate& c) {
  return count(c, ObjectKind::ball,
               [](const TrueObject& o) { return o.distance < 17.0 && o.pixels > 8000; }) > 0;
}

bool goalIsCut(const Candidate& c) {
  return count(c, ObjectKind::goal, [](const TrueObject& o) { return o.cut && o.pixels > 1500; }) >
         0;
}

bool goalBehindRobot(const Candidate& c) {
  return count(c, ObjectKind::goal, [](const TrueObject& o) {
           return o.toSee && o.distance < 300.0 && isHidden(o);
         }) > 0;
}

bool beaconIsNear(const Candidate& c) {
  return count(c, ObjectKind::beacon,
               [](const TrueObject& o) { return o.pixels > 300 && o.distance < 120.0; }) > 0;
}

bool twoLandmarks(const Candidate& c) {
  const auto toSee = [](const TrueObject& o) { return o.toSee; };
  return count(c, ObjectKind::goal, toSee) + count(c, ObjectKind::beacon, toSee) >= 2;
}

bool isScrum(const Candidate& c) {
  return count(c, ObjectKind::robot,
               [](const TrueObject& o) { return o.pixels > 200 && o.distance < 170.0; }) >= 4;
}

bool onlyLines(const Candidate& c) {
  const Angle nod = c.view.input.sensors.joints[Joint::headNod];
  return showsNothing(c) && c.view.input.sensors.joints[Joint::neckTilt].deg() > -40.0 &&
         nod.deg() < 15.0;
}

bool onlyCarpet(const Candidate& c) {
  if (!showsNothing(c)) return false;
  const auto plane = std::make_unique<vision::ClassPlane>();
  vision::classifyWhole(c.view.input.image, vision::nominalCalibration(), *plane);
  const auto green = static_cast<std::uint8_t>(vision::ColourClass::green);
  return std::count(plane->begin(), plane->end(), green) >
         static_cast<std::ptrdiff_t>(kImagePixels * 98 / 100);
}

// Pixels that are neither grey nor the carpet's green.
int colouredPixels(const Image& image) {
  int coloured = 0;
  for (std::size_t i = 0; i < kImagePixels; ++i) {
    const int cr = image.cr[i] - 128;
    const int cb = image.cb[i] - 128;
    if (cr > -13 && std::abs(cr) + std::abs(cb) > 40) ++coloured;
  }
  return coloured;
}

bool onlySpectators(const Candidate& c) {
  return showsNothing(c) && colouredPixels(c.view.input.image) > 1500;
}

bool headTurnsFast(const Candidate& c) {
  constexpr double kFast = 1.8;  // rad/s
  return std::fabs(c.view.input.headRate.headPan) > kFast && ballBetween(c, 30.0, 150.0);
}

bool anything(const Candidate& c) {
  return std::any_of(c.objects.begin(), c.objects.end(),
                     [](const TrueObject& o) { return o.toSee; });
}

bool glossyRobot(const Candidate& c) {
  constexpr double kGlossy = 1.4;  // times as much of the edges as usual
  return showsRobot(c, TeamColour::red) &&
         std::any_of(c.view.robots.begin(), c.view.robots.end(),
                     [](const sim::RobotLook& look) { return look.uniform.gloss > kGlossy; });
}

template <LandmarkKind mark>
bool landmark(const Candidate& c) {
  return showsLandmark(c, mark, 350.0);
}

void asUsual(ViewParams& params) { static_cast<void>(params); }
void still(ViewParams& params) { params.headTurning = params.bodyTurning = 0.0; }
void ballClose(ViewParams& params) {
  still(params);
  params.nearestBall = 9.0;
  params.farthestBall = 17.0;
  params.maxRobots = 0;
}
void crowded(ViewParams& params) { params.maxRobots = 12; }
void bare(ViewParams& params) {
  params.ball = false;
  params.maxRobots = 0;
}
void turning(ViewParams& params) { params.headTurning = 1.0; }
void dark(ViewParams& params) {
  params.randomised.darkestCarpet = 0.6;
  params.randomised.brightestCarpet = 0.72;
}

}  // namespace

const std::vector<Kind>& kinds() {
  using K = LandmarkKind;
  static const std::vector<Kind> all = {
      {"ball_near",
       11,
       {1, 1},
       {0, 0},
       asUsual,
       [](auto& c) { return ballBetween(c, 20.0, 60.0); }},
      {"ball_at_two_metres",
       12,
       {1, 1},
       {0, 1},
       asUsual,
       [](auto& c) { return ballBetween(c, 170.0, 230.0); }},
      {"ball_far", 13, {1, 1}, {0, 0}, still, [](auto& c) { return ballBetween(c, 260.0, 350.0); }},
      {"ball_cut", 14, {2, 2}, {0, 0}, asUsual, ballIsCut},
      {"ball_half_hidden", 15, {2, 2}, {0, 0}, asUsual, ballIsHidden},
      {"ball_under_the_chin", 16, {2, 2}, {1, 0}, ballClose, ballUnderTheChin},
      {"beacon_blue_on_pink", 17, {1, 1}, {0, 0}, asUsual, landmark<K::beaconBlueOnPink>},
      {"beacon_pink_on_blue", 18, {1, 1}, {0, 0}, asUsual, landmark<K::beaconPinkOnBlue>},
      {"beacon_yellow_on_pink", 19, {1, 1}, {0, 0}, asUsual, landmark<K::beaconYellowOnPink>},
      {"beacon_pink_on_yellow", 20, {1, 1}, {0, 0}, asUsual, landmark<K::beaconPinkOnYellow>},
      {"beacon_near", 21, {1, 1}, {0, 0}, asUsual, beaconIsNear},
      {"goal_blue", 22, {1, 1}, {0, 0}, asUsual, landmark<K::goalBlue>},
      {"goal_yellow", 23, {1, 1}, {0, 0}, asUsual, landmark<K::goalYellow>},
      {"goal_cut", 24, {2, 2}, {1, 1}, asUsual, goalIsCut},
      {"goal_behind_robot", 25, {2, 2}, {0, 0}, crowded, goalBehindRobot},
      {"two_landmarks", 26, {1, 1}, {1, 0}, asUsual, twoLandmarks},
      {"robot_red",
       27,
       {1, 1},
       {0, 0},
       asUsual,
       [](auto& c) { return showsRobot(c, TeamColour::red); }},
      {"robot_blue",
       28,
       {1, 1},
       {0, 0},
       asUsual,
       [](auto& c) { return showsRobot(c, TeamColour::blue); }},
      {"scrum", 29, {2, 2}, {1, 1}, crowded, isScrum},
      {"only_lines", 30, {2, 2}, {1, 0}, bare, onlyLines},
      {"only_carpet", 35, {1, 1}, {0, 0}, bare, onlyCarpet},
      {"only_spectators", 31, {2, 2}, {0, 1}, bare, onlySpectators},
      {"head_turns_fast", 32, {1, 1}, {1, 0}, turning, headTurnsFast},
      {"dark_carpet", 33, {0, 2}, {0, 1}, dark, anything},
      {"glossy_robot", 34, {0, 2}, {0, 1}, asUsual, glossyRobot}};
  return all;
}

ViewParams paramsFor(const Kind& kind, std::uint64_t randomised) {
  ViewParams params;
  params.randomised = sim::randomisationParams(randomised, {});
  kind.draw(params);
  return params;
}

std::string nameOf(const TrueObject& object) {
  if (object.kind == ObjectKind::ball) return "ball";
  return object.kind == ObjectKind::robot ? nameOf(object.team) : nameOf(object.landmark);
}

}  // namespace kelpie::recorded
