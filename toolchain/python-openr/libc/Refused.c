// SPDX-License-Identifier: Apache-2.0
// Maths that CPython's modules name and no behaviour calls: each answers "not a number" with errno
// set, of which the module `math` makes a ValueError. A wrong last bit would be worse than none.
#include <errno.h>

static double refuse(void) {
  errno = EDOM;
  return __builtin_nan("");
}

double acosh(double x) { return (void)x, refuse(); }
double asinh(double x) { return (void)x, refuse(); }
double atanh(double x) { return (void)x, refuse(); }
double cbrt(double x) { return (void)x, refuse(); }
double cosh(double x) { return (void)x, refuse(); }
double exp2(double x) { return (void)x, refuse(); }
double expm1(double x) { return (void)x, refuse(); }
double log10(double x) { return (void)x, refuse(); }
double log1p(double x) { return (void)x, refuse(); }
double log2(double x) { return (void)x, refuse(); }
double sinh(double x) { return (void)x, refuse(); }
double tanh(double x) { return (void)x, refuse(); }
double hypot(double x, double y) { return (void)x, (void)y, refuse(); }  // of complex numbers
double nextafter(double x, double y) { return (void)x, (void)y, refuse(); }
