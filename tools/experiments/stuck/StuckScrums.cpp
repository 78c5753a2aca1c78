// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/stuck/StuckScrums.h"

#include <cmath>

#include "robot/core/Random.h"
#include "tools/cli/options/Config.h"
#include "tools/experiments/harness/ChildProcesses.h"
#include "tools/experiments/pose/LocaliseFilters.h"

namespace kelpie::experiments {
namespace {

constexpr int kScrums = 8;        // a match
constexpr double kFirst = 15.0;   // s, until the pose is known
constexpr double kCalm = 15.0;    // s after each
constexpr double kSlice = 0.032;  // s between pushes
constexpr double kRecoveredCm = 30.0;
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
struct ScrumTrack {
  std::string name;
  Values recovery;   // s
  Values endErrors;  // cm
  Values endSds;     // cm
  ErrorTrack inside;
  ErrorTrack after;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("name", &ScrumTrack::name),
                     field("recovery", &ScrumTrack::recovery, "s"),
                     field("endErrors", &ScrumTrack::endErrors, "cm"),
                     field("endSds", &ScrumTrack::endSds, "cm"),
                     field("inside", &ScrumTrack::inside), field("after", &ScrumTrack::after));
  }
  void add(const ScrumTrack& other) {
    name = other.name;
    append(other.recovery, recovery);
    append(other.endErrors, endErrors);
    append(other.endSds, endSds);
    inside.add(other.inside);
    after.add(other.after);
  }
  Json summary() const {
    return {{"recovery_mean_s", mean(recovery)},
            {"recovery_p90_s", percentile(recovery, 0.9)},
            {"end_error_mean_cm", mean(endErrors)},
            {"end_error_p90_cm", percentile(endErrors, 0.9)},
            {"end_sd_mean_cm", mean(endSds)},
            {"inside", inside.summary()},
            {"after", after.summary()}};
  }
};

// All that is kept of one match, or of several.
struct ScrumRecord {
  std::vector<ScrumTrack> tracks;  // the player's own first
  Share heldNoticed;               // frames held that were thought stuck
  Share freeNoticed;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("tracks", &ScrumRecord::tracks),
                     field("heldNoticed", &ScrumRecord::heldNoticed),
                     field("freeNoticed", &ScrumRecord::freeNoticed));
  }
  void add(const ScrumRecord& other) {
    tracks.resize(other.tracks.size());
    for (std::size_t i = 0; i < tracks.size(); ++i) tracks[i].add(other.tracks[i]);
    heldNoticed.add(other.heldNoticed);
    freeNoticed.add(other.freeNoticed);
  }
};

class TrackRecorder {
 public:
  explicit TrackRecorder(std::string name) { track_.name = std::move(name); }

  void frame(double time, bool scrum, const WorldModel& world, const PoseError& error) {
    if (scrum) {
      track_.inside.add(error);
      if (!inScrum_) finish();
      inScrum_ = true;
      atEnd_ = error.cm;
      sdAtEnd_ = world.positionSd;
      return;
    }
    if (inScrum_) {
      began_ = lastFar_ = time;
      track_.endErrors.push_back(atEnd_);
      track_.endSds.push_back(sdAtEnd_);
      open_ = true;
    }
    inScrum_ = false;
    if (open_) track_.after.add(error);
    if (open_ && error.cm > kRecoveredCm) lastFar_ = time;
  }
  void finish() {
    if (open_) track_.recovery.push_back(lastFar_ - began_);
    open_ = false;
  }
  const ScrumTrack& track() const { return track_; }

 private:
  bool inScrum_ = false;
  bool open_ = false;  // between the end of a scrum and the next
  double began_ = 0.0;
  double lastFar_ = 0.0;
  double atEnd_ = 0.0;
  double sdAtEnd_ = 0.0;
  ScrumTrack track_;
};

// A localiser that listens.
struct Variant {
  const char* name;
  bool aware;
  double pause;  // s
  gps::Localise localise;
};

constexpr Variant kVariants[] = {
    {"unaware", false, 0.0, gps::step},
    {"aware", true, 0.0, gps::step},
    {"aware_pause_2_s", true, 2.0, gps::step},
    {"aware_pause_5_s", true, 5.0, gps::step},
    {"joint_unaware", false, 0.0, gps::stepJointly},
    {"joint_aware", true, 0.0, gps::stepJointly},
    {"joint_aware_pause_2_s", true, 2.0, gps::stepJointly},
    {"method1_unaware", false, 0.0, gps::stepRefusing},
    {"method1_aware", true, 0.0, gps::stepRefusing},
    {"method1_aware_pause_2_s", true, 2.0, gps::stepRefusing},
};

