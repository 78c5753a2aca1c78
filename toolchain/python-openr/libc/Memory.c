// SPDX-License-Identifier: Apache-2.0
// malloc for the emulator: one block of 48 MB, twice what the whole object may use, since it is
// cut into pieces of 16 bytes times a power of two, each behind a head of 8 bytes; freed pieces
// wait in a list for the next of their size. With 24 MB a script that took all that it may left
// nothing for the line that tells of it. Wasteful, but a piece costs a few instructions. What is
// counted is what was asked for, with 8 bytes for the head that every malloc needs. Python asks it
// only for what its own allocator does not keep (over 512 bytes).
#include <stddef.h>
#include <stdint.h>
#include <string.h>

enum { kHeapBytes = 48 << 20, kClasses = 22, kSmallest = 16 };

typedef struct Piece {
  uint32_t class;
  union {
    uint32_t asked;      // bytes, while it is in use
    struct Piece* next;  // while it is free
  } state;
} Piece;

static union {
  uint64_t aligned;
  uint8_t bytes[kHeapBytes];
} heap;
static size_t cut;    // bytes ever cut off the block
static size_t inUse;  // bytes asked for and not given back, heads included
static size_t maxInUse;
static Piece* waiting[kClasses];

uint32_t kelpieHeapPeak(void) { return maxInUse; }

static size_t sizeOf(uint32_t class) { return (size_t)kSmallest << class; }

void* malloc(size_t size) {
  uint32_t class = 0;
  while (class < kClasses && sizeOf(class) < size) ++class;
  if (class == kClasses) return NULL;
  Piece* piece = waiting[class];
  if (piece != NULL) {
    waiting[class] = piece->state.next;
  } else {
    const size_t whole = 8 + sizeOf(class);
    if (whole > kHeapBytes - cut) return NULL;
    piece = (Piece*)(heap.bytes + cut);
    cut += whole;
  }
  piece->class = class;
  piece->state.asked = size + 8;
  inUse += size + 8;
  if (inUse > maxInUse) maxInUse = inUse;
  return (uint8_t*)piece + 8;
}

void free(void* memory) {
  if (memory == NULL) return;
  Piece* const piece = (Piece*)((uint8_t*)memory - 8);
  inUse -= piece->state.asked;
  piece->state.next = waiting[piece->class];
  waiting[piece->class] = piece;
}

void* calloc(size_t count, size_t size) {
  if (size != 0 && count > SIZE_MAX / size) return NULL;
  void* const memory = malloc(count * size);
  if (memory != NULL) memset(memory, 0, count * size);
  return memory;
}

void* realloc(void* memory, size_t size) {
  if (memory == NULL) return malloc(size);
  const size_t has = ((Piece*)((uint8_t*)memory - 8))->state.asked - 8;
  if (size <= has) return memory;
  void* const larger = malloc(size);
  if (larger == NULL) return NULL;
  memcpy(larger, memory, has);
  free(memory);
  return larger;
}
