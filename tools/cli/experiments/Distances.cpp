// SPDX-License-Identifier: Apache-2.0
// Vision's distance from a size in the image against what was measured on real robots, beside the
// team's fits. Both have two constants to choose, so both are also judged on series that their
// constants were not chosen on ("unseen"): a fit of noisy sizes flatters itself.
#include <cmath>

#include "tools/cli/experiments/DistanceData.h"
#include "tools/cli/experiments/Experiment.h"

namespace kelpie::cli {
namespace {

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

Family opticsOf(SizedObject object) {
  return {[object](double f, double edge) {
            return geometry(object, {f, edge});
          },
          170.0, 260.0, -4.0, 4.0};
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
      const double second = family.secondLow + secondStep * static_cast<double>(i / kPlaces);
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

// Each series judged with constants chosen on all the others; cm.
double unseenRms(const Measurements& rows, const Family& family) {
  double sum = 0.0;
  std::size_t judged = 0;
  for (int series = 0; judged < rows.size(); ++series) {
    Measurements own;
    Measurements others;
    for (const Measured& m : rows) (m.series == series ? own : others).push_back(m);
    if (own.empty()) continue;
    const Constants chosen = fitted(others, family);
    const double rms = misfit(own, family.make(chosen.first, chosen.second)).rms;
    sum += rms * rms * static_cast<double>(own.size());
    judged += own.size();
  }
  return std::sqrt(sum / static_cast<double>(rows.size()));
}

void addMisfit(const std::string& name, const Misfit& m, Json& json) {
  json[name + "rms_cm"] = m.rms;
  json[name + "rms_percent"] = m.rmsPercent;
  json[name + "bias_cm"] = m.bias;
}

Status report(const std::string& name, SizedObject object, Json& json) {
  const auto rows = readMeasurements(object);
  if (!rows) return Error{rows.error()};
  json[name + "_measurements"] = rows->size();
  addMisfit(name + "_", misfit(*rows, geometry(object, {})), json);
  addMisfit(name + "_team_", misfit(*rows, teamsFit(object)), json);
  const Constants best = fitted(*rows, opticsOf(object));
  json[name + "_fitted_focal_px"] = best.first;
  json[name + "_fitted_edge_px"] = best.second;
  addMisfit(name + "_fitted_", misfit(*rows, geometry(object, {best.first, best.second})), json);
  json[name + "_team_unseen_rms_cm"] = unseenRms(*rows, hyperbolas(object));
  json[name + "_fitted_unseen_rms_cm"] = unseenRms(*rows, opticsOf(object));
  return Done{};
}

}  // namespace

Expected<Json> distances(const ExperimentOptions& options) {
  Json json{{"experiment", "distances"}, {"trials", options.trials}, {"seed", options.seed}};
  for (const auto& [name, object] :
       {std::pair{"ball", SizedObject::ball}, std::pair{"beacon", SizedObject::beacon},
        std::pair{"goal", SizedObject::goal}}) {
    const Status done = report(name, object, json);
    if (!done) return Error{done.error()};
  }
  return json;
}

}  // namespace kelpie::cli
