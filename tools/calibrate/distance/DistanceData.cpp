// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/distance/DistanceData.h"

#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "robot/body/Camera.h"
#include "robot/body/FieldDescription.h"
#include "robot/core/Maths.h"
#include "tools/calibrate/Csv.h"
#include "tools/calibrate/SharedData.h"
#include "vision/VisionParams.h"

namespace kelpie::calibrate {
namespace {

constexpr double kBeaconHeight = 40.0;  // cm: whole beacons were measured
constexpr double kBeaconRadius = 5.0;   // its front is seen, the distance is to its axis
constexpr double kGoalHeight = 30.0;

struct DataFile {
  const char* name;
  bool seriesFirst;  // column 0 tells the series; else each row is one of its own
};

DataFile fileOf(SizedObject object) {
  switch (object) {
    case SizedObject::ball: return {"ball_radius.csv", true};
    case SizedObject::beacon: return {"beacon_height_lab.csv", true};
    default: return {"goal_height.csv", false};
  }
}

// Standing, head straight ahead, looking `pitch` up from level: the nod makes up for the lean of
// the body, the neck bends for what is lower.
CameraPose headAt(double pitch) {
  const Stance stance{10.0, Angle::deg(14.25), {}};
  JointAngles joints;
  const double up = stance.bodyTilt.rad() + pitch;
  joints[Joint::headNod] = Angle::rad(std::fmax(up, 0.0));
  joints[Joint::neckTilt] = Angle::rad(std::fmin(up, 0.0));
  return body::cameraPose(joints, stance);
}

// The camera that has a ball at this distance from the neck base in the middle of its image.
CameraPose headAtBall(double distance) {
  double pitch = 0.0;
  for (int round = 0; round < 20; ++round) {
    const CameraPose camera = headAt(pitch);
    const double drop = body::kBallRadius - camera.position.z;
    pitch = std::atan2(drop, std::fmax(distance - camera.position.y, 1.0));
  }
  return headAt(pitch);
}

void addPosture(SizedObject object, Measured& m) {
  m.ahead = headAt(0.0).position.y;
  if (object != SizedObject::ball) return;
  const CameraPose camera = headAtBall(m.distance);
  m.ahead = camera.position.y;
  const double way = m.distance - camera.position.y;
  m.level = way / std::hypot(way, body::kBallRadius - camera.position.z);
}

double ballDistance(const Measured& m, const Optics& optics) {
  const double half = 0.5 * (m.pixels - optics.edge);
  const double radius = half + std::sqrt(half * half + 0.5 * maths::square(optics.blur));
  const double tangent = std::fmax(radius, 0.5) / optics.focalLength;
  const double range = body::kBallRadius * std::sqrt(1.0 + tangent * tangent) / tangent;
  return m.ahead + range * m.level;
}

double landmarkDistance(const Measured& m, const Optics& optics, double height, double beyond) {
  const double pixels = std::fmax(m.pixels - optics.edge, 0.5);
  return m.ahead + optics.focalLength * height / pixels + beyond;
}

}  // namespace

Expected<Measurements> readMeasurements(SizedObject object) {
  return readMeasurements(object, sharedData() + "distance/");
}

Expected<Measurements> readMeasurements(SizedObject object, const std::string& folder) {
  const DataFile file = fileOf(object);
  const std::string path = folder + file.name;
  std::ifstream in(path);
  if (!in) return Error{path + ": cannot be opened (the measurements are no part of the project)"};
  Measurements rows;
  std::map<std::string, int> series;
  std::string line;
  std::getline(in, line);
  for (int number = 2; std::getline(in, line); ++number) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty()) continue;
    std::istringstream row(line);
    std::array<std::string, 4> cell;
    for (auto& c : cell) std::getline(row, c, ',');
    const auto next = static_cast<int>(file.seriesFirst ? series.size() : rows.size());
    const int own = file.seriesFirst ? series.emplace(cell[0], next).first->second : next;
    if (cell[3] == "1") continue;
    double pixels = 0.0;
    double centimetres = 0.0;
    if (!parseNumber(cell[1], pixels) || !parseNumber(cell[2], centimetres) || pixels <= 0.0 ||
        centimetres <= 0.0)
      return Error{path + ":" + std::to_string(number) +
                   ": a size and a distance above 0 expected"};
    rows.push_back({own, pixels, centimetres});
    addPosture(object, rows.back());
  }
  if (rows.empty()) return Error{path + ": holds no measurements"};
  return rows;
}

DistanceModel geometry(SizedObject object, const Optics& optics) {
  if (object == SizedObject::ball)
    return [optics](const Measured& m) { return ballDistance(m, optics); };
  if (object == SizedObject::beacon)
    return [optics](const Measured& m) {
      return landmarkDistance(m, optics, kBeaconHeight, kBeaconRadius);
    };
  const double depth = body::FieldDescription{}.goalDepth;
  return [optics, depth](const Measured& m) {
    return landmarkDistance(m, optics, kGoalHeight, -depth);
  };
}

DistanceModel hyperbola(double factor, double offset) {
  return [factor, offset](const Measured& m) { return factor / (m.pixels + offset); };
}

DistanceModel teamsFit(SizedObject object) {
  switch (object) {
    case SizedObject::ball: return hyperbola(1103.94, 0.847627);
    case SizedObject::beacon: return hyperbola(8995.2, 2.45167);
    default: return hyperbola(5433.4, 0.641);
  }
}

Misfit misfit(const Measurements& rows, const DistanceModel& model) {
  Misfit sum;
  for (const Measured& m : rows) {
    const double error = model(m) - m.distance;
    sum.rms += error * error;
    sum.rmsPercent += maths::square(100.0 * error / m.distance);
    sum.bias += error;
  }
  const auto n = static_cast<double>(rows.size());
  return {std::sqrt(sum.rms / n), std::sqrt(sum.rmsPercent / n), sum.bias / n};
}

}  // namespace kelpie::calibrate
