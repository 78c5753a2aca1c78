// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/kick/KickLearner.h"

#include <fmt/format.h>

#include <cmath>

#include "robot/host/OnCores.h"

namespace kelpie::learn {
namespace {

using actuator::MotionData;

constexpr double kTicksPerFrame = 1.0 / (30.0 * kTickSeconds);

double off(Angle direction, const KickAim& aim) {
  const double over = std::fmax((direction - aim.max).deg(), (aim.min - direction).deg());
  return std::fmax(0.0, over);
}

}  // namespace

std::vector<KickStart> beforeKicks(const KickAim& aim,
                                   const std::vector<sim::PhysicsParams>& models, int places,
                                   std::uint64_t seed, BeforeKick before) {
  std::vector<KickStart> starts(models.size() * static_cast<std::size_t>(places));
  host::onCores(starts.size(), [&](std::size_t i) {
    starts[i] = beforeKick(aim, models[i % models.size()], seed + i, before);
  });
  return starts;
}

std::vector<Kicked> tryFromAll(const MotionData& motion, const KickAim& aim,
                               const std::vector<KickStart>& starts) {
  std::vector<Kicked> kicked(starts.size());
  host::onCores(starts.size(),
                [&](std::size_t i) { kicked[i] = tryKick(motion, aim.motion, starts[i]); });
  return kicked;
}

Point2<Robot> meanPlace(const std::vector<KickStart>& starts) {
  Point2<Robot> mean;
  for (const KickStart& start : starts)
    mean =
        mean + robotFromField(start.pose, start.ball) * (1.0 / static_cast<double>(starts.size()));
  return mean;
}

// Mean and standard deviation of one number.
struct Spread {
  double mean = 0.0;
  double sd = 0.0;
};
template <class Get>
Spread spreadOver(const std::vector<Kicked>& kicked, Get get) {
  Spread spread;
  const auto count = static_cast<double>(kicked.size());
  double squares = 0.0;
  for (const Kicked& kick : kicked) {
    spread.mean += get(kick) / count;
    squares += maths::square(get(kick)) / count;
  }
  spread.sd = std::sqrt(std::fmax(0.0, squares - maths::square(spread.mean)));
  return spread;
}

actuator::MotionWay wayOver(const std::vector<Kicked>& kicked) {
  const Spread forward = spreadOver(kicked, [](const Kicked& k) { return k.way.forward; });
  const Spread left = spreadOver(kicked, [](const Kicked& k) { return k.way.left; });
  const Spread turn = spreadOver(kicked, [](const Kicked& k) { return k.way.turn; });
  return {forward.mean, left.mean, Angle::rad(turn.mean), forward.sd, left.sd, Angle::rad(turn.sd)};
}

KickSpread spreadOf(const std::vector<Kicked>& kicked) {
  KickSpread spread;
  const Spread distance = spreadOver(kicked, [](const Kicked& k) { return k.distance; });
  spread.distance = distance.mean;
  spread.distanceSd = distance.sd;
  spread.way = wayOver(kicked);
  double cosSum = 0.0;
  double sinSum = 0.0;
  const auto count = static_cast<double>(kicked.size());
  for (const Kicked& kick : kicked) {
    spread.falls += kick.fell ? 1 : 0;
    spread.stayed += kick.left ? 0 : 1;
    if (!kick.left) continue;
    const maths::SinCos way = maths::sinCos(kick.direction.rad());
    cosSum += way.cos;
    sinSum += way.sin;
  }
  spread.direction = Angle::rad(maths::atan2(sinSum, cosSum));
  double off = 0.0;
  for (const Kicked& kick : kicked)
    if (kick.left) off += maths::square((kick.direction - spread.direction).rad());
  const double left = std::fmax(1.0, count - spread.stayed);
  spread.directionSd = Angle::rad(std::sqrt(off / left));
  return spread;
}

std::string spreadText(const KickSpread& spread, const MotionData& motion) {
  return fmt::format(
      "{:.0f} cm (sd {:.0f}), direction {:.1f} deg (sd {:.1f}), {:.0f} frames; {} fell, {} balls "
      "stayed",
      spread.distance, spread.distanceSd, spread.direction.deg(), spread.directionSd.deg(),
      ticksOf(motion) / kTicksPerFrame, spread.falls, spread.stayed);
}

double gainOf(const std::vector<Kicked>& kicked, const KickAim& aim, const MotionData& motion) {
  constexpr double kWorthlessOffset = 40.0;  // deg outside the aim's directions
  constexpr double kSpread = 12.0;           // deg of standard deviation that cost a whole
  constexpr double kFrame = 0.05;            // for a frame too many
  double gain = 0.0;
  const auto count = static_cast<double>(kicked.size());
  for (const Kicked& kick : kicked) {
    const double share = kick.distance / aim.distance;
    const double utility = share <= 1.0 ? share : 1.0 + (share - 1.0) / 20.0;
    gain += utility * std::fmax(0.0, 1.0 - off(kick.direction, aim) / kWorthlessOffset) / count;
    gain -= kick.fell ? 1.0 / count : 0.0;
  }
  const KickSpread spread = spreadOf(kicked);
  gain -= 0.3 * spread.distanceSd / aim.distance;
  // A ball that hardly rolls has any direction.
  const double rolls = std::fmin(1.0, spread.distance / (0.3 * aim.distance));
  gain -= rolls * std::fmin(1.0, 0.5 * spread.directionSd.deg() / kSpread);
  const double over = ticksOf(motion) / kTicksPerFrame - aim.frames;
  return gain - kFrame * std::fmax(0.0, over);
}

}  // namespace kelpie::learn
