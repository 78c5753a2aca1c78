// SPDX-License-Identifier: Apache-2.0
// Matches that begin and end in a folder, and recorded logs played by the clock.
#include "tests/live/Relayed.h"

namespace kelpie::live {
namespace {

// FOLDER/playing, as a match makes it.
class Followed : public Relayed {
 protected:
  static std::string playing() { return pathOf("out/playing"); }
  static LogWriter begun(const std::string& name, TeamColour team, std::uint8_t player) {
    fs::create_directories(playing());
    LogWriter log = std::move(*LogWriter::open(playing() + "/" + name, LogOptions{}));
    writeConfig(log, team, player);
    return log;
  }
  bool becomes(const std::function<bool()>& fact) { return Relayed::becomes(feed, fact); }
  bool becomesPlaying(bool so) {
    return becomes([&] { return feed.playing() == so; });
  }

  FolderFeed feed{pathOf("out"), viewers, studio};
};

TEST_F(Followed, AFolderWithoutAMatchIsWaitedFor) {
  feed.poll();
  EXPECT_FALSE(feed.playing());
  const LogWriter log = begun("red-1.mcap", TeamColour::red, 1);
  EXPECT_TRUE(becomesPlaying(true));
  EXPECT_TRUE(becomes([this] { return offered("/live/red-1/config") == 1; }));
  EXPECT_TRUE(page.said("unadvertise").empty());
}

TEST_F(Followed, MessagesComeAsTheyAreWrittenAlsoOfALogThatComesLater) {
  LogWriter red = begun("red-1.mcap", TeamColour::red, 1);
  ASSERT_TRUE(becomes([this] { return offered("/live/red-1/config") == 1; }));
  writeFrame(red, 1000);
  ASSERT_TRUE(becomes([this] { return offered("/live/red-1/frame/output") == 1; }));
  studio.hear(page, subscribing(1, page.channelOf("/live/red-1/frame/output")));
  writeFrame(red, 34000);
  EXPECT_TRUE(becomes([this] { return page.frames.size() == 1; }));
  LogWriter blue = begun("blue-2.mcap", TeamColour::blue, 2);
  EXPECT_TRUE(becomes([this] { return offered("/live/blue-2/config") == 1; }));
}

TEST_F(Followed, AMatchThatEndsIsToldAndTheNextBeginsAnew) {
  {
    LogWriter log = begun("red-1.mcap", TeamColour::red, 1);
    ASSERT_TRUE(becomes([this] { return offered("/live/red-1/config") == 1; }));
  }
  fs::remove_all(playing());
  ASSERT_TRUE(becomesPlaying(false));
  EXPECT_EQ(viewer.said("status").back().at("message"), "the match is over");
  const LogWriter next = begun("blue-3.mcap", TeamColour::blue, 3);
  EXPECT_TRUE(becomes([this] { return offered("/live/blue-3/config") == 1; }));
  EXPECT_EQ(offered("/live/red-1/config"), 0U);
  EXPECT_EQ(viewer.said("unadvertise").size(), 1U);
}

// A file system may give the number of a folder that was removed to the next that is made.
TEST_F(Followed, AMatchThatBeginsAtOnceBehindAnotherIsAnother) {
  for (int i = 0; i < 5; ++i) {
    const std::size_t before = page.said("unadvertise").size();
    {
      LogWriter log = begun("red-1.mcap", TeamColour::red, 1);
      ASSERT_TRUE(becomes([this] { return offered("/live/red-1/config") == 1; }));
    }
    fs::remove_all(playing());
    const LogWriter log = begun("red-1.mcap", TeamColour::red, 1);
    ASSERT_TRUE(becomes([&] { return page.said("unadvertise").size() > before; })) << i;
    ASSERT_TRUE(becomes([this] { return offered("/live/red-1/config") == 1; }));
    fs::remove_all(playing());
    ASSERT_TRUE(becomesPlaying(false));
  }
}

TEST_F(Followed, AKilledMatchThatWasMovedAwayMakesPlaceForAnother) {
  LogWriter killed = begun("red-1.mcap", TeamColour::red, 1);
  ASSERT_TRUE(becomes([this] { return offered("/live/red-1/config") == 1; }));
  fs::create_directories(pathOf("out/earlier/1"));
  fs::rename(playing(), pathOf("out/earlier/1/playing"));
  const LogWriter next = begun("red-1.mcap", TeamColour::red, 1);
  EXPECT_TRUE(becomes([this] { return page.said("unadvertise").size() == 1; }));
  EXPECT_TRUE(becomes([this] { return offered("/live/red-1/config") == 1; }));
}

TEST_F(Followed, AMatchThatNobodyPlaysAnyMoreIsOverThoughItsLogsAreThere) {
  bool held = true;
  FolderFeed watched(pathOf("out"), viewers, studio, [&held] { return held; });
  const LogWriter log = begun("red-1.mcap", TeamColour::red, 1);
  ASSERT_TRUE(Relayed::becomes(watched, [&] { return watched.playing(); }));
  held = false;
  ASSERT_TRUE(Relayed::becomes(watched, [&] { return !watched.playing(); }));
  EXPECT_EQ(viewer.said("status").back().at("message"), "the match is over");
}

TEST_F(Followed, AFolderThatIsRemovedEndsItsMatch) {
  LogWriter log = begun("red-1.mcap", TeamColour::red, 1);
  ASSERT_TRUE(becomesPlaying(true));
  fs::remove_all(pathOf("out"));
  EXPECT_TRUE(becomesPlaying(false));
  writeFrame(log, 1000);
  feed.poll();
}

TEST_F(Followed, WhatIsNoLogIsNotFollowed) {
  const LogWriter log = begun("red-1.mcap", TeamColour::red, 1);
  std::ofstream(playing() + "/blue-1.mcap") << "this is no log";
  std::ofstream(playing() + "/notes.txt") << "nor this";
  fs::create_directory(playing() + "/folder.mcap");
  EXPECT_TRUE(becomes([this] { return offered("/live/red-1/config") == 1; }));
  EXPECT_EQ(page.topics().size(), 1U);
}

using Playback = Relayed;

TEST_F(Playback, BeginsWhenSomebodyWatchesAndEndsWithTheLastLog) {
  writeRobot("a.mcap", TeamColour::red, 1);
  writeRobot("b.mcap", TeamColour::blue, 2, 20000);
  Hub idleViewers("viewers", 1), idleStudio("studio", 1);
  auto feed = PlaybackFeed::open({pathOf("a.mcap"), pathOf("b.mcap")}, idleViewers, idleStudio);
  ASSERT_TRUE(feed) << feed.error();
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  (*feed)->poll();
  EXPECT_FALSE((*feed)->ended());
  EXPECT_FALSE(idleStudio.isOffered("/live/red-1/config"));
  FakePeer late;
  idleStudio.enter(late);
  EXPECT_TRUE(becomes(**feed, [&] { return (*feed)->ended(); }));
  for (const char* topic : {"/live/red-1/frame/output", "/live/blue-2/frame/output"})
    EXPECT_TRUE(idleStudio.isOffered(topic)) << topic;
  (*feed)->poll();
}

TEST_F(Playback, RefusesWhatHoldsNoMessagesInALine) {
  { const auto log = std::move(*LogWriter::open(pathOf("empty.mcap"))); }
  writeRobot("a.mcap", TeamColour::red, 1);
  for (const std::string& bad : {pathOf("empty.mcap"), fileWith("text", "x"), pathOf("none")}) {
    const auto feed = PlaybackFeed::open({pathOf("a.mcap"), bad}, viewers, studio);
    ASSERT_FALSE(feed) << bad;
    EXPECT_NE(feed.error().find(bad), std::string::npos) << feed.error();
  }
  EXPECT_FALSE(PlaybackFeed::open({folderOfTest()}, viewers, studio));
  EXPECT_FALSE(PlaybackFeed::open({}, viewers, studio));
}

}  // namespace
}  // namespace kelpie::live
