// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/distance/CurveFit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "vision/LogOdds.h"

namespace kelpie::calibrate {
namespace {

using Eigen::Index;
using vision::KnotPlace;

// How much of the examples has a value, both kinds counting half: the positive ones are few.
using Masses = std::map<double, double>;

Masses massesOf(const std::vector<CurveExample>& examples, std::size_t fact) {
  const auto positive = static_cast<double>(std::count_if(
      examples.begin(), examples.end(), [](const CurveExample& e) { return e.positive; }));
  const double negative = static_cast<double>(examples.size()) - positive;
  Masses masses;
  for (const CurveExample& e : examples)
    masses[0.01 * std::round(100.0 * e.facts[fact])] += 0.5 / (e.positive ? positive : negative);
  return masses;
}

double quantile(const Masses& masses, double all, double share) {
  double sum = 0.0;
  for (const auto& [value, mass] : masses) {
    sum += mass;
    if (sum >= share * all) return value;
  }
  return masses.rbegin()->first;
}

// Values that many examples have are knots; the others lie where equal parts of the rest end.
std::vector<double> knotsOf(const std::vector<CurveExample>& examples, std::size_t fact,
                            std::size_t count) {
  constexpr double kRim = 0.02;
  Masses rest = massesOf(examples, fact);
  std::vector<double> knots;
  for (auto at = rest.begin(); at != rest.end();) {
    const bool heavy = at->second * static_cast<double>(count) > 1.0 && knots.size() < count;
    if (heavy) knots.push_back(at->first);
    at = heavy ? rest.erase(at) : std::next(at);
  }
  double all = 0.0;
  for (const auto& [value, mass] : rest) all += mass;
  const std::size_t left = rest.empty() ? 0 : count - knots.size();
  for (std::size_t i = 0; i < left; ++i) {
    const double part = left > 1 ? static_cast<double>(i) / static_cast<double>(left - 1) : 0.5;
    knots.push_back(quantile(rest, all, kRim + (1.0 - 2.0 * kRim) * part));
  }
  std::sort(knots.begin(), knots.end());
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
  return knots;
}

// A row for each example: the hat functions of each fact, of which two are not 0, then the
// constant.
class Design {
 public:
  Design(const std::vector<CurveExample>& examples, const std::vector<FittedCurve>& curves)
      : examples_(examples), curves_(curves) {
    for (const FittedCurve& curve : curves) {
      first_.push_back(columns_);
      columns_ += static_cast<Index>(curve.at.size());
    }
    rows_.resize(static_cast<Index>(examples.size()), columns_ + 1);
    rows_.setZero();
    for (std::size_t i = 0; i < examples.size(); ++i) fill(i);
  }

  const Eigen::MatrixXd& rows() const { return rows_; }
  Index first(std::size_t fact) const { return first_[fact]; }
  Index constant() const { return columns_; }

 private:
  void fill(std::size_t example) {
    const auto row = static_cast<Index>(example);
    for (std::size_t k = 0; k < curves_.size(); ++k) {
      const KnotPlace place = vision::placeAmong(curves_[k].at, examples_[example].facts[k]);
      const Index column = first_[k] + static_cast<Index>(place.knot);
      rows_(row, column) += 1.0 - place.share;
      if (place.share > 0.0) rows_(row, column + 1) += place.share;
    }
    rows_(row, columns_) = 1.0;
  }

  const std::vector<CurveExample>& examples_;
  const std::vector<FittedCurve>& curves_;
  std::vector<Index> first_;
  Index columns_ = 0;
  Eigen::MatrixXd rows_;
};

Eigen::VectorXd regress(const Design& design, const std::vector<CurveExample>& examples,
                        const CurveFitParams& params) {
  const Eigen::MatrixXd& rows = design.rows();
  Eigen::VectorXd ridge = Eigen::VectorXd::Constant(rows.cols(), params.ridge);
  ridge(design.constant()) = 1e-6;
  Eigen::VectorXd theta = Eigen::VectorXd::Zero(rows.cols());
  for (int step = 0; step < params.steps; ++step) {
    const Eigen::VectorXd odds = rows * theta;
    Eigen::VectorXd slope(rows.rows());
    Eigen::VectorXd curvature(rows.rows());
    for (Index i = 0; i < rows.rows(); ++i) {
      const CurveExample& e = examples[static_cast<std::size_t>(i)];
      const double p = 1.0 / (1.0 + std::exp(-odds(i)));
      slope(i) = e.weight * (p - (e.positive ? 1.0 : 0.0));
      curvature(i) = e.weight * std::max(p * (1.0 - p), 1e-9);
    }
    const Eigen::VectorXd gradient = rows.transpose() * slope + ridge.cwiseProduct(theta);
    Eigen::MatrixXd hessian = rows.transpose() * curvature.asDiagonal() * rows;
    hessian.diagonal() += ridge;
    const Eigen::VectorXd change = hessian.ldlt().solve(gradient);
    theta -= change;
    if (change.cwiseAbs().maxCoeff() < 1e-6) break;
  }
  return theta;
}

// Moves each curve.s average over the negative examples into the prior.
void centre(const std::vector<CurveExample>& examples, CurveFit& fit) {
  for (std::size_t k = 0; k < fit.curves.size(); ++k) {
    double sum = 0.0;
    double count = 0.0;
    for (const CurveExample& e : examples) {
      if (e.positive) continue;
      sum += fit.curves[k](e.facts[k]);
      count += 1.0;
    }
    const double mean = count > 0.0 ? sum / count : 0.0;
    for (double& value : fit.curves[k].logOdds) value -= mean;
    fit.prior += mean;
  }
}

}  // namespace

double FittedCurve::operator()(double value) const {
  return at.empty() ? 0.0 : vision::valueAt(logOdds, vision::placeAmong(at, value));
}

double CurveFit::operator()(const std::vector<double>& facts) const {
  double sum = prior;
  for (std::size_t k = 0; k < curves.size(); ++k) sum += curves[k](facts[k]);
  return sum;
}

CurveFit fitCurves(const std::vector<CurveExample>& examples, const CurveFitParams& params) {
  CurveFit fit;
  for (std::size_t k = 0; k < examples.front().facts.size(); ++k)
    fit.curves.push_back({knotsOf(examples, k, params.knots), {}});
  const Design design(examples, fit.curves);
  const Eigen::VectorXd theta = regress(design, examples, params);
  for (std::size_t k = 0; k < fit.curves.size(); ++k)
    for (std::size_t i = 0; i < fit.curves[k].at.size(); ++i)
      fit.curves[k].logOdds.push_back(theta(design.first(k) + static_cast<Index>(i)));
  fit.prior = theta(design.constant());
  centre(examples, fit);
  return fit;
}

std::vector<double> heldOut(const std::vector<CurveExample>& examples, int folds,
                            const CurveFitParams& params) {
  std::vector<double> odds(examples.size(), 0.0);
  for (int fold = 0; fold < folds; ++fold) {
    std::vector<CurveExample> others;
    for (const CurveExample& e : examples)
      if (e.fold != fold) others.push_back(e);
    if (others.empty()) continue;
    const CurveFit fit = fitCurves(others, params);
    for (std::size_t i = 0; i < examples.size(); ++i)
      if (examples[i].fold == fold) odds[i] = fit(examples[i].facts);
  }
  return odds;
}

}  // namespace kelpie::calibrate
