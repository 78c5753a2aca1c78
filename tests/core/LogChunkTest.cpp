// SPDX-License-Identifier: Apache-2.0
// Logs in chunks: what they keep when whole, cut off, damaged or on a full disk.
#include <gtest/gtest.h>
#include <zstd.h>

#include <algorithm>
#include <filesystem>

#include "robot/core/Checksum.h"
#include "robot/core/log/ChunkBuffer.h"
#include "tests/core/LogFiles.h"
#include "tests/core/SampleLog.h"

namespace kelpie {
namespace {

class LogChunks : public LogFiles {};

// Thirty messages of two topics, 10 ms apart, with an attachment and metadata among them.
void writeLog(const std::string& path, const LogOptions& options) {
  LogWriter log = std::move(*LogWriter::open(path, options));
  Random random(5);
  for (int i = 0; i < 30; ++i) {
    if (i == 10) log.attachment("table", "text/plain", {1, 2, 3});
    if (i == 20) log.metadata("place", {{"half", "second"}});
    if (i % 3 == 0) {
      writeRandom<HeadRequest>(log, "head", TimeUs{i * 10000}, random);
    } else {
      writeRandom<WalkRequest>(log, "walk", TimeUs{i * 10000}, random);
    }
  }
  ASSERT_TRUE(log.close());
}

std::string logWith(const LogOptions& options) {
  const std::string path = pathOf("source");
  writeLog(path, options);
  return contentOf(path);
}

TEST_F(LogChunks, KeepEveryMessageHoweverTheyAreCut) {
  const std::string path = pathOf("log");
  writeLog(path, LogOptions{});
  const Reading plain = readAll(path);
  ASSERT_EQ(plain.messages, 30);
  for (const char* compression : {"", "zstd"}) {
    for (const std::size_t bytes : {1U, 300U, 1000U, 1U << 20}) {
      writeLog(path, chunksOf(bytes, compression));
      const Reading reading = readAll(path);
      EXPECT_EQ(reading.error, "");
      EXPECT_FALSE(reading.truncated);
      EXPECT_EQ(reading.contents, plain.contents) << bytes << compression;
      EXPECT_EQ(reading.offset, std::filesystem::file_size(path));
    }
  }
}

TEST(ChunkBuffer, IsTakenOnceForAllChunksOfAboutASize) {
  std::vector<std::uint8_t> buffer;
  growTo(buffer, 1100000);
  const std::uint8_t* const at = buffer.data();
  const std::size_t room = buffer.capacity();
  EXPECT_GE(room, 1100000U);
  for (std::size_t bytes = 900000; bytes < 1200000; bytes += 10000) {
    growTo(buffer, bytes);
    buffer.assign(bytes, 1);
    ASSERT_EQ(buffer.data(), at);
  }
  growTo(buffer, 3 * room);
  EXPECT_GE(buffer.capacity(), 3 * room);
}

// Frames with images, a few to a chunk; the values themselves are compared.
TEST_F(LogChunks, GiveBackRandomValuesBitForBit) {
  const std::string path = pathOf("log");
  ASSERT_TRUE(writeSampleLog(path, 40));
  auto reader = LogReader::open(path);
  ASSERT_TRUE(reader) << reader.error();
  Random random(1);
  const auto expected = std::make_unique<FrameInput>();
  const auto read = std::make_unique<FrameInput>();
  LogMessage message;
  for (int i = 0; i < 40; ++i) {
    randomise(*expected, random);
    const auto rest = std::make_unique<FrameOutput>();
    randomise(*rest, random);
    MotionInput motionInput;
    randomise(motionInput, random);
    MotionOutput motionOutput;
    randomise(motionOutput, random);
    do {
      ASSERT_TRUE(reader->next(message)) << reader->status().error();
    } while (message.topic() != "input");
    ASSERT_TRUE(decodeAs(message, *read));
    std::string difference;
    ASSERT_FALSE(firstDifference(*expected, *read, &difference)) << i << difference;
  }
  EXPECT_GT(reader->chunkCounts().chunks, 3U);
  EXPECT_EQ(reader->chunkCounts().compression, "zstd");
}

TEST_F(LogChunks, TheSameMessagesGiveTheSameFile) {
  ASSERT_TRUE(writeSampleLog(pathOf("a"), 40));
  ASSERT_TRUE(writeSampleLog(pathOf("b"), 40));
  EXPECT_TRUE(contentOf(pathOf("a")) == contentOf(pathOf("b")));
}

TEST_F(LogChunks, MakeImagesSmaller) {
  const std::string chunked = pathOf("chunked");
  const std::string plain = pathOf("plain");
  for (const auto& [path, options] :
       {std::pair{chunked, defaultLogOptions()}, std::pair{plain, LogOptions{}}}) {
    LogWriter log = std::move(*LogWriter::open(path, options));
    const auto frame = std::make_unique<FrameInput>();  // one colour
    for (int i = 0; i < 30; ++i) log.write("input", TimeUs{i * 33333}, *frame);
    ASSERT_TRUE(log.close());
  }
  EXPECT_LT(std::filesystem::file_size(chunked), std::filesystem::file_size(plain) / 50);
  EXPECT_EQ(readAll(chunked).contents, readAll(plain).contents);
}

// What a killed process leaves is what the file holds before close().
TEST_F(LogChunks, NoMoreThanASecondIsNotYetInTheFile) {
  const std::string path = pathOf("log");
  LogWriter log = std::move(*LogWriter::open(path, chunksOf(1 << 20, "")));
  for (std::int64_t us = 0; us < 5000000; us += 50000) {
    log.write("walk", TimeUs{us}, WalkRequest{});
    EXPECT_GE(readAll(path).messages, (us - 999999) / 50000);
  }
  EXPECT_EQ(readAll(path).messages, 80);
  log.flush();
  EXPECT_EQ(readAll(path).messages, 100);
  EXPECT_EQ(readAll(path).offset, log.bytes());
}

TEST_F(LogChunks, HoldAMegabyteOrASecond) {
  const std::string path = pathOf("log");
  ASSERT_TRUE(writeSampleLog(path, 60));  // 2 s, 7 MB
  const std::vector<FileRecord> records = recordsOf(contentOf(path));
  std::size_t chunks = 0;
  for (const FileRecord& record : records) {
    if (record.op != mcap::Op::chunk) continue;
    mcap::ContentReader content = readerOf(record.content);
    const auto first = content.number<std::uint64_t>();
    const auto last = content.number<std::uint64_t>();
    const auto size = content.number<std::uint64_t>();
    EXPECT_LT(last - first, 1000000000U);
    EXPECT_LT(size, 1300000U);
    ++chunks;
  }
  EXPECT_GE(chunks, 5U);
  EXPECT_LE(chunks, 10U);
}

// Of every cut the reader gives the chunks before it, and says where the last whole record ends.
TEST_F(LogChunks, CutAtAnyByteKeepTheChunksBefore) {
  const std::string path = pathOf("source");
  const std::string whole = logWith(chunksOf(300));
  const std::vector<std::string> all = readAll(path).contents;
  const std::vector<FileRecord> records = recordsOf(whole);
  for (std::size_t size = whole.size() - 1; size >= 8; --size) {
    std::filesystem::resize_file(path, size);
    const Reading reading = readAll(path);
    ASSERT_EQ(reading.error, "") << size;
    ASSERT_TRUE(reading.truncated) << size;
    std::size_t end = 8;
    std::size_t messages = 0;
    for (const FileRecord& record : records) {
      if (record.offset + record.size > size) break;
      end = record.offset + record.size;
      if (record.op == mcap::Op::messageIndex) messages += (record.size - 15) / 16;
    }
    ASSERT_EQ(reading.offset, end) << size;
    ASSERT_GE(reading.contents.size(), messages) << size;  // its indexes may be cut off a chunk
    ASSERT_LE(reading.contents.size(), messages + 6) << size;
    ASSERT_TRUE(std::equal(reading.contents.begin(), reading.contents.end(), all.begin()));
  }
}

// A broken byte may cost messages; a message that is given is as it was written.
TEST_F(LogChunks, AnyByteBrokenGivesNoWrongMessage) {
  for (const char* compression : {"", "zstd"}) {
    const std::string whole = logWith(chunksOf(300, compression));
    const std::string path = pathOf("source");
    const std::vector<std::string> all = readAll(path).contents;
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    Random random(3);
    int damaged = 0;
    for (std::size_t at = 0; at < whole.size(); ++at) {
      const auto place = static_cast<std::streamoff>(at);
      const int broken = whole[at] ^ static_cast<int>(1 + random.index(255));
      file.seekp(place).put(static_cast<char>(broken)).flush();
      const Reading reading = readAll(path);
      for (const std::string& content : reading.contents)
        ASSERT_TRUE(std::find(all.begin(), all.end(), content) != all.end()) << at;
      ASSERT_TRUE(reading.error.empty() || reading.error.find(path + ": byte ") == 0) << at;
      if (!reading.gaps.empty()) ++damaged;
      file.seekp(place).put(whole[at]).flush();
    }
    EXPECT_EQ(readAll(path).contents, all);
    EXPECT_GT(damaged, 1000);
  }
}

TEST_F(LogChunks, ThatDoNotFitTheDiskAreTakenBack) {
  for (const char* compression : {"", "zstd"}) {
    const std::string path = pathOf("log");
    LogWriter log = std::move(*LogWriter::open(path, chunksOf(400, compression)));
    Random random(2);
    withFilesUpTo(2500, [&] {
      for (int i = 0; i < 200; ++i) writeRandom<WalkRequest>(log, "walk", TimeUs{i}, random);
      log.close();
    });
    const std::string place = path + ": byte " + std::to_string(log.bytes());
    EXPECT_EQ(log.status().error(), place + ": cannot write the log: File too large");
    EXPECT_EQ(std::filesystem::file_size(path), log.bytes());
    const Reading reading = readAll(path);
    EXPECT_GT(reading.messages, 8);
    EXPECT_EQ(reading.error, "");
    EXPECT_EQ(reading.offset, log.bytes());
  }
}

TEST_F(LogChunks, AreKeptByALogThatMoves) {
  const std::string path = pathOf("log");
  LogWriter first = std::move(*LogWriter::open(path, chunksOf(300)));
  Random random(2);
  for (int i = 0; i < 10; ++i) writeRandom<WalkRequest>(first, "walk", TimeUs{i}, random);
  LogWriter second = std::move(first);
  for (int i = 0; i < 10; ++i) writeRandom<WalkRequest>(second, "walk", TimeUs{i}, random);
  LogWriter third = std::move(*LogWriter::open(pathOf("other"), chunksOf(300)));
  third = std::move(second);
  ASSERT_TRUE(third.close());
  EXPECT_EQ(readAll(path).messages, 20);
  EXPECT_FALSE(readAll(pathOf("other")).truncated);
}

// A file of one chunk that says of itself what it is made to say.
struct ChunkFile {
  std::string compression;
  std::string stored;
  std::uint64_t size = 0;
  std::uint32_t checksum = 0;

