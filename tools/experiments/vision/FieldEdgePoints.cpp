// SPDX-License-Identifier: Apache-2.0
// The fit alone, on made-up points: checklist E4. 24 points with 1 px noise, some of them wrong;
// success = within 6 px at both image borders, whatever number of edges is claimed.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "robot/core/Random.h"
#include "tools/experiments/baselines/CorrelationEdge.h"
#include "tools/experiments/vision/FieldEdgeParts.h"
#include "vision/Scene.h"
#include "vision/edge/FieldEdge.h"

namespace kelpie::experiments {
namespace {

constexpr int kPoints = 24;
constexpr double kNoise = 1.0;    // px
constexpr double kAllowed = 6.0;  // px
constexpr double kMargin = 10.0;  // px that the edge stays inside the image's rows
constexpr double kSteepest = 0.5;

struct Line {
  double slope = 0.0;
  double offset = 0.0;
  double at(double x) const { return offset + slope * x; }
};

// A line whose both ends are in the image.
Line randomLine(Random& random, double slope) {
  const double half = std::fabs(slope) * kImageWidth / 2;
  const double middle = random.uniform(kMargin + half, kImageHeight - kMargin - half);
  return {slope, middle - slope * kImageWidth / 2};
}

double columnOf(int i) { return (i + 0.5) * kImageWidth / kPoints; }

using Wrong = std::array<bool, kPoints>;

// Exactly this share of the points, anywhere.
Wrong anywhere(Random& random, double share) {
  Wrong wrong{};
  std::fill_n(wrong.begin(), std::lround(share * kPoints), true);
  for (std::size_t i = 0; i + 1 < kPoints; ++i)
    std::swap(wrong[i], wrong[i + random.index(static_cast<std::uint32_t>(kPoints - i))]);
  return wrong;
}

// The same share on neighbouring columns.
Wrong together(Random& random, double share) {
  Wrong wrong{};
  const auto count = static_cast<std::uint32_t>(std::lround(share * kPoints));
  const std::uint32_t from = random.index(kPoints - count + 1);
  std::fill_n(wrong.begin() + from, count, true);
  return wrong;
}

vision::EdgeFeatures uniformPoints(Random& random, const Line& line, double share) {
  vision::EdgeFeatures points;
  const Wrong wrong = anywhere(random, share);
  for (int i = 0; i < kPoints; ++i) {
    const double x = columnOf(i);
    const double row = wrong[static_cast<std::size_t>(i)] ? random.uniform(0.0, kImageHeight)
                                                          : line.at(x) + kNoise * random.gaussian();
    points.push_back({{x, row}, false, 1.0});
  }
  return points;
}

// An obstacle's straight border, over all its width 5 to 60 px off the edge: below it, since the
// obstacle stands on the carpet; `beyond` puts it above, as something green behind the carpet
// would.
Line obstacleLine(Random& random, const Line& edge, double from, double to, bool beyond) {
  const double left = random.uniform(5.0, 60.0);
  const double right = maths::clamp(left + random.uniform(-0.3, 0.3) * (to - from), 5.0, 60.0);
  const double side = beyond ? -1.0 : 1.0;
  const double slope = edge.slope + side * (right - left) / (to - from);
  return {slope, edge.at(from) + side * left - slope * from};
}

// Half of the image covered, or less (thesis 2006 figure 3.5).
vision::EdgeFeatures coveredPoints(Random& random, const Line& line, double share, bool beyond) {
  vision::EdgeFeatures points;
  const Wrong wrong = together(random, share);
  const auto first = static_cast<int>(std::find(wrong.begin(), wrong.end(), true) - wrong.begin());
  const double from = columnOf(first);
  const Line border = obstacleLine(random, line, from, from + share * kImageWidth, beyond);
  for (int i = 0; i < kPoints; ++i) {
    const double x = columnOf(i);
    const double row = wrong[static_cast<std::size_t>(i)] ? border.at(x) : line.at(x);
    points.push_back({{x, row + kNoise * random.gaussian()}, false, 1.0});
  }
  return points;
}

using Fit = std::function<std::optional<Line>(const vision::EdgeFeatures&, std::uint32_t seed)>;

std::optional<Line> ours(const vision::EdgeFeatures& points, std::uint32_t seed) {
  vision::FieldEdgeParams params;
  params.seed = seed;
  VisionCounts counts;
  const auto edges = vision::edgeRows(vision::fitEdgeLines(points, {}, params, counts));
  if (edges.empty()) return std::nullopt;
  const double left = vision::fieldEdgeRow(edges, 0.0);
  return Line{(vision::fieldEdgeRow(edges, kImageWidth) - left) / kImageWidth, left};
}

Fit thesis(int points, baselines::EdgeFitness fitness) {
  return [points, fitness](const vision::EdgeFeatures& features,
                           std::uint32_t seed) -> std::optional<Line> {
    baselines::CorrelationParams params;
    params.points = points;
    params.fitness = fitness;
    params.seed = seed;
    const auto line = baselines::correlationEdge(features, params);
    if (!line) return std::nullopt;
    return Line{line->slope, line->offset};
  };
}

bool succeeds(const std::optional<Line>& found, const Line& truth) {
  return found && std::fabs(found->at(0.0) - truth.at(0.0)) <= kAllowed &&
         std::fabs(found->at(kImageWidth) - truth.at(kImageWidth)) <= kAllowed;
}

using Scatter = std::function<vision::EdgeFeatures(Random&, const Line&)>;

// Share of successes. Slope: fixed, or drawn up to kSteepest to either side when not given.
double successRate(const Fit& fit, const Scatter& scatter, std::optional<double> slope,
                   const Request& request) {
  Random random(request.seed);
  int good = 0;
  for (int trial = 0; trial < request.trials; ++trial) {
    const Line truth = randomLine(random, slope ? *slope : random.uniform(-kSteepest, kSteepest));
    const auto points = scatter(random, truth);
    good += succeeds(fit(points, static_cast<std::uint32_t>(trial)), truth) ? 1 : 0;
  }
  return static_cast<double>(good) / request.trials;
}

struct Slope {
  const char* name;
  std::optional<double> value;
};
const std::array<Slope, 4> kSlopes = {
    {{"slope_000", 0.0}, {"slope_002", 0.02}, {"slope_010", 0.1}, {"slope_any", std::nullopt}}};
constexpr std::array<int, 5> kShares = {0, 10, 20, 30, 50};  // %

Json uniformTable(const Fit& fit, const Request& request) {
  Json table;
  for (const Slope& slope : kSlopes) {
    Json row;
    for (const int percent : kShares) {
      const Scatter scatter = [percent](Random& random, const Line& line) {
        return uniformPoints(random, line, percent / 100.0);
      };
      row["success_" + std::to_string(percent) + "_rate"] =
          successRate(fit, scatter, slope.value, request);
    }
    table[slope.name] = row;
  }
  return table;
}

// The worst slope and the mean over the slopes for each share of wrong points.
void summarise(const Json& table, Json& out) {
  for (const int percent : kShares) {
    const std::string key = "success_" + std::to_string(percent);
    double worst = 1.0;
    double sum = 0.0;
    for (const auto& row : table) {
      const double rate = row[key + "_rate"].get<double>();
      worst = std::min(worst, rate);
      sum += rate;
    }
    out[key + "_worst_rate"] = worst;
    out[key + "_mean_rate"] = sum / static_cast<double>(table.size());
  }
}

Json coveredTable(const Fit& fit, const Request& request) {
  Json table;
  for (const Slope& slope : kSlopes) {
    Json row;
    for (const int percent : {30, 50}) {
      for (const bool beyond : {false, true}) {
        const Scatter scatter = [=](Random& random, const Line& line) {
          return coveredPoints(random, line, percent / 100.0, beyond);
        };
        row[std::string(beyond ? "green_beyond_" : "obstacle_") + std::to_string(percent) +
            "_rate"] = successRate(fit, scatter, slope.value, request);
      }
    }
    table[slope.name] = row;
  }
  return table;
}

}  // namespace

Json fieldEdgePoints(const Request& request) {
  const Json table = uniformTable(ours, request);
  Json out;
  summarise(table, out);
  out["uniform"] = table;
  out["covered"] = coveredTable(ours, request);
  using baselines::EdgeFitness;
  const Fit r8 = thesis(8, EdgeFitness::correlation);
  const Fit r2 = thesis(2, EdgeFitness::correlation);
  const Fit count2 = thesis(2, EdgeFitness::count);
  out["thesis_r_n8"] = uniformTable(r8, request);
  out["thesis_r_n2"] = uniformTable(r2, request);
  out["count_n2"] = uniformTable(count2, request);
  out["thesis_r_n8_covered"] = coveredTable(r8, request);
  out["count_n2_covered"] = coveredTable(count2, request);
  return out;
}

}  // namespace kelpie::experiments
