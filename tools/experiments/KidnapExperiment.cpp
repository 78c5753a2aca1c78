// SPDX-License-Identifier: Apache-2.0
// A robot that plays is carried to a random place every twenty seconds: how long until it knows
// again where it is. The three ways to treat unlikely sightings (thesis 2004 section 2.2.3) listen
// to the same matches.
#include <algorithm>
#include <fstream>
#include <optional>
#include <set>

#include "robot/core/ParameterFile.h"
#include "robot/core/Random.h"
#include "tools/cli/Config.h"
#include "tools/experiments/LocaliseApart.h"
#include "tools/experiments/LocaliseFilters.h"

namespace kelpie::experiments {
namespace {

constexpr int kKidnaps = 9;        // a match
constexpr double kEvery = 20.0;    // s; also before the first
constexpr double kFromLines = 30;  // cm, of the place carried to
constexpr double kNearCm = 30.0;
constexpr double kNearDeg = 15.0;
constexpr double kForGood = 1.0;  // s
constexpr int kMethods = 3;
constexpr const char* kMethodKey = "gps.modes.noiseMethod";  // 0, 1, 2

// From being carried away to the first time from which the belief is right for a second. One that
// is never right counts as the whole time.
class Recovery {
 public:
  void begin(double time) {
    end();
    began_ = time;
    goodSince_.reset();
    done_ = false;
  }
  void end() {
    if (!done_) times_.push_back(kEvery);
    done_ = true;
  }
  void frame(double time, const PoseError& error) {
    if (done_) return;
    if (error.cm > kNearCm || error.deg > kNearDeg) return goodSince_.reset();
    if (!goodSince_) goodSince_ = time;
    if (time - *goodSince_ < kForGood) return;
    times_.push_back(*goodSince_ - began_);
    done_ = true;
  }
  const std::vector<double>& times() const { return times_; }

 private:
  double began_ = 0.0;
  std::optional<double> goodSince_;
  bool done_ = true;
  std::vector<double> times_;
};

// Time until so many different landmarks have been seen.
class Sightings {
 public:
  void begin(double time) {
    began_ = time;
    kinds_.clear();
    first_.push_back(kEvery);
    second_.push_back(kEvery);
  }
  void frame(double time, const Percepts& percepts) {
    if (first_.empty()) return;
    for (const LandmarkPercept& percept : percepts.landmarks) {
      if (!kinds_.insert(percept.kind).second) continue;
      if (kinds_.size() == 1) first_.back() = time - began_;
      if (kinds_.size() == 2) second_.back() = time - began_;
    }
  }
  const std::vector<double>& first() const { return first_; }
  const std::vector<double>& second() const { return second_; }

 private:
  double began_ = 0.0;
  std::set<LandmarkKind> kinds_;
  std::vector<double> first_;
  std::vector<double> second_;
};

std::string nameOf(int method) { return "method" + std::to_string(method + 1); }

// The three methods, all else as the player has it; none while the localiser knows only one.
std::vector<Listener> listeners(const gps::GpsParams& params) {
  std::vector<Listener> all;
  for (int method = 0; method < kMethods; ++method) {
    gps::GpsParams other = params;
    ParameterSet set;
    set.add("gps", other);
    if (set.assign(kMethodKey, method)) all.emplace_back(nameOf(method), other, Hearing{});
  }
  return all;
}

class Watch {
 public:
  Watch(std::vector<Listener> listeners, const std::string& csv)
      : listeners_(std::move(listeners)), recoveries_(listeners_.size() + 1) {
    if (!csv.empty()) csv_.open(csv);
    if (csv_.is_open()) csv_ << "t_s,filter,error_cm,error_deg,sd_cm,landmarks\n";
  }
  void begin(double time) {
    for (Recovery& recovery : recoveries_) recovery.begin(time);
    sightings_.begin(time);
  }
  void frame(const WatchedFrame& frame) {
    hear(frame, frame.output.world, 0);
    for (std::size_t i = 0; i < listeners_.size(); ++i)
      hear(frame, listeners_[i].hear(frame), i + 1);
    sightings_.frame(frame.input.time.seconds(), frame.output.percepts);
  }
  Json json() {
    Json all;
    for (std::size_t i = 0; i < recoveries_.size(); ++i) {
      recoveries_[i].end();
      all[i == 0 ? "own" : listeners_[i - 1].name()] = recoveries_[i].times();
    }
    all["first"] = sightings_.first();
    all["second"] = sightings_.second();
    return all;
  }

