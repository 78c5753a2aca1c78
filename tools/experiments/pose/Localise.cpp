// SPDX-License-Identifier: Apache-2.0
// How well the robot knows its place while it plays: matches of three minutes from an unknown
// start, from pixels. Beside the player's own filter others listen that lack lines or landmarks, or
// are helped by the truth in one thing; the difference tells what the error comes from.
#include <algorithm>

#include "tools/cli/options/Config.h"
#include "tools/experiments/harness/ChildProcesses.h"
#include "tools/experiments/pose/LocaliseFilters.h"
#include "tools/experiments/pose/LocaliseSenses.h"

namespace kelpie::experiments {
namespace {

constexpr double kSeconds = 180.0;
constexpr double kSettle = 10.0;  // s that are not counted
constexpr double kBin = 10.0;     // s

gps::GpsParams startingAt(const Pose2& start, gps::GpsParams params) {
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
  all.emplace_back("lines_only", startingAt(start, params), only);
  only.lines = false;  // nothing but odometry: what lines must beat
  all.emplace_back("odometry_only", startingAt(start, params), only);
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
  all.emplace_back("joint", params, Hearing{}, gps::stepJointly);
  all.emplace_back("by_determinant", params, Hearing{}, gps::stepByDeterminant);
  gps::GpsParams other = params;
  other.lines.update.use = gps::LineUse::sanity;
  all.emplace_back("lines_judge", other, Hearing{});
  helped = {};
  helped.noFalse = true;
  add("no_false", helped);
  return all;
}

struct NamedTrack {
  std::string name;
  ErrorTrack errors;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("name", &NamedTrack::name), field("errors", &NamedTrack::errors));
  }
};

// What the figures tell of each match by itself.
struct MatchResult {
  std::uint64_t seed = 0;
  int goals = 0;
  int ownGoals = 0;
  int outs = 0;
  double mean = 0.0;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("seed", &MatchResult::seed), field("goals", &MatchResult::goals),
                     field("own_goals", &MatchResult::ownGoals), field("outs", &MatchResult::outs),
                     field("mean_cm", &MatchResult::mean));
  }
};

// All that is kept of one match.
struct MatchRecord {
  std::vector<NamedTrack> tracks;  // the player's own first
  Values binMeans;                 // cm, every ten seconds
  Values sinceLandmark;            // s
  SenseErrors senses;
  MatchResult result;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("tracks", &MatchRecord::tracks),
                     field("binMeans", &MatchRecord::binMeans, "cm"),
                     field("sinceLandmark", &MatchRecord::sinceLandmark, "s"),
                     field("senses", &MatchRecord::senses), field("result", &MatchRecord::result));
  }
};

struct FrameRow {
  TimeUs time;
  double x, y;
  Angle heading;
  double believedX, believedY;
  Angle believedHeading;
  double sd;
  Angle headingSd;
  double nees;
  double sinceLandmark;
  std::size_t landmarks;
  std::size_t linePoints;
  double odometryForward, odometryLeft;
  Angle odometryTurn;
  std::size_t walk, motion;  // last asked, and under way
  double forward, left;
  Angle turn;  // a second

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(
        field("t_s", &FrameRow::time), field("x_cm", &FrameRow::x), field("y_cm", &FrameRow::y),
        field("heading_deg", &FrameRow::heading), field("estimate_x_cm", &FrameRow::believedX),
        field("estimate_y_cm", &FrameRow::believedY),
        field("estimate_heading_deg", &FrameRow::believedHeading), field("sd_cm", &FrameRow::sd),
        field("sd_deg", &FrameRow::headingSd), field("nees", &FrameRow::nees),
        field("since_landmark_s", &FrameRow::sinceLandmark),
        field("landmarks", &FrameRow::landmarks), field("line_points", &FrameRow::linePoints),
        field("odometry_forward_cm", &FrameRow::odometryForward),
        field("odometry_left_cm", &FrameRow::odometryLeft),
        field("odometry_turn_deg", &FrameRow::odometryTurn), field("walk", &FrameRow::walk),
        field("motion", &FrameRow::motion), field("forward_cm_s", &FrameRow::forward),
        field("left_cm_s", &FrameRow::left), field("turn_deg_s", &FrameRow::turn));
  }
};

FrameRow rowOf(const WatchedFrame& frame, const PoseError& error) {
  const WorldModel& world = frame.output.world;
  return {frame.input.time,
          frame.truth.position.x,
          frame.truth.position.y,
          frame.truth.heading,
          world.pose.position.x,
          world.pose.position.y,
          world.pose.heading,
          world.positionSd,
          world.headingSd,
          error.nees,
          world.secondsSinceLandmark,
          frame.output.percepts.landmarks.size(),
          frame.output.percepts.linePoints.size(),
          frame.input.odometry.forward,
          frame.input.odometry.left,
          frame.input.odometry.turn,
          static_cast<std::size_t>(frame.input.lastCommand.walk.kind),
          static_cast<std::size_t>(frame.input.motion.running),
          frame.input.lastCommand.walk.forward,
          frame.input.lastCommand.walk.left,
          Angle::rad(frame.input.lastCommand.walk.turn)};
}

