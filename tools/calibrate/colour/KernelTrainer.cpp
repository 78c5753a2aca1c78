// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/colour/KernelTrainer.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace kelpie::calibrate {
namespace {

using vision::ColourClass;
using vision::kColourClassCount;

constexpr double kMomentum = 0.9;  // share of a round's change that the next one keeps

struct Near {
  std::size_t cell = 0;
  double weight = 0.0;
};

// A cell of the table that has labels, while its bump's heights are fitted.
struct Cell {
  ColourPlace at{};
  ClassScores labelled{};  // weights of its labels
  double weight = 0.0;     // of all of them
  double step = 0.0;
  std::vector<Near> near;
  ClassScores height{};
  ClassScores change{};  // of the height in the last round
  ClassScores score{};
};

double middleOf(int value, int bits) {
  const int size = 1 << (8 - bits);
  return (value / size + 0.5) * size - 0.5;
}

ColourPlace placeOf(Yuv p, const TableBits& bits) {
  return {middleOf(p.y, bits.y), middleOf(p.cr, bits.cr), middleOf(p.cb, bits.cb)};
}

double squaredDistance(const ColourPlace& a, const ColourPlace& b) {
  return maths::square(a[0] - b[0]) + maths::square(a[1] - b[1]) + maths::square(a[2] - b[2]);
}

double bumpWeight(double squaredLevels, const KernelParams& params) {
  const double squares = squaredLevels / maths::square(params.width);
  return squares > maths::square(params.reach) ? 0.0 : std::exp(-0.5 * squares);
}

void addScores(ClassScores& sum, double weight, const ClassScores& heights) {
  for (std::size_t c = 0; c < kColourClassCount; ++c) sum[c] += weight * heights[c];
}

// What one label of each class counts, 1 on the mean of all labels; 0 where there is none.
ClassScores classWeights(const LabelledPixels& pixels, const KernelParams& params) {
  ClassScores counts{};
  for (const auto& p : pixels) counts[vision::index(p.colour)] += 1.0;
  ClassScores weights{};
  double sum = 0.0;
  for (std::size_t c = 0; c < kColourClassCount; ++c) {
    if (counts[c] == 0.0) continue;
    weights[c] = std::pow(counts[c], params.balance);
    if (c == vision::index(ColourClass::orange)) weights[c] *= params.ballCost;
    sum += counts[c] * weights[c];
  }
  for (double& w : weights) w *= static_cast<double>(pixels.size()) / sum;
  return weights;
}

std::vector<Cell> labelledCells(const LabelledPixels& pixels, const ClassScores& weights,
                                const TableBits& bits) {
  std::map<ColourPlace, Cell> cells;
  for (const auto& p : pixels) {
    const auto at = placeOf(p.value, bits);
    Cell& cell = cells[at];
    cell.at = at;
    cell.labelled[vision::index(p.colour)] += weights[vision::index(p.colour)];
    cell.weight += weights[vision::index(p.colour)];
  }
  std::vector<Cell> out;
  for (auto& entry : cells) out.push_back(entry.second);
  return out;
}

// A step divided by the sum of its cell's row converges however unevenly the labels lie.
void findNear(std::vector<Cell>& cells, const KernelParams& params) {
  for (Cell& cell : cells) {
    double sum = 0.0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double weight = bumpWeight(squaredDistance(cell.at, cells[i].at), params);
      if (weight == 0.0) continue;
      cell.near.push_back({i, weight});
      sum += weight;
    }
    cell.step = 1.0 / (cell.weight * sum + params.penalty);
  }
}

// Scores to probabilities, of the classes that have labels.
ClassScores probabilities(const ClassScores& scores, const ClassScores& weights) {
  const double max = *std::max_element(scores.begin(), scores.end());
  ClassScores out{};
  double sum = 0.0;
  for (std::size_t c = 0; c < kColourClassCount; ++c) {
    if (weights[c] > 0.0) out[c] = std::exp(scores[c] - max);
    sum += out[c];
  }
  for (double& p : out) p /= sum;
  return out;
}

