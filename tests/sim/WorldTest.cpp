// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "tools/sim/World.h"

namespace kelpie::sim {
namespace {

struct Place {
  Place() {
    for (int i = 0; i < 20; ++i) world.tick();
  }
  Pose2 truth(TimeUs time) const { return world.truth(time).robots[0].pose; }
  body::FieldDescription field = *body::fieldDescription("2006");
  World world{WorldParams{}, field, *scenario("empty-goal", field, {{TeamColour::red, 1}}, 3), 3};
};

TEST(World, ACarriedRobotIsThereAtOnceAndNoImageShowsTheWay) {
  Place place;
  const Pose2 there{{30.0, 500.0}, Angle::deg(-100.0)};
  ASSERT_TRUE(place.world.carry(0, there));
  for (const std::int64_t back : {0, 16667, 40000}) {
    const Pose2 seen = place.truth({place.world.time().us - back});
    EXPECT_NEAR(distance(seen.position, there.position), 0.0, 1e-9);
    EXPECT_NEAR((seen.heading - there.heading).deg(), 0.0, 1e-9);
  }
  for (int i = 0; i < 20; ++i) place.world.tick();
  EXPECT_LT(distance(place.truth(place.world.time()).position, there.position), 1.0);
}

TEST(World, ACarriedRobotDoesNotHitTheBallOnTheWay) {
  Place place;
  const Point2<Field> ball = place.world.ball().position;
  ASSERT_TRUE(place.world.carry(0, {{ball.x - 60.0, ball.y}, Angle()}));
  place.world.tick();
  ASSERT_TRUE(place.world.carry(0, {{ball.x + 60.0, ball.y}, Angle()}));
  for (int i = 0; i < 20; ++i) place.world.tick();
  EXPECT_NEAR(distance(place.world.ball().position, ball), 0.0, 1e-9);
}

TEST(World, APlaceThatNoRobotCanStandOnIsRefused) {
  Place place;
  const Pose2 before = place.truth(place.world.time());
  EXPECT_FALSE(place.world.carry(1, before));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(place.world.carry(0, {{nan, 100.0}, Angle()}));
  EXPECT_FALSE(place.world.carry(0, {{100.0, 100.0}, Angle::rad(nan)}));
  EXPECT_FALSE(place.world.carry(0, {{-200.0, 100.0}, Angle()}));
  EXPECT_FALSE(place.world.carry(0, {{100.0, 1000.0}, Angle()}));
  EXPECT_NEAR(distance(place.truth(place.world.time()).position, before.position), 0.0, 1e-9);
}

}  // namespace
}  // namespace kelpie::sim