class MatchRecorder {
 public:
  // The traces' names begin with `name`.
  MatchRecorder(const gps::GpsParams& params, const Pose2& start, const Request& request,
                const std::string& name)
      : listeners_(listeners(params, start)),
        senses_(params, request.tracePath(name + "-landmarks")),
        trace_(request.tracePath(name + "-frames")) {
    record_.tracks.push_back({"both", {}});
    for (const Listener& listener : listeners_) record_.tracks.push_back({listener.name(), {}});
  }

  void frame(const WatchedFrame& frame) {
    const double time = frame.input.time.seconds();
    const PoseError own = poseError(frame.output.world, frame.truth);
    trace_.add(rowOf(frame, own));
    const auto bin = static_cast<std::size_t>(time / kBin);
    bins_.resize(std::max(bins_.size(), bin + 1));
    bins_[bin].push_back(own.cm);
    if (time >= kSettle) {
      record_.tracks[0].errors.add(own);
      record_.sinceLandmark.push_back(frame.output.world.secondsSinceLandmark);
    }
    for (std::size_t i = 0; i < listeners_.size(); ++i) {
      const PoseError error = poseError(listeners_[i].hear(frame), frame.truth);
      if (time >= kSettle) record_.tracks[i + 1].errors.add(error);
    }
    senses_.frame(frame);
  }

  MatchRecord record() const {
    MatchRecord record = record_;
    for (const Values& bin : bins_) record.binMeans.push_back(mean(bin));
    record.senses = senses_.errors();
    return record;
  }

 private:
  std::vector<Listener> listeners_;
  SenseRecorder senses_;
  Trace<FrameRow> trace_;
  MatchRecord record_;
  std::vector<Values> bins_;
};

Expected<MatchRecord> playMatch(const Request& request, const agent::AgentConfig& config,
                                std::uint64_t seed) {
  LocaliseMatch match(config, cli::defaultScripts(), seed, request.randomised, !request.fast);
  MatchRecorder recorder(config.gps, match.world().truth({}).robots[0].pose, request,
                         "localise-" + std::to_string(seed));
  const Status played =
      match.play(kSeconds, [&recorder](const WatchedFrame& frame) { recorder.frame(frame); });
  if (!played) return Error{played.error()};
  MatchRecord record = recorder.record();
  const sim::Score& score = match.world().score();
  record.result = {seed, score.red, score.blue, score.outs, mean(record.tracks[0].errors.cm)};
  return record;
}

// All matches together.
struct Totals {
  std::vector<NamedTrack> tracks;
  Values binMeans;  // mean over the matches
  Values sinceLandmark;
  SenseErrors senses;
  std::vector<MatchResult> results;

  void add(const MatchRecord& match, std::size_t matches) {
    tracks.resize(match.tracks.size());
    for (std::size_t i = 0; i < tracks.size(); ++i) {
      tracks[i].name = match.tracks[i].name;
      tracks[i].errors.add(match.tracks[i].errors);
    }
    binMeans.resize(std::max(binMeans.size(), match.binMeans.size()));
    for (std::size_t i = 0; i < match.binMeans.size(); ++i)
      binMeans[i] += match.binMeans[i] / static_cast<double>(matches);
    append(match.sinceLandmark, sinceLandmark);
    senses.add(match.senses);
    results.push_back(match.result);
  }
};

Expected<Json> localise(const Request& request) {
  const auto config = agentConfig(request, !request.fast);
  if (!config) return Error{config.error()};
  const auto matches = trialsInChildProcesses(
      request, [&](const Trial& trial) { return playMatch(request, *config, trial.seed); });
  if (!matches) return Error{matches.error()};
  Totals all;
  for (const MatchRecord& match : *matches) all.add(match, matches->size());
  Json filters;
  for (const NamedTrack& track : all.tracks) filters[track.name] = track.errors.summary();
  return Json{{"mean_cm", filters["both"]["mean_cm"]},
              {"mean_deg", filters["both"]["mean_deg"]},
              {"p95_cm", filters["both"]["p95_cm"]},
              {"nees_mean", filters["both"]["nees_mean"]},
              {"lines_only_cm", filters["lines_only"]["mean_cm"]},
              {"odometry_only_cm", filters["odometry_only"]["mean_cm"]},
              {"landmarks_only_cm", filters["landmarks_only"]["mean_cm"]},
              {"both_cm", filters["both"]["mean_cm"]},
              {"since_landmark_mean_s", mean(all.sinceLandmark)},
              {"since_landmark_p95_s", percentile(all.sinceLandmark, 0.95)},
              {"filters", filters},
              {"senses", all.senses.summary()},
              {"by_10_s_cm", all.binMeans},
              {"each", toJson(all.results)}};
}

const Registration kLocalise(
    "localise", "three minutes of play from pixels: errors of the pose and their causes",
    {Option::trials, Option::seed, Option::randomised, Option::params, Option::field,
     Option::traces, Option::fast},
    8, localise);

}  // namespace
}  // namespace kelpie::experiments
