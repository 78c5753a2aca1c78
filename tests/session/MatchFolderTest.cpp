// SPDX-License-Identifier: Apache-2.0
// What a match leaves in its folder, and where the next one finds it.
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>

#include "tests/core/LogFiles.h"
#include "tools/session/MatchFolder.h"

namespace kelpie::cli {
namespace {

namespace fs = std::filesystem;

class MatchFolders : public LogFiles {
 protected:
  static void make(const std::string& name, int secondsAgo) {
    std::ofstream(pathOf(name)) << name;
    fs::last_write_time(pathOf(name),
                        fs::file_time_type::clock::now() - std::chrono::seconds(secondsAgo));
  }
  static void kill(int secondsAgo) {
    fs::create_directories(pathOf("playing"));
    make("playing/red-1.mcap", 0);
    fs::last_write_time(pathOf("playing"),
                        fs::file_time_type::clock::now() - std::chrono::seconds(secondsAgo));
  }
};

TEST_F(MatchFolders, OfAKilledMatchDoNotMixWithTheWholeOneBeforeIt) {
  make("match.mcap", 100);
  kill(50);
  const auto taken = MatchFolder::take(folderOfTest());
  ASSERT_TRUE(taken) << taken.error();
  EXPECT_TRUE(fs::exists(pathOf("earlier/1/match.mcap")));
  EXPECT_TRUE(fs::exists(pathOf("earlier/2/playing/red-1.mcap")));
  EXPECT_FALSE(fs::exists(pathOf("earlier/2/match.mcap")));
}

TEST_F(MatchFolders, KeepWhatAKilledMatchHadJoinedWithItsParts) {
  kill(50);
  make("red-2.mcap", 10);
  const auto taken = MatchFolder::take(folderOfTest());
  ASSERT_TRUE(taken) << taken.error();
  EXPECT_TRUE(fs::exists(pathOf("earlier/1/playing/red-1.mcap")));
  EXPECT_TRUE(fs::exists(pathOf("earlier/1/red-2.mcap")));
  EXPECT_FALSE(fs::exists(pathOf("earlier/2")));
}

}  // namespace
}  // namespace kelpie::cli
