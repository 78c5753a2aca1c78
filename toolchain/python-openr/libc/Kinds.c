// SPDX-License-Identifier: Apache-2.0
// The kinds of characters in the locale C, as glibc's <ctype.h> asks for them: tables that begin
// 128 before the character 0, with glibc's bits.
#include <stdint.h>

enum {
  kBlank = 1,
  kControl = 2,
  kPunctuation = 4,
  kAlphanumeric = 8,
  kUpper = 0x100,
  kLower = 0x200,
  kLetter = 0x400,
  kDigit = 0x800,
  kHexDigit = 0x1000,
  kSpace = 0x2000,
  kPrinted = 0x4000,
  kGraphic = 0x8000,
  kBefore = 128
};

static uint16_t kinds[kBefore + 256];
static int32_t lowers[kBefore + 256];
static const uint16_t* kindsAt;
static const int32_t* lowersAt;

static int within(int c, int first, int last) { return c >= first && c <= last; }

static int letterKind(int c) {
  const int hex = within(c | 32, 'a', 'f') ? kHexDigit : 0;
  if (within(c, 'A', 'Z')) return kUpper | kLetter | kAlphanumeric | hex;
  if (within(c, 'a', 'z')) return kLower | kLetter | kAlphanumeric | hex;
  return within(c, '0', '9') ? kDigit | kAlphanumeric | kHexDigit : 0;
}

static int kindOf(int c) {
  int kind = letterKind(c);
  if (c == ' ' || within(c, '\t', '\r')) kind |= kSpace;
  if (c == ' ' || c == '\t') kind |= kBlank;
  if (!within(c, ' ', '~')) return kind | kControl;
  if (c != ' ') kind |= kGraphic | ((kind & kAlphanumeric) != 0 ? 0 : kPunctuation);
  return kind | kPrinted;
}

static void makeTables(void) {
  if (kindsAt != 0) return;
  for (int c = 0; c < 128; ++c) {
    kinds[kBefore + c] = (uint16_t)kindOf(c);
    lowers[kBefore + c] = within(c, 'A', 'Z') ? c | 32 : c;
  }
  kindsAt = kinds + kBefore;
  lowersAt = lowers + kBefore;
}

const uint16_t** __ctype_b_loc(void) {
  makeTables();
  return &kindsAt;
}

const int32_t** __ctype_tolower_loc(void) {
  makeTables();
  return &lowersAt;
}
