// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/motion/BallInHold.h"

#include <cmath>

namespace kelpie::learn {
namespace {

constexpr int kStand = 20;    // messages in the stance, before the ball is put down
constexpr int kHeadDown = 6;  // until the jaw opens
constexpr int kRest = 22;     // until all is at rest
// Where a held ball is (physics.md section 10), from the neck base.
constexpr double kNearest = 3.0;  // cm
constexpr double kFurthest = 10.8;
constexpr double kLateral = 3.5;

void stand(int messages, const Command& command, PhysicalWalker& walker) {
  for (int i = 0; i < messages; ++i) walker.step(command);
}

}  // namespace

Command holdingCommand() {
  Command command;
  command.walk.kind = WalkKind::dribble;
  command.head.neckTilt = Angle::deg(-52.0);
  command.head.headNod = Angle::deg(45.0);
  command.mouthOpen = true;
  return command;
}

void giveBall(Point2<Robot> place, PhysicalWalker& walker) {
  Command command = holdingCommand();
  command.mouthOpen = false;
  command.head.neckTilt = Angle::deg(-20.0);
  command.head.headNod = {};
  stand(kStand, command, walker);
  walker.bodies().putBall({fieldFromRobot(walker.pose(), place), {}});
  command.head = holdingCommand().head;
  stand(kHeadDown, command, walker);
  stand(kRest, holdingCommand(), walker);
}

bool holdsBall(PhysicalWalker& walker) {
  const Point2<Robot> ball = robotFromField(walker.pose(), walker.bodies().ball().position);
  return !walker.failed() && ball.y > kNearest && ball.y < kFurthest &&
         std::fabs(ball.x) < kLateral;
}

}  // namespace kelpie::learn
