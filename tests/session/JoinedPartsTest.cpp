// SPDX-License-Identifier: Apache-2.0
// What is reported of the logs that a killed match left is what the joined ones hold.
#include <gtest/gtest.h>

#include "robot/core/log/LogTopics.h"
#include "robot/core/types/PictureFrame.h"
#include "robot/core/types/PlaneFrame.h"
#include "tests/core/LogFiles.h"
#include "tools/session/MatchFolder.h"
#include "tools/sim/world/Truth.h"

namespace kelpie::cli {
namespace {

class JoinedParts : public LogFiles {
 protected:
  // Ten messages of each of two topics of Kelpie's and one that it does not know; frames of planes
  // when the truth is to be thinned.
  static Joined joined(bool planes) {
    std::filesystem::create_directories(pathOf("playing"));
    auto log = LogWriter::open(pathOf("playing/red-1.mcap"));
    for (int i = 0; i < 10; ++i) {
      log->write(sim::kEventTopic, TimeUs{1000 * i}, sim::MatchEvent{});
      log->write(sim::kTruthTopic, TimeUs{1000 * i}, sim::TruthFrame{});
      log->write("/walk", TimeUs{1000 * i}, WalkRequest{});
    }
    if (planes) log->write(kPlaneFrameTopic, TimeUs{}, *std::make_unique<PlaneFrame>());
    if (planes) log->write(kPictureFrameTopic, TimeUs{}, *std::make_unique<PictureFrame>());
    EXPECT_TRUE(log->close());
    const auto logs = joinParts(folderOfTest());
    EXPECT_TRUE(logs) << logs.error();
    return logs->front().holds;
  }
  static std::size_t held() {
    return static_cast<std::size_t>(readAll(pathOf("red-1.mcap")).messages);
  }
};

TEST_F(JoinedParts, WithoutForeignTopicsWhichAreReported) {
  const Joined reported = joined(false);
  EXPECT_EQ(reported.messages, 20U);
  EXPECT_EQ(reported.foreign, 10U);
  EXPECT_EQ(reported.messages, held());
}

TEST_F(JoinedParts, OfAThinnedTruthTellOnlyWhatTheyHold) {
  const Joined reported = joined(true);
  EXPECT_EQ(reported.messages, 14U);
  EXPECT_EQ(reported.foreign, 10U);
  EXPECT_EQ(reported.messages, held());
}

}  // namespace
}  // namespace kelpie::cli
