// SPDX-License-Identifier: Apache-2.0
// How well the robot knows its place while it plays: matches of three minutes from an unknown
// start, from pixels. Beside the player's own filter others listen that lack lines or landmarks, or
// are helped by the truth in one thing; the difference tells what the error comes from.
#include <fstream>

#include "tools/cli/Config.h"
#include "tools/experiments/LocaliseApart.h"
#include "tools/experiments/LocaliseFilters.h"
#include "tools/experiments/LocaliseSenses.h"

namespace kelpie::experiments {
namespace {

constexpr double kSeconds = 180.0;
constexpr double kSettle = 10.0;  // s that are not counted
constexpr double kBin = 10.0;     // s

gps::GpsParams from(const Pose2& start, gps::GpsParams params) {
  params.initialPose.present = true;
  params.initialPose.pose = start;
  return params;
}

std::vector<Listener> listeners(const gps::GpsParams& params, const Pose2& start) {
  std::vector<Listener> all;
  const auto add = [&](const char* name, const Hearing& hearing) {
    all.emplace_back(name, params, hearing);
  };
  Hearing only;
  only.landmarks = false;
  all.emplace_back("lines_only", from(start, params), only);
  only.lines = false;  // nothing but odometry: what lines must beat
  all.emplace_back("odometry_only", from(start, params), only);
  only = {};
  only.lines = false;
  add("landmarks_only", only);
  Hearing helped;
  helped.trueOdometry = true;
  add("true_odometry", helped);
  helped = {};
  helped.trueDistances = true;
  add("true_distances", helped);
  helped = {};
  helped.trueHeadings = true;
  add("true_headings", helped);
  gps::GpsParams other = params;
  other.line.combine = params.line.combine == gps::LineCombine::joint ? gps::LineCombine::separate
                                                                      : gps::LineCombine::joint;
  all.emplace_back("other_combine", other, Hearing{});
  helped = {};
  helped.noFalse = true;
  add("no_false", helped);
  return all;
}

// What is kept of one match.
class Watch {
 public:
  // `tables`: where tables of every frame and landmark go, less "-frames.csv"; empty: none.
  Watch(const gps::GpsParams& params, const Pose2& start, const std::string& tables)
      : listeners_(listeners(params, start)),
        senses_(params, tables.empty() ? "" : tables + "-landmarks.csv") {
    for (const Listener& listener : listeners_) names_.push_back(listener.name());
    names_.insert(names_.begin(), "both");
    tracks_.resize(names_.size());
    if (tables.empty()) return;
    csv_.open(tables + "-frames.csv");
    csv_ << "t_s,x_cm,y_cm,heading_deg,estimate_x_cm,estimate_y_cm,estimate_heading_deg,sd_cm,"
            "sd_deg,nees,since_landmark_s,landmarks,line_points\n";
  }

  void frame(const WatchedFrame& frame) {
    const double time = frame.input.time.seconds();
    const PoseError own = poseError(frame.output.world, frame.truth);
    if (csv_.is_open()) write(frame, own);
    const auto bin = static_cast<std::size_t>(time / kBin);
    bins_.resize(std::max(bins_.size(), bin + 1));
    bins_[bin].push_back(own.cm);
    if (time >= kSettle) {
      tracks_[0].add(own);
      since_.push_back(frame.output.world.secondsSinceLandmark);
    }
    for (std::size_t i = 0; i < listeners_.size(); ++i) {
      const PoseError error = poseError(listeners_[i].hear(frame), frame.truth);
      if (time >= kSettle) tracks_[i + 1].add(error);
    }
    senses_.frame(frame);
  }

  Json json() const {
    Json tracks;
    for (std::size_t i = 0; i < names_.size(); ++i) tracks[names_[i]] = tracks_[i].json();
    std::vector<double> bins;
    for (const auto& bin : bins_) bins.push_back(mean(bin));
    return {{"tracks", tracks}, {"bins", bins}, {"since", since_}, {"senses", senses_.json()}};
  }

