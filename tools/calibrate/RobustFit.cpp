// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/RobustFit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace kelpie::calibrate {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

constexpr int kMaxSteps = 60;
constexpr double kSmallGain = 1e-9;  // share of the cost; less is converged

double square(double x) { return x * x; }

Eigen::Index at(std::size_t i) { return static_cast<Eigen::Index>(i); }

// Gradient and Gauss-Newton matrix, with the prior's part, and what each group says.
struct Normal {
  Matrix matrix;
  Vector gradient;
  Matrix groups;  // a row each
};

class Fitter {
 public:
  explicit Fitter(const FitProblem& problem) : p_(problem) {
    for (std::size_t i = 0; i < p_.unknowns.size(); ++i) {
      value_.push_back(p_.unknowns[i].start);
      if (!p_.unknowns[i].fixed) free_.push_back(i);
    }
    p_.residuals(value_, residuals_);
    cost_ = costOf(value_, residuals_);
  }

  Fit run() {
    Fit fit;
    double damping = 1e-3;
    for (int i = 0; i < kMaxSteps && !fit.converged && !free_.empty(); ++i)
      fit.converged = !improve(normal(), damping);
    fit.value = value_;
    fit.residuals = residuals_;
    fit.cost = cost_;
    fit.sd.assign(value_.size(), 0.0);
    if (!free_.empty()) addDeviations(fit.sd);
    return fit;
  }

 private:
  // One step downhill; false when there is none that helps.
  bool improve(const Normal& n, double& damping) {
    constexpr double kMaxDamping = 1e9;
    for (; damping < kMaxDamping; damping *= 8.0) {
      Matrix damped = n.matrix;
      damped.diagonal() += damping * n.matrix.diagonal();
      const Vector step = -damped.ldlt().solve(n.gradient);
      Numbers next = value_;
      for (std::size_t i = 0; i < free_.size(); ++i) next[free_[i]] += step[at(i)];
      Numbers residuals;
      p_.residuals(next, residuals);
      const double cost = costOf(next, residuals);
      if (!(cost < cost_)) continue;
      const double gain = cost_ - cost;
      value_ = next;
      residuals_ = residuals;
      cost_ = cost;
      damping = std::max(damping * 0.2, 1e-12);
      return gain > kSmallGain * cost;
    }
    return false;
  }

  double costOf(const Numbers& value, const Numbers& residuals) const {
    const double c = square(p_.cauchy);
    double sum = 0.0;
    for (const double r : residuals) sum += c * std::log1p(square(r) / c);
    for (const std::size_t i : free_) {
      const FitUnknown& u = p_.unknowns[i];
      if (u.priorSd > 0.0) sum += square((value[i] - u.prior) / u.priorSd);
    }
    return 0.5 * sum;
  }

  Matrix jacobian() const {
    Matrix j(at(residuals_.size()), at(free_.size()));
    Numbers low;
    Numbers high;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const double step = p_.unknowns[free_[i]].step;
      Numbers beside = value_;
      beside[free_[i]] = value_[free_[i]] - step;
      p_.residuals(beside, low);
      beside[free_[i]] = value_[free_[i]] + step;
      p_.residuals(beside, high);
      for (std::size_t k = 0; k < low.size(); ++k)
        j(at(k), at(i)) = (high[k] - low[k]) / (2.0 * step);
    }
    return j;
  }

  Normal normal() const {
    const Matrix j = jacobian();
    const int groups =
        p_.groups.empty() ? 0 : *std::max_element(p_.groups.begin(), p_.groups.end());
    const Eigen::Index n = at(free_.size());
    Normal result{Matrix::Zero(n, n), Vector::Zero(n), Matrix::Zero(groups + 1, n)};
    for (std::size_t k = 0; k < residuals_.size(); ++k) {
      const double weight = 1.0 / (1.0 + square(residuals_[k] / p_.cauchy));
      const Vector row = j.row(at(k)).transpose();
      result.matrix += weight * row * row.transpose();
      result.groups.row(p_.groups[k]) += weight * residuals_[k] * row.transpose();
    }
    result.gradient = result.groups.colwise().sum().transpose();
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const FitUnknown& u = p_.unknowns[free_[i]];
      if (u.priorSd <= 0.0) continue;
      result.matrix(at(i), at(i)) += 1.0 / square(u.priorSd);
      result.gradient[at(i)] += (value_[free_[i]] - u.prior) / square(u.priorSd);
    }
    return result;
  }

  // Few groups look too well agreed with one another, by the unknowns that were fitted to them.
  void addDeviations(Numbers& sd) const {
    const Normal n = normal();
    const auto groups = static_cast<double>(n.groups.rows());
    const double spare = std::max(groups - static_cast<double>(free_.size()), 1.0);
    Matrix middle = n.groups.transpose() * n.groups * (groups / spare);
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const double prior = p_.unknowns[free_[i]].priorSd;
      if (prior > 0.0) middle(at(i), at(i)) += 1.0 / square(prior);
    }
    const Matrix inverse =
        n.matrix.ldlt().solve(Matrix::Identity(n.matrix.rows(), n.matrix.cols()));
    const Matrix covariance = inverse * middle * inverse;
    for (std::size_t i = 0; i < free_.size(); ++i)
      sd[free_[i]] = std::sqrt(std::max(covariance(at(i), at(i)), 0.0));
  }

  const FitProblem& p_;
  std::vector<std::size_t> free_;
  Numbers value_;
  Numbers residuals_;
  double cost_ = 0.0;
};

}  // namespace

Fit robustFit(const FitProblem& problem) { return Fitter(problem).run(); }

}  // namespace kelpie::calibrate
