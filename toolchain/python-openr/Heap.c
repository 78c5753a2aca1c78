// SPDX-License-Identifier: Apache-2.0
// The memory of the robot's Python, from malloc and free of the SDK: nothing else of a C library
// outside is asked. Each piece stands behind 8 bytes that hold its size, which realloc wants to
// know. The names are those that `build` gives to Python's own C library. What is asked for is
// counted, and refused where it would be more than a script may have
// (behaviour/interpreter/Heap.h).
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include "behaviour/frozen/Steps.h"

enum {
  kHead = 8,             // keeps what follows aligned for a double
  kReserve = 256 << 10,  // an arena of Python's
};

extern void* kelpiec_memcpy(void* to, const void* from, size_t count);
extern void* kelpiec_memset(void* to, int value, size_t count);

static size_t used;  // without the heads
static size_t limit = SIZE_MAX - kReserve;
static int refused;  // a small piece, since the limit was set

size_t kelpieHeapUsed(void) { return used; }
void kelpieLimitHeap(size_t bytes) {
  limit = bytes < SIZE_MAX - kReserve ? bytes : SIZE_MAX - kReserve;
  refused = 0;
}

// Where there is no arena, Python asks for single blocks: the limit is reached when one of those is
// refused.
static int refuses(size_t size) {
  const size_t most = refused ? limit + kReserve : limit;
  if (used <= most && size <= most - used) return 0;
  refused = refused || size < kReserve;
  return 1;
}

static size_t sizeOf(const void* memory) {
  return *(const size_t*)((const uint8_t*)memory - kHead);
}

void* kelpiec_malloc(size_t size) {
  if (size > SIZE_MAX - kHead || refuses(size)) return NULL;
  uint8_t* const piece = malloc(size + kHead);
  if (piece == NULL) return NULL;
  used += size;
  *(size_t*)piece = size;
  return piece + kHead;
}

void kelpiec_free(void* memory) {
  if (memory == NULL) return;
  used -= sizeOf(memory);
  free((uint8_t*)memory - kHead);
}

void* kelpiec_calloc(size_t count, size_t size) {
  if (size != 0 && count > SIZE_MAX / size) return NULL;
  void* const memory = kelpiec_malloc(count * size);
  return memory != NULL ? kelpiec_memset(memory, 0, count * size) : NULL;
}

void* kelpiec_realloc(void* memory, size_t size) {
  if (memory != NULL && size <= sizeOf(memory)) return memory;
  void* const larger = kelpiec_malloc(size);
  if (memory == NULL || larger == NULL) return larger;
  kelpiec_memcpy(larger, memory, sizeOf(memory));
  kelpiec_free(memory);
  return larger;
}
