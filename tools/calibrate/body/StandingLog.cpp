// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/body/StandingLog.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "tools/calibrate/LoggedFrames.h"

namespace kelpie::calibrate {
namespace {

constexpr double kMinSeconds = 5.0;
// Half of it for an image that is a frame late, half for a nod that sinks by its play.
constexpr double kRestSeconds = 0.13;
// A neck needs 0.17 s for 2.5 deg of play (tools/sim/bodies/Backlash.cpp), the image comes on top.
constexpr double kNeckSeconds = 0.25;
// A sensed angle spreads by 0.1 deg from frame to frame, a third of a pixel: the more are averaged
// the better, but not while the head is still coming to rest.
constexpr double kSettleSeconds = 0.06;
constexpr std::size_t kMinStops = 10;
constexpr std::size_t kMaxFrames = 400;

// What of a frame decides whether it may be used.
struct Moment {
  double seconds = 0.0;
  std::array<double, 3> head{};  // rad: neck tilt, pan, nod
  Stance stance;
  bool stands = false;  // neither walks nor is carried
  bool image = false;
};

// The sensed angles of a resting joint spread by 0.1 deg.
bool sameJoint(const Moment& a, const Moment& b, std::size_t joint) {
  constexpr double kRests = 0.01;  // rad
  return std::fabs(a.head[joint] - b.head[joint]) <= kRests;
}

bool sameHead(const Moment& a, const Moment& b) {
  return sameJoint(a, b, 0) && sameJoint(a, b, 1) && sameJoint(a, b, 2);
}

bool sameStance(const Stance& a, const Stance& b) {
  return std::fabs(a.shoulderHeight - b.shoulderHeight) < 0.3 &&
         std::fabs((a.bodyTilt - b.bodyTilt).deg()) < 1.0;
}

Moment momentOf(const FrameInput& input, bool image) {
  const Odometry& way = input.odometry;
  const auto& joints = input.sensors.joints;
  const auto& back = input.sensors.back;
  const bool still = std::fabs(way.forward) < 0.02 && std::fabs(way.left) < 0.02 &&
                     std::fabs(way.turn.deg()) < 0.05;
  const bool touched = std::any_of(back.begin(), back.end(), [](bool b) { return b; });
  return {
      input.time.seconds(),
      {joints[Joint::neckTilt].rad(), joints[Joint::headPan].rad(), joints[Joint::headNod].rad()},
      input.stance,
      still && !touched,
      image};
}

struct Span {
  std::size_t first = 0;
  std::size_t end = 0;
};

double secondsOf(const std::vector<Moment>& moments, const Span& span) {
  return span.end > span.first ? moments[span.end - 1].seconds - moments[span.first].seconds : 0.0;
}

Span longestStand(const std::vector<Moment>& moments) {
  Span best;
  Span now;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const bool goesOn = moments[i].stands && now.first < i &&
                        sameStance(moments[i].stance, moments[now.first].stance);
    if (!goesOn) now.first = moments[i].stands ? i : i + 1;
    now.end = i + 1;
    if (secondsOf(moments, now) > secondsOf(moments, best)) best = now;
  }
  return best;
}

// What the head does in a frame.
struct Rest {
  int stop = -1;          // -1: it moves or came to rest just now
  std::size_t began = 0;  // frame from which on it has been where it is
  bool settled = false;   // what is sensed is where it will stay
};

// Joints are sensed up to a frame before the middle of the exposure: in the last image of a rest
// the head may move already (1.3 deg seen), always towards its next place, which tilts and rolls
// all.
void dropLast(std::vector<Rest>& rests) {
  for (std::size_t i = 0; i + 1 < rests.size(); ++i) {
    if (rests[i].began == rests[i + 1].began) continue;
    rests[i].stop = -1;
    rests[i].settled = false;
  }
}

std::vector<Rest> restsOf(const std::vector<Moment>& moments, const Span& stand) {
  std::vector<Rest> rests(moments.size());
  Rest now;
  now.began = stand.first;
  std::size_t neckBegan = stand.first;
  int stops = 0;
  for (std::size_t i = stand.first; i < stand.end; ++i) {
    if (!sameJoint(moments[i], moments[neckBegan], 0)) neckBegan = i;
    if (!sameHead(moments[i], moments[now.began])) now = {-1, i, false};
    const double still = moments[i].seconds - moments[now.began].seconds;
    now.settled = still >= kSettleSeconds;
    const bool resting =
        still >= kRestSeconds && moments[i].seconds - moments[neckBegan].seconds >= kNeckSeconds;
    if (resting && now.stop < 0) now.stop = stops++;
    rests[i] = now;
  }
  dropLast(rests);
  return rests;
}

// Mean of what is sensed while the head stays where it is in frame i.
std::array<double, 3> meanHead(const std::vector<Moment>& moments, const std::vector<Rest>& rests,
                               std::size_t i) {
  std::array<double, 3> sum{};
  double count = 0.0;
  for (std::size_t k = rests[i].began; k < rests.size() && rests[k].began == rests[i].began; ++k) {
    if (!rests[k].settled) continue;
    for (std::size_t joint = 0; joint < sum.size(); ++joint) sum[joint] += moments[k].head[joint];
    count += 1.0;
  }
  for (double& s : sum) s /= count;
  return sum;
}

std::string seconds(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f s", value);
  return text.data();
}

Status checkStand(const std::string& path, const std::vector<Moment>& moments, const Span& stand) {
  if (moments.empty()) return Error{path + ": holds no frames of an agent"};
  const double longest = secondsOf(moments, stand);
  if (longest >= kMinSeconds) return Done{};
  return Error{path + ": the robot's longest stand is " + seconds(longest) + " of " +
               seconds(moments.back().seconds - moments.front().seconds) + ", " +
               seconds(kMinSeconds) + " are needed"};
}

Status checkStops(const std::string& path, const StandingLog& log) {
  const std::string found = std::to_string(log.stops);
  if (static_cast<std::size_t>(log.stops) >= kMinStops) return Done{};
  return Error{path + ": the head came to rest at " + found + " places with an image kept, " +
               std::to_string(kMinStops) + " are needed"};
}

}  // namespace

