// SPDX-License-Identifier: Apache-2.0
// What a log says at its end of where everything stands, checked against the file record by record;
// and seeking, checked against reading from the start.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "robot/core/Checksum.h"
#include "tests/core/LogFiles.h"
#include "tests/core/SampleLog.h"

namespace kelpie {
namespace {

using mcap::ContentReader;
using mcap::Op;
using Bytes = std::vector<std::uint8_t>;

class LogIndexes : public LogFiles {};

// 200 messages within 4 s, their times out of order by up to 30 ms, and what stands outside chunks.
void writeLog(const std::string& path, const LogOptions& options) {
  LogWriter log = std::move(*LogWriter::open(path, options));
  Random random(7);
  log.metadata("start", {{"a", "b"}});
  for (int i = 0; i < 200; ++i) {
    const TimeUs time{i * 20000 + static_cast<std::int64_t>(random.index(30000))};
    if (i % 90 == 50) log.attachment("table", "text/plain", {1, 2, 3});
    if (i % 3 == 0) writeRandom<HeadRequest>(log, "head", time, random);
    if (i % 3 != 0) writeRandom<WalkRequest>(log, i > 100 ? "late" : "walk", time, random);
  }
  log.metadata("end", {{"c", "d"}});
  ASSERT_TRUE(log.close());
}

// A log's bytes and its records by their place.
struct LogBytes {
  std::string bytes;
  std::vector<FileRecord> records;
  std::map<std::uint64_t, const FileRecord*> at;

