/* SPDX-License-Identifier: Apache-2.0
 * Included before each of glibc's maths files that `build` compiles: what they expect of the rest
 * of glibc's build. Each function gets its public name at once, without aliases and versions; the
 * mode of rounding is always to nearest, since nothing here ever sets another.
 */
#pragma once

#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#define __sin sin
#define __cos cos
#define __tan tan
#define __atan atan
#define __erf erf
#define __erfc erfc
#define __exp exp
#define __log log
#define __pow pow
#define __ieee754_acos acos
#define __ieee754_asin asin
#define __ieee754_atan2 atan2
#define __ieee754_exp exp
#define __ieee754_fmod fmod
#define __ieee754_log log
#define __sqrt __builtin_sqrt

#define attribute_hidden __attribute__((visibility("hidden")))
#define hidden_def(name)
#define hidden_proto(name)
#define libm_hidden_def(name)
#define libm_alias_double(from, to)
#define libm_alias_double_other(from, to)
#define libm_alias_finite(from, to)
#define strong_alias(from, to)
#define weak_alias(from, to)
#define versioned_symbol(library, from, to, version)
#define libm_alias_exclusive_double(from, to)
#define __set_errno(number) (errno = (number))

#define SET_RESTORE_ROUND(mode) ((void)0)
#define SET_RESTORE_ROUND_NOEX(mode) ((void)0)
#define SET_RESTORE_ROUND_53BIT(mode) ((void)0)
#define libc_feholdexcept_setround(env, mode) ((void)(env))
#define libc_fesetenv(env) ((void)(env))

#define math_opt_barrier(x) (x)
#define math_force_eval(x) ((void)(x))
#define math_narrow_eval(x) (x)
#define math_check_force_underflow(x) ((void)(x))
#define math_check_force_underflow_nonneg(x) ((void)(x))
#define FIX_INT_FP_CONVERT_ZERO 0
#define HIGH_ORDER_BIT_IS_SET_FOR_SNAN 1
#define LIBM_SVID_COMPAT 0
#define LITTLE_ENDI 1
#define HIGH_HALF 1
#define LOW_HALF 0
#define fabs(x) __builtin_fabs(x)
#define copysign(x, y) __builtin_copysign(x, y)

typedef union Words {
  double value;
  struct {
    uint32_t low;
    uint32_t high;
  } parts;
  uint64_t word;
} Words;

#define EXTRACT_WORDS64(bits, x) ((bits) = (int64_t)(Words){.value = (x)}.word)
#define INSERT_WORDS64(x, bits) ((x) = (Words){.word = (uint64_t)(bits)}.value)
#define EXTRACT_WORDS(upper, lower, x) \
  ((upper) = (int32_t)(Words){.value = (x)}.parts.high, (lower) = (Words){.value = (x)}.parts.low)
#define INSERT_WORDS(x, upper, lower) \
  ((x) = (Words){.parts = {.low = (uint32_t)(lower), .high = (uint32_t)(upper)}}.value)
#define GET_HIGH_WORD(upper, x) ((upper) = (int32_t)(Words){.value = (x)}.parts.high)
#define GET_LOW_WORD(lower, x) ((lower) = (int32_t)(Words){.value = (x)}.parts.low)
#define SET_LOW_WORD(x, lower)                                                                  \
  ((x) = (Words){.parts = {.low = (uint32_t)(lower), .high = (Words){.value = (x)}.parts.high}} \
             .value)
