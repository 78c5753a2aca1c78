/* SPDX-License-Identifier: Apache-2.0 */
#include "mips.h"

const unsigned kClassCycles[kClasses] = {1, 1, 5, 36, 3, 4, 19, 34};

static uint32_t opcode(uint32_t word) { return word >> 26; }
static uint32_t function(uint32_t word) { return word & 63; }

static enum Class specialClass(uint32_t word) {
  switch (function(word)) {
    case 0x08: /* jr */
    case 0x09: /* jalr */ return kBranch;
    case 0x18: /* mult */
    case 0x19: /* multu */ return kMul;
    case 0x1a: /* div */
    case 0x1b: /* divu */ return kDiv;
    default: return kPlain;
  }
}

static enum Class fpClass(uint32_t word) {
  const uint32_t format = (word >> 21) & 31;
  if (format == 8) return kBranch; /* bc1 */
  if (format < 16) return kPlain;  /* moves between the register files */
  const int isDouble = format == 17;
  switch (function(word)) {
    case 2: /* mul */ return isDouble ? kFpMulDouble : kFp;
    case 3: /* div */
    case 4: /* sqrt */ return isDouble ? kFpDivDouble : kFpDivSingle;
    case 6: /* mov */ return kPlain;
    default: return kFp;
  }
}

enum Class mipsClass(uint32_t word) {
  const uint32_t op = opcode(word);
  if (op == 0x00) return specialClass(word);
  if (op == 0x11) return fpClass(word);
  if (op == 0x1c && function(word) < 6) return kMul; /* mul, madd of MIPS32: libc only */
  if (op == 0x13) return (word & 7) == 1 ? kFpMulDouble : kFp;
  const int branch = (op >= 1 && op <= 7) || (op >= 0x14 && op <= 0x17);
  return branch ? kBranch : kPlain;
}

int isMips32(uint32_t word) { return opcode(word) == 0x1c || opcode(word) == 0x1f; }
