/* SPDX-License-Identifier: Apache-2.0
 * Sorts MIPS instruction words into classes and says what each class costs when its operands are in
 * the caches. */
#pragma once

#include <stdint.h>

enum Class { kPlain, kBranch, kMul, kDiv, kFp, kFpMulDouble, kFpDivSingle, kFpDivDouble, kClasses };

/* Cycles of one instruction of a class: the R7000's latencies as far as they are known (from
 * memory, no data sheet), used as issue cost by a model without overlap. A dual-issue core that
 * schedules well does better; the comparison between two builds is what it is good for. */
extern const unsigned kClassCycles[kClasses];

enum Class mipsClass(uint32_t word);
/* An instruction that came with MIPS32 (clz, mul, seb, ...): the R7000 does not have it. */
int isMips32(uint32_t word);
