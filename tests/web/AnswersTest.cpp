// SPDX-License-Identifier: Apache-2.0
// Which bytes of a file are answered to which range.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tools/web/Site.h"

namespace kelpie::web {
namespace {

namespace fs = std::filesystem;

std::string fileOf(const std::string& name, std::size_t size) {
  const std::string path = (fs::temp_directory_path() / name).string();
  std::ofstream(path, std::ios::binary) << std::string(size, 'x');
  return path;
}

Answer answerTo(const std::string& range, std::size_t size = 100) {
  Request request;
  request.range = range;
  return fileAnswer(request, fileOf("answer", size), "text/plain");
}

void expectPart(const std::string& range, std::uint64_t first, std::uint64_t count) {
  const Answer answer = answerTo(range);
  EXPECT_EQ(answer.status, 206U) << range;
  EXPECT_EQ(answer.first, first) << range;
  EXPECT_EQ(answer.count, count) << range;
  EXPECT_EQ(answer.size, 100U) << range;
}

TEST(FileAnswer, WithoutARangeIsTheWholeFile) {
  const Answer answer = answerTo("");
  EXPECT_EQ(answer.status, 200U);
  EXPECT_EQ(answer.first, 0U);
  EXPECT_EQ(answer.count, 100U);
  EXPECT_EQ(answer.type, "text/plain");
}

TEST(FileAnswer, ARangeIsItsBytesAndEndsWithTheFile) {
  expectPart("bytes=0-0", 0, 1);
  expectPart("bytes=0-99", 0, 100);
  expectPart("bytes=10-19", 10, 10);
  expectPart("bytes=10-", 10, 90);
  expectPart("bytes=99-", 99, 1);
  expectPart("bytes=90-1000", 90, 10);
  expectPart("bytes=0-18446744073709551615", 0, 100);
}

TEST(FileAnswer, ASuffixIsTheFilesLastBytes) {
  expectPart("bytes=-1", 99, 1);
  expectPart("bytes=-100", 0, 100);
  expectPart("bytes=-5000", 0, 100);
}

TEST(FileAnswer, ARangeThatHoldsNothingOfTheFileIsRefusedWithItsSize) {
  for (const char* range :
       {"bytes=100-", "bytes=100-200", "bytes=-0", "bytes=5-4", "bytes=18446744073709551615-"}) {
    const Answer answer = answerTo(range);
    EXPECT_EQ(answer.status, 416U) << range;
    EXPECT_EQ(answer.size, 100U) << range;
    EXPECT_TRUE(answer.file.empty()) << range;
  }
  EXPECT_EQ(answerTo("bytes=0-", 0).status, 416U);
  EXPECT_EQ(answerTo("bytes=-1", 0).status, 416U);
}

TEST(FileAnswer, ARangeThatIsNoneIsRefused) {
  for (const char* range :
       {"bytes=", "bytes=-", "bytes=a-b", "bytes=1-b", "bytes=0x1-2", "bytes=-1-2", "bytes=--1",
        "bytes= 1-2", "bytes=1-2,4-5", "bytes=+1-2", "bytes=18446744073709551616-"})
    EXPECT_EQ(answerTo(range).status, 416U) << range;
}

// RFC 9110, 14.2: such a range is ignored.
TEST(FileAnswer, ARangeInAnotherUnitThanBytesIsNotLookedAt) {
  for (const char* range : {"lines=1-2", "seconds=1-", "bytes", "nonsense"}) {
    EXPECT_EQ(answerTo(range).status, 200U) << range;
    EXPECT_EQ(answerTo(range).count, 100U) << range;
  }
}

TEST(FileAnswer, AnEmptyFileIsAnsweredWhole) {
  EXPECT_EQ(answerTo("", 0).status, 200U);
  EXPECT_EQ(answerTo("", 0).count, 0U);
}

TEST(FileAnswer, FoldersAndFilesThatAreNotThereAreNotFound) {
  EXPECT_EQ(fileAnswer({}, fs::temp_directory_path().string(), "").status, 404U);
  EXPECT_EQ(fileAnswer({}, fileOf("there", 1) + "-not", "").status, 404U);
  EXPECT_EQ(fileAnswer({}, "/dev/zero", "").status, 404U);
  EXPECT_EQ(fileAnswer({}, "", "").status, 404U);
}

}  // namespace
}  // namespace kelpie::web
