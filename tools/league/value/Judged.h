// SPDX-License-Identifier: Apache-2.0
// How good a value is, by what came of the moments that it was said of. Pure figures; moments of
// one match are not independent, so that the matches and not the moments are what counts as many.
#pragma once

#include <vector>

#include "tools/league/value/Rows.h"
#include "tools/league/value/Value.h"

namespace kelpie::value {

// A probability, and whether it came so.
struct Said {
  double p = 0.0;
  bool was = false;
};

// Of a match's rows; without those whose stretch ended before the horizon did, by no goal.
std::vector<Said> saidOf(const std::vector<Row>& rows, const Model& model);

double sharedBy(const std::vector<Said>& said);  // of those that came so
double logLoss(const std::vector<Said>& said);
// Of one who knows the share of these very moments, and nothing else: the best of all constants.
double baseLogLoss(const std::vector<Said>& said);

// As many moments each, from the least probable on.
struct Bin {
  double said = 0.0;
  double was = 0.0;
};
std::vector<Bin> binsOf(std::vector<Said> said, std::size_t bins);
// The mean gap between what was said and what was.
double calibrationError(const std::vector<Bin>& bins);

// 0 when one of them does not vary.
double correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace kelpie::value
