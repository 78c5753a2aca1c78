// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/Unlike.h"

#include <algorithm>

#include "robot/core/Random.h"

namespace kelpie::sim {
namespace {

struct Kind {
  const char* name;
  bool UnlikeParams::*on;
};
constexpr std::array<Kind, 5> kKinds{{{"body", &UnlikeParams::body},
                                      {"neck", &UnlikeParams::neck},
                                      {"lens", &UnlikeParams::lens},
                                      {"shutter", &UnlikeParams::shutter},
                                      {"lag", &UnlikeParams::lag}}};

enum class Stream : std::uint64_t { body = 1, neck, lens, shutter, lag };

// Every kind of every robot of every match has its own numbers.
Random streamOf(const UnlikeParams& params, std::uint64_t match, std::size_t robot, Stream kind) {
  Random first(params.seed * 0x9e3779b97f4a7c15ULL ^ match);
  const std::uint64_t part = 100 * (robot + 1) + static_cast<std::uint64_t>(kind);
  return Random(first.next() ^ part * 0xbf58476d1ce4e5b9ULL);
}

BodyFaults drawBody(const UnlikeParams& params, Random random) {
  BodyFaults body;
  body.lean = {Angle::deg(random.gaussian(0.0, params.leanSdDeg)),
               Angle::deg(random.gaussian(0.0, params.leanSdDeg))};
  for (double& bias : body.accelerationBias) bias = random.gaussian(0.0, params.accelerationBias);
  return body;
}

NeckPlay drawPlay(const UnlikeParams& params, Random random) {
  return {Angle::deg(random.uniform(0.0, params.tiltPlayDeg)),
          Angle::deg(random.uniform(0.0, params.panPlayDeg)),
          Angle::deg(random.uniform(0.0, params.nodPlayDeg))};
}

double drawReadout(const UnlikeParams& params, Random random) {
  if (random.chance(params.globalShutter)) return 0.0;
  return random.uniform(params.shortestReadout, 1.0);
}

}  // namespace

UnlikeRobot drawUnlikeRobot(const UnlikeParams& params, std::uint64_t match, std::size_t robot) {
  UnlikeRobot drawn;
  const auto stream = [&](Stream kind) { return streamOf(params, match, robot, kind); };
  if (params.seed != 0) {
    if (params.body) drawn.body = drawBody(params, stream(Stream::body));
    if (params.neck) drawn.body.play = drawPlay(params, stream(Stream::neck));
    if (params.lens)
      drawn.lens.focal *= 1.0 + params.focalShare * stream(Stream::lens).uniform(-1.0, 1.0);
    if (params.shutter) drawn.readout = drawReadout(params, stream(Stream::shutter));
    if (params.lag) drawn.lag = stream(Stream::lag).chance(params.lagging) ? 1.0 : 0.0;
  }
  drawn.body.lean.tilt = drawn.body.lean.tilt + params.lean.tilt;
  drawn.body.lean.roll = drawn.body.lean.roll + params.lean.roll;
  return drawn;
}

UnlikeWorld drawUnlike(const UnlikeParams& params, std::uint64_t match, std::size_t robots) {
  UnlikeWorld world;
  for (std::size_t i = 0; i < std::min(robots, kMaxRobots); ++i)
    world.robots.push_back(drawUnlikeRobot(params, match, i));
  return world;
}

std::vector<std::string> unlikeKinds() {
  std::vector<std::string> names;
  names.reserve(kKinds.size());
  for (const Kind& kind : kKinds) names.emplace_back(kind.name);
  return names;
}

UnlikeParams unlikeParams(std::uint64_t seed, const std::vector<std::string>& only) {
  UnlikeParams params;
  params.seed = seed;
  for (const Kind& kind : kKinds)
    params.*kind.on = only.empty() || std::find(only.begin(), only.end(), kind.name) != only.end();
  return params;
}

}  // namespace kelpie::sim
