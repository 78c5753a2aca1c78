// SPDX-License-Identifier: Apache-2.0
// The target of a request, taken apart.
#include <gtest/gtest.h>

#include "tools/web/Target.h"

namespace kelpie::web {
namespace {

Request requestFor(const std::string& target) {
  Request request;
  readTarget(target, request);
  return request;
}

TEST(Target, TriplesAreDecodedOnce) {
  EXPECT_EQ(decoded("%41%6a%6A"), "Ajj");
  EXPECT_EQ(decoded("%2e%2E%2f"), "../");
  EXPECT_EQ(decoded("%2541"), "%41");
  EXPECT_EQ(decoded("a%20b+c"), "a b+c");
  EXPECT_EQ(decoded("%00").size(), 1U);
  EXPECT_EQ(decoded("%C3%BC"), "\xC3\xBC");
}

TEST(Target, WhatIsNoTripleStaysAsItIs) {
  for (const char* text : {"%", "%4", "%4g", "%g4", "%%", "100%", "a%-1"})
    EXPECT_EQ(decoded(text), text);
  EXPECT_EQ(decoded("%%41"), "%A");
}

TEST(Target, TheQueryBeginsAtTheFirstMark) {
  const Request request = requestFor("/api/behaviour?team=red&path=roles%2fkeeper.py&x?=?y");
  EXPECT_EQ(request.path, "/api/behaviour");
  EXPECT_EQ(request.query.at("team"), "red");
  EXPECT_EQ(request.query.at("path"), "roles/keeper.py");
  EXPECT_EQ(request.query.at("x?"), "?y");
}

TEST(Target, AnEncodedMarkOrAmpersandIsAPartOfItsWord) {
  EXPECT_EQ(requestFor("/a%3fb=c").path, "/a?b=c");
  EXPECT_EQ(requestFor("/?a=1%262").query.at("a"), "1&2");
  EXPECT_EQ(requestFor("/?a%3d1=2").query.at("a=1"), "2");
}

TEST(Target, WordsWithoutAValueAreEmptyAndTheLastOfANameCounts) {
  const Request request = requestFor("/?a&b=&=c&&d=1&d=2&e=1=2");
  EXPECT_EQ(request.query.at("a"), "");
  EXPECT_EQ(request.query.at("b"), "");
  EXPECT_EQ(request.query.at(""), "");
  EXPECT_EQ(request.query.at("d"), "2");
  EXPECT_EQ(request.query.at("e"), "1=2");
  EXPECT_TRUE(requestFor("/").query.empty());
  EXPECT_TRUE(requestFor("").path.empty());
}

}  // namespace
}  // namespace kelpie::web
