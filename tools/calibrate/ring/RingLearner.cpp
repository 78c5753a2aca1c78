// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/ring/RingLearner.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "robot/core/Maths.h"
#include "tools/calibrate/Quantile.h"

namespace kelpie::calibrate {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kFarthest = 132.0;  // px; distances enter as shares of it
constexpr double kTypical = 100.0;   // grey level at which a gain's coefficient counts one for one
constexpr Index kCoefficients = 6;
constexpr int kHuberRounds = 4;
constexpr int kTukeyRounds = 6;
constexpr double kHuber = 1.345;         // standard deviations; 95 % efficiency for normal noise
constexpr double kTukey = 4.685;         // the same
constexpr double kMinScale = 0.5;        // grey levels; bytes are rounded
constexpr std::size_t kSearchEvery = 8;  // of the pixels; a thousand of each sheet place the centre
constexpr std::size_t kFewestPixels = 200;
constexpr std::array<const char*, 3> kChannels = {"Y", "Cr", "Cb"};

struct Observation {
  double t = 0.0;  // distance over kFarthest
  double value = 0.0;
  Index sheet = 0;
};
using Observations = std::vector<Observation>;

// Unknowns: 100 a1, b1, 100 a2, b2, 100 a3, b3 for t, then the sheets' colours.
double gainOf(const VectorXd& p, double t) {
  return 1.0 + ((p[0] * t + p[2]) * t + p[4]) * t / kTypical;
}
double offsetOf(const VectorXd& p, double t) { return ((p[1] * t + p[3]) * t + p[5]) * t; }
double residual(const VectorXd& p, const Observation& o) {
  return gainOf(p, o.t) * p[kCoefficients + o.sheet] + offsetOf(p, o.t) - o.value;
}

Observations observe(const std::vector<Sheet>& sheets, std::size_t channel, const Centre& centre,
                     std::size_t every) {
  Observations out;
  for (std::size_t s = 0; s < sheets.size(); ++s)
    for (std::size_t i = 0; i < sheets[s].pixels.size(); i += every) {
      const SheetPixel& pixel = sheets[s].pixels[i];
      out.push_back({distanceTo(centre, pixel) / kFarthest,
                     static_cast<double>(channelOf(pixel.value, channel)), static_cast<Index>(s)});
    }
  return out;
}

// Normal equations of one Gauss-Newton step; only the row of a pixel's own sheet is touched.
struct Normal {
  Eigen::MatrixXd left;
  VectorXd right;

  explicit Normal(Index unknowns)
      : left(Eigen::MatrixXd::Identity(unknowns, unknowns) * 1e-9),
        right(VectorXd::Zero(unknowns)) {}