 private:
  void hear(const WatchedFrame& frame, const WorldModel& world, std::size_t filter) {
    const double time = frame.input.time.seconds();
    const PoseError error = poseError(world, frame.truth);
    recoveries_[filter].frame(time, error);
    if (!csv_.is_open()) return;
    csv_ << time << ',' << (filter == 0 ? "own" : listeners_[filter - 1].name()) << ',' << error.cm
         << ',' << error.deg << ',' << world.positionSd << ','
         << frame.output.percepts.landmarks.size() << '\n';
  }

  std::vector<Listener> listeners_;
  std::vector<Recovery> recoveries_;
  Sightings sightings_;
  std::ofstream csv_;
};

Pose2 anywhere(const body::FieldDescription& field, Random& random) {
  const double x = random.uniform(kFromLines, field.width - kFromLines);
  const double y = random.uniform(kFromLines, field.length - kFromLines);
  return {{x, y}, Angle::rad(random.uniform(-maths::kPi, maths::kPi))};
}

Expected<Json> oneMatch(const ExperimentOptions& options, int number) {
  const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(number);
  const auto config = agentConfig(options);
  if (!config) return Error{config.error()};
  const std::string csv =
      options.pictures.empty() ? "" : options.pictures + "/kidnap-" + std::to_string(seed) + ".csv";
  Watch watch(listeners(config->gps), csv);
  LocaliseMatch match(*config, cli::defaultScripts(), seed);
  Random random(seed ^ 0x51dca9ULL);
  for (int kidnap = 0; kidnap <= kKidnaps; ++kidnap) {
    const Status played = match.play(kEvery * (kidnap + 1),
                                     [&watch](const WatchedFrame& frame) { watch.frame(frame); });
    if (!played) return Error{"seed " + std::to_string(seed) + ": " + played.error()};
    if (kidnap == kKidnaps) break;
    const Status carried = match.world().carry(0, anywhere(config->gps.field, random));
    if (!carried) return Error{carried.error()};
    watch.begin(match.world().time().seconds());
  }
  return watch.json();
}

std::vector<double> joined(const std::vector<Json>& matches, const std::string& key) {
  std::vector<double> all;
  for (const Json& match : matches)
    for (const Json& value : match.value(key, Json::array())) all.push_back(value.get<double>());
  return all;
}

void addTimes(const std::string& prefix, const std::vector<double>& times, Json& figures) {
  const auto never = std::count(times.begin(), times.end(), kEvery);
  figures[prefix + "median_s"] = percentile(times, 0.5);
  figures[prefix + "p95_s"] = percentile(times, 0.95);
  figures[prefix + "never_rate"] = static_cast<double>(never) / static_cast<double>(times.size());
}

}  // namespace

Expected<Json> kidnap(const ExperimentOptions& options) {
  const auto matches = runApart(
      options.trials, [&](int number) { return oneMatch(options, number); }, options.progress);
  if (!matches) return Error{matches.error()};
  const std::vector<double> own = joined(*matches, "own");
  Json figures{{"experiment", "kidnap"},
               {"trials", options.trials},
               {"seed", options.seed},
               {"kidnaps", own.size()}};
  addTimes("", own, figures);
  for (int method = 0; method < kMethods; ++method) {
    const std::vector<double> times = joined(*matches, nameOf(method));
    if (!times.empty()) addTimes(nameOf(method) + "_", times, figures);
  }
  addTimes("first_landmark_", joined(*matches, "first"), figures);
  addTimes("second_landmark_", joined(*matches, "second"), figures);
  return figures;
}

}  // namespace kelpie::experiments
