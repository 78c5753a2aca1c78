// SPDX-License-Identifier: Apache-2.0
// A log that is read while it is written, cut or damaged.
#include "tests/core/LogFiles.h"
#include "tools/live/LogTail.h"

namespace kelpie::live {
namespace {

class Tail : public LogFiles {
 protected:
  static std::string logOf(const LogOptions& options, int messages = 40) {
    auto log = LogWriter::open(pathOf("whole.mcap"), options);
    for (int i = 0; i < messages; ++i) {
      WalkRequest walk;
      walk.forward = i;
      log->write(i % 3 == 0 ? "/often" : "/walk", TimeUs{1000 * i}, walk);
    }
    EXPECT_TRUE(log->close());
    return contentOf(pathOf("whole.mcap"));
  }
  static std::vector<std::string> restOf(LogTail& tail) {
    std::vector<std::string> contents;
    LogMessage message;
    while (tail.next(message)) contents.push_back(contentOf(message));
    return contents;
  }
  static void add(std::vector<std::string>& to, const std::vector<std::string>& more) {
    to.insert(to.end(), more.begin(), more.end());
  }
  // What a tail gives of a file that holds this and grows no more.
  static std::vector<std::string> heldBy(const std::string& content) {
    auto tail = LogTail::open(fileWith("held.mcap", content));
    return tail ? restOf(*tail) : std::vector<std::string>{};
  }
};

const std::vector<LogOptions> kKinds = {{}, chunksOf(300, ""), chunksOf(300), chunksOf(1 << 20)};

TEST_F(Tail, OfALogThatGrowsByteByByteGivesWhatTheReaderGives) {
  for (const LogOptions& kind : kKinds) {
    const std::string whole = logOf(kind);
    const std::string path = fileWith("growing.mcap", whole.substr(0, 8));
    auto tail = LogTail::open(path);
    ASSERT_TRUE(tail) << tail.error();
    std::vector<std::string> contents;
    std::ofstream file(path, std::ios::binary | std::ios::app);
    for (std::size_t i = 8; i < whole.size(); ++i) {
      EXPECT_FALSE(tail->ended() && i < 9);
      file << whole[i] << std::flush;
      add(contents, restOf(*tail));
    }
    EXPECT_EQ(contents, readAll(pathOf("whole.mcap")).contents);
    EXPECT_EQ(contents.size(), 40U);
    EXPECT_TRUE(tail->ended());
  }
}

TEST_F(Tail, OfALogWithoutChunksGivesAMessageAsSoonAsItIsThere) {
  auto log = LogWriter::open(pathOf("log.mcap"), LogOptions{});
  auto tail = LogTail::open(pathOf("log.mcap"));
  ASSERT_TRUE(tail) << tail.error();
  for (int i = 0; i < 10; ++i) {
    log->write("/walk", TimeUs{1000 * i}, WalkRequest{});
    EXPECT_EQ(restOf(*tail).size(), 1U);
    EXPECT_EQ(tail->behind(), 0U);
  }
  EXPECT_FALSE(tail->ended());
}

TEST_F(Tail, SaysHowFarItIsBehind) {
  const std::string whole = logOf({});
  auto tail = LogTail::open(fileWith("log.mcap", whole));
  EXPECT_EQ(tail->behind(), whole.size() - 8);
  LogMessage message;
  ASSERT_TRUE(tail->next(message));
  EXPECT_LT(tail->behind(), whole.size() - 8);
}

TEST_F(Tail, OfALogThatIsCutAnywhereGivesTheWholeMessagesBefore) {
  for (const LogOptions& kind : kKinds) {
    const std::string whole = logOf(kind);
    const auto all = heldBy(whole);
    for (std::size_t size = 8; size < whole.size(); size += 31) {
      const auto some = heldBy(whole.substr(0, size));
      ASSERT_LE(some.size(), all.size());
      EXPECT_TRUE(std::equal(some.begin(), some.end(), all.begin())) << size;
    }
  }
}

TEST_F(Tail, OfADamagedLogGivesWhatItCanAndEnds) {
  for (const LogOptions& kind : kKinds) {
    const std::string whole = logOf(kind);
    std::uint64_t chance = 1;
    for (int i = 0; i < 200; ++i) {
      std::string damaged = whole;
      for (int j = 0; j < 3; ++j) {
        chance = chance * 6364136223846793005U + 1442695040888963407U;
        damaged[8 + (chance >> 33) % (whole.size() - 8)] = static_cast<char>(chance >> 25);
      }
      EXPECT_LE(heldBy(damaged).size(), 1000U) << i;
    }
  }
}

std::string record(mcap::Op op, const std::string& content, std::uint64_t length) {
  std::string bytes(1, static_cast<char>(op));
  bytes.append(reinterpret_cast<const char*>(&length), sizeof length);
  return bytes + content;
}
std::string record(mcap::Op op, const std::string& content) {
  return record(op, content, content.size());
}

const std::string kMagic(mcap::kMagic.begin(), mcap::kMagic.end());

TEST_F(Tail, ARecordOfAnEnormousLengthEndsItAndTakesNoMemory) {
  for (const std::uint64_t length : {1ULL << 60, ~0ULL, ~0ULL - 8, 1ULL << 27}) {
    auto tail =
        LogTail::open(fileWith("log.mcap", kMagic + record(mcap::Op::message, "x", length)));
    ASSERT_TRUE(tail);
    LogMessage message;
    EXPECT_FALSE(tail->next(message));
    EXPECT_TRUE(tail->ended());
    EXPECT_FALSE(tail->next(message));
  }
}

std::string chunk(const std::string& compression, const std::string& stored, std::uint64_t size,
                  std::uint64_t length) {
  std::vector<std::uint8_t> bytes;
  mcap::RecordWriter to(bytes);
  to.number(std::uint64_t{0});
  to.number(std::uint64_t{0});
  to.number(size);
  to.number(std::uint32_t{0});
  to.string(compression);
  to.number(length);
  to.bytes(stored.data(), stored.size());
  return record(mcap::Op::chunk, {bytes.begin(), bytes.end()});
}

TEST_F(Tail, AChunkThatLiesOfItsSizeEndsIt) {
  const std::string junk(100, 'j');
  for (const std::string& bad :
       {chunk("zstd", junk, 1ULL << 60, 100), chunk("zstd", junk, 100, 100),
        chunk("", junk, 100, 1ULL << 60), chunk("none that we know", junk, 100, 100),
        chunk("", record(mcap::Op::message, "x", 1ULL << 40), 10, 10)}) {
    auto tail = LogTail::open(fileWith("log.mcap", kMagic + bad));
    ASSERT_TRUE(tail);
    EXPECT_TRUE(restOf(*tail).empty());
    EXPECT_TRUE(tail->ended());
  }
}

// It would be unpacked over itself.
TEST_F(Tail, AChunkInsideAChunkEndsIt) {
  std::string nested = record(mcap::Op::schema, "");
  for (int i = 0; i < 3; ++i) nested = chunk("", nested, nested.size(), nested.size());
  auto tail = LogTail::open(fileWith("log.mcap", kMagic + nested));
  ASSERT_TRUE(tail);
  EXPECT_TRUE(restOf(*tail).empty());
  EXPECT_TRUE(tail->ended());
}

TEST_F(Tail, AMessageOfAChannelThatNobodyDefinedIsPassedOver) {
  const std::string whole = logOf({});
  const std::string stranger = record(mcap::Op::message, std::string(30, '\x77'));
  EXPECT_EQ(heldBy(whole.substr(0, 8) + stranger + whole.substr(8)), heldBy(whole));
}

TEST_F(Tail, AFileThatBeginsAsNoLogIsRefusedInALine) {
  for (const std::string& content : {std::string(), std::string("\x89MCAP"), std::string(100, 'x'),
                                     std::string("\x89MCAP1\r\n")}) {
    const auto tail = LogTail::open(fileWith("file", content));
    ASSERT_FALSE(tail);
    EXPECT_NE(tail.error().find("does not begin as a log"), std::string::npos) << tail.error();
  }
  EXPECT_FALSE(LogTail::open(pathOf("none")));
  EXPECT_FALSE(LogTail::open(folderOfTest()));
}

// As another process may cut its log off, and write on.
TEST_F(Tail, AFileThatShrinksGivesNothingMore) {
  const std::string whole = logOf({});
  const std::string path = fileWith("log.mcap", whole.substr(0, whole.size() / 2));
  auto tail = LogTail::open(path);
  const std::size_t before = restOf(*tail).size();
  EXPECT_GT(before, 0U);
  std::filesystem::resize_file(path, 100);
  EXPECT_TRUE(restOf(*tail).empty());
  EXPECT_EQ(tail->behind(), 0U);
}

}  // namespace
}  // namespace kelpie::live
