// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/StuckScrums.h"

#include <cmath>

#include "robot/core/Random.h"
#include "tools/cli/Config.h"
#include "tools/experiments/LocaliseApart.h"
#include "tools/experiments/LocaliseFilters.h"

namespace kelpie::experiments {
namespace {

constexpr int kScrums = 8;        // a match
constexpr double kFirst = 15.0;   // s, until the pose is known
constexpr double kCalm = 15.0;    // s after each
constexpr double kSlice = 0.032;  // s between pushes
constexpr double kNearCm = 30.0;
constexpr double kStep = 0.36;  // s, 44 ticks

// Somebody holds, pushes and turns the robot.
struct Scrum {
  double seconds;
  double held;         // share of its way that it loses
  Point2<Field> push;  // cm in all
  Angle turn;          // in all
};

Scrum drawn(Random& random) {
  Scrum scrum{};
  scrum.seconds = random.uniform(2.0, 5.0);
  scrum.held = random.uniform(0.7, 1.0);
  const double way = random.uniform(0.0, 40.0);
  const Angle to = Angle::rad(random.uniform(-maths::kPi, maths::kPi));
  scrum.push = {way * to.cos(), way * to.sin()};
  scrum.turn = Angle::deg(random.uniform(-90.0, 90.0));
  return scrum;
}

// What one localiser made of the scrums of a match.
class Track {
 public:
  void frame(double time, bool scrum, const WorldModel& world, const PoseError& error) {
    if (scrum) {
      inside_.add(error);
      if (!inScrum_) finish();
      inScrum_ = true;
      atEnd_ = error.cm;
      sdAtEnd_ = world.positionSd;
      return;
    }
    if (inScrum_) {
      began_ = lastFar_ = time;
      errors_.push_back(atEnd_);
      sds_.push_back(sdAtEnd_);
      open_ = true;
    }
    inScrum_ = false;
    if (open_) after_.add(error);
    if (open_ && error.cm > kNearCm) lastFar_ = time;
  }
  void finish() {
    if (open_) times_.push_back(lastFar_ - began_);
    open_ = false;
  }
  Json json() const {
    return {{"recovery", times_},
            {"error", errors_},
            {"sd", sds_},
            {"inside", inside_.json()},
            {"after", after_.json()}};
  }

 private:
  bool inScrum_ = false;
  bool open_ = false;  // between the end of a scrum and the next
  double began_ = 0.0;
  double lastFar_ = 0.0;
  double atEnd_ = 0.0;
  double sdAtEnd_ = 0.0;
  std::vector<double> times_;
  std::vector<double> errors_;
  std::vector<double> sds_;
  ErrorTrack inside_;
  ErrorTrack after_;
};

struct Way {
  const char* name;
  bool aware;
  double pause;  // s
  gps::LineCombine combine;
  gps::NoiseMethod method;
};

constexpr Way kWays[] = {
    {"unaware", false, 0.0, gps::LineCombine::separate, gps::NoiseMethod::splitAndWide},
    {"aware", true, 0.0, gps::LineCombine::separate, gps::NoiseMethod::splitAndWide},
    {"aware_pause_2_s", true, 2.0, gps::LineCombine::separate, gps::NoiseMethod::splitAndWide},
    {"aware_pause_5_s", true, 5.0, gps::LineCombine::separate, gps::NoiseMethod::splitAndWide},
    {"joint_unaware", false, 0.0, gps::LineCombine::joint, gps::NoiseMethod::splitAndWide},
    {"joint_aware", true, 0.0, gps::LineCombine::joint, gps::NoiseMethod::splitAndWide},
    {"joint_aware_pause_2_s", true, 2.0, gps::LineCombine::joint, gps::NoiseMethod::splitAndWide},
    {"method1_unaware", false, 0.0, gps::LineCombine::separate, gps::NoiseMethod::refuse},
    {"method1_aware", true, 0.0, gps::LineCombine::separate, gps::NoiseMethod::refuse},
    {"method1_aware_pause_2_s", true, 2.0, gps::LineCombine::separate, gps::NoiseMethod::refuse},
};

std::vector<Listener> listeners(const gps::GpsParams& params) {
  std::vector<Listener> all;
  for (const Way& way : kWays) {
    gps::GpsParams other = params;
    other.stuck.use = way.aware;
    other.stuck.pauseSeconds = way.pause;
    other.line.combine = way.combine;
    other.modes.noiseMethod = way.method;
    all.emplace_back(way.name, other, Hearing{});
  }
  return all;
}

class Watch {
 public:
  explicit Watch(const gps::GpsParams& params)
      : listeners_(listeners(params)), tracks_(listeners_.size() + 1) {}