  void add(const VectorXd& p, double t, double colour, Index own, double error, double weight) {
    const double v = colour / kTypical;
    const double t2 = t * t;
    const double t3 = t2 * t;
    Eigen::Matrix<double, kCoefficients, 1> j;
    j << v * t3, t3, v * t2, t2, v * t, t;
    left.topLeftCorner<kCoefficients, kCoefficients>() += weight * j * j.transpose();
    right.head<kCoefficients>() -= weight * error * j;
    if (own < 0) return;
    const double g = gainOf(p, t);
    left.col(own).head<kCoefficients>() += weight * g * j;
    left.row(own).head<kCoefficients>() += weight * g * j.transpose();
    left(own, own) += weight * g * g;
    right[own] -= weight * g * error;
  }
};

// Pulls F towards the published one at three values and four distances: with fewer than three the
// cubic through them would be free in between.
void addPrior(Normal& normal, const VectorXd& p, std::size_t channel, double weight) {
  const vision::RingChannel published = vision::ringModel2006().channel[channel];
  for (const double value : {40.0, 120.0, 200.0})
    for (const double t : {0.25, 0.5, 0.75, 1.0}) {
      const double error =
          gainOf(p, t) * value + offsetOf(p, t) - ringDistort(published, value, t * kFarthest);
      normal.add(p, t, value, -1, error, weight / 12.0);
    }
}

std::vector<double> residuals(const Observations& all, const VectorXd& p) {
  std::vector<double> out(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) out[i] = residual(p, all[i]);
  return out;
}

// Standard deviation by the median, which half of the pixels may not fool.
double scaleOf(const std::vector<double>& errors) {
  std::vector<double> sizes(errors.size());
  std::transform(errors.begin(), errors.end(), sizes.begin(),
                 [](double e) { return std::fabs(e); });
  return std::fmax(kMinScale, 1.4826 * quantile(sizes, 0.5));
}

double huberWeight(double e) { return std::fabs(e) <= kHuber ? 1.0 : kHuber / std::fabs(e); }
double tukeyWeight(double e) {
  const double inside = 1.0 - maths::square(e / kTukey);
  return inside <= 0.0 ? 0.0 : inside * inside;
}

struct Solution {
  VectorXd p;
  std::vector<double> weights;
};

// No ring effect; every sheet's colour is the median of its nearest tenth.
VectorXd startOf(const Observations& all, Index sheets) {
  VectorXd p = VectorXd::Zero(kCoefficients + sheets);
  for (Index s = 0; s < sheets; ++s) {
    std::vector<std::pair<double, double>> near;
    for (const auto& o : all)
      if (o.sheet == s) near.emplace_back(o.t, o.value);
    const std::size_t tenth = std::max<std::size_t>(1, near.size() / 10);
    std::sort(near.begin(), near.end());
    std::vector<double> values;
    for (std::size_t i = 0; i < tenth && i < near.size(); ++i) values.push_back(near[i].second);
    std::sort(values.begin(), values.end());
    p[kCoefficients + s] = values[values.size() / 2];
  }
  return p;
}

void solveOnce(const Observations& all, std::size_t channel, double priorShare, Solution& s) {
  Normal normal(s.p.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (s.weights[i] <= 0.0) continue;
    const Index own = kCoefficients + all[i].sheet;
    normal.add(s.p, all[i].t, s.p[own], own, residual(s.p, all[i]), s.weights[i]);
  }
  if (priorShare > 0.0)
    addPrior(normal, s.p, channel, priorShare * static_cast<double>(all.size()));
  s.p += normal.left.ldlt().solve(normal.right);
}

Solution solve(const Observations& all, Index sheets, std::size_t channel, double priorShare) {
  Solution s{startOf(all, sheets), std::vector<double>(all.size(), 1.0)};
  for (int round = 0; round < kHuberRounds + kTukeyRounds; ++round) {
    const auto errors = residuals(all, s.p);
    const double scale = scaleOf(errors);
    for (std::size_t i = 0; i < all.size(); ++i)
      s.weights[i] =
          round < kHuberRounds ? huberWeight(errors[i] / scale) : tukeyWeight(errors[i] / scale);
    solveOnce(all, channel, priorShare, s);
  }
  return s;
}

// Mean squared residual, each counted as three standard deviations at most.
double costAt(const std::vector<Sheet>& sheets, std::size_t channel, const Centre& centre,
              double priorShare, double scale) {
  const auto all = observe(sheets, channel, centre, kSearchEvery);
  const auto s = solve(all, static_cast<Index>(sheets.size()), channel, priorShare);
  double sum = 0.0;
  for (const auto& o : all)
    sum += std::fmin(maths::square(residual(s.p, o)), maths::square(3.0 * scale));
  return sum / static_cast<double>(all.size());
}

constexpr Centre kImageCentre = {kImageWidth / 2.0, kImageHeight / 2.0};

bool allowed(const Centre& c) {
  return std::fabs(c[0] - kImageCentre[0]) <= vision::kMaxCentreOffset &&
         std::fabs(c[1] - kImageCentre[1]) <= vision::kMaxCentreOffset;
}

// Pattern search: four neighbours at 4, 2, 1 px; the cost has one valley. Whole pixels, as the
// model has them: a half one is rounded a pixel away, which costs Y 1.7 levels in a corner.
Centre findCentre(const std::vector<Sheet>& sheets, std::size_t channel, double priorShare) {
  const auto all = observe(sheets, channel, kImageCentre, kSearchEvery);
  const auto first = solve(all, static_cast<Index>(sheets.size()), channel, priorShare);
  const double scale = scaleOf(residuals(all, first.p));
  Centre best = kImageCentre;
  double min = costAt(sheets, channel, best, priorShare, scale);
  for (double step = 4.0; step >= 1.0;) {
    Centre next = best;
    for (const Centre& way : {Centre{1, 0}, Centre{-1, 0}, Centre{0, 1}, Centre{0, -1}}) {
      const Centre tried = {best[0] + step * way[0], best[1] + step * way[1]};
      if (!allowed(tried)) continue;
      const double cost = costAt(sheets, channel, tried, priorShare, scale);
      if (cost < min) {
        min = cost;
        next = tried;
      }
    }
    if (next == best) step /= 2.0;
    best = next;
  }
  return best;
}

vision::RingChannel coefficients(const VectorXd& p) {
  const double far2 = kFarthest * kFarthest;
  const double far3 = far2 * kFarthest;
  return {p[0] / kTypical / far3,      p[1] / far3,     p[2] / kTypical / far2, p[3] / far2,
          p[4] / kTypical / kFarthest, p[5] / kFarthest};
}

double weightedRms(const std::vector<double>& errors, const std::vector<double>& weights) {
  double sum = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    sum += weights[i] * errors[i] * errors[i];
    all += weights[i];
  }
  return all > 0.0 ? std::sqrt(sum / all) : 0.0;
}

// Each value less the weighted mean of its sheet: what the ring effect makes of an even colour.
std::vector<double> aboutMeans(const Observations& all, const std::vector<double>& weights,
                               std::size_t sheets) {
  std::vector<double> sum(sheets), weight(sheets), out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto s = static_cast<std::size_t>(all[i].sheet);
    sum[s] += weights[i] * all[i].value;
    weight[s] += weights[i];
  }
  for (const auto& o : all) {
    const auto s = static_cast<std::size_t>(o.sheet);
    out.push_back(weight[s] > 0.0 ? o.value - sum[s] / weight[s] : 0.0);
  }
  return out;
}