Expected<StandingLog> readStanding(const std::string& path) {
  StandingLog log;
  log.config = std::make_unique<agent::AgentConfig>();
  std::vector<Moment> moments;
  const Status read = forEachFrame(
      path, *log.config, log.lacks,
      [&](const FrameInput& input, bool image) { moments.push_back(momentOf(input, image)); });
  if (!read) return Error{read.error()};
  const Span stand = longestStand(moments);
  const Status stood = checkStand(path, moments, stand);
  if (!stood) return Error{stood.error()};
  log.seconds = secondsOf(moments, stand);
  std::vector<Rest> rests = restsOf(moments, stand);
  std::size_t usable = 0;
  for (std::size_t i = 0; i < rests.size(); ++i) {
    if (!moments[i].image) rests[i].stop = -1;
    usable += rests[i].stop >= 0 ? 1 : 0;
  }
  const std::size_t every = usable / kMaxFrames + 1;
  for (std::size_t i = 0; i < stand.end; ++i) log.pans.push_back(moments[i].head[1]);

  std::size_t at = 0;
  std::size_t met = 0;
  int last = -1;
  const Status kept =
      forEachFrame(path, *log.config, log.lacks, [&](const FrameInput& input, bool) {
        const std::size_t frame = at++;
        if (frame >= rests.size() || rests[frame].stop < 0 || met++ % every != 0) return;
        if (rests[frame].stop != last) ++log.stops;
        last = rests[frame].stop;
        log.frames.push_back({input, log.stops - 1, frame, meanHead(moments, rests, frame)});
      });
  if (!kept) return Error{kept.error()};
  const Status rested = checkStops(path, log);
  if (!rested) return Error{rested.error()};
  return Expected<StandingLog>(std::move(log));
}

}  // namespace kelpie::calibrate
