// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/ring/RingSimplex.h"

#include <nlopt.h>

#include <cmath>
#include <memory>
#include <vector>

namespace kelpie::calibrate {
namespace {

constexpr std::size_t kEvery = 8;
constexpr double kFarthest = 132.0;
constexpr double kTypical = 100.0;
constexpr int kEvaluations = 6000;
constexpr int kStarts = 4;  // afresh from where the last one ended: a simplex may collapse early

// The simplex walks in grey levels: what each term adds to a value of 100 at distance 132.
vision::RingChannel channelAt(const double* x) {
  const double far2 = kFarthest * kFarthest;
  return {x[0] / kTypical / far2 / kFarthest,
          x[1] / far2 / kFarthest,
          x[2] / kTypical / far2,
          x[3] / far2,
          x[4] / kTypical / kFarthest,
          x[5] / kFarthest};
}

double cost(unsigned /*count*/, const double* x, double* /*gradient*/, void* data) {
  return meanSquareError(*static_cast<const std::vector<RingPixel>*>(data), channelAt(x));
}

std::vector<RingPixel> pixelsOf(const RingFit& fit, std::size_t channel) {
  const ChannelFit& known = fit.channel[channel];
  const auto& whole = fit.model.centre[channel];
  const Centre centre = {static_cast<double>(whole.column), static_cast<double>(whole.row)};
  std::vector<RingPixel> pixels;
  std::size_t at = 0;
  for (std::size_t s = 0; s < fit.used.size(); ++s)
    for (const SheetPixel& p : fit.used[s].pixels) {
      const double weight = known.weights[at++];
      if (at % kEvery == 0 && weight > 0.0)
        pixels.push_back({distanceTo(centre, p), static_cast<double>(channelOf(p.value, channel)),
                          known.colour[s], weight});
    }
  return pixels;
}

}  // namespace

double meanSquareError(const std::vector<RingPixel>& pixels, const vision::RingChannel& model) {
  double sum = 0.0;
  double all = 0.0;
  for (const RingPixel& p : pixels) {
    const double gain = ((model.a1 * p.distance + model.a2) * p.distance + model.a3) * p.distance;
    const double add = ((model.b1 * p.distance + model.b2) * p.distance + model.b3) * p.distance;
    const double error = (gain + 1.0) * p.colour + add - p.value;
    sum += p.weight * error * error;
    all += p.weight;
  }
  return sum / all;
}

SimplexCheck checkWithSimplex(const RingFit& fit, std::size_t channel) {
  auto pixels = pixelsOf(fit, channel);
  SimplexCheck check;
  check.squares = std::sqrt(meanSquareError(pixels, fit.model.channel[channel]));
  const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> simplex(
      nlopt_create(NLOPT_LN_NELDERMEAD, 6), nlopt_destroy);
  nlopt_set_min_objective(simplex.get(), cost, &pixels);
  nlopt_set_initial_step1(simplex.get(), 10.0);
  nlopt_set_maxeval(simplex.get(), kEvaluations);
  nlopt_set_xtol_rel(simplex.get(), 1e-7);
  std::array<double, 6> x{};
  double min = cost(6, x.data(), nullptr, &pixels);
  for (int i = 0; i < kStarts; ++i) nlopt_optimize(simplex.get(), x.data(), &min);
  check.simplex = std::sqrt(min);
  return check;
}

}  // namespace kelpie::calibrate