Centre rounded(const Centre& c) { return {std::round(c[0]), std::round(c[1])}; }

ChannelFit fitChannel(const std::vector<Sheet>& sheets, std::size_t channel,
                      const RingLearnParams& params) {
  ChannelFit fit;
  fit.centre = params.findCentre ? findCentre(sheets, channel, params.priorShare) : kImageCentre;
  const auto all = observe(sheets, channel, rounded(fit.centre), 1);
  auto s = solve(all, static_cast<Index>(sheets.size()), channel, params.priorShare);
  fit.model = coefficients(s.p);
  fit.colour.assign(s.p.data() + kCoefficients, s.p.data() + s.p.size());
  fit.after = weightedRms(residuals(all, s.p), s.weights);
  fit.before = weightedRms(aboutMeans(all, s.weights, sheets.size()), s.weights);
  fit.weights = std::move(s.weights);
  return fit;
}

// How uneven each sheet still is: the rms of its ring means, in its worst channel.
std::vector<double> unevenness(const RingFit& fit) {
  std::vector<double> worst(fit.used.size(), 0.0);
  for (std::size_t c = 0; c < 3; ++c) {
    const ChannelFit& channel = fit.channel[c];
    for (std::size_t s = 0; s < fit.used.size(); ++s) {
      RingMeans rings;
      for (const SheetPixel& pixel : fit.used[s].pixels) {
        const double d = distanceTo(rounded(channel.centre), pixel);
        const double error =
            channelOf(pixel.value, c) - ringDistort(channel.model, channel.colour[s], d);
        rings.add(d, maths::clamp(error, -20.0, 20.0));
      }
      worst[s] = std::fmax(worst[s], rings.rms());
    }
  }
  return worst;
}

// Moves the most uneven sheet to leftOut; false when all are even.
bool leaveOneOut(RingFit& fit, const RingLearnParams& params) {
  if (fit.used.size() < 3) return false;
  const auto uneven = unevenness(fit);
  auto sorted = uneven;
  std::sort(sorted.begin(), sorted.end());
  const double median = sorted[(sorted.size() - 1) / 2];
  const auto worst = std::max_element(uneven.begin(), uneven.end()) - uneven.begin();
  const double max = uneven[static_cast<std::size_t>(worst)];
  if (max <= std::fmax(params.maxUneven, params.unevenRatio * median)) return false;
  fit.leftOut.push_back(fit.used[static_cast<std::size_t>(worst)].name);
  fit.used.erase(fit.used.begin() + worst);
  return true;
}

Status enoughColours(const RingFit& fit, const RingLearnParams& params) {
  if (params.priorShare > 0.0) return Done{};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto& colours = fit.channel[c].colour;
    const auto [low, high] = std::minmax_element(colours.begin(), colours.end());
    if (*high - *low < params.minSpread)
      return Error{std::string("the sheets' ") + kChannels[c] + " spans " +
                   std::to_string(std::lround(*high - *low)) + " grey levels, at least " +
                   std::to_string(std::lround(params.minSpread)) +
                   " are needed: add sheets of other colours"};
  }
  return Done{};
}

Status evenSheets(const RingFit& fit, const RingLearnParams& params) {
  for (std::size_t c = 0; c < 3; ++c)
    if (fit.channel[c].after > params.maxResidual)
      return Error{std::string("no even sheets: ") + kChannels[c] + " is off by " +
                   std::to_string(std::lround(fit.channel[c].after)) +
                   " grey levels after the fit"};
  return Done{};
}

}  // namespace

Expected<RingFit> learnRing(const std::vector<Sheet>& sheets, const RingLearnParams& params) {
  RingFit fit;
  for (const Sheet& sheet : sheets) {
    if (sheet.pixels.size() >= kFewestPixels)
      fit.used.push_back(sheet);
    else
      fit.leftOut.push_back(sheet.name);
  }
  if (fit.used.empty()) return Error{"no sheet with 200 usable pixels"};
  if (fit.used.size() < 2 && params.priorShare <= 0.0)
    return Error{"one sheet cannot tell gain from offset: give sheets of several colours"};
  do {
    for (std::size_t c = 0; c < 3; ++c) fit.channel[c] = fitChannel(fit.used, c, params);
  } while (leaveOneOut(fit, params));
  const Status even = evenSheets(fit, params);
  if (!even) return Error{even.error()};
  const Status enough = enoughColours(fit, params);
  if (!enough) return Error{enough.error()};
  for (std::size_t c = 0; c < 3; ++c) {
    const Centre centre = rounded(fit.channel[c].centre);
    fit.model.channel[c] = fit.channel[c].model;
    fit.model.centre[c] = {static_cast<std::int32_t>(centre[0]),
                           static_cast<std::int32_t>(centre[1])};
  }
  return fit;
}

}  // namespace kelpie::calibrate