  std::string path() const {
    std::vector<std::uint8_t> bytes(mcap::kMagic.begin(), mcap::kMagic.end());
    mcap::RecordWriter record(bytes);
    record.begin(mcap::Op::chunk);
    for (int i = 0; i < 2; ++i) record.number(std::uint64_t{0});
    record.number(size);
    record.number(checksum);
    record.string(compression);
    record.number(static_cast<std::uint64_t>(stored.size()));
    record.bytes(stored.data(), stored.size());
    record.end();
    return fileWith("chunk", {bytes.begin(), bytes.end()});
  }
  std::string error() const {
    const std::string file = path();
    const Reading reading = readAll(file);
    if (reading.gaps.size() == 1 && reading.gaps[0].from == 8) return reading.gaps[0].what;
    const std::string place = file + ": byte 8: ";
    return reading.error.compare(0, place.size(), place) == 0 ? reading.error.substr(place.size())
                                                              : "at " + reading.error;
  }
};

// Schemas, channels and messages of a small log.
std::string someRecords() {
  std::string records;
  const std::string log = logWith(LogOptions{});
  for (const FileRecord& record : recordsOf(log)) {
    if (record.op == mcap::Op::dataEnd) break;
    if (record.op != mcap::Op::header) records += log.substr(record.offset, record.size);
  }
  return records;
}

std::string zstd(const std::string& content) {
  std::string out(ZSTD_compressBound(content.size()), '\0');
  out.resize(ZSTD_compress(out.data(), out.size(), content.data(), content.size(), 19));
  return out;
}

TEST_F(LogChunks, OfOthersAreReadWithAndWithoutChecksum) {
  const std::string records = someRecords();
  const auto* data = reinterpret_cast<const std::uint8_t*>(records.data());
  for (const std::uint32_t checksum : {0U, crc32(data, records.size())}) {
    EXPECT_EQ(readAll(ChunkFile{"", records, records.size(), checksum}.path()).messages, 30);
    EXPECT_EQ(readAll(ChunkFile{"zstd", zstd(records), records.size(), checksum}.path()).messages,
              30);
  }
  const ChunkFile wrong{"", records, records.size(), 1};
  EXPECT_EQ(wrong.error(), "damaged chunk: wrong checksum");
  const ChunkFile lz4{"lz4", records, records.size(), 0};
  EXPECT_EQ(lz4.error(), "compressed with lz4, which we cannot read");
}

TEST_F(LogChunks, InsideChunksAreRefused) {
  const std::string inner = contentOf(ChunkFile{"", someRecords(), someRecords().size(), 0}.path());
  const std::string chunk = inner.substr(8);  // without the magic
  const ChunkFile outer{"", chunk, chunk.size(), 0};
  EXPECT_EQ(outer.error(), "a chunk inside a chunk");
  const ChunkFile compressed{"zstd", zstd(chunk), chunk.size(), 0};
  EXPECT_EQ(compressed.error(), "a chunk inside a chunk");
}

TEST_F(LogChunks, WithMoreOrLessInsideThanTheySayAreRefused) {
  const std::string small = zstd(std::string(1000, 'x'));
  for (const std::uint64_t size : {0U, 1U, 999U, 1001U, 200000000U}) {
    const ChunkFile chunk{"zstd", small, size, 0};
    EXPECT_EQ(chunk.error().substr(0, 20), "damaged chunk: zstd:") << size;
  }
  const ChunkFile plain{"", "abc", 4, 0};
  EXPECT_EQ(plain.error(), "damaged chunk: says that it holds 4 bytes, has 3");
}

// Kilobytes, the most that this process has used so far.
long peakMemory() {
  struct rusage usage {};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

// 3 GB of zeros in 100 KB, and a chunk that only says so: no memory is taken for either.
TEST_F(LogChunks, BombsAreRefusedWithoutMemoryForThem) {
  const std::string bomb = zstd(std::string(3U << 20, '\0'));
  std::string bombs;
  for (int i = 0; i < 1000; ++i) bombs += bomb;
  const ChunkFile said{"zstd", bombs, 3000ULL << 20, 0};
  const ChunkFile unsaid{"zstd", bombs, 3U << 20, 0};
  const ChunkFile lie{"zstd", bomb, 255U << 20, 0};
  const long before = peakMemory();
  EXPECT_EQ(said.error(), "damaged chunk: says that it holds 3145728000 bytes");
  EXPECT_EQ(unsaid.error().substr(0, 20), "damaged chunk: zstd:");
  EXPECT_EQ(lie.error().substr(0, 20), "damaged chunk: zstd:");
  EXPECT_LT(peakMemory() - before, 50000);
}

}  // namespace
}  // namespace kelpie
