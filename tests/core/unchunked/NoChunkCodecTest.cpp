// SPDX-License-Identifier: Apache-2.0
// A program as for the robot: linked with NoChunkCodec.cpp, it has no compressor.
#include <gtest/gtest.h>

#include "tests/core/LogFiles.h"

namespace kelpie {
namespace {

class RobotsLog : public LogFiles {};

TEST_F(RobotsLog, HasNoChunksAndEveryRecordIsWrittenAtOnce) {
  const std::string path = pathOf("log");
  LogWriter log = std::move(*LogWriter::open(path));
  for (int i = 1; i <= 5; ++i) {
    log.write("walk", TimeUs{i}, WalkRequest{});
    EXPECT_EQ(readAll(path).messages, i);
  }
  ASSERT_TRUE(log.close());
  for (const FileRecord& record : recordsOf(contentOf(path))) EXPECT_NE(record.op, mcap::Op::chunk);
}

TEST_F(RobotsLog, CannotBeCompressedAndSaysSo) {
  const std::string path = pathOf("log");
  EXPECT_EQ(LogWriter::open(path, chunksOf(1000, "zstd")).error(),
            path + ": no compressor for zstd");
  EXPECT_FALSE(std::ifstream(path));
  LogWriter log = std::move(*LogWriter::open(path, chunksOf(100, "")));
  for (int i = 1; i <= 5; ++i) log.write("walk", TimeUs{i}, WalkRequest{});
  ASSERT_TRUE(log.close());
  EXPECT_EQ(readAll(path).messages, 5);
}

TEST_F(RobotsLog, CompressedLogIsRefusedWithThePlace) {
  std::vector<std::uint8_t> bytes(mcap::kMagic.begin(), mcap::kMagic.end());
  mcap::RecordWriter record(bytes);
  record.begin(mcap::Op::chunk);
  for (int i = 0; i < 3; ++i) record.number(std::uint64_t{1});
  record.number(std::uint32_t{0});
  record.string("zstd");
  record.number(std::uint64_t{0});
  record.end();
  const std::string path = fileWith("log", {bytes.begin(), bytes.end()});
  EXPECT_EQ(readAll(path).error, path + ": byte 8: compressed with zstd, which we cannot read");
}

TEST_F(RobotsLog, NeedsNoZstdLibrary) {
  EXPECT_EQ(contentOf("/proc/self/maps").find("libzstd"), std::string::npos);
}

}  // namespace
}  // namespace kelpie
