// SPDX-License-Identifier: Apache-2.0
// Orders that come through a pipe, and a world that obeys them while it goes on.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <memory>

#include "tools/sim/world/OrderDesk.h"

namespace kelpie::sim {
namespace {

constexpr std::array<host::AgentHello, 2> kRobots = {{{TeamColour::red, 1}, {TeamColour::blue, 1}}};

class Ordered : public testing::Test {
 protected:
  Ordered() : Ordered(std::vector<BallTake>{}) {}
  explicit Ordered(const std::vector<BallTake>& takes) {
    EXPECT_EQ(pipe(ends_.data()), 0);
    auto setup = *scenario("attack", field, robots, 3);
    setup.takes = takes;
    world = std::make_unique<World>(WorldParams{}, field, setup, 3);
    desk = std::make_unique<OrderDesk>(ends_[0], *world, pace, field, robots,
                                       [this](const std::string& line) { told.push_back(line); });
  }
  ~Ordered() override {
    close(ends_[0]);
    stopSaying();
  }
  void say(const std::string& bytes) const {
    ASSERT_EQ(write(ends_[1], bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  void stopSaying() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }
  void hear(const std::string& bytes) {
    say(bytes);
    desk->hear();
  }
  // Events on the way are kept.
  void play(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      ASSERT_TRUE(world->tick());
      for (const MatchEvent& event : world->takeEvents())
        if (event.kind != EventKind::start) events.push_back(event);
    }
  }
  std::vector<EventKind> kinds() const {
    std::vector<EventKind> all;
    for (const MatchEvent& event : events) all.push_back(event.kind);
    return all;
  }
  double ballFrom(Point2<Field> place) const { return distance(world->ball().position, place); }
  Pose2 poseOf(std::size_t robot) const { return world->truth(world->time()).robots[robot].pose; }

  const body::FieldDescription field = *body::fieldDescription("2006");
  const std::vector<host::AgentHello> robots{kRobots.begin(), kRobots.end()};
  std::unique_ptr<World> world;
  Pace pace{0.0};
  std::unique_ptr<OrderDesk> desk;
  std::vector<std::string> told;
  std::vector<MatchEvent> events;

 private:
  std::array<int, 2> ends_{-1, -1};
};

TEST_F(Ordered, NothingSaidIsNotWaitedFor) {
  desk->hear();
  EXPECT_TRUE(told.empty());
  EXPECT_FALSE(pace.paused());
}

TEST_F(Ordered, ALineIsObeyedWhenItsEndHasCome) {
  hear("pau");
  EXPECT_FALSE(pace.paused());
  hear("se");
  EXPECT_FALSE(pace.paused());
  hear("\nresume");
  EXPECT_TRUE(pace.paused());
  hear("\n");
  EXPECT_FALSE(pace.paused());
  EXPECT_TRUE(told.empty());
}

TEST_F(Ordered, SeveralLinesAreObeyedInTheirOrder) {
  hear("resume\npause\nresume\npause\n");
  EXPECT_TRUE(pace.paused());
  hear("pause\nresume\n");
  EXPECT_FALSE(pace.paused());
}

TEST_F(Ordered, WhatCannotBeObeyedIsToldAndTheRestIsHeard) {
  hear("nonsense\nball -5,0\ncarry red:2:100,100,0\n\npause\n");
  EXPECT_EQ(told.size(), 4U);
  EXPECT_TRUE(pace.paused());
}

TEST_F(Ordered, WhoStopsSayingIsHeardToTheEndAndNotAskedAgain) {
  say("pause\nresu");
  stopSaying();
  desk->hear();
  desk->hear();
  EXPECT_TRUE(pace.paused());
}

TEST_F(Ordered, AThousandOrdersAtOnceAreObeyed) {
  std::string orders;
  for (int i = 0; i < 500; ++i) orders += "ball 100," + std::to_string(i) + "\npause\n";
  hear(orders + "ball 60,300\nresume\n");
  EXPECT_FALSE(pace.paused());
  play(2);
  EXPECT_LT(ballFrom({60.0, 300.0}), 1.0);
  EXPECT_TRUE(told.empty());
}

TEST_F(Ordered, ABallIsPutElsewhereWithinTwoTicksAndBothIsTold) {
  play(20);
  hear("ball 60,300\n");
  play(2);
  EXPECT_LT(ballFrom({60.0, 300.0}), 1.0);
  EXPECT_EQ(kinds(), (std::vector<EventKind>{EventKind::taken, EventKind::returned}));
  EXPECT_EQ(events.back().place.x, 60.0);
  play(100);
  EXPECT_LT(ballFrom({60.0, 300.0}), 1.0);
  EXPECT_FALSE(world->interventions().ballAway());
}

// A person who drags it while the match stands lets it go at the last place.
TEST_F(Ordered, OfSeveralPlacesOfTheBallAtOneMomentTheLastCounts) {
  hear("ball 60,300\nball 100,400\nball 300,200\n");
  play(6);
  EXPECT_LT(ballFrom({300.0, 200.0}), 1.0);
  EXPECT_EQ(events.size(), 2U);
  hear("ball 60,300\n");
  play(1);
  hear("ball 100,400\n");
  play(6);
  EXPECT_LT(ballFrom({100.0, 400.0}), 1.0);
}

TEST_F(Ordered, ARobotIsCarriedAndTold) {
  play(20);
  hear("carry red:1:60,300,45\n");
  play(1);
  EXPECT_LT(distance(poseOf(0).position, {60.0, 300.0}), 1.0);
  EXPECT_NEAR(poseOf(0).heading.deg(), 45.0, 1.0);
  ASSERT_EQ(kinds(), std::vector<EventKind>{EventKind::carried});
  EXPECT_EQ(events[0].team, TeamColour::red);
  EXPECT_EQ(events[0].player, 1);
}

TEST_F(Ordered, OfSeveralPlacesOfARobotTheLastCountsAndItIsCarriedOnce) {
  hear(
      "carry red:1:60,300,0\ncarry red:1:100,400,0\ncarry blue:1:250,250,0\n"
      "carry red:1:300,100,0\n");
  play(10);
  EXPECT_LT(distance(poseOf(0).position, {300.0, 100.0}), 1.0);
  EXPECT_LT(distance(poseOf(1).position, {250.0, 250.0}), 1.0);
  EXPECT_EQ(events.size(), 2U);
}

TEST_F(Ordered, ARobotWaitsUntilItsPlaceIsFree) {
  hear("ball 60,300\n");
  play(2);
  hear("carry red:1:60,300,0\n");
  play(10);
  EXPECT_GT(distance(poseOf(0).position, {60.0, 300.0}), 20.0);
  hear("ball 300,100\n");
  play(4);
  EXPECT_LT(distance(poseOf(0).position, {60.0, 300.0}), 1.0);
}

TEST_F(Ordered, ABallThatIsPutIntoARobotLeavesTheWorldSound) {
  for (int i = 0; i < 5; ++i) {
    const Point2<Field> at = poseOf(0).position;
    hear("ball " + std::to_string(at.x) + "," + std::to_string(at.y) + "\n");
    play(40);
    EXPECT_TRUE(std::isfinite(world->ball().position.x));
    EXPECT_LT(ballFrom(at), 300.0);
  }
}

class OrderedWithoutBall : public Ordered {
 protected:
  // From 0.1 s on for 100 s; and again later.
  OrderedWithoutBall() : Ordered(std::vector<BallTake>{{0.1, 100.0, {}}, {1000.0, 5.0, {}}}) {
    play(30);
  }
};

TEST_F(OrderedWithoutBall, ABallThatSomebodyHasIsBackWhereItIsPut) {
  ASSERT_TRUE(world->interventions().ballAway());
  hear("ball 60,300\nball 100,400\n");
  play(2);
  EXPECT_FALSE(world->interventions().ballAway());
  EXPECT_LT(ballFrom({100.0, 400.0}), 1.0);
  EXPECT_EQ(kinds(), (std::vector<EventKind>{EventKind::taken, EventKind::returned}));
  play(200);
  EXPECT_LT(ballFrom({100.0, 400.0}), 1.0);
}

TEST_F(OrderedWithoutBall, ARobotIsCarriedAllTheSame) {
  hear("carry blue:1:60,300,0\n");
  play(2);
  EXPECT_LT(distance(poseOf(1).position, {60.0, 300.0}), 1.0);
  EXPECT_TRUE(world->interventions().ballAway());
}

}  // namespace
}  // namespace kelpie::sim
