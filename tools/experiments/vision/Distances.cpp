// SPDX-License-Identifier: Apache-2.0
// Vision's distance from a size in the image against what was measured on real robots, beside the
// team's fits: as vision stands, and calibrated: one focal length for all, an edge for each object
// and a blur for the ball chosen on these measurements as the team chose its two constants. Both
// are also measured on series that their constants were not chosen on ("unseen"): a fit of noisy
// sizes flatters itself.
#include <cmath>

#include "robot/core/Maths.h"
#include "tools/calibrate/distance/DistanceData.h"
#include "tools/experiments/harness/Experiment.h"

namespace kelpie::experiments {
namespace {

using calibrate::DistanceModel;
using calibrate::geometry;
using calibrate::hyperbola;
using calibrate::Measured;
using calibrate::Measurements;
using calibrate::Misfit;
using calibrate::misfit;
using calibrate::readMeasurements;
using calibrate::SizedObject;
using calibrate::teamsFit;

using Maker = std::function<DistanceModel(double, double)>;

// A family of models with two constants, and where to look for them.
struct Family {
  Maker make;
  double firstLow = 0.0;
  double firstHigh = 0.0;
  double secondLow = 0.0;
  double secondHigh = 0.0;
};

struct Constants {
  double first = 0.0;
  double second = 0.0;
  double rms = 1e9;  // cm
};

// Edge and blur; blur only where the outline is round.
Family opticsOf(SizedObject object, double focalLength) {
  const double maxBlur = object == SizedObject::ball ? 4.0 : 0.0;
  return {[=](double edge, double blur) {
            return geometry(object, {focalLength, edge, blur});
          },
          -4.0, 4.0, 0.0, maxBlur};
}

Family hyperbolas(SizedObject object) {
  const double middle = object == SizedObject::ball     ? 1104.0
                        : object == SizedObject::beacon ? 8995.0
                                                        : 5433.0;
  return {hyperbola, 0.8 * middle, 1.2 * middle, -3.0, 8.0};
}

// The best of 25 x 25 places, then again in a tenth of the area round it.
Constants fitted(const Measurements& rows, Family family) {
  constexpr int kPlaces = 25;
  constexpr int kRounds = 5;
  Constants best;
  for (int round = 0; round < kRounds; ++round) {
    const double firstStep = (family.firstHigh - family.firstLow) / (kPlaces - 1);
    const double secondStep = (family.secondHigh - family.secondLow) / (kPlaces - 1);
    for (int i = 0; i < kPlaces * kPlaces; ++i) {
      const double first = family.firstLow + firstStep * (i % kPlaces);
      const int row = i / kPlaces;
      const double second = family.secondLow + secondStep * row;
      const double rms = misfit(rows, family.make(first, second)).rms;
      if (rms < best.rms) best = {first, second, rms};
    }
    family.firstLow = best.first - 2.0 * firstStep;
    family.firstHigh = best.first + 2.0 * firstStep;
    family.secondLow = best.second - 2.0 * secondStep;
    family.secondHigh = best.second + 2.0 * secondStep;
  }
  return best;
}

// Each series compared with constants chosen on all the others; cm.
double unseenRms(const Measurements& rows, const Family& family) {
  double sum = 0.0;
  std::size_t compared = 0;
  for (int series = 0; compared < rows.size(); ++series) {
    Measurements own;
    Measurements others;
    for (const Measured& m : rows) (m.series == series ? own : others).push_back(m);
    if (own.empty()) continue;
    const Constants chosen = fitted(others, family);
    const double rms = misfit(own, family.make(chosen.first, chosen.second)).rms;
    sum += rms * rms * static_cast<double>(own.size());
    compared += own.size();
  }
  return std::sqrt(sum / static_cast<double>(rows.size()));
}

struct Object {
  const char* name;
  SizedObject object;
  Measurements rows;
};

// One camera took all pictures: the focal length with which the three objects together fit best,
// each against the team's fit.
double commonFocalLength(const std::vector<Object>& objects) {
  double best = 0.0;
  double smallest = 1e9;
  for (double focal = 180.0; focal <= 230.0; focal += 0.5) {
    double sum = 0.0;
    for (const auto& o : objects)
      sum += maths::square(fitted(o.rows, opticsOf(o.object, focal)).rms /
                           misfit(o.rows, teamsFit(o.object)).rms);
    if (sum >= smallest) continue;
    smallest = sum;
    best = focal;
  }
  return best;
}

// Beacons at 80 and 100 cm were measured too small for any camera
// (tests/calibrate/DistanceDataTest.cpp).
Measurements fromWholeBeacons(const Measurements& rows) {
  Measurements far;
  for (const Measured& m : rows)
    if (m.distance >= 120.0) far.push_back(m);
  return far;
}

void addMisfit(const std::string& name, const Object& o, const DistanceModel& model, Json& json) {
  const Misfit all = misfit(o.rows, model);
  json[name + "_rms_cm"] = all.rms;
  json[name + "_rms_percent"] = all.rmsPercent;
  json[name + "_bias_cm"] = all.bias;
  json[name + "_from_120_rms_cm"] = misfit(fromWholeBeacons(o.rows), model).rms;
}

void report(const Object& o, double focalLength, Json& json) {
  const std::string name = o.name;
  const Family optics = opticsOf(o.object, focalLength);
  const Constants best = fitted(o.rows, optics);
  json[name + "_measurements"] = o.rows.size();
  addMisfit(name, o, geometry(o.object, {}), json);
  addMisfit(name + "_team", o, teamsFit(o.object), json);
  addMisfit(name + "_calibrated", o, optics.make(best.first, best.second), json);
  json[name + "_calibrated_edge_px"] = best.first;
  json[name + "_calibrated_blur_px"] = best.second;
  json[name + "_team_unseen_rms_cm"] = unseenRms(o.rows, hyperbolas(o.object));
  json[name + "_calibrated_unseen_rms_cm"] = unseenRms(o.rows, optics);
}

Expected<Json> distances(const Request& /*request*/) {
  std::vector<Object> objects = {{"ball", SizedObject::ball, {}},
                                 {"beacon", SizedObject::beacon, {}},
                                 {"goal", SizedObject::goal, {}}};
  for (auto& o : objects) {
    auto rows = readMeasurements(o.object);
    if (!rows) return Error{rows.error()};
    o.rows = *rows;
  }
  const double focalLength = commonFocalLength(objects);
  Json json{{"calibrated_focal_px", focalLength}};
  for (const auto& o : objects) report(o, focalLength, json);
  return json;
}

const Registration kDistances("distances",
                              "models of distance against sizes measured on real robots in 2005",
                              {}, 1, distances);

}  // namespace
}  // namespace kelpie::experiments