  void frame(const WatchedFrame& frame, bool scrum) {
    const double time = frame.input.time.seconds();
    const WorldModel& own = frame.output.world;
    tracks_[0].frame(time, scrum, own, poseError(own, frame.truth));
    judge(scrum, time, own.stuck > 0.0, frame.input.motion.effort > 0.0);
    for (std::size_t i = 0; i < listeners_.size(); ++i) {
      const WorldModel& world = listeners_[i].hear(frame);
      tracks_[i + 1].frame(time, scrum, world, poseError(world, frame.truth));
    }
  }
  Json json() {
    Json tracks;
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
      tracks_[i].finish();
      tracks[i == 0 ? "own" : listeners_[i - 1].name()] = tracks_[i].json();
    }
    return {{"tracks", tracks}, {"held", held_}, {"free", free_}};
  }

 private:
  // Hits and false alarms, less the step after a change that the effort is a mean over.
  void judge(bool scrum, double time, bool stuck, bool walks) {
    if (scrum != scrum_) changed_ = time;
    scrum_ = scrum;
    if (walks && time - changed_ > kStep) (scrum ? held_ : free_).push_back(stuck ? 1.0 : 0.0);
  }

  std::vector<Listener> listeners_;
  std::vector<Track> tracks_;
  bool scrum_ = false;
  double changed_ = 0.0;
  std::vector<double> held_;  // 1 where the frame was thought stuck
  std::vector<double> free_;
};

Status playScrum(const Scrum& scrum, Watch& watch, LocaliseMatch& match) {
  Status done = match.world().hold(0, scrum.held);
  const double share = kSlice / scrum.seconds;
  double time = match.world().time().seconds();
  const double end = time + scrum.seconds;
  while (done && time < end) {
    done = match.world().shove(0, scrum.push * share, scrum.turn * share);
    time += kSlice;
    if (done) done = match.play(time, [&](const WatchedFrame& f) { watch.frame(f, true); });
  }
  return done ? match.world().hold(0, 0.0) : done;
}

Expected<Json> oneMatch(const ExperimentOptions& options, int number) {
  const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(number);
  const auto config = agentConfig(options);
  if (!config) return Error{config.error()};
  Watch watch(config->gps);
  LocaliseMatch match(*config, cli::defaultScripts(), seed);
  Random random(seed ^ 0x5c4a11ULL);
  const auto calm = [&](double seconds) {
    const double until = match.world().time().seconds() + seconds;
    return match.play(until, [&](const WatchedFrame& frame) { watch.frame(frame, false); });
  };
  Status done = calm(kFirst);
  for (int i = 0; i < kScrums && done; ++i) {
    done = playScrum(drawn(random), watch, match);
    if (done) done = calm(kCalm);
  }
  if (!done) return Error{"seed " + std::to_string(seed) + ": " + done.error()};
  return watch.json();
}

std::vector<double> joined(const std::vector<Json>& parts, const char* key) {
  std::vector<double> all;
  for (const Json& part : parts)
    for (const Json& value : part[key]) all.push_back(value.get<double>());
  return all;
}

Json summary(const std::vector<Json>& tracks) {
  ErrorTrack inside;
  ErrorTrack after;
  for (const Json& track : tracks) {
    inside.add(track["inside"]);
    after.add(track["after"]);
  }
  const std::vector<double> recovery = joined(tracks, "recovery");
  const std::vector<double> error = joined(tracks, "error");
  return {{"recovery_mean_s", mean(recovery)},
          {"recovery_p90_s", percentile(recovery, 0.9)},
          {"end_error_mean_cm", mean(error)},
          {"end_error_p90_cm", percentile(error, 0.9)},
          {"end_sd_mean_cm", mean(joined(tracks, "sd"))},
          {"inside", inside.summary()},
          {"after", after.summary()}};
}

}  // namespace

Expected<Json> scrums(const ExperimentOptions& options) {
  const auto matches = runApart(
      options.trials, [&](int number) { return oneMatch(options, number); }, options.progress);
  if (!matches) return Error{matches.error()};
  Json figures{{"scrums", kScrums * options.trials},
               {"hit_rate", mean(joined(*matches, "held"))},
               {"false_rate", mean(joined(*matches, "free"))}};
  for (const auto& [name, unused] : (*matches)[0]["tracks"].items()) {
    std::vector<Json> tracks;
    for (const Json& match : *matches) tracks.push_back(match["tracks"][name]);
    figures[name] = summary(tracks);
  }
  return figures;
}

}  // namespace kelpie::experiments