std::vector<Listener> listeners(const gps::GpsParams& params) {
  std::vector<Listener> all;
  for (const Variant& variant : kVariants) {
    gps::GpsParams other = params;
    other.stuck.use = variant.aware;
    other.stuck.pauseSeconds = variant.pause;
    all.emplace_back(variant.name, other, Hearing{}, variant.localise);
  }
  return all;
}

class MatchRecorder {
 public:
  explicit MatchRecorder(const gps::GpsParams& params) : listeners_(listeners(params)) {
    tracks_.emplace_back("own");
    for (const Listener& listener : listeners_) tracks_.emplace_back(listener.name());
  }

  void frame(const WatchedFrame& frame, bool scrum) {
    const double time = frame.input.time.seconds();
    const WorldModel& own = frame.output.world;
    tracks_[0].frame(time, scrum, own, poseError(own, frame.truth));
    countNoticed(scrum, frame.input.motion.effort > 0.0, time, own.stuck > 0.0);
    for (std::size_t i = 0; i < listeners_.size(); ++i) {
      const WorldModel& world = listeners_[i].hear(frame);
      tracks_[i + 1].frame(time, scrum, world, poseError(world, frame.truth));
    }
  }
  ScrumRecord record() {
    for (TrackRecorder& recorder : tracks_) {
      recorder.finish();
      record_.tracks.push_back(recorder.track());
    }
    return record_;
  }

 private:
  // Hits and false alarms, less the step after a change that the effort is a mean over.
  void countNoticed(bool scrum, bool walks, double time, bool stuck) {
    if (scrum != scrum_) changed_ = time;
    scrum_ = scrum;
    if (!walks || time - changed_ <= kStep) return;
    (scrum ? record_.heldNoticed : record_.freeNoticed).count(stuck);
  }

  std::vector<Listener> listeners_;
  std::vector<TrackRecorder> tracks_;
  ScrumRecord record_;
  bool scrum_ = false;
  double changed_ = 0.0;
};

Status playScrum(const Scrum& scrum, MatchRecorder& recorder, LocaliseMatch& match) {
  Status done = match.world().hold(0, scrum.held);
  const double share = kSlice / scrum.seconds;
  double time = match.world().time().seconds();
  const double end = time + scrum.seconds;
  while (done && time < end) {
    done = match.world().shove(0, scrum.push * share, scrum.turn * share);
    time += kSlice;
    if (done) done = match.play(time, [&](const WatchedFrame& f) { recorder.frame(f, true); });
  }
  return done ? match.world().hold(0, 0.0) : done;
}

Expected<ScrumRecord> playMatch(const Request& request, const agent::AgentConfig& config,
                                std::uint64_t seed) {
  MatchRecorder recorder(config.gps);
  LocaliseMatch match(config, cli::defaultScripts(), seed, request.randomised);
  Random random(seed ^ 0x5c4a11ULL);
  const auto calm = [&](double seconds) {
    const double until = match.world().time().seconds() + seconds;
    return match.play(until, [&](const WatchedFrame& frame) { recorder.frame(frame, false); });
  };
  Status done = calm(kFirst);
  for (int i = 0; i < kScrums && done; ++i) {
    done = playScrum(drawn(random), recorder, match);
    if (done) done = calm(kCalm);
  }
  if (!done) return Error{done.error()};
  return recorder.record();
}

}  // namespace

Expected<Json> scrums(const Request& request) {
  const auto config = agentConfig(request);
  if (!config) return Error{config.error()};
  const auto matches = trialsInChildProcesses(
      request, [&](const Trial& trial) { return playMatch(request, *config, trial.seed); });
  if (!matches) return Error{matches.error()};
  ScrumRecord all;
  for (const ScrumRecord& match : *matches) all.add(match);
  Json figures{{"scrums", kScrums * request.trials},
               {"hit_rate", all.heldNoticed.value()},
               {"false_rate", all.freeNoticed.value()}};
  for (const ScrumTrack& track : all.tracks) figures[track.name] = track.summary();
  return figures;
}

}  // namespace kelpie::experiments
