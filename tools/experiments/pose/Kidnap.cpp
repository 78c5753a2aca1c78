// SPDX-License-Identifier: Apache-2.0
// A robot that plays is carried to a random place every twenty seconds: how long until it knows
// again where it is. The three ways to treat unlikely sightings (thesis 2004 section 2.2.3) listen
// to the same matches, with lines and without: which is best, and what beginning anew adds.
#include <algorithm>
#include <optional>
#include <set>

#include "robot/core/Random.h"
#include "tools/cli/options/Config.h"
#include "tools/experiments/harness/ChildProcesses.h"
#include "tools/experiments/harness/Trace.h"
#include "tools/experiments/pose/LocaliseFilters.h"

namespace kelpie::experiments {
namespace {

constexpr int kKidnaps = 9;        // a match
constexpr double kEvery = 20.0;    // s; also before the first
constexpr double kFromLines = 30;  // cm, of the place carried to
constexpr double kRecoveredCm = 30.0;
constexpr double kRecoveredDeg = 15.0;
constexpr double kRightFor = 1.0;  // s

// The thesis' methods as it has them: none begins anew, which the robot does.
struct Method {
  const char* name;
  gps::Localise localise;
  bool wide;         // adds a wide mode
  bool linesAlways;  // lines correct even a mode that is too wide to tell which they are
};
constexpr Method kMethods[] = {{"method1", gps::stepRefusing, false, false},
                               {"method1_slow", gps::stepRefusingSlowly, false, false},
                               {"method1_lines_always", gps::stepRefusing, false, true},
                               {"method2", gps::step, false, false},
                               {"method3", gps::step, true, false}};

// The time from being carried away until the belief is right for a second. A belief that is never
// right counts as the whole time.
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
    errors_.push_back(error.cm);
    if (done_) return;
    if (error.cm > kRecoveredCm || error.deg > kRecoveredDeg) return goodSince_.reset();
    if (!goodSince_) goodSince_ = time;
    if (time - *goodSince_ < kRightFor) return;
    times_.push_back(*goodSince_ - began_);
    done_ = true;
  }
  const Values& times() const { return times_; }
  double meanError() const { return mean(errors_); }

 private:
  double began_ = 0.0;
  Values errors_;  // cm
  std::optional<double> goodSince_;
  bool done_ = true;
  Values times_;
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
  const Values& first() const { return first_; }
  const Values& second() const { return second_; }

 private:
  double began_ = 0.0;
  std::set<LandmarkKind> kinds_;
  Values first_;
  Values second_;
};

struct NamedTimes {
  std::string name;
  Values times;       // s, of each recovery
  Values meanErrors;  // cm, of each match

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("name", &NamedTimes::name), field("times", &NamedTimes::times, "s"),
                     field("meanErrors", &NamedTimes::meanErrors, "cm"));
  }
};

// All that is kept of one match.
struct MatchRecord {
  std::vector<NamedTimes> filters;  // the player's own first
  Values firstLandmark;             // s, until it was seen
  Values secondLandmark;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("filters", &MatchRecord::filters),
                     field("firstLandmark", &MatchRecord::firstLandmark, "s"),
                     field("secondLandmark", &MatchRecord::secondLandmark, "s"));
  }
  void add(const MatchRecord& other) {
    filters.resize(other.filters.size());
    for (std::size_t i = 0; i < filters.size(); ++i) {
      filters[i].name = other.filters[i].name;
      append(other.filters[i].times, filters[i].times);
      append(other.filters[i].meanErrors, filters[i].meanErrors);
    }
    append(other.firstLandmark, firstLandmark);
    append(other.secondLandmark, secondLandmark);
  }
};

struct FilterRow {
  TimeUs time;
  std::string filter;
  double error;
  double errorDeg;
  double sd;
  std::size_t landmarks;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("t_s", &FilterRow::time), field("filter", &FilterRow::filter),
                     field("error_cm", &FilterRow::error), field("error_deg", &FilterRow::errorDeg),
                     field("sd_cm", &FilterRow::sd), field("landmarks", &FilterRow::landmarks));
  }
};

gps::GpsParams paramsOf(const Method& method, gps::GpsParams params) {
  params.modes.maxUnexplained = 0;
  if (!method.wide) params.modes.wideWeight = 0.0;
  if (!method.linesAlways) return params;
  params.lines.update.maxSd = 1000.0;
  params.lines.update.maxHeadingSd = Angle::deg(180.0);
  return params;
}

// The methods with landmarks and lines, all else as the player has it; then by landmarks alone, for
// which method 1 was made.
std::vector<Listener> listeners(const gps::GpsParams& params) {
  std::vector<Listener> all;
  for (const Method& method : kMethods)
    all.emplace_back(method.name, paramsOf(method, params), Hearing{}, method.localise);
  Hearing landmarks;
  landmarks.lines = false;
  for (const Method& method : kMethods)
    if (!method.linesAlways)
      all.emplace_back("landmarks_" + std::string(method.name), paramsOf(method, params), landmarks,
                       method.localise);
  all.emplace_back("landmarks", params, landmarks);
  return all;
}

