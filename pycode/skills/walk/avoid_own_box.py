# SPDX-License-Identifier: Apache-2.0
# What an attacker does while the ball is in its own goal's box, which only the goalie may enter
# (thesis 2006 section 4.3.2, algorithm 4.3): far from the ball nothing; beside the box it walks to
# the nearest front corner; before it, to a side of the ball, so that the goalie's way to clear is
# free. Keeps nothing but the branch it reported. All walking bends around the box, by a pose that
# must be right to within what is kept free; other robots it does not see.
import math

import kelpie
from arbiter.machine import Machine
from lib.geom import clamp, from_field, heading
from lib.steer import TURN_GAIN, TURN_SPEED
from safety.own_box import clear_of, held_off
from skills.head.track_ball import TrackBall

FAR = 100.0      # cm to the ball (U02)
LATERAL = 55.0   # cm from the ball's line, where the goalie's kick does not come
EDGE = 25.0      # cm from the side line
ARRIVED = 6.0    # cm
SPEED = 26.0     # cm/s
SLOW_DOWN = 1.5  # 1/s


def in_own_box(field, x, y) -> bool:
    """Whether a point of the field lies in the box of the own goal, or in the goal behind it."""
    return y <= field.box_depth and abs(x - 0.5 * field.width) <= 0.5 * field.box_width


def triggered(ball_in_box, grabbed, started) -> bool:
    """The trigger's truth table: a grab that was begun goes on."""
    return ball_in_box and not grabbed and not started


def place_to_stand(field, robot, ball) -> tuple[str, tuple[float, float]]:
    """The branch of algorithm 4.3 and its place on the field, for a robot at (x, y)."""
    left, right, top = clear_of(field)
    away = math.hypot(ball[0] - robot[0], ball[1] - robot[1])
    if away > FAR:
        return 'far', robot
    if robot[1] < top and not left < robot[0] < right:
        return 'corner', (left if robot[0] <= left else right, top)
    side = 1.0 if robot[0] >= ball[0] else -1.0
    x = ball[0] + side * LATERAL
    if not EDGE <= x <= field.width - EDGE:
        x = ball[0] - side * LATERAL
    return 'aside', (clamp(x, EDGE, field.width - EDGE), max(top, ball[1]))


def step_towards(field, robot, place) -> tuple[float, float]:
    """Velocity on the field, cm/s, that goes to a place and never deeper into what is kept free."""
    left, right, top = clear_of(field)
    x, y = robot
    dx, dy = place[0] - x, place[1] - y
    if left < x < right and y < top:
        dx, dy = way_out(left, right, top, x, y)
    away = math.hypot(dx, dy)
    if away < ARRIVED:
        return 0.0, 0.0
    speed = min(SPEED, SLOW_DOWN * away)
    vx, vy = speed * dx / away, speed * dy / away
    return held_off(left, right, top, x, y, vx, vy)


def way_out(left, right, top, x, y) -> tuple[float, float]:
    """The shortest way out for who is inside already."""
    return min((left - 2.0 * ARRIVED - x, 0.0), (right + 2.0 * ARRIVED - x, 0.0),
               (0.0, top + 2.0 * ARRIVED - y), key=lambda way: math.hypot(*way))


class AvoidOwnBox(Machine):
    NAME = 'avoid_own_box'

    def __init__(self, memory=None):
        super().__init__(self.walk_there)
        self.track = TrackBall(memory)
        self.branch = ''

    @staticmethod
    def needed(world, grabbed, started=False) -> bool:
        ball = world.ball
        inside = ball.present and in_own_box(world.field, ball.position.x, ball.position.y)
        return triggered(inside, grabbed, started)

    def walk_there(self, world):
        robot = (world.pose.position.x, world.pose.position.y)
        ball = (world.ball.position.x, world.ball.position.y)
        branch, place = place_to_stand(world.field, robot, ball)
        if branch != self.branch:
            self.branch = branch
            self.enter(world, self.walk_there, None, WHY[branch], world.ball.distance)
        return kelpie.Command(walk=self.walk_to(world, place), head=self.track.step(world))

    def walk_to(self, world, place) -> kelpie.WalkRequest:
        """Facing the ball while walking to any side."""
        robot = (world.pose.position.x, world.pose.position.y)
        vx, vy = step_towards(world.field, robot, place)
        right, ahead = from_field(world.pose, robot[0] + vx, robot[1] + vy)
        off_deg = heading(world.ball.relative.x, world.ball.relative.y)
        return kelpie.WalkRequest(forward=ahead, left=-right,
                                  turn_deg=clamp(TURN_GAIN * off_deg, -TURN_SPEED, TURN_SPEED))

    def explain(self, trace) -> None:
        trace.append((self.LAYER, self.NAME, self.branch, self.why, *self.numbers))


WHY = {'far': 'the ball in the own box is {} cm away: wait',
       'corner': 'beside the box, the ball {} cm away: to its front corner',
       'aside': 'before the box, the ball {} cm away: out of the goalie\'s way'}
