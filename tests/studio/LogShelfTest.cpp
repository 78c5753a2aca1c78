// SPDX-License-Identifier: Apache-2.0
// Logs of every kind on the shelf: each can be read by index, or is refused in a line.
#include "robot/core/log/LogIndex.h"
#include "tests/core/LogFiles.h"
#include "tools/sim/world/Truth.h"
#include "tools/studio/LogShelf.h"

namespace kelpie::studio {
namespace {

namespace fs = std::filesystem;

class Shelf : public LogFiles {
 protected:
  static std::string logOf(const std::string& name, const LogOptions& options) {
    auto log = LogWriter::open(pathOf(name), options);
    for (int i = 0; i < 200; ++i) log->write(sim::kTruthTopic, TimeUs{1000 * i}, sim::TruthFrame{});
    EXPECT_TRUE(log->close());
    return pathOf(name);
  }
  static bool isIndexed(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const auto summary = readSummary(file, fs::file_size(path));
    mcap::ContentReader content(summary.data(), summary.size());
    while (content.left() > 0 && content.good())
      if (content.record().op == mcap::Op::chunkIndex) return true;
    return false;
  }
  LogShelf shelf;
};

TEST_F(Shelf, ALogWithAnIndexIsReadWhereItLies) {
  const std::string log = logOf("red-1.mcap", chunksOf(500));
  ASSERT_TRUE(shelf.add(log));
  ASSERT_EQ(shelf.logs().size(), 1U);
  EXPECT_EQ(shelf.logs()[0].name, "red-1.mcap");
  EXPECT_EQ(shelf.logs()[0].path, log);
  EXPECT_EQ(shelf.logs()[0].bytes, fs::file_size(log));
  EXPECT_TRUE(shelf.logs()[0].notes.empty());
}

TEST_F(Shelf, ALogWithoutChunksIsCopiedIntoOneWithAnIndex) {
  const std::string log = logOf("plain.mcap", {});
  const std::string before = contentOf(log);
  ASSERT_TRUE(shelf.add(log));
  const ShelvedLog& shelved = shelf.logs().at(0);
  EXPECT_EQ(shelved.name, "plain.mcap");
  EXPECT_NE(shelved.path, log);
  EXPECT_TRUE(isIndexed(shelved.path));
  EXPECT_EQ(readAll(shelved.path).contents, readAll(log).contents);
  EXPECT_EQ(contentOf(log), before);
}

TEST_F(Shelf, ALogThatIsCutOffGivesWhatItHoldsAndSaysSo) {
  for (const LogOptions& kind : {LogOptions{}, chunksOf(500)}) {
    const std::string whole = contentOf(logOf("whole.mcap", kind));
    LogShelf own;
    ASSERT_TRUE(own.add(fileWith("cut.mcap", whole.substr(0, whole.size() / 2))));
    const ShelvedLog& shelved = own.logs().at(0);
    EXPECT_TRUE(isIndexed(shelved.path));
    EXPECT_GT(readAll(shelved.path).messages, 10);
    EXPECT_LT(readAll(shelved.path).messages, 200);
    EXPECT_FALSE(shelved.notes.empty());
  }
}

TEST_F(Shelf, AMatchThatWasKilledGivesItsParts) {
  const std::string folder = pathOf("killed");
  fs::create_directories(folder + "/playing");
  logOf("killed/match.mcap", chunksOf(500));
  logOf("killed/playing/red-1.mcap", {});
  ASSERT_TRUE(shelf.addMatch(folder));
  ASSERT_EQ(shelf.logs().size(), 1U);
  EXPECT_EQ(shelf.logs()[0].name, "red-1.mcap");
  shelf.clear();
  fs::remove_all(folder + "/playing");
  ASSERT_TRUE(shelf.addMatch(folder));
  ASSERT_EQ(shelf.logs().size(), 1U);
  EXPECT_EQ(shelf.logs()[0].name, "match.mcap");
}

TEST_F(Shelf, ADamagedLogGivesTheRest) {
  std::string log = contentOf(logOf("whole.mcap", {}));
  for (std::size_t i = log.size() / 2; i < log.size() / 2 + 40; ++i) log[i] = '\xA5';
  log.resize(log.size() - 100);
  const Status added = shelf.add(fileWith("damaged.mcap", log));
  ASSERT_TRUE(added) << added.error();
  EXPECT_GT(readAll(shelf.logs().at(0).path).messages, 100);
}

TEST_F(Shelf, AFolderGivesItsLogsInAlphabeticalOrder) {
  logOf("b.mcap", chunksOf(500));
  logOf("a.mcap", {});
  std::ofstream(pathOf("notes.txt")) << "no log";
  fs::create_directory(pathOf("deeper"));
  fs::copy(pathOf("a.mcap"), pathOf("deeper/c.mcap"));
  ASSERT_TRUE(shelf.add(folderOfTest()));
  ASSERT_EQ(shelf.logs().size(), 2U);
  EXPECT_EQ(shelf.logs()[0].name, "a.mcap");
  EXPECT_EQ(shelf.logs()[1].name, "b.mcap");
}

TEST_F(Shelf, AnEmptyFolderIsNoError) {
  EXPECT_TRUE(shelf.add(folderOfTest()));
  EXPECT_TRUE(shelf.addFolder(pathOf("none")));
  EXPECT_TRUE(shelf.logs().empty());
}

TEST_F(Shelf, WhatIsNoLogIsRefusedInALineThatNamesIt) {
  for (const std::string& path :
       {fileWith("empty.mcap", ""), fileWith("text.mcap", "this is no log"),
        fileWith("magic.mcap", std::string("\x89MCAP0\r\n")), pathOf("none.mcap")}) {
    const Status added = shelf.add(path);
    ASSERT_FALSE(added) << path;
    EXPECT_NE(added.error().find(path), std::string::npos) << added.error();
    EXPECT_EQ(added.error().find('\n'), std::string::npos) << added.error();
  }
  EXPECT_TRUE(shelf.logs().empty());
}

TEST_F(Shelf, OfAFolderWithSomethingThatIsNoLogTheOthersAreThere) {
  logOf("a.mcap", chunksOf(500));
  fileWith("b.mcap", "no log");
  logOf("c.mcap", chunksOf(500));
  const Status added = shelf.addFolder(folderOfTest());
  EXPECT_FALSE(added);
  EXPECT_NE(added.error().find("b.mcap"), std::string::npos) << added.error();
  EXPECT_EQ(shelf.logs().size(), 2U);
}

TEST_F(Shelf, CopiesGoWithTheShelf) {
  std::string copy;
  {
    LogShelf own;
    ASSERT_TRUE(own.add(logOf("plain.mcap", {})));
    copy = own.logs().at(0).path;
    EXPECT_TRUE(fs::exists(copy));
  }
  EXPECT_FALSE(fs::exists(copy));
}

}  // namespace
}  // namespace kelpie::studio
