// SPDX-License-Identifier: Apache-2.0
// Student's t distribution. Its degrees of freedom are whole numbers here, for which the
// probability is a finite series: no incomplete beta function is needed, and no library for it
// (libboost-math-dev is 140 MB with what it depends on).
#pragma once

namespace kelpie::league {

// P(T > t) with `freedom` >= 1 degrees of freedom (Abramowitz and Stegun, 26.7.3 and 26.7.4). The
// error is below 1e-12, so that smaller probabilities have no digits left.
double studentTail(double t, int freedom);

// The t that is exceeded with probability `tail`, 1e-9 .. 0.5; error below 1e-9 of itself.
double studentQuantile(double tail, int freedom);

}  // namespace kelpie::league
