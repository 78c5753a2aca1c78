// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/sim/rules/Scenes.h"
#include "tools/sim/rules/KickOff.h"

namespace kelpie::sim {
namespace {

struct Stand {
  const char* fact;
  TeamColour team;
  std::uint8_t number;
  Point2<Field> place;
  double heading_deg;
  bool legal;  // at red's kick-off
};

constexpr Stand kStands[] = {
    {"in its own half", kRed, 2, {180, 200}, 90, true},
    {"beyond the half-way line", kRed, 2, {60, 275}, 90, false},
    {"on the half-way line", kRed, 2, {60, 271.5}, 90, true},
    {"who kicks off may be in the circle", kRed, 2, {180, 250}, 90, true},
    {"who does not may not", kBlue, 2, {180, 290}, -90, false},
    {"not even with the head only", kBlue, 2, {180, 295}, -90, false},
    {"but outside it", kBlue, 2, {180, 300}, -90, true},
    {"a forward in its own goal box", kRed, 3, {180, 60}, 90, false},
    {"before it", kRed, 3, {180, 70}, 90, true},
    {"beside it", kRed, 3, {110, 60}, 90, true},
    {"the goalie in its box", kRed, 1, {180, 20}, 90, true},
    {"blue's box is at the other end", kBlue, 3, {180, 500}, -90, false},
    {"blue in red's half", kBlue, 3, {100, 200}, -90, false},
    {"beside the field", kRed, 4, {-5, 200}, 90, false},
    {"behind the goal line", kRed, 1, {180, -3}, 90, false},
};

TEST(KickOff, WhereRobotsMayStand) {
  for (const Stand& stand : kStands) {
    ScenePlayer player{
        stand.team, stand.number, {stand.place, Angle::deg(stand.heading_deg)}, true, true};
    EXPECT_EQ(standsLegally(ruleField(), player, kRed), stand.legal) << stand.fact;
    player.upright = false;
    EXPECT_FALSE(standsLegally(ruleField(), player, kRed)) << "lies, " << stand.fact;
  }
}

// The seconds until places count as taken, with what happens in each tick; 0 = not in ten.
template <class F>
double untilTaken(MadeScene& scene, F&& happens) {
  KickOffState state;
  const auto field = ruleField();
  double taken = 0.0;
  scene.goesOn(10.0, [&](MadeScene& now) {
    happens(now);
    if (step({now, kRed}, field, state) && taken == 0.0) taken = now.time.seconds();
  });
  return taken;
}

MadeScene two() { return MadeScene().with(kRed, 2, {180, 200}).with(kBlue, 2, {180, 400}, -90); }

TEST(KickOff, PlacesAreTakenAfterTwoSecondsStill) {
  MadeScene scene = two();
  EXPECT_NEAR(untilTaken(scene, [](MadeScene&) {}), 2.0, 0.02);
}

TEST(KickOff, SwayingIsStillWalkingIsNot) {
  MadeScene sways = two();
  EXPECT_NEAR(untilTaken(sways,
                         [](MadeScene& now) {
                           now.players[0].pose.position.x =
                               (now.time.us / kTickUs) % 2 == 0 ? 180.0 : 181.0;
                         }),
              2.0, 0.02);
  MadeScene walks = two();
  EXPECT_EQ(untilTaken(walks, [](MadeScene& now) { now.players[0].pose.position.x += 0.02; }), 0.0);
  MadeScene turns = two();
  EXPECT_EQ(untilTaken(turns,
                       [](MadeScene& now) {
                         now.players[1].pose.heading = Angle::deg(5.0 * now.time.seconds());
                       }),
            0.0);
}

TEST(KickOff, OneIllegalPlaceHoldsThemAllUp) {
  MadeScene scene = two();
  scene.with(kBlue, 3, {180, 100}, -90);
  EXPECT_EQ(untilTaken(scene, [](MadeScene&) {}), 0.0);
  scene = two();
  scene.with(kBlue, 3, {180, 100}, -90);
  scene.players[2].playing = false;
  EXPECT_NEAR(untilTaken(scene, [](MadeScene&) {}), 2.0, 0.02) << "it waits for its penalty's end";
}

TEST(KickOff, ManualPlacesAreLegalAndApartOnEveryField) {
  for (const char* name : {"2006", "osaka2005", "2004"}) {
    const auto field = *body::fieldDescription(name);
    for (const TeamColour kickOff : {kRed, kBlue}) {
      MadeScene scene;  // all on one heap in the middle
      for (const TeamColour team : {kRed, kBlue})
        for (std::uint8_t number = 1; number <= 4; ++number)
          scene.with(team, number, {field.width / 2, field.length / 2});
      for (std::size_t i = 0; i < 8; ++i)
        scene.players[i].pose = manualPlace(field, scene, i, kickOff);
      for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_TRUE(standsLegally(field, scene.players[i], kickOff)) << name << " " << i;
        EXPECT_TRUE(isFree(scene, scene.players[i].pose.position, 40.0, i)) << name << " " << i;
      }
    }
  }
}

TEST(KickOff, WhereSomebodyStandsAnotherPlaceIsTaken) {
  MadeScene scene;
  scene.with(kRed, 3, {180, 225}).with(kRed, 2, {180, 500});
  scene.players[1].pose = manualPlace(ruleField(), scene, 1, kRed);
  EXPECT_TRUE(standsLegally(ruleField(), scene.players[1], kRed));
  EXPECT_GT(distance(scene.players[0].pose.position, scene.players[1].pose.position), 40.0);
}

}  // namespace
}  // namespace kelpie::sim
