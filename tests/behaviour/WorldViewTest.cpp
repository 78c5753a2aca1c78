// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "behaviour/views/KelpieModule.h"
#include "tests/behaviour/Scripts.h"

namespace kelpie::behaviour {
namespace {

// The number that an expression over `world` gives, handed back as the walk's speed.
double seen(HostRun& run, const Scripts& scripts, const std::string& expression) {
  scripts.writeDecide("return kelpie.Command(walk=kelpie.WalkRequest(forward=" + expression + "))");
  const Command command = run.step();
  EXPECT_EQ(command.fallback, Fallback::none) << run.state.lastError();
  return command.walk.forward;
}

TEST(WorldView, NumbersAnglesAndTimesAreShownInTheirUnits) {
  const Scripts scripts("return kelpie.Command()");
  HostRun run(scripts);
  run.world.ball.heading = Angle::deg(12.5);
  run.world.ball.relative = {-3.0, 8.0};
  run.percepts.ball.headingVariance = Angle::deg(2.0).rad() * Angle::deg(2.0).rad();
  run.input.sensors.joints[Joint::headPan] = Angle::deg(-20.0);
  EXPECT_NEAR(seen(run, scripts, "world.ball.heading_deg"), 12.5, 1e-12);
  EXPECT_EQ(seen(run, scripts, "world.ball.relative.x + 1"), -2.0);
  EXPECT_NEAR(seen(run, scripts, "world.percepts.ball.heading_variance_deg2"), 4.0, 1e-12);
  EXPECT_NEAR(seen(run, scripts, "world.head.head_pan_deg"), -20.0, 1e-12);
  EXPECT_NEAR(seen(run, scripts, "world.sensors.joints.angle_deg[kelpie.HEAD_PAN]"), -20, 1e-12);
  EXPECT_NEAR(seen(run, scripts, "world.time_s * 30 - world.frame"), 0.0, 1e-3);
}

TEST(WorldView, NearDistanceIsThatOfTheBaseRobotAndItsThresholdIsBesideIt) {
  const Scripts scripts("return kelpie.Command()");
  HostRun run(scripts);
  run.input.sensors.headNearDistance = 30.0;
  EXPECT_EQ(seen(run, scripts, "world.sensors.head_near_distance"), 30.0);
  EXPECT_EQ(seen(run, scripts, "world.sensors.head_near_threshold"), 20.0);
  run.infrared = {0.9, 1.5, 18.5};
  EXPECT_NEAR(seen(run, scripts, "world.sensors.head_near_distance"), 28.5, 1e-12);
  EXPECT_EQ(seen(run, scripts, "world.sensors.head_near_threshold"), 18.5);
  EXPECT_EQ(seen(run, scripts, "world.sensors.chest_distance - 60"), 30.0);
}

TEST(WorldView, BatterysCurrentAndChargeAreSeen) {
  const Scripts scripts("return kelpie.Command()");
  HostRun run(scripts);
  run.input.battery = {1.5, 0.25};
  EXPECT_EQ(seen(run, scripts, "world.battery.current"), 1.5);
  EXPECT_EQ(seen(run, scripts, "world.battery.charge"), 0.25);
}

TEST(WorldView, ListsHaveTheirLengthAndElements) {
  const Scripts scripts("return kelpie.Command()");
  HostRun run(scripts);
  for (const double distance : {11.0, 22.0, 9.0}) {
    LandmarkPercept landmark;
    landmark.kind = LandmarkKind::beaconPinkOnBlue;
    landmark.distance = distance;
    run.percepts.landmarks.push_back(landmark);
  }
  EXPECT_EQ(seen(run, scripts, "len(world.percepts.landmarks)"), 3.0);
  EXPECT_EQ(seen(run, scripts, "sum(l.distance for l in world.percepts.landmarks)"), 42.0);
  EXPECT_EQ(seen(run, scripts, "world.percepts.landmarks[-1].distance"), 9.0);
  EXPECT_EQ(seen(run, scripts, "world.percepts.landmarks[0].kind - kelpie.BEACON_PINK_ON_BLUE"), 0);
}

TEST(WorldView, TheShippedQuestionsToTheObstacleMapAreAnswered) {
  const Scripts scripts("return kelpie.Command()");
  for (const std::string folder : {"lib", "situation"})
    std::filesystem::copy(KELPIE_SOURCE_DIR "/pycode/" + folder, scripts.path() + "/" + folder);
  scripts.write("main.py",
                "import kelpie\nfrom situation import obstacles\n\ndef decide(world):\n"
                "    points = obstacles.points_near(world, world.pose.position, 100.0)\n"
                "    return kelpie.Command(walk=kelpie.WalkRequest(\n"
                "        forward=len(points),\n"
                "        left=obstacles.in_box(points, world.pose, -20.0, 20.0, 10.0, 50.0)))\n");
  HostRun run(scripts);
  run.field = *body::fieldDescription("2006");
  run.world.pose = {{180, 300}, Angle::deg(90)};
  run.world.obstacles.push_back({{185, 335}, 4.0, 2.0});
  run.world.obstacles.push_back({{145, 335}, 8.0, 0.0});
  run.world.obstacles.push_back({{305, 305}, 8.0, 0.0});
  const Command command = run.step();
  EXPECT_EQ(command.fallback, Fallback::none) << run.state.lastError();
  EXPECT_EQ(command.walk.forward, 2.0);  // points within 100 cm
  EXPECT_EQ(command.walk.left, 6.0);     // seen by itself and by mates, ahead
}

TEST(WorldView, APartIsTheSameObjectWheneverItIsAskedFor) {
  const Scripts scripts("return kelpie.Command()");
  HostRun run(scripts);
  run.percepts.landmarks.resize(2);
  EXPECT_EQ(seen(run, scripts, "world.ball.relative is world.ball.relative"), 1.0);
  EXPECT_EQ(seen(run, scripts, "world.percepts.landmarks[1] is world.percepts.landmarks[1]"), 1.0);
  EXPECT_EQ(seen(run, scripts, "world.percepts.landmarks[0] is world.percepts.landmarks[1]"), 0.0);
}

TEST(WorldView, NothingCanBeWritten) {
  for (const char* body :
       {"world.frame = 3", "world.ball.distance = 1", "world.new = 1", "world.pose.position.x = 2",
        "world.sensors.duty[0] = 1", "del world.ball", "type(world).frame = 1", "type(world)()"}) {
    const Scripts scripts(std::string(body) + "; return kelpie.Command()");
    HostRun run(scripts);
    EXPECT_EQ(run.step().fallback, Fallback::scriptError) << body;
  }
}

TEST(WorldView, IndexBeyondTheEndIsAScriptError) {
  const Scripts scripts("world.percepts.landmarks[0]; return kelpie.Command()");
  HostRun run(scripts);
  EXPECT_EQ(run.step().fallback, Fallback::scriptError);
}

TEST(WorldView, ReferenceKeptFromAnEarlierFrameShowsTheNewestOne) {
  const Scripts scripts;
  scripts.write("main.py",
                "import kelpie\nkept = []\n\ndef decide(world):\n    kept.append(world)\n"
                "    return kelpie.Command(walk=kelpie.WalkRequest("
                "forward=kept[0].frame))\n");
  HostRun run(scripts);
  for (int i = 0; i < 3; ++i) run.step();
  EXPECT_EQ(run.step().walk.forward, 4.0);
}

}  // namespace
}  // namespace kelpie::behaviour