 private:
  void write(const WatchedFrame& frame, const PoseError& error) {
    const WorldModel& world = frame.output.world;
    csv_ << frame.input.time.seconds() << ',' << frame.truth.position.x << ','
         << frame.truth.position.y << ',' << frame.truth.heading.deg() << ','
         << world.pose.position.x << ',' << world.pose.position.y << ',' << world.pose.heading.deg()
         << ',' << world.positionSd << ',' << world.headingSd.deg() << ',' << error.nees << ','
         << world.secondsSinceLandmark << ',' << frame.output.percepts.landmarks.size() << ','
         << frame.output.percepts.linePoints.size() << '\n';
  }

  std::vector<Listener> listeners_;
  SenseErrors senses_;
  std::vector<std::string> names_;
  std::vector<ErrorTrack> tracks_;
  std::vector<std::vector<double>> bins_;
  std::vector<double> since_;
  std::ofstream csv_;
};

Expected<Json> oneMatch(const ExperimentOptions& options, int number) {
  const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(number);
  const auto config = agentConfig(options);
  if (!config) return Error{config.error()};
  LocaliseMatch match(*config, cli::defaultScripts(), seed);
  const std::string tables =
      options.pictures.empty() ? "" : options.pictures + "/localise-" + std::to_string(seed);
  Watch watch(config->gps, match.world().truth({}).robots[0].pose, tables);
  const Status played =
      match.play(kSeconds, [&watch](const WatchedFrame& frame) { watch.frame(frame); });
  if (!played) return Error{"seed " + std::to_string(seed) + ": " + played.error()};
  Json answer = watch.json();
  const sim::Score& score = match.world().score();
  answer["match"] = {{"seed", seed},
                     {"goals", score.red},
                     {"own_goals", score.blue},
                     {"outs", score.outs},
                     {"mean_cm", mean(answer["tracks"]["both"]["cm"].get<std::vector<double>>())}};
  return answer;
}

// Mean over the matches, bin by bin.
std::vector<double> meanBins(const std::vector<Json>& matches) {
  std::vector<double> bins;
  for (const Json& match : matches) {
    const auto own = match["bins"].get<std::vector<double>>();
    bins.resize(std::max(bins.size(), own.size()));
    for (std::size_t i = 0; i < own.size(); ++i)
      bins[i] += own[i] / static_cast<double>(matches.size());
  }
  return bins;
}

}  // namespace

Expected<Json> localise(const ExperimentOptions& options) {
  const auto matches = runApart(
      options.trials, [&](int number) { return oneMatch(options, number); }, options.progress);
  if (!matches) return Error{matches.error()};
  Json filters;
  for (const auto& [name, unused] : (*matches)[0]["tracks"].items()) {
    ErrorTrack track;
    for (const Json& match : *matches) track.add(match["tracks"][name]);
    filters[name] = track.summary();
  }
  std::vector<double> since;
  std::vector<Json> senses;
  Json each = Json::array();
  for (const Json& match : *matches) {
    for (const Json& value : match["since"]) since.push_back(value.get<double>());
    senses.push_back(match["senses"]);
    each.push_back(match["match"]);
  }
  return Json{{"experiment", "localise"},
              {"trials", options.trials},
              {"seed", options.seed},
              {"mean_cm", filters["both"]["mean_cm"]},
              {"mean_deg", filters["both"]["mean_deg"]},
              {"p95_cm", filters["both"]["p95_cm"]},
              {"lines_only_cm", filters["lines_only"]["mean_cm"]},
              {"odometry_only_cm", filters["odometry_only"]["mean_cm"]},
              {"landmarks_only_cm", filters["landmarks_only"]["mean_cm"]},
              {"both_cm", filters["both"]["mean_cm"]},
              {"since_landmark_mean_s", mean(since)},
              {"since_landmark_p95_s", percentile(since, 0.95)},
              {"filters", filters},
              {"senses", SenseErrors::summary(senses)},
              {"by_10_s_cm", meanBins(*matches)},
              {"each", each}};
}

}  // namespace kelpie::experiments
