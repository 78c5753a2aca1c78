// SPDX-License-Identifier: Apache-2.0
// What vision finds in each recorded scene beside what a person sees there. Each test is one
// picture; a better vision passes them as they are.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/data/record/RecordedVision.h"
#include "vision/Refusal.h"

namespace kelpie::recorded {
namespace {

const std::string kFolder = KELPIE_SOURCE_DIR "/tests/data";

std::vector<Scene> allScenes() {
  const auto scenes = readScenes(kFolder);
  if (!scenes) ADD_FAILURE() << scenes.error();
  return scenes ? *scenes : std::vector<Scene>{};
}

std::string textOf(const Found& found) {
  return fmt::format("{} at {:.0f} cm, {:.0f} deg", found.what, found.distance,
                     found.heading.deg());
}
std::string refusedIn(const Percepts& seen) {
  std::string text;
  for (std::size_t i = 0; i < vision::kRefusalCount; ++i)
    if (seen.counts.refused[i] > 0)
      text += fmt::format(" {} {}", vision::kRefusalNames[i].name, seen.counts.refused[i]);
  return text;
}

std::string textOf(const SeenThing& thing) {
  return fmt::format("{} at {:.0f} cm, {:.0f} deg{}{}", thing.what, thing.distance,
                     thing.heading.deg(), thing.cut ? ", cut" : "", thing.hidden ? ", hidden" : "");
}

std::string textOf(const std::vector<Found>& all) {
  std::string text;
  for (const Found& found : all) text += "\n  " + textOf(found);
  return text.empty() ? " nothing" : text;
}

TEST(RecordedScenes, AreSixtyClassPlanesAndTwelveFramesOrMoreOfBothKindsOfWorld) {
  const std::vector<Scene> scenes = allScenes();
  const auto count = [&](auto&& which) {
    return std::count_if(scenes.begin(), scenes.end(), which);
  };
  EXPECT_GE(count([](const Scene& s) { return !s.frame; }), 60);
  EXPECT_GE(count([](const Scene& s) { return s.frame; }), 12);
  EXPECT_GE(count([](const Scene& s) { return s.randomised; }), 30);
  EXPECT_GE(count([](const Scene& s) { return s.things.empty(); }), 8) << "empty views";
}

// How many things of one kind, as the end of their name, a person names at once and vision finds.
struct Tally {
  int named = 0;
  int found = 0;
};

bool endsWith(const std::string& what, const std::string& end) {
  return what.size() >= end.size() && what.substr(what.size() - end.size()) == end;
}

Tally tallyOf(const std::string& kind) {
  Tally tally;
  RecordedVision vision;
  for (const Scene& scene : allScenes()) {
    const auto seen = vision.look(scene, kFolder);
    if (!seen) ADD_FAILURE() << seen.error();
    for (const SeenThing& thing : scene.things) {
      if (!seen || !thing.nameable || !endsWith(thing.what, kind)) continue;
      ++tally.named;
      tally.found += finds(*seen, thing, scene.randomised) ? 1 : 0;
    }
  }
  return tally;
}

// Balls that fill the view, goals next to the robot and robots whose patches are cut are missed.
TEST(RecordedScenes, ShowVisionSevenOfTenBallsBeaconsAndGoalsAndAlmostHalfOfTheRobots) {
  const Tally balls = tallyOf("ball");
  const Tally beacons = tallyOf("beacon");
  const Tally goals = tallyOf("goal");
  const Tally robots = tallyOf("robot");
  EXPECT_EQ(balls.named, 41);
  EXPECT_GE(balls.found, 33);
  EXPECT_EQ(beacons.named, 40);
  EXPECT_GE(beacons.found, 36);
  EXPECT_EQ(goals.named, 34);
  EXPECT_GE(goals.found, 25);
  EXPECT_EQ(robots.named, 60);
  EXPECT_GE(robots.found, 29);
}

class RecordedScene : public ::testing::TestWithParam<Scene> {
 protected:
  void SetUp() override {
    RecordedVision vision;
    const auto seen = vision.look(GetParam(), kFolder);
    ASSERT_TRUE(seen) << seen.error();
    seen_ = *seen;
  }
  Percepts seen_;
};

TEST_P(RecordedScene, ShowsVisionWhatItFoundWhenItWasRecorded) {
  for (const SeenThing& thing : GetParam().things) {
    if (!thing.nameable || !thing.foundOnce) continue;
    EXPECT_TRUE(finds(seen_, thing, GetParam().randomised))
        << textOf(thing) << " is not found, but" << textOf(foundIn(seen_))
        << "\nrefused:" << refusedIn(seen_);
  }
}

TEST_P(RecordedScene, ShowsVisionNothingThatIsNotThere) {
  const Scene& scene = GetParam();
  for (const Found& found : foundIn(seen_))
    EXPECT_TRUE(std::any_of(scene.things.begin(), scene.things.end(),
                            [&](const SeenThing& t) { return isNear(found, t, true); }))
        << textOf(found) << " is not there";
}

INSTANTIATE_TEST_SUITE_P(Each, RecordedScene, ::testing::ValuesIn(allScenes()),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace kelpie::recorded
