// SPDX-License-Identifier: Apache-2.0
// Logs with damage inside: all undamaged chunks are read, and the gaps that are reported hold all
// that is missing.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "robot/core/Random.h"
#include "tests/core/LogFiles.h"
#include "tests/core/SampleLog.h"

namespace kelpie {
namespace {

class LogDamage : public LogFiles {};

constexpr int kMessages = 400;

// About forty chunks of two topics; without `whole` as a killed process leaves it, without summary.
std::string writeLog(const std::string& path, const LogOptions& options, bool whole = true) {
  LogWriter log = std::move(*LogWriter::open(path, options));
  Random random(5);
  log.metadata("about", {{"a", "b"}});
  for (int i = 0; i < kMessages; ++i) {
    writeRandom<WalkRequest>(log, i % 3 == 0 ? "walk" : "other", TimeUs{10000 * i}, random);
    if (i % 7 == 0) writeRandom<HeadRequest>(log, "head", TimeUs{10000 * i}, random);
  }
  if (!whole) log.flush();
  if (whole) log.close();
  std::string content = contentOf(path);
  log.close();
  fileWith("copy", content);
  return content;
}

struct ChunkSpan {
  std::size_t from = 0, to = 0;       // bytes of the record
  std::uint64_t first = 0, last = 0;  // times, ns
};

std::vector<ChunkSpan> chunksIn(const std::string& log) {
  std::vector<ChunkSpan> chunks;
  for (const FileRecord& record : recordsOf(log + std::string(8, '\0'))) {
    if (record.op != mcap::Op::chunk) continue;
    auto content = readerOf(record.content);
    ChunkSpan chunk{record.offset, record.offset + record.size, 0, 0};
    chunk.first = content.number<std::uint64_t>();
    chunk.last = content.number<std::uint64_t>();
    chunks.push_back(chunk);
  }
  return chunks;
}

// Overwrites bytes; tells nothing of what stood there.
struct Damage {
  std::size_t from = 0, to = 0;
};

Damage flip(std::string& log, Random& random) {
  const std::size_t at = 8 + random.index(static_cast<std::uint32_t>(log.size() - 8));
  log[at] = static_cast<char>(log[at] ^ static_cast<char>(1 + random.index(255)));
  return {at, at + 1};
}

Damage zeros(std::string& log, Random& random) {
  const std::size_t at = 8 + random.index(static_cast<std::uint32_t>(log.size() - 8));
  const std::size_t end = std::min(log.size(), at + 1 + random.index(3000));
  std::fill(log.begin() + static_cast<long>(at), log.begin() + static_cast<long>(end), '\0');
  return {at, end};
}

// The time of a message's text in a Reading, ns.
std::uint64_t timeOf(const std::string& content) {
  return 1000U * std::stoull(content.substr(content.find(' ') + 1));
}

void expectAllUndamaged(const Reading& reading, const std::vector<std::string>& all,
                        const std::string& whole, const std::vector<Damage>& damages) {
  const std::set<std::string> read(reading.contents.begin(), reading.contents.end());
  const std::vector<ChunkSpan> chunks = chunksIn(whole);
  for (const std::string& content : all) {
    const std::uint64_t time = timeOf(content);
    const bool hit = std::any_of(chunks.begin(), chunks.end(), [&](const ChunkSpan& chunk) {
      return chunk.first <= time && time <= chunk.last &&
             std::any_of(damages.begin(), damages.end(), [&](const Damage& damage) {
               return damage.from < chunk.to && chunk.from < damage.to;
             });
    });
    if (hit) continue;
    ASSERT_TRUE(read.count(content) == 1) << "message of " << time << " ns is missing";
  }
}

bool isReported(const Reading& reading, std::uint64_t time) {
  if (reading.truncated && (reading.contents.empty() || timeOf(reading.contents.back()) <= time))
    return true;
  return std::any_of(reading.gaps.begin(), reading.gaps.end(), [&](const LogGap& gap) {
    const auto ns = [](TimeUs at) { return 1000U * static_cast<std::uint64_t>(at.us); };
    return (!gap.last || ns(*gap.last) <= time) && (!gap.following || time <= ns(*gap.following));
  });
}

// Every message that is given is as it was written, and every other lies in a gap that is reported.
void expectGapsReported(const Reading& reading, const std::vector<std::string>& all) {
  const std::set<std::string> read(reading.contents.begin(), reading.contents.end());
  const std::set<std::string> written(all.begin(), all.end());
  for (const std::string& content : reading.contents) ASSERT_EQ(written.count(content), 1U);
  for (const std::string& content : all)
    ASSERT_TRUE(read.count(content) == 1 || isReported(reading, timeOf(content)))
        << timeOf(content) << " ns";
}

void tryDamages(const LogOptions& options, bool whole, std::uint64_t seed) {
  const std::string log = writeLog(pathOf("log"), options, whole);
  const std::vector<std::string> all = readAll(fileWith("whole", log)).contents;
  ASSERT_GE(all.size(), 400U);
  Random random(seed);
  for (int trial = 0; trial < 250; ++trial) {
    SCOPED_TRACE(trial);
    std::string broken = log;
    std::vector<Damage> damages;
    const std::size_t count = 1 + random.index(3);
    for (std::size_t i = 0; i < count; ++i)
      damages.push_back(trial % 2 == 0 ? flip(broken, random) : zeros(broken, random));
    const Reading reading = readAll(fileWith("broken", broken));
    ASSERT_EQ(reading.error, "");
    expectAllUndamaged(reading, all, log, damages);
    expectGapsReported(reading, all);
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST_F(LogDamage, InChunksCostsOnlyThoseChunksAndIsReported) {
  tryDamages(chunksOf(600), true, 1);
  tryDamages(chunksOf(600, ""), true, 2);
}

TEST_F(LogDamage, InALogWithoutEndCostsOnlyThoseChunksAndIsReported) {
  tryDamages(chunksOf(600), false, 3);
  tryDamages(chunksOf(600, ""), false, 4);
}

TEST_F(LogDamage, OfTheFirstChunkOfAKilledLogLeavesTheOthersReadable) {
  const std::string log = writeLog(pathOf("log"), chunksOf(600), false);
  const ChunkSpan first = chunksIn(log)[0];
  std::string broken = log;
  broken[first.to - 10] ^= 1;
  const Reading reading = readAll(fileWith("broken", broken));
  ASSERT_EQ(reading.gaps.size(), 1U);
  EXPECT_EQ(reading.gaps[0].from, first.from);
  EXPECT_EQ(reading.gaps[0].to, first.to);
  EXPECT_GT(reading.messages, 420);
}

TEST_F(LogDamage, IsReportedWithBytesReasonAndTimes) {
  const std::string log = writeLog(pathOf("log"), chunksOf(600));
  const ChunkSpan third = chunksIn(log)[2];
  std::string broken = log;
  broken[third.to - 10] ^= 1;
  const Reading reading = readAll(fileWith("broken", broken));
  ASSERT_EQ(reading.gaps.size(), 1U);
  const std::string text = reading.gaps[0].text();
  const std::string start =
      "bytes " + std::to_string(third.from) + " to " + std::to_string(third.to) + ": damaged chunk";
  EXPECT_EQ(text.substr(0, start.size()), start);
  const auto seconds = [](std::uint64_t ns) {
    const std::string digits = std::to_string(1e-9 * static_cast<double>(ns));
    return digits.substr(0, digits.size() - 3);
  };
  const std::string lost = "; what was between " + seconds(third.first - 10000000) + " and " +
                           seconds(third.last + 10000000) + " s is lost";
  ASSERT_GT(text.size(), lost.size());
  EXPECT_EQ(text.substr(text.size() - lost.size()), lost);
}

// As a file system leaves it that lost power: a megabyte of zeros where data should be.
TEST_F(LogDamage, AMegabyteOfZerosInTheMiddleCostsWhatItCovers) {
  const std::string log = writeLog(pathOf("log"), chunksOf(600));
  const std::vector<ChunkSpan> chunks = chunksIn(log);
  const std::string rest = log.substr(chunks[20].from);
  const std::string broken = log.substr(0, chunks[10].from + 5) + std::string(1 << 20, '\0') + rest;
  const Reading reading = readAll(fileWith("broken", broken));
  EXPECT_FALSE(reading.truncated);
  ASSERT_EQ(reading.gaps.size(), 1U);
  EXPECT_EQ(reading.gaps[0].to, broken.size() - rest.size());
  EXPECT_EQ(static_cast<std::uint64_t>(reading.gaps[0].following->us) * 1000, chunks[20].first);
}

// The chunk's length is whole, its content and what was behind it are not.
TEST_F(LogDamage, ZerosFromTheMiddleOfAChunkToTheEndAreACut) {
  const std::string log = writeLog(pathOf("log"), chunksOf(600));
  const ChunkSpan chunk = chunksIn(log)[10];
  const std::string broken = log.substr(0, chunk.from + 60) + std::string(1 << 20, '\0');
  const Reading reading = readAll(fileWith("broken", broken));
  EXPECT_TRUE(reading.truncated);
  EXPECT_TRUE(reading.gaps.empty());
  EXPECT_EQ(reading.offset, chunk.from);
}

TEST_F(LogDamage, SwappedChunksAreAllRead) {
  const std::string log = writeLog(pathOf("log"), chunksOf(600), false);
  const std::vector<ChunkSpan> chunks = chunksIn(log);
  const auto cut = [&](std::size_t from, std::size_t to) { return log.substr(from, to - from); };
  const std::string swapped = cut(0, chunks[0].from) + cut(chunks[5].from, chunks[6].from) +
                              cut(chunks[1].from, chunks[5].from) +
                              cut(chunks[0].from, chunks[1].from) + cut(chunks[6].from, log.size());
  const Reading reading = readAll(fileWith("swapped", swapped));
  EXPECT_EQ(reading.messages, readAll(pathOf("copy")).messages);
  EXPECT_TRUE(reading.gaps.empty());
}

// Records that go out alone have no checksum: what is broken inside a message is not seen here.
TEST_F(LogDamage, InALogWithoutChunksCostsTheRecordsThatItHits) {
  const std::string log = writeLog(pathOf("log"), LogOptions{});
  const std::vector<FileRecord> records = recordsOf(log);
  const FileRecord& hit = records[records.size() / 2];
  std::string broken = log;
  std::fill_n(broken.begin() + static_cast<long>(hit.offset), 9, '\0');
  const Reading reading = readAll(fileWith("broken", broken));
  ASSERT_EQ(reading.gaps.size(), 1U);
  EXPECT_EQ(reading.gaps[0].from, hit.offset);
  EXPECT_EQ(reading.gaps[0].to, hit.offset + hit.size);
  EXPECT_EQ(reading.messages + 1, readAll(pathOf("log")).messages);
}

// The record of a kind that came later is suspected twice: as what stands before the damage, and as
// the chunk that the index behind it is of.
TEST_F(LogDamage, BehindARecordOfUnknownKindIsOneGap) {
  const std::string log = writeLog(pathOf("log"), chunksOf(600));
  const ChunkSpan chunk = chunksIn(log)[10];
  const std::string unknown = '\x2f' + std::string(8, '\0');
  const std::string broken =
      log.substr(0, chunk.to) + unknown + std::string(48, '\0') + log.substr(chunk.to);
  const Reading reading = readAll(fileWith("broken", broken));
  ASSERT_EQ(reading.gaps.size(), 1U);
  EXPECT_EQ(reading.gaps[0].from, chunk.to);
  EXPECT_EQ(reading.gaps[0].to, chunk.to + unknown.size() + 48);
  EXPECT_EQ(reading.messages, readAll(pathOf("log")).messages);
}

}  // namespace
}  // namespace kelpie
