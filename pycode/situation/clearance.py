# SPDX-License-Identifier: Apache-2.0
# The goalie's clearing kicks (thesis 2006 section 4.3.1): which kick, of the ball as it will lie
# when the motion strikes, sends it far, up-field and past who stands there, and in no case to the
# own goal. Keeps nothing; what a kick does it reads from the kick map. Fails where the map does:
# for a ball that an opponent holds against the kick goes anywhere (docs/physical-body.md, Kicks).
import math

import kelpie
from lib import intercept, kick_table, rulebook
from lib.geom import Point, wrap
from lib.goalie_places import UP_FIELD, off_own_goal
from situation.shot import speed

CONSTANTS = kelpie.constants.clearance  # behaviour/constants.toml: defaults and ranges
OFF_GOAL = 25.0      # deg from the own goal's cone, at least,
SDS = 3.0            # and so many sd of the kick's direction
SEEN = 0.2           # s; of kicks at balls unseen for longer hardly one hit
NEAR = 25.0          # cm; no kick reaches farther
WALKS = 3.0          # cm/s: a slower robot stands
BESIDE = 2.0         # cm about a kick's window,
FARTHEST = 16.0      # and cm ahead at most
LATENCY = 0.05, 0.2  # s from asking to the motion's beginning, at least and at most
STRIKE = 0.2         # s from there to the strike: a kick's last key frame ends after 0.18 to 0.24
UTILITY = CONSTANTS.utility  # of a kick that is done as the ball lies
FAR = CONSTANTS.far  # cm that are as good as farther
UPENN = kelpie.UPENN_LEFT, kelpie.UPENN_RIGHT   # the goalie's kicks in 2006
SIDEWAYS = CONSTANTS.sideways  # utility lost by a kick across the field
ACROSS = CONSTANTS.across  # share left of one that goes past the goal's middle
OPPONENT = 70.0      # cm to an opponent that stands in the way,
OPPONENT_DEG = 25.0  # deg off it
HELD = CONSTANTS.held  # share left of a kick at an opponent: it comes back, or gets 10 cm
HELD_DEG = 106.0     # deg to which a kick to a side then goes (docs/physical-body.md)


class Clearance:
    """A kick of a ball at (x, y) on the field: where it goes (deg on the field), how many deg off
    the own goal that is, and its utility, 0 to 1. It is safe if it cannot become an own goal,
    not even where the ball goes when somebody holds against a kick to a side."""

    def __init__(self, world, kick, ball, outcome, heading_deg):
        self.kick, self.ball = kick, ball
        chance, off_deg, sd, distance, _ = outcome
        self.direction = wrap(heading_deg + off_deg)
        self.off_goal = off_own_goal(world.field, ball, self.direction)
        held = heading_deg + HELD_DEG * side_of(kick)
        self.safe = (self.off_goal > max(OFF_GOAL, SDS * sd) and
                     (side_of(kick) == 0.0 or off_own_goal(world.field, ball, held) > 0.0))
        up = math.cos(math.radians(self.direction - UP_FIELD))
        self.utility = chance * min(1.0, distance / FAR) * (1.0 - SIDEWAYS * (1.0 - up))
        outwards = (ball[0] - 0.5 * world.field.width) * math.cos(math.radians(self.direction))
        if outwards < 0.0:
            self.utility *= ACROSS
        if any(in_the_way(ball, self.direction, other.position) for other in world.opponents):
            self.utility *= HELD

    def after(self, way):
        """The point of the field that the ball passes after so many cm."""
        angle = math.radians(self.direction)
        return self.ball[0] + way * math.cos(angle), self.ball[1] + way * math.sin(angle)


def side_of(kick) -> float:
    """+1 for a kick to the left, -1 for one to the right, 0 for one straight ahead."""
    return -1.0 if kick in kick_table.LEFT_OF else 1.0 if kick in kick_table.RIGHT_OF else 0.0


def in_the_way(ball, direction, other) -> bool:
    """Whether somebody at `other` stands near the ball in that direction."""
    dx, dy = other.x - ball[0], other.y - ball[1]
    return (math.hypot(dx, dy) < OPPONENT and
            abs(wrap(math.degrees(math.atan2(dy, dx)) - direction)) < OPPONENT_DEG)


def predicted(world, seconds) -> tuple[Point, Point]:
    """The ball's place in the robot frame, and on the field, as a kick that begins after that time
    strikes it: the robot walks on until the motion begins, the ball rolls until the strike, ever
    slower. The kick map's balls lay still."""
    ball, step = world.ball, world.odometry
    share, rolls = seconds / max(world.elapsed_s, 0.02), 0.0
    if intercept.rolls(ball):
        rolls = intercept.rolled(speed(ball), seconds + STRIKE) / speed(ball)
    vx, vy = intercept.relative_velocity(world)
    return ((ball.relative.x + share * step.left + rolls * vx,
             ball.relative.y - share * step.forward + rolls * vy),
            (ball.position.x + rolls * ball.velocity.x, ball.position.y + rolls * ball.velocity.y))


def walks(world) -> bool:
    """Whether the kick begins from a walk, in which it does another thing than from standing."""
    step = world.odometry
    return math.hypot(step.forward, step.left) > WALKS * world.elapsed_s


def in_window(kick, x, y, walking) -> bool:
    """Whether a ball lies in the kick's window of the map or a little beside it: from its outer
    places half of the balls stayed."""
    left, near, right, far = kick_table.window(kick, walking)
    beside = BESIDE
    return (left - beside <= x <= right + beside and
            near - beside <= y <= min(far + beside, FARTHEST))


def strikes(world) -> list[tuple[Point, Point]]:
    """predicted() of a kick that is asked for now, whether the motion begins at once or at the end
    of a step."""
    return [predicted(world, seconds) for seconds in LATENCY]


def clearance(world, kick, strikes_at) -> Clearance | None:
    """The least utility of a kick that meets the ball at one of strikes(); None if it then
    reaches no ball or is not safe."""
    walking, worst = walks(world), None
    for place, ball in strikes_at:
        outcome = (kick_table.outcome(kick, *place, walking)
                   if in_window(kick, *place, walking) else None)
        if outcome is None:
            return None
        one = Clearance(world, kick, ball, outcome, world.pose.heading_deg)
        if not one.safe:
            return None
        if worst is None or one.utility < worst.utility:
            worst = one
    return worst


def clearing_kick(world) -> Clearance | None:
    """The best safe kick of the ball as it lies, if it is good enough not to walk on."""
    ball = world.ball
    if not ball.present or ball.seconds_since_seen > SEEN or ball.distance > NEAR:
        return None
    by_map, strikes_at = rulebook.of(world).CLEARS_BY_MAP, strikes(world)
    found = [clearance(world, kick, strikes_at) for kick in kicks(world)]
    if not by_map:
        safe = [one for one in found if one is not None]
        return max(safe, key=lambda one: one.off_goal, default=None)
    good = [one for one in found if one is not None and one.utility > UTILITY]
    return max(good, key=lambda one: one.utility, default=None)


def kicks(world) -> tuple:
    """That a goalie may clear with: all of the map, or to either side by a foreleg's swipe."""
    return kick_table.kicks(False) if rulebook.of(world).CLEARS_BY_MAP else UPENN