class MatchRecorder {
 public:
  MatchRecorder(const gps::GpsParams& params, const std::string& tracePath)
      : listeners_(listeners(params)), recoveries_(listeners_.size() + 1), trace_(tracePath) {}

  void begin(double time) {
    for (Recovery& recovery : recoveries_) recovery.begin(time);
    sightings_.begin(time);
  }
  void frame(const WatchedFrame& frame) {
    addBelief(frame, frame.output.world, 0);
    for (std::size_t i = 0; i < listeners_.size(); ++i)
      addBelief(frame, listeners_[i].hear(frame), i + 1);
    sightings_.frame(frame.input.time.seconds(), frame.output.percepts);
  }
  MatchRecord record() {
    MatchRecord record;
    for (std::size_t i = 0; i < recoveries_.size(); ++i) {
      recoveries_[i].end();
      record.filters.push_back({nameOf(i), recoveries_[i].times(), {recoveries_[i].meanError()}});
    }
    record.firstLandmark = sightings_.first();
    record.secondLandmark = sightings_.second();
    return record;
  }

 private:
  std::string nameOf(std::size_t filter) const {
    return filter == 0 ? "own" : listeners_[filter - 1].name();
  }
  void addBelief(const WatchedFrame& frame, const WorldModel& world, std::size_t filter) {
    const PoseError error = poseError(world, frame.truth);
    recoveries_[filter].frame(frame.input.time.seconds(), error);
    trace_.add({frame.input.time, nameOf(filter), error.cm, error.deg, world.positionSd,
                frame.output.percepts.landmarks.size()});
  }

  std::vector<Listener> listeners_;
  std::vector<Recovery> recoveries_;
  Sightings sightings_;
  Trace<FilterRow> trace_;
};

Pose2 anywhere(const body::FieldDescription& field, Random& random) {
  const double x = random.uniform(kFromLines, field.width - kFromLines);
  const double y = random.uniform(kFromLines, field.length - kFromLines);
  return {{x, y}, Angle::rad(random.uniform(-maths::kPi, maths::kPi))};
}

Expected<MatchRecord> playMatch(const Request& request, const agent::AgentConfig& config,
                                std::uint64_t seed) {
  MatchRecorder recorder(config.gps, request.tracePath("kidnap-" + std::to_string(seed)));
  LocaliseMatch match(config, cli::defaultScripts(), seed, request.randomised, !request.fast);
  Random random(seed ^ 0x51dca9ULL);
  for (int kidnap = 0; kidnap <= kKidnaps; ++kidnap) {
    const Status played = match.play(
        kEvery * (kidnap + 1), [&recorder](const WatchedFrame& frame) { recorder.frame(frame); });
    if (!played) return Error{played.error()};
    if (kidnap == kKidnaps) break;
    const Status carried = match.world().carry(0, anywhere(config.field, random));
    if (!carried) return Error{carried.error()};
    recorder.begin(match.world().time().seconds());
  }
  return recorder.record();
}

void addTimes(const std::string& prefix, const Values& times, Json& figures) {
  const auto never = std::count(times.begin(), times.end(), kEvery);
  figures[prefix + "median_s"] = percentile(times, 0.5);
  figures[prefix + "p95_s"] = percentile(times, 0.95);
  figures[prefix + "never_rate"] = static_cast<double>(never) / static_cast<double>(times.size());
}

Expected<Json> kidnap(const Request& request) {
  const auto config = agentConfig(request, !request.fast);
  if (!config) return Error{config.error()};
  const auto matches = trialsInChildProcesses(
      request, [&](const Trial& trial) { return playMatch(request, *config, trial.seed); });
  if (!matches) return Error{matches.error()};
  MatchRecord all;
  for (const MatchRecord& match : *matches) all.add(match);
  Json figures{{"kidnaps", all.filters[0].times.size()}};
  for (const NamedTimes& filter : all.filters) {
    const std::string prefix = filter.name == "own" ? "" : filter.name + "_";
    addTimes(prefix, filter.times, figures);
    figures[prefix + "mean_cm"] = mean(filter.meanErrors);
  }
  addTimes("first_landmark_", all.firstLandmark, figures);
  addTimes("second_landmark_", all.secondLandmark, figures);
  return figures;
}

const Registration kKidnap(
    "kidnap", "carried away every 20 s while playing: time until the pose is right again",
    {Option::trials, Option::seed, Option::randomised, Option::params, Option::traces,
     Option::fast},
    8, kidnap);

}  // namespace
}  // namespace kelpie::experiments