  explicit LogBytes(const std::string& path) : bytes(contentOf(path)), records(recordsOf(bytes)) {
    for (const FileRecord& record : records) at[record.offset] = &record;
  }
  std::vector<const FileRecord*> of(Op op) const {
    std::vector<const FileRecord*> found;
    for (const FileRecord& record : records)
      if (record.op == op) found.push_back(&record);
    return found;
  }
};

// The records in a chunk, checked against what the chunk says of them.
std::string contentOfChunk(const FileRecord& chunk) {
  ContentReader content = readerOf(chunk.content);
  content.take(16);
  const auto size = content.number<std::uint64_t>();
  const auto checksum = content.number<std::uint32_t>();
  const std::string compression = content.string();
  const auto stored = content.number<std::uint64_t>();
  EXPECT_EQ(stored, content.left());
  Bytes records(content.data(), content.data() + content.left());
  if (!compression.empty()) {
    const Bytes packed = records;
    EXPECT_TRUE(
        makeDecompressor(compression)
            ->decompress(packed.data(), packed.size(), static_cast<std::size_t>(size), records));
  }
  EXPECT_EQ(records.size(), size);
  EXPECT_EQ(crc32(records.data(), records.size()), checksum);
  return {records.begin(), records.end()};
}

// Each entry of a message index must point at a message of its channel and time. Returns the times.
std::vector<std::uint64_t> checkMessageIndex(const FileRecord& index, const std::string& records) {
  ContentReader content = readerOf(index.content);
  const auto channel = content.number<std::uint16_t>();
  const std::size_t length = content.number<std::uint32_t>();
  EXPECT_EQ(length, content.left());
  std::vector<std::uint64_t> times;
  while (content.left() > 0) {
    times.push_back(content.number<std::uint64_t>());
    const std::string found = records.substr(content.number<std::uint64_t>());
    ContentReader message = readerOf(found);
    EXPECT_EQ(message.number<Op>(), Op::message);
    message.take(8);
    EXPECT_EQ(message.number<std::uint16_t>(), channel);
    message.take(4);
    EXPECT_EQ(message.number<std::uint64_t>(), times.back());
  }
  return times;
}

// A chunk as its index in the summary has it; gives the number of its messages.
std::size_t checkChunkIndex(const LogBytes& log, const FileRecord& index) {
  ContentReader content = readerOf(index.content);
  const auto first = content.number<std::uint64_t>();
  const auto last = content.number<std::uint64_t>();
  const FileRecord& chunk = *log.at.at(content.number<std::uint64_t>());
  EXPECT_EQ(chunk.op, Op::chunk);
  EXPECT_EQ(content.number<std::uint64_t>(), chunk.size);
  const std::string records = contentOfChunk(chunk);
  std::vector<std::uint64_t> times;
  std::size_t lengths = 0;
  const std::size_t channels = content.number<std::uint32_t>() / 10;
  for (std::size_t i = 0; i < channels; ++i) {
    const auto channel = content.number<std::uint16_t>();
    const FileRecord& messages = *log.at.at(content.number<std::uint64_t>());
    EXPECT_EQ(messages.op, Op::messageIndex);
    EXPECT_EQ(readerOf(messages.content).number<std::uint16_t>(), channel);
    lengths += messages.size;
    const auto some = checkMessageIndex(messages, records);
    times.insert(times.end(), some.begin(), some.end());
  }
  EXPECT_EQ(content.number<std::uint64_t>(), lengths);
  EXPECT_EQ(log.at.count(chunk.offset + chunk.size + lengths), 1U);
  EXPECT_EQ(first, *std::min_element(times.begin(), times.end()));
  EXPECT_EQ(last, *std::max_element(times.begin(), times.end()));
  ContentReader head = readerOf(chunk.content);
  EXPECT_EQ(head.number<std::uint64_t>(), first);
  EXPECT_EQ(head.number<std::uint64_t>(), last);
  EXPECT_EQ(content.string(), "zstd");
  EXPECT_LT(content.number<std::uint64_t>(), chunk.size);
  EXPECT_EQ(content.number<std::uint64_t>(), records.size());
  EXPECT_TRUE(content.good());
  EXPECT_EQ(content.left(), 0U);
  return times.size();
}

TEST_F(LogIndexes, PointAtEveryChunkAndMessage) {
  const std::string path = pathOf("log");
  writeLog(path, chunksOf(800));
  const LogBytes log(path);
  EXPECT_EQ(log.of(Op::message).size(), 0U);
  EXPECT_GT(log.of(Op::chunk).size(), 10U);
  EXPECT_EQ(log.of(Op::chunkIndex).size(), log.of(Op::chunk).size());
  std::size_t messages = 0;
  for (const FileRecord* index : log.of(Op::chunkIndex)) messages += checkChunkIndex(log, *index);
  EXPECT_EQ(messages, 200U);
}

TEST_F(LogIndexes, PointAtAttachmentsAndMetadata) {
  const std::string path = pathOf("log");
  writeLog(path, chunksOf(800));
  const LogBytes log(path);
  for (const auto& [index, op] : {std::pair{Op::attachmentIndex, Op::attachment},
                                  std::pair{Op::metadataIndex, Op::metadata}}) {
    const auto found = log.of(index);
    EXPECT_EQ(found.size(), 2U);
    EXPECT_EQ(log.of(op).size(), 2U);
    for (const FileRecord* record : found) {
      ContentReader content = readerOf(record->content);
      const FileRecord& there = *log.at.at(content.number<std::uint64_t>());
      EXPECT_EQ(there.op, op);
      EXPECT_EQ(content.number<std::uint64_t>(), there.size);
    }
  }
}

// With and without chunks: footer, summary offsets and counts.
TEST_F(LogIndexes, SummaryIsFoundByTheFooterAndByItsOffsets) {
  for (const LogOptions& options : {LogOptions{}, chunksOf(800)}) {
    const std::string path = pathOf("log");
    writeLog(path, options);
    const LogBytes log(path);
    const FileRecord& footer = log.records.back();
    ASSERT_EQ(footer.op, Op::footer);
    ContentReader content = readerOf(footer.content);
    const auto start = content.number<std::uint64_t>();
    const auto offsets = content.number<std::uint64_t>();
    EXPECT_EQ(log.at.at(start)->op, Op::schema);
    EXPECT_EQ(log.at.at(offsets)->op, Op::summaryOffset);
    const FileRecord& dataEnd = *log.of(Op::dataEnd)[0];
    EXPECT_EQ(dataEnd.offset + dataEnd.size, start);
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(log.bytes.data());
    EXPECT_EQ(content.number<std::uint32_t>(),
              crc32(bytes + start, footer.offset + 9 + 16 - start));
    std::uint64_t at = start;
    for (const FileRecord* record : log.of(Op::summaryOffset)) {
      ContentReader group = readerOf(record->content);
      const auto op = group.number<Op>();
      EXPECT_EQ(group.number<std::uint64_t>(), at);
      const std::uint64_t end = at + group.number<std::uint64_t>();
      for (; at < end; at += log.at.at(at)->size) EXPECT_EQ(log.at.at(at)->op, op);
      EXPECT_EQ(at, end);
    }
    EXPECT_EQ(at, offsets);
  }
}

TEST_F(LogIndexes, StatisticsCountWhatIsThere) {
  for (const LogOptions& options : {LogOptions{}, chunksOf(800)}) {
    const std::string path = pathOf("log");
    writeLog(path, options);
    const LogBytes log(path);
    ContentReader content = readerOf(log.of(Op::statistics)[0]->content);
    EXPECT_EQ(content.number<std::uint64_t>(), 200U);
    EXPECT_EQ(content.number<std::uint16_t>(), 2U);  // schemas
    EXPECT_EQ(content.number<std::uint32_t>(), 3U);  // channels
    EXPECT_EQ(content.number<std::uint32_t>(), 2U);  // attachments
    EXPECT_EQ(content.number<std::uint32_t>(), 2U);  // metadata
    EXPECT_EQ(content.number<std::uint32_t>(), log.of(Op::chunk).size());
    LogMessage message;
    auto reader = LogReader::open(path);
    std::int64_t first = 1LL << 60;
    std::int64_t last = 0;
    while (reader->next(message)) {
      first = std::min(first, message.time.us);
      last = std::max(last, message.time.us);
    }
    EXPECT_EQ(content.number<std::uint64_t>(), first * 1000U);
    EXPECT_EQ(content.number<std::uint64_t>(), last * 1000U);
    std::size_t messages = 0;
    EXPECT_EQ(content.number<std::uint32_t>(), 30U);
    for (int i = 0; i < 3; ++i) {
      content.number<std::uint16_t>();
      messages += content.number<std::uint64_t>();
    }
    EXPECT_EQ(messages, 200U);
  }
}

// What seek() should give: the first message of that time or later, and all behind it.
std::vector<std::string> scanned(const std::string& path, TimeUs time) {
  std::vector<std::string> contents;
  auto reader = LogReader::open(path);
  LogMessage message;
  while (reader->next(message))
    if (!contents.empty() || time <= message.time) contents.push_back(contentOf(message));
  return contents;
}

// Of every message, in random order, and between them, before the first and after the last.
std::vector<TimeUs> timesToSeek(const std::string& path) {
  Random random(11);
  std::vector<TimeUs> times = {{-1}, {0}, {5000000}};
  auto reader = LogReader::open(path);
  LogMessage message;
  while (reader->next(message)) {
    times.insert(times.begin() + random.index(static_cast<std::uint32_t>(times.size())),
                 message.time);
    times.push_back({message.time.us + random.index(20000)});
  }
  return times;
}

TEST_F(LogIndexes, SeekingGivesWhatScanningGives) {
  const std::string whole = pathOf("whole");
  writeLog(whole, chunksOf(800));
  const std::string cut = fileWith("cut", contentOf(whole).substr(0, 9000));
  const std::string plain = pathOf("plain");
  writeLog(plain, LogOptions{});
  for (const std::string& path : {whole, cut, plain}) {
    auto reader = LogReader::open(path);
    for (const TimeUs time : timesToSeek(whole)) {
      reader->seek(time);
      const Reading reading = readOn(*reader);
      ASSERT_EQ(reading.error, "");
      ASSERT_EQ(reading.truncated, path == cut);
      ASSERT_EQ(reading.contents, scanned(path, time)) << path << " " << time.us;
    }
  }
}

TEST_F(LogIndexes, SeekingReadsOneChunk) {
  const std::string path = pathOf("log");
  writeLog(path, chunksOf(800));
  auto reader = LogReader::open(path);
  LogMessage message;
  reader->seek(TimeUs{3000000});
  ASSERT_TRUE(reader->next(message));
  EXPECT_GE(message.time.us, 3000000);
  EXPECT_LE(message.time.us, 3050000);
  EXPECT_EQ(reader->chunkCounts().chunks, 1U);
}

TEST_F(LogIndexes, SeekingBackMeetsMetadataOnce) {
  const std::string path = pathOf("log");
  writeLog(path, chunksOf(800));
  auto reader = LogReader::open(path);
  EXPECT_EQ(readOn(*reader).messages, 200);
  reader->seek(TimeUs{-1});
  EXPECT_EQ(readOn(*reader).messages, 200);
  EXPECT_EQ(reader->metadata().size(), 2U);
  EXPECT_EQ(reader->attachments().size(), 2U);
}

// The summary's checksum finds the damage, and the log is read from its start.
TEST_F(LogIndexes, DamagedIndexIsNotUsed) {
  const std::string path = pathOf("log");
  writeLog(path, chunksOf(800));
  const LogBytes log(path);
  std::string broken = log.bytes;
  broken[log.of(Op::chunkIndex)[5]->offset + 9 + 16] ^= 0x55;  // where its chunk stands
  const std::string damaged = fileWith("damaged", broken);
  auto reader = LogReader::open(damaged);
  reader->seek(TimeUs{3000000});
  EXPECT_EQ(readOn(*reader).contents, scanned(path, TimeUs{3000000}));
  EXPECT_GT(reader->chunkCounts().chunks, 10U);
}

// Its checksum is left out, so that nothing finds the damage.
TEST_F(LogIndexes, AnyByteOfAnIndexBrokenGivesNoWrongMessage) {
  const std::string path = pathOf("log");
  writeLog(path, chunksOf(800));
  const std::vector<std::string> all = readAll(path).contents;
  std::string whole = contentOf(path);
  const std::size_t start = LogBytes(path).of(Op::chunkIndex)[0]->offset;
  whole.replace(whole.size() - 12, 4, 4, '\0');
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(static_cast<std::streamoff>(whole.size() - 12)).write("\0\0\0\0", 4).flush();
  Random random(13);
  for (std::size_t at = start; at < whole.size(); ++at) {
    const auto place = static_cast<std::streamoff>(at);
    const int broken = whole[at] ^ static_cast<int>(1 + random.index(255));
    file.seekp(place).put(static_cast<char>(broken)).flush();
    auto reader = LogReader::open(path);
    reader->seek(TimeUs{3500000});
    for (const std::string& content : readOn(*reader).contents)
      ASSERT_TRUE(std::find(all.begin(), all.end(), content) != all.end()) << at;
    file.seekp(place).put(whole[at]).flush();
  }
}

}  // namespace
}  // namespace kelpie
