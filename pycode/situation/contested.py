# SPDX-License-Identifier: Apache-2.0
# Whether somebody else is at the ball (thesis 2006 section 5.5): the robot is close to it and an
# obstacle stands around it, on the map or in the image, or the infrared sees something nearer than
# the ball, or a front paw pushes at something. Keeps the frames since that was so last: it stays
# contested for 15 more. Does not tell a team mate from an opponent.
import math

from situation import obstacles

CLOSE = 40.0         # cm from the robot; farther balls are nobody's business yet
AROUND = 25.0        # cm around the ball
MAP_COUNT = 10.0     # of the obstacle map: fewer points may be nobody
SEEN_ROBOT = 30.0    # cm from a robot that vision sees to the ball
IR_NEARER = 8.0      # cm that the infrared's thing must be nearer than the ball
LATCH = 15           # frames


class Contested:
    def __init__(self):
        self.frames = LATCH + 1  # since the last trigger

    @property
    def now(self) -> bool:
        return self.frames <= LATCH

    def update(self, world, memory) -> bool:
        """Once per frame; whether the ball is contested in it."""
        self.frames = 0 if triggered(world, memory) else self.frames + 1
        return self.now


def triggered(world, memory) -> bool:
    """Something but this robot is at a ball that is close (each of four witnesses is enough)."""
    ball = world.ball
    if not ball.present or ball.distance > CLOSE:
        return False
    return (any(world.motion.feeling.paw_blocked) or ir_nearer(world, memory) or
            robot_at(world) or on_map(world))


def ir_nearer(world, memory) -> bool:
    """The head looks at the ball, so that its infrared reads the ball or what is before it."""
    return memory.ir < world.ball.distance - IR_NEARER


def robot_at(world) -> bool:
    x, y = world.ball.relative.x, world.ball.relative.y
    for robot in world.percepts.robots:
        angle = math.radians(robot.heading_deg)
        away = math.hypot(-robot.distance * math.sin(angle) - x,
                          robot.distance * math.cos(angle) - y)
        if away < SEEN_ROBOT:
            return True
    return False


def on_map(world) -> bool:
    ball = world.ball.position
    total = 0.0
    for x, y, count in obstacles.points_near(world, ball, AROUND):
        if math.hypot(x - ball.x, y - ball.y) < AROUND:
            total += count
    return total >= MAP_COUNT
