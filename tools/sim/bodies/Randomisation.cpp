// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/bodies/Randomisation.h"

#include <algorithm>

#include "robot/core/Random.h"

namespace kelpie::sim {
namespace {

struct Kind {
  const char* name;
  bool RandomisationParams::*on;
};
constexpr std::array<Kind, 16> kKinds{{{"body", &RandomisationParams::body},
                                       {"physics", &RandomisationParams::physics},
                                       {"neck", &RandomisationParams::neck},
                                       {"lens", &RandomisationParams::lens},
                                       {"shutter", &RandomisationParams::shutter},
                                       {"lag", &RandomisationParams::lag},
                                       {"tone", &RandomisationParams::tone},
                                       {"uniform", &RandomisationParams::uniform},
                                       {"tape", &RandomisationParams::tape},
                                       {"carpet", &RandomisationParams::carpet},
                                       {"light", &RandomisationParams::light},
                                       {"room", &RandomisationParams::room},
                                       {"infrared", &RandomisationParams::infrared},
                                       {"odometry", &RandomisationParams::odometry},
                                       {"brightness", &RandomisationParams::brightness},
                                       {"noise", &RandomisationParams::noise}}};

enum class Stream : std::uint64_t {
  body = 1,
  neck,
  lens,
  shutter,
  lag,
  tone,
  uniform,
  tape,
  carpet,
  light,
  room,
  physics,
  infrared,
  jointsLag,
  odometry,
  brightness,
  noise
};
constexpr std::size_t kVenue = kMaxRobots;  // where a robot's number stands otherwise

// Every kind of every robot of every match has its own numbers.
Random streamOf(const RandomisationParams& params, std::uint64_t match, std::size_t robot,
                Stream kind) {
  Random first(params.seed * 0x9e3779b97f4a7c15ULL ^ match);
  const std::uint64_t part = 100 * (robot + 1) + static_cast<std::uint64_t>(kind);
  return Random(first.next() ^ part * 0xbf58476d1ce4e5b9ULL);
}

BodyFaults drawBody(const RandomisationParams& params, Random random) {
  BodyFaults body;
  body.lean = {Angle::deg(random.gaussian(0.0, params.leanSdDeg)),
               Angle::deg(random.gaussian(0.0, params.leanSdDeg))};
  for (double& bias : body.accelerationBias) bias = random.gaussian(0.0, params.accelerationBias);
  return body;
}

NeckPlay drawPlay(const RandomisationParams& params, Random random) {
  return {Angle::deg(random.uniform(0.0, params.tiltPlayDeg)),
          Angle::deg(random.uniform(0.0, params.panPlayDeg)),
          Angle::deg(random.uniform(0.0, params.nodPlayDeg))};
}

Stride drawStride(const RandomisationParams& params, Random random) {
  Stride stride;
  stride.share = 1.0 + params.strideShare * random.uniform(-1.0, 1.0);
  stride.turn = Angle::deg(params.turnBiasDeg * random.uniform(-1.0, 1.0));
  return stride;
}

// Of the share of robots that have one.
double drawLag(double share, const RandomisationParams& params, Random random) {
  return random.chance(share) ? random.uniform(0.0, params.mostLag) : 0.0;
}

double drawReadout(const RandomisationParams& params, Random random) {
  if (random.chance(params.globalShutter)) return 0.0;
  return random.uniform(params.shortestReadout, 1.0);
}

std::array<double, 3> drawTone(const RandomisationParams& params, Random random) {
  const auto about1 = [&](double max) { return 1.0 + max * random.uniform(-1.0, 1.0); };
  const double y = about1(params.toneY);
  const double cr = about1(params.toneChroma);
  return {y, cr, about1(params.toneChroma)};
}

Uniform drawUniform(const RandomisationParams& params, Random random) {
  Uniform uniform;
  uniform.fade = random.uniform(0.0, params.fade);
  uniform.scuffs = random.uniform(0.0, params.scuffs);
  uniform.gloss = random.uniform(0.0, params.glossiest);
  return uniform;
}

NoseSensor drawNose(const RandomisationParams& params, Random random) {
  const double gain = 1.0 + params.noseGain * random.uniform(-1.0, 1.0);
  return {gain, params.noseOffset * random.uniform(-1.0, 1.0)};
}

void drawCarpet(const RandomisationParams& params, Random random, Venue& venue) {
  venue.carpet = random.uniform(params.darkestCarpet, params.brightestCarpet);
  venue.stripes.width = random.uniform(60.0, 200.0);  // cm; carpet is sold in strips of 2 m
  venue.stripes.contrast = random.uniform(0.0, params.stripeContrast);
}

SecondLight drawLight(const RandomisationParams& params, Random random) {
  SecondLight light;
  light.side = Angle::deg(random.uniform(-180.0, 180.0));
  light.strength = random.uniform(0.0, params.lightStrength);
  light.warmth = params.lightWarmth * random.uniform(-1.0, 1.0);
  return light;
}

}  // namespace

Venue drawRandomisedVenue(const RandomisationParams& params, std::uint64_t match) {
  Venue venue;
  if (params.seed == 0) return venue;
  const auto stream = [&](Stream kind) { return streamOf(params, match, kVenue, kind); };
  if (params.tape)
    venue.tapeWidth = stream(Stream::tape).uniform(params.narrowestTape, params.widestTape);
  if (params.carpet) drawCarpet(params, stream(Stream::carpet), venue);
  if (params.light) venue.light = drawLight(params, stream(Stream::light));
  if (params.brightness)
    venue.brightness = stream(Stream::brightness).uniform(params.darkest, params.brightest);
  if (params.room) venue.room = stream(Stream::room).next() | 1U;
  return venue;
}

RandomisedRobot drawRandomisedRobot(const RandomisationParams& params, std::uint64_t match,
                                    std::size_t robot) {
  RandomisedRobot drawn;
  const auto stream = [&](Stream kind) { return streamOf(params, match, robot, kind); };
  if (params.seed != 0) {
    if (params.body) drawn.body = drawBody(params, stream(Stream::body));
    if (params.physics) drawn.physics = stream(Stream::physics).next() | 1U;
    if (params.neck) drawn.body.play = drawPlay(params, stream(Stream::neck));
    if (params.lens)
      drawn.lens.focal *= 1.0 + params.focalShare * stream(Stream::lens).uniform(-1.0, 1.0);
    if (params.shutter) drawn.readout = drawReadout(params, stream(Stream::shutter));
    if (params.tone) drawn.tone = drawTone(params, stream(Stream::tone));
    if (params.uniform) drawn.uniform = drawUniform(params, stream(Stream::uniform));
    if (params.infrared) drawn.nose = drawNose(params, stream(Stream::infrared));
    if (params.noise) drawn.noise = stream(Stream::noise).uniform(0.0, params.noisiest);
    if (params.odometry) drawn.body.stride = drawStride(params, stream(Stream::odometry));
    if (params.lag) {
      drawn.lag = drawLag(params.lagging, params, stream(Stream::lag));
      drawn.jointsLag = drawLag(params.jointsLagging, params, stream(Stream::jointsLag));
    }
  }
  drawn.body.lean.tilt = drawn.body.lean.tilt + params.lean.tilt;
  drawn.body.lean.roll = drawn.body.lean.roll + params.lean.roll;
  return drawn;
}

RandomisedWorld drawRandomised(const RandomisationParams& params, std::uint64_t match,
                               std::size_t robots) {
  RandomisedWorld world;
  for (std::size_t i = 0; i < std::min(robots, kMaxRobots); ++i)
    world.robots.push_back(drawRandomisedRobot(params, match, i));
  world.venue = drawRandomisedVenue(params, match);
  return world;
}

std::vector<std::string> randomisedKinds() {
  std::vector<std::string> names;
  names.reserve(kKinds.size());
  for (const Kind& kind : kKinds) names.emplace_back(kind.name);
  return names;
}

RandomisationParams randomisationParams(std::uint64_t seed, const std::vector<std::string>& only) {
  RandomisationParams params;
  params.seed = seed;
  for (const Kind& kind : kKinds)
    params.*kind.on = only.empty() || std::find(only.begin(), only.end(), kind.name) != only.end();
  return params;
}

}  // namespace kelpie::sim
