// SPDX-License-Identifier: Apache-2.0
// Bytes as text, against the vectors of RFC 4648, section 10.
#include <gtest/gtest.h>

#include "tools/live/Base64.h"

namespace kelpie::live {
namespace {

TEST(Base64, IsAsTheStandardsVectorsHaveIt) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, UsesTheWholeAlphabetInItsOrder) {
  std::string bytes;
  for (unsigned i = 0; i < 64; i += 4) {
    bytes += static_cast<char>(i << 2 | (i + 1) >> 4);
    bytes += static_cast<char>((i + 1) << 4 | (i + 2) >> 2);
    bytes += static_cast<char>((i + 2) << 6 | (i + 3));
  }
  EXPECT_EQ(base64(bytes), "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/");
}

TEST(Base64, ZerosAndHighBytesCount) {
  EXPECT_EQ(base64(std::string("\0\0\0", 3)), "AAAA");
  EXPECT_EQ(base64(std::string("\0", 1)), "AA==");
  EXPECT_EQ(base64("\xFF\xFF\xFF"), "////");
  EXPECT_EQ(base64("\xFB\xFF"), "+/8=");
}

}  // namespace
}  // namespace kelpie::live
