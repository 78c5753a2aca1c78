/* SPDX-License-Identifier: Apache-2.0
 * Tags of a set-associative cache with least-recently-used replacement, lines of 32 bytes. */
#pragma once

#include <stdint.h>

enum { kLineShift = 5, kWays = 4, kMaxSets = 2048 };

struct Cache {
  uint32_t sets;                  /* a power of two, at most kMaxSets */
  uint32_t tags[kMaxSets][kWays]; /* line number + 1, newest first; 0: empty */
};

/* Reads or writes the line; 1 if it was not there (it is then). */
static inline int cacheMisses(struct Cache* cache, uint32_t line) {
  uint32_t* tags = cache->tags[line & (cache->sets - 1)];
  const uint32_t tag = line + 1;
  uint32_t carried = tag;
  for (int way = 0; way < kWays; ++way) {
    const uint32_t here = tags[way];
    tags[way] = carried;
    if (here == tag) return 0;
    carried = here;
  }
  return 1;
}
