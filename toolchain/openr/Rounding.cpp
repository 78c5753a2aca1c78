// SPDX-License-Identifier: Apache-2.0
// Under the names of the C library and of libgcc; linked before them, and used in their place.
#include "toolchain/openr/Rounding.h"

// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming): libgcc's name
extern "C" {

double floor(double x) { return kelpie::openr::floorOf(x); }
double ceil(double x) { return kelpie::openr::ceilOf(x); }
long lround(double x) { return kelpie::openr::lroundOf(x); }
int __clzsi2(std::uint32_t word) { return kelpie::openr::leadingZeros(word); }
}
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)
