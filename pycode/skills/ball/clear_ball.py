# SPDX-License-Identifier: Apache-2.0
# The goalie's clearing kicks (thesis 2006 section 4.3.1): which kick, of the ball as it will lie
# when the motion strikes, sends it far, up-field and past who stands there, and in no case to the
# own goal. Keeps nothing; what a kick does it reads from the kick map. Fails where the map does:
# for a ball that an opponent holds against the kick goes anywhere (docs/body.md, Kicks).
import math

import kelpie
from lib import intercept, kick_table
from lib.geom import Point, wrap
from lib.goalie_places import UP_FIELD, off_own_goal
from lib.tune_goalie import Clear
from lib.ways import point_of
from situation.obstacles import OWN_BODY, opponent_within
from situation.shot import speed


class Clearance:
    """A kick of a ball at (x, y) on the field: where it goes (deg on the field), how many deg off
    the own goal that is, and what it is worth, 0 to 1. It is safe if it cannot become an own goal,
    not even where the ball goes when somebody holds against a kick to a side."""

    def __init__(self, world, kick, ball, outcome, heading_deg):
        self.kick, self.ball = kick, ball
        chance, aside, sd, distance, _ = outcome
        self.direction = wrap(heading_deg + aside)
        self.off_goal = off_own_goal(world.field, ball, self.direction)
        held = heading_deg + Clear.HELD_DEG * side_of(kick)
        self.safe = (self.off_goal > max(Clear.OFF_GOAL, Clear.SDS * sd) and
                     (side_of(kick) == 0.0 or off_own_goal(world.field, ball, held) > 0.0))
        up = math.cos(math.radians(self.direction - UP_FIELD))
        self.worth = chance * min(1.0, distance / Clear.FAR) * (1.0 - Clear.ASIDE * (1.0 - up))
        outwards = (ball[0] - 0.5 * world.field.width) * math.cos(math.radians(self.direction))
        if outwards < 0.0:
            self.worth *= Clear.ACROSS
        if any(in_the_way(ball, self.direction, other.position) for other in world.opponents):
            self.worth *= Clear.HELD

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
    return (math.hypot(dx, dy) < Clear.OPPONENT and
            abs(wrap(math.degrees(math.atan2(dy, dx)) - direction)) < Clear.OPPONENT_DEG)


def predicted(world, seconds) -> tuple[Point, Point]:
    """The ball's place in the robot frame, and on the field, as a kick that begins after that time
    strikes it: the robot walks on until the motion begins, the ball rolls until the strike, ever
    slower. The kick map's balls lay still."""
    ball, step = world.ball, world.odometry
    share, rolls = seconds / max(world.elapsed_s, 0.02), 0.0
    if intercept.rolls(ball):
        rolls = intercept.rolled(speed(ball), seconds + Clear.STRIKE) / speed(ball)
    vx, vy = intercept.relative_velocity(world)
    return ((ball.relative.x + share * step.left + rolls * vx,
             ball.relative.y - share * step.forward + rolls * vy),
            (ball.position.x + rolls * ball.velocity.x, ball.position.y + rolls * ball.velocity.y))


def at_ball(world, place, reach) -> bool:
    """Whether a place of the field is so near (cm) to the ball."""
    ball = world.ball.position
    return world.ball.present and math.hypot(place.x - ball.x, place.y - ball.y) < reach


def opponent_at(world, x, y) -> bool:
    """Whether an opponent, seen just now, is at a ball that lies there: half of the kicks then
    leave it where it lay, or nearly."""
    return opponent_within(world, (x, y), Clear.AT_BALL, Clear.HAS_SEEN)


def opponent_has(world) -> bool:
    """Whether an opponent that was seen just now holds the ball, or will before it is kicked."""
    near = opponent_within(world, point_of(world.ball), Clear.HAS, Clear.HAS_SEEN)
    return world.ball.present and near or feet_at_ball(world)


def feet_at_ball(world) -> bool:
    """Whether somebody's feet stand at the ball in this image, and no mate's: of who comes head on,
    or is at a ball that the head looks down at, no uniform shows, and it is not known of."""
    ball = world.ball
    if not ball.present or ball.seconds_since_seen > Clear.SEEN:
        return False
    feet = sum(math.hypot(foot.position.x, foot.position.y) > OWN_BODY and
               math.hypot(foot.position.x - ball.relative.x,
                          foot.position.y - ball.relative.y) < Clear.FEET
               for foot in world.percepts.obstacles)
    return feet >= Clear.FEET_LEAST and not any(
        at_ball(world, mate.pose.position, Clear.FEET_MATE) for mate in world.teammates)


def mate_grabs(world) -> bool:
    """Whether a mate at the ball says that it grabs or holds it: who kicks there, too, sends the
    ball back past himself."""
    return any(mate.note.grabs != kelpie.GRABS_NOT and
               at_ball(world, mate.pose.position, Clear.MATE) for mate in world.teammates)


def walks(world) -> bool:
    """Whether the kick begins from a walk, in which it does another thing than from standing."""
    step = world.odometry
    return math.hypot(step.forward, step.left) > Clear.WALKS * world.elapsed_s


def in_window(kick, x, y, walking) -> bool:
    """Whether a ball lies in the kick's window of the map or a little beside it: from its outer
    places half of the balls stayed."""
    left, near, right, far = kick_table.window(kick, walking)
    beside = Clear.BESIDE
    return (left - beside <= x <= right + beside and
            near - beside <= y <= min(far + beside, Clear.FARTHEST))


def strikes(world) -> list[tuple[Point, Point]]:
    """predicted() of a kick that is asked for now, whether the motion begins at once or at the end
    of a step."""
    return [predicted(world, seconds) for seconds in Clear.LATENCY]


def clearance(world, kick, strikes_at) -> Clearance | None:
    """What a kick is worth at least that meets the ball at one of strikes(); None if it then
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
        if worst is None or one.worth < worst.worth:
            worst = one
    return worst


def clearing_kick(world) -> Clearance | None:
    """The best safe kick of the ball as it lies, if it is good enough not to walk on."""
    ball = world.ball
    if not ball.present or ball.seconds_since_seen > Clear.SEEN or ball.distance > Clear.NEAR:
        return None
    strikes_at = strikes(world)
    found = [clearance(world, kick, strikes_at) for kick in kick_table.kicks(False)]
    good = [one for one in found if one is not None and one.worth > Clear.WORTH]
    return max(good, key=lambda one: one.worth, default=None)
