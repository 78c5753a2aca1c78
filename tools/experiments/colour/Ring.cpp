// SPDX-License-Identifier: Apache-2.0
// The ring learner against a ring effect that it does not know: sheets of six colours, made with
// the simulator's polynomial (its own code, thesis 2006 section 2.3.2) and noise of 2 grey levels;
// every second trial with each channel's centre displaced. Also what the correction does to a white
// sheet, to the genuine frames, and how large the tables of
// thesis 2006 section 2.4 are.
#include <cmath>
#include <memory>

#include "robot/core/Random.h"
#include "tools/calibrate/ring/RingLearner.h"
#include "tools/calibrate/ring/RingSimplex.h"
#include "tools/experiments/colour/GenuineFrames.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/harness/Trials.h"
#include "tools/sim/camera/Artefacts.h"
#include "tools/sim/camera/Colours.h"
#include "vision/colour/RingTable.h"

namespace kelpie::experiments {
namespace {

using calibrate::Centre;
using calibrate::RingFit;
using calibrate::Sheet;

constexpr double kNoise = 2.0;  // grey levels, as checklist A-2.3.2.4
constexpr int kMaxDistance = 132;
constexpr std::array<const char*, 3> kNames = {"y", "cr", "cb"};
// Thesis 2006 section 2.3.2 names blue, green, dark blue, pink, white and yellow.
constexpr std::array<sim::Colour, 6> kPapers = {{sim::colours::kBlue, sim::colours::kGreen,
                                                 sim::colours::kRobotBlue, sim::colours::kPink,
                                                 sim::colours::kWhite, sim::colours::kYellow}};
constexpr std::size_t kWhitePaper = 4;

using Centres = std::array<Centre, 3>;

std::array<double, 3> channels(sim::Colour c) {
  return {static_cast<double>(c.y), static_cast<double>(c.cr), static_cast<double>(c.cb)};
}

std::uint8_t byteOf(double value) {
  return static_cast<std::uint8_t>(maths::clamp(std::floor(value + 0.5), 0.0, 255.0));
}

Image sheetImage(sim::Colour paper, const Centres& centres, Random& random) {
  Image image;
  const auto colour = channels(paper);
  const std::array<Image::Plane*, 3> planes{&image.y, &image.cr, &image.cb};
  for (std::size_t c = 0; c < 3; ++c)
    for (int py = 0; py < kImageHeight; ++py)
      for (int px = 0; px < kImageWidth; ++px) {
        const double d = calibrate::distanceTo(centres[c], {px, py, {}});
        (*planes[c])[Image::at(px, py)] =
            byteOf(sim::ringValue(c, colour[c], d) + random.gaussian(0.0, kNoise));
      }
  return image;
}

// Largest difference of the learnt F to the true one over all distances and the values given.
double worstError(const vision::RingChannel& learnt, std::size_t channel, int low, int high) {
  double worst = 0.0;
  for (int d = 0; d <= kMaxDistance; ++d)
    for (int v = low; v <= high; ++v)
      worst =
          std::fmax(worst, std::fabs(ringDistort(learnt, v, d) - sim::ringValue(channel, v, d)));
  return worst;
}

struct Figures {
  std::array<double, 3> spanned{};   // largest error of F, values between the papers' own
  std::array<double, 3> anywhere{};  // and over 0..255
  std::array<double, 3> before{};
  std::array<double, 3> after{};
  std::array<double, 3> simplexRatio{};
  double centrePx = 0.0;  // largest error of a centre
  double chroma = 0.0;    // spread of a corrected white sheet's ring means of Cr or Cb
  double fallOfSd = 1.0;  // of Y over a white sheet, smallest
};

void keepLarger(double& largest, double value) { largest = std::fmax(largest, value); }

void addFit(const RingFit& fit, const Centres& truth, Figures& worst) {
  for (std::size_t c = 0; c < 3; ++c) {
    double low = 255.0;
    double high = 0.0;
    for (const auto& paper : kPapers) {
      low = std::fmin(low, channels(paper)[c]);
      high = std::fmax(high, channels(paper)[c]);
    }
    const auto& model = fit.model.channel[c];
    keepLarger(worst.spanned[c],
               worstError(model, c, static_cast<int>(low), static_cast<int>(high)));
    keepLarger(worst.anywhere[c], worstError(model, c, 0, 255));
    keepLarger(worst.before[c], fit.channel[c].before);
    keepLarger(worst.after[c], fit.channel[c].after);
    const auto check = calibrate::checkWithSimplex(fit, c);
    keepLarger(worst.simplexRatio[c], check.squares / check.simplex);
    keepLarger(worst.centrePx, std::hypot(fit.channel[c].centre[0] - truth[c][0],
                                          fit.channel[c].centre[1] - truth[c][1]));
  }
}

void addWhite(const Image& white, const vision::RingTable& table, Figures& worst) {
  const vision::RingDistances distances;
  std::array<calibrate::RingMeans, 2> chroma;
  Values raw, corrected;
  for (const auto& pixel : calibrate::wholeSheet("white", white, 1).pixels) {
    const auto place = distances(pixel.px, pixel.py, table.centre);
    const Yuv c = table(pixel.value, place);
    raw.push_back(pixel.value.y);
    corrected.push_back(c.y);
    if (place.cr <= 120) chroma[0].add(place.cr, c.cr);
    if (place.cb <= 120) chroma[1].add(place.cb, c.cb);
  }
  for (const auto& rings : chroma) keepLarger(worst.chroma, rings.spread());
  const double fall = 1.0 - standardDeviation(corrected) / standardDeviation(raw);
  worst.fallOfSd = std::fmin(worst.fallOfSd, fall);
}

Status runTrial(Random& random, bool displaced, Figures& worst) {
  Centres centres;
  for (auto& centre : centres) {
    centre = {kImageWidth / 2.0, kImageHeight / 2.0};
    if (displaced) {
      centre[0] += static_cast<double>(random.index(21)) - 10.0;
      centre[1] += static_cast<double>(random.index(21)) - 10.0;
    }
  }
  std::vector<Sheet> sheets;
  Image white;
  for (std::size_t i = 0; i < kPapers.size(); ++i) {
    const Image image = sheetImage(kPapers[i], centres, random);
    if (i == kWhitePaper) white = image;
    sheets.push_back(calibrate::wholeSheet("sheet", image, 2));
  }
  const auto fit = calibrate::learnRing(sheets, {});
  if (!fit) return Error{fit.error()};
  addFit(*fit, centres, worst);
  addWhite(white, buildRingTable(fit->model), worst);
  return Done{};
}

Json perChannel(const std::array<double, 3>& values) {
  Json out;
  for (std::size_t c = 0; c < 3; ++c) out[kNames[c]] = values[c];
  return out;
}

// Thesis 2006 section 2.4, in cells and bytes (checklist E2); the built one has the distances that
// a displaced centre needs, two bytes a centre beside it.
Json tableSizes() {
  constexpr double kJoint = 1.0 * kImagePixels * 256 * 256 * 256;
  return {{"joint_cells", kJoint},
          {"joint_bytes", 3.0 * kJoint},
          {"per_position_cells", kImagePixels * 768},
          {"per_position_bytes", kImagePixels * 768},
          {"per_distance_cells", vision::kRingDistances * 768},
          {"per_distance_bytes", sizeof(vision::RingTable)},
          {"distance_map_bytes", sizeof(vision::RingDistances)}};
}

// Correction by rounded distance against correction by exact position: what the small table costs.
Json roundingCost() {
  std::array<double, 3> worst{};
  const auto model = vision::ringModel2006();
  for (int py = kImageHeight / 2; py < kImageHeight; ++py)
    for (int px = kImageWidth / 2; px < kImageWidth; ++px) {
      const double d = std::hypot(px + 0.5 - kImageWidth / 2.0, py + 0.5 - kImageHeight / 2.0);
      for (std::size_t c = 0; c < 3; ++c)
        for (const double v : {0.0, 255.0}) {
          const double raw = ringDistort(model.channel[c], v, d);
          keepLarger(worst[c],
                     std::fabs(ringCorrect(model.channel[c], raw, std::floor(d + 0.5)) - v));
        }
    }
  return perChannel(worst);
}

Expected<Json> ring(const Request& request) {
  Random random(request.seed);
  Figures centred, displaced;
  const Status learned = eachTrial(request, [&](const Trial&) {
    const Status done = runTrial(random, false, centred);
    return done ? runTrial(random, true, displaced) : done;
  });
  if (!learned) return Error{learned.error()};
  Json out;
  for (const bool away : {false, true}) {
    const Figures& f = away ? displaced : centred;
    out[away ? "displaced" : "centred"] = {
        {"f_error_levels", perChannel(f.spanned)},
        {"f_error_all_values_levels", perChannel(f.anywhere)},
        {"residual_before_levels", perChannel(f.before)},
        {"residual_after_levels", perChannel(f.after)},
        {"squares_over_simplex_ratio", perChannel(f.simplexRatio)},
        {"centre_error_px", f.centrePx},
        {"white_chroma_spread_levels", f.chroma},
        {"white_y_sd_fall_share", f.fallOfSd}};
  }
  out["table_sizes"] = tableSizes();
  out["rounded_distance_cost_levels"] = roundingCost();
  out["genuine_frames"] = genuineFrames();
  return out;
}

const Registration kRing(
    "ring", "the ring learner on seeded sheets: errors of F and centres; genuine frames",
    {Option::trials, Option::seed}, 2, ring);

}  // namespace
}  // namespace kelpie::experiments
