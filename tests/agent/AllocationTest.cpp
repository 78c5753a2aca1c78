// SPDX-License-Identifier: Apache-2.0
// Replaces the global allocator: memory taken inside a C++ stage fails the test. The loops play in
// the simulated world, in one process and without OPEN-R.
#include <gtest/gtest.h>

#include <memory>

#include "robot/agent/loops/FrameLoop.h"
#include "robot/agent/loops/MotionLoop.h"
#include "robot/body/FieldDescription.h"
#include "robot/host/primitives/Orders.h"
#include "tests/AllocationCount.h"
#include "tools/sim/world/World.h"

namespace kelpie::agent {
namespace {

// Counts in every stage but the behaviours: Python has its own memory.
class Counter : public StageObserver {
 public:
  void begin(Stage stage) override {
    if (stage != Stage::behaviour) startCountingAllocations();
  }
  void end(Stage stage) override {
    if (stage == Stage::behaviour) return;
    allocations += stopCountingAllocations();
    ++stages;
  }
  int stages = 0;
  int allocations = 0;
};

host::AgentReply orders(const MotionOutput& output) { return host::ordersOf(output.joints, 1.0); }

struct Match {
  Match() {
    const auto field = *body::fieldDescription("2006");
    config->field = field;
    config->calibration = vision::nominalCalibration();
    const auto setup = *sim::scenario("empty-goal", field, {{TeamColour::red, 1}}, 5);
    world = std::make_unique<sim::World>(sim::WorldParams{}, field, setup, 5);
    frames = std::make_unique<FrameLoop>(*config, KELPIE_SOURCE_DIR "/pycode");
    motions = std::make_unique<MotionLoop>(*config);
  }
  // 32 ms: a motion message, then an image.
  void step() {
    for (int tick = 0; tick < kTicksPerMessage; ++tick) world->tick();
    motion.time = world->time();
    motion.sensors = world->sensors(0);
    const MotionOutput& output = motions->step(motion, counter);
    world->bodies().command(0, orders(output));
    world->render(0, world->time(), input->image);
    input->time = world->time();
    input->elapsed = 0.032;
    input->sensors = motion.sensors.back();
    input->stance = output.stances.back();
    input->odometry = output.odometry;
    input->motion = output.status;
    motion.command = frames->step(*input, counter).command;
  }

  std::unique_ptr<AgentConfig> config = std::make_unique<AgentConfig>();
  std::unique_ptr<sim::World> world;
  std::unique_ptr<FrameLoop> frames;
  std::unique_ptr<MotionLoop> motions;
  std::unique_ptr<FrameInput> input = std::make_unique<FrameInput>();
  MotionInput motion;
  Counter counter;
};

TEST(Allocation, NoStageTakesMemoryWhileItPlays) {
  Match match;
  for (int i = 0; i < 400; ++i) match.step();
  EXPECT_EQ(match.counter.stages, 1600);
  EXPECT_EQ(match.counter.allocations, 0);
}

}  // namespace
}  // namespace kelpie::agent
