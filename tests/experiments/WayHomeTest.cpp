// SPDX-License-Identifier: Apache-2.0
// When a non-attacker is home, and what it ran into on the way, from made true places.
#include <gtest/gtest.h>

#include "tools/experiments/team/WayHome.h"

namespace kelpie::experiments {
namespace {

constexpr Point2<Field> kHome{180.0, 100.0};

// Red 2 walks down the field, one centimetre a frame, through red 3; a blue robot stands somewhere.
struct MadeWay {
  Played played;
  double y = 400.0;
  Point2<Field> blue{60.0, 250.0};
  Role role = Role::defender;

  void walks(int frames, double step = 1.0) {
    for (int i = 0; i < frames; ++i) {
      y -= step;
      PlayedMoment moment;
      moment.seen = true;
      const double seconds = kFrameSeconds * static_cast<double>(played.moments.size() + 1);
      moment.truth.time = TimeUs::fromSeconds(seconds);
      moment.truth.robots.push_back({TeamColour::red, 3, {{190.0, 320.0}, {}}, {}});
      moment.truth.robots.push_back({TeamColour::red, 2, {{180.0, y}, Angle::deg(-90.0)}, {}});
      moment.truth.robots.push_back({TeamColour::blue, 1, {blue, {}}, {}});
      moment.command.team.role = role;
      moment.command.team.wants = true;
      moment.command.team.wanted = kHome;
      played.moments.push_back(moment);
    }
  }
};

TEST(WayHome, ADefenderIsHomeWithin30CentimetresOfWhereItWantsToBe) {
  MadeWay way;
  way.walks(300);
  const WayHome found = wayHomeOf(way.played, 2);
  ASSERT_TRUE(found.home);
  EXPECT_NEAR(*found.home, 271 * kFrameSeconds, 1e-3);
  EXPECT_EQ(found.contacts, 0);
}

TEST(WayHome, WhoStopsShortIsNotHome) {
  MadeWay way;
  way.walks(260);
  EXPECT_FALSE(wayHomeOf(way.played, 2).home);
}

TEST(WayHome, AnAttackersWishIsNoHome) {
  MadeWay way;
  way.role = Role::attacker;
  way.walks(300);
  EXPECT_FALSE(wayHomeOf(way.played, 2).home);
}

TEST(WayHome, OneWhomItWalksIntoIsOneContactUntilTheyHaveBeenApart) {
  MadeWay way;
  way.blue = {190.0, 250.0};
  way.walks(300);
  EXPECT_EQ(wayHomeOf(way.played, 2).contacts, 1);
}

TEST(WayHome, WhoComesBackToABlockerTouchesItAgain) {
  MadeWay way;
  way.blue = {190.0, 250.0};
  way.walks(200);
  way.walks(100, -1.0);
  way.walks(260);
  EXPECT_EQ(wayHomeOf(way.played, 2).contacts, 3);
}

TEST(WayHome, AMateIsNoContactNorIsWhatComesAfterHome) {
  MadeWay mate;
  mate.walks(298);
  EXPECT_EQ(wayHomeOf(mate.played, 2).contacts, 0);
  MadeWay after;
  after.blue = {190.0, 102.0};
  after.walks(275);
  const WayHome found = wayHomeOf(after.played, 2);
  EXPECT_TRUE(found.home);
  EXPECT_EQ(found.contacts, 0);
}

}  // namespace
}  // namespace kelpie::experiments
