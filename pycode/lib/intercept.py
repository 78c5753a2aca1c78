# SPDX-License-Identifier: Apache-2.0
# Where a rolling ball can be met: the first place on its way that the robot reaches as early as the
# ball does. The ball slows down as gps believes it (gps/ball: 0.76 /s of its speed and 6 cm/s2).
# Keeps nothing. Without a seen ball, or with a slow one, the place is the ball's own. It knows no
# obstacles and no bounce.
import math

from lib import rulebook
from lib.geom import Point, frame_of, heading, in_frame

DRAG = 0.76             # 1/s
FRICTION = 6.0          # cm/s2
SLOW = 9.0              # cm/s: slower ones stop within 6 cm
SEEN_S = 0.35           # an older velocity tells nothing
STEP_S = 0.1  # s
LAST_STEP = 39  # steps
LONGEST_S = 4.0         # just beyond it
FOREVER = 60.0          # s
TURN_SPEED = 150.0      # deg/s of the robot
WALK_SPEED = 33.0       # cm/s
REACH = 9.0             # cm: the ball need not come to the neck


def rolled(speed, seconds) -> float:
    """cm that a ball of that speed (cm/s) rolls within a time: v' = -(DRAG v + FRICTION)."""
    return rolled_until(speed, min(seconds, stops_after(speed)))


def stops_after(speed) -> float:
    """Seconds until it rests."""
    return math.log(1.0 + DRAG * speed / FRICTION) / DRAG


def rolled_until(speed, t) -> float:
    """The same as rolled(), for a time at which it still rolls."""
    asymptote = speed + FRICTION / DRAG
    return asymptote * (1.0 - math.exp(-DRAG * t)) / DRAG - FRICTION * t / DRAG


def rolls(ball) -> bool:
    """Whether its velocity is sure enough for a prediction."""
    return (ball.seconds_since_seen < SEEN_S and
            math.hypot(ball.velocity.x, ball.velocity.y) > SLOW)


class Rolling:
    """A ball on its way to the stopping point that gps foretells. Keeps what does not depend on
    the time: meeting() asks for several places of it in a frame."""

    def __init__(self, ball):
        self.x, self.y = ball.position.x, ball.position.y
        self.dx, self.dy = ball.stopping_point.x - self.x, ball.stopping_point.y - self.y
        self.speed = math.hypot(ball.velocity.x, ball.velocity.y)
        self.stop_s = stops_after(self.speed)
        self.whole = max(rolled(self.speed, FOREVER), 1e-6)
        self.fastest = self.speed * math.hypot(self.dx, self.dy) / self.whole

    def at(self, seconds) -> Point:
        """Where it will be on the field."""
        share = rolled_until(self.speed, min(seconds, self.stop_s)) / self.whole
        return self.x + share * self.dx, self.y + share * self.dy


def needed(x, y) -> float:
    """Seconds until the robot is at a point of its frame: it turns, then walks."""
    return abs(heading(x, y)) / TURN_SPEED + walk_s(x, y)


def walk_s(x, y) -> float:
    return max(0.0, math.hypot(x, y) - REACH) / WALK_SPEED


def meeting(world) -> Point:
    """The point of the robot frame to walk to, the last one looked at when none is early enough."""
    if not rolls(world.ball):
        return world.ball.relative.x, world.ball.relative.y
    rolling, frame = Rolling(world.ball), frame_of(world.pose)
    closing = 1.0 + rolling.fastest / WALK_SPEED
    step = 1
    while True:
        seconds = step * STEP_S
        x, y = in_frame(frame, *rolling.at(seconds))
        if step == LAST_STEP or seconds >= rolling.stop_s:  # later it lies there, too
            return x, y
        late = walk_s(x, y) - seconds
        if late <= 0.0 and needed(x, y) <= seconds:
            return x, y
        # Not earlier than that, even if both go straight at each other.
        step = min(LAST_STEP, step + max(1, int(late / closing / STEP_S)))


def target(world) -> Point:
    """Where to walk for the ball; the ball itself when intercepts are switched off."""
    if rulebook.intercepts(world):
        return meeting(world)
    return world.ball.relative.x, world.ball.relative.y


def relative_velocity(world) -> Point:
    """The ball's velocity over the ground in the robot frame's directions, cm/s."""
    angle = math.radians(world.pose.heading_deg)
    vx, vy = world.ball.velocity.x, world.ball.velocity.y
    return vx * math.sin(angle) - vy * math.cos(angle), vx * math.cos(angle) + vy * math.sin(angle)