void improve(std::vector<Cell>& cells, const ClassScores& weights, const KernelParams& params) {
  for (Cell& cell : cells) {
    cell.score = {};
    for (const Near& near : cell.near) addScores(cell.score, near.weight, cells[near.cell].height);
  }
  for (Cell& cell : cells) {
    const auto likely = probabilities(cell.score, weights);
    for (std::size_t c = 0; c < kColourClassCount; ++c) {
      const double slope =
          cell.labelled[c] - cell.weight * likely[c] - params.penalty * cell.height[c];
      cell.change[c] = kMomentum * cell.change[c] + cell.step * slope;
      cell.height[c] += cell.change[c];
    }
  }
}

// Of the classes that have labels.
ColourClass highest(const ClassScores& scores, const ClassScores& weights) {
  std::size_t best = 0;
  for (std::size_t c = 0; c < kColourClassCount; ++c)
    if (weights[c] > 0.0 && (weights[best] == 0.0 || scores[c] > scores[best])) best = c;
  return static_cast<ColourClass>(best);
}

}  // namespace

ColourClass TrainedClasses::operator()(Yuv p) const {
  const auto at = placeOf(p, bits);
  ClassScores scores{};
  bool labelNear = false;
  for (const ClassBump& bump : bumps) {
    const double squares = squaredDistance(at, bump.at);
    labelNear = labelNear || squares <= maths::square(params.noneBeyond);
    const double weight = bumpWeight(squares, params);
    if (weight > 0.0) addScores(scores, weight, bump.height);
  }
  return labelNear ? highest(scores, weights) : ColourClass::none;
}

TrainedClasses trainClasses(const LabelledPixels& pixels, const KernelParams& params,
                            const TableBits& bits) {
  TrainedClasses trained{bits, params, classWeights(pixels, params), {}};
  auto cells = labelledCells(pixels, trained.weights, bits);
  findNear(cells, params);
  for (int round = 0; round < params.rounds; ++round) improve(cells, trained.weights, params);
  for (const Cell& cell : cells) trained.bumps.push_back({cell.at, cell.height});
  return trained;
}

vision::ColourTable robotTable(const TrainedClasses& trained) {
  vision::ColourTable table;
  for (std::size_t cell = 0; cell < vision::ColourTable::kCells; ++cell)
    table.set(cell, trained(vision::ColourTable::centreOf(cell)));
  return table;
}

void addTo(Confusion& sum, const Confusion& more) {
  for (std::size_t i = 0; i < kColourClassCount; ++i)
    for (std::size_t j = 0; j < kColourClassCount; ++j) sum[i][j] += more[i][j];
}

double accuracyOf(const Confusion& confusion) {
  int right = 0;
  int all = 0;
  for (std::size_t i = 0; i < kColourClassCount; ++i)
    for (std::size_t j = 0; j < kColourClassCount; ++j) {
      all += confusion[i][j];
      if (i == j) right += confusion[i][j];
    }
  return all > 0 ? static_cast<double>(right) / all : 0.0;
}

double recallOf(const Confusion& confusion, ColourClass c) {
  const auto& row = confusion[vision::index(c)];
  int all = 0;
  for (const int count : row) all += count;
  return all > 0 ? static_cast<double>(row[vision::index(c)]) / all : 0.0;
}

double precisionOf(const Confusion& confusion, ColourClass c) {
  const std::size_t found = vision::index(c);
  int all = 0;
  for (const auto& row : confusion) all += row[found];
  return all > 0 ? static_cast<double>(confusion[found][found]) / all : 0.0;
}

ColourClass nearestNeighbours(const LabelledPixels& pixels, Yuv value, std::size_t count) {
  std::vector<std::pair<int, std::size_t>> near;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Yuv p = pixels[i].value;
    near.emplace_back(maths::square(p.y - value.y) + maths::square(p.cr - value.cr) +
                          maths::square(p.cb - value.cb),
                      i);
  }
  const auto end = near.begin() + static_cast<std::ptrdiff_t>(std::min(count, near.size()));
  std::partial_sort(near.begin(), end, near.end());
  std::array<int, kColourClassCount> votes{};
  for (auto it = near.begin(); it != end; ++it) ++votes[vision::index(pixels[it->second].colour)];
  return static_cast<ColourClass>(std::max_element(votes.begin(), votes.end()) - votes.begin());
}

}  // namespace kelpie::calibrate
