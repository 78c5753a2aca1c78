# SPDX-License-Identifier: Apache-2.0
# How long a robot needs to a point or to the ball (thesis 2006 section 4.4.1): straight there and
# the turn before, more for what stands on the way and for a robot that is stuck. Bonuses of the
# time to the ball (a sure ball, the attacker of the last frame, a grab) are seconds that are not
# added, so that it is never negative. Each term more is never less time. And where the ball is that
# is gone for, by the own belief or by the team's. Keeps nothing. It fails to see that others move
# out of the way, and as pose and ball do; a mate with a wrong pose tells of a ball that is nowhere.
import math

import kelpie
from lib import rulebook
from lib.geom import from_field, heading, wrap

SPEED = 30.0             # cm/s, and
TURN_SPEED = 120.0       # deg/s: checklist U04
CORRIDOR = 30.0          # cm; of the obstacle map, facts-2005 section 7.1
FEW = 5.0     # counts,
MANY = 100.0  # counts: fewer are noise, more are as bad
OBSTACLE_S = 0.01        # s for each
STUCK_S = 2.0            # ours: backing off takes 0.8 s, coming back as long
SURE_FRAMES = 15         # frames lost from which a ball is less sure (facts-2005 section 7.1),
LOST_S = 0.002           # s for the square of each more,
LOST_MAX_S = 6.0         # up to so much, after 2.3 s
ROUND_S = 0.9            # s for half a circle round the ball: ours, of who runs with it and has to
                         # be behind it
ATTACKER_S = 0.7         # bonuses of U04
GRAB_S = 2.0  # s
NEVER_S = 1000.0         # of who knows no ball (robot/core/types/TeamNote.h)
FRESH_S = 1.0            # s; an older ball of the team is not gone for
LATER_S = 0.4            # s by which a mate saw it later than the robot itself
OFF = 15.0               # cm beyond the lines; a ball farther off is one of a wrong pose: by one
                         # 38 cm behind the goal a goalie went the wrong way
APPROACH = 40.0          # cm, of a grab that is reported


def seconds(distance, off_deg=0.0, obstacles=0.0, stuck=False) -> float:
    """For a point so many cm away and deg off, with that count on the way."""
    on_the_way = min(obstacles, MANY) if obstacles >= FEW else 0.0
    return (distance / SPEED + abs(off_deg) / TURN_SPEED + OBSTACLE_S * on_the_way +
            (STUCK_S if stuck else 0.0))


def of_pose(pose, point, obstacles=0.0) -> float:
    """For a robot at a pose to a point of the field, both as anybody may know them."""
    dx, dy = point[0] - pose.position.x, point[1] - pose.position.y
    off_deg = wrap(math.degrees(math.atan2(dy, dx)) - pose.heading_deg)
    return seconds(math.hypot(dx, dy), off_deg, obstacles)


def on_way(cells, start, end) -> float:
    """The count of the obstacle map within half a corridor of the way from one (x, y) to another,
    but for a robot's length before its end: there the ball is contested, not the way blocked."""
    x0, y0 = start
    dx, dy = end[0] - x0, end[1] - y0
    length = math.hypot(dx, dy)
    if length < 2.0 * CORRIDOR:
        return 0.0
    dx, dy = dx / length, dy / length
    half, maximum, total = CORRIDOR / 2.0, length - CORRIDOR, 0.0
    left, right = min(x0, end[0]) - half, max(x0, end[0]) + half
    for cell in cells:
        place = cell.position
        x = place.x
        if left < x < right:  # half of the cells do not
            x, y = x - x0, place.y - y0
            if half < x * dx + y * dy < maximum and abs(x * dy - y * dx) < half:
                total += cell.own + cell.heard
    return total


def to_point(world, point) -> float:
    """Of this robot to a point of the field, by all that it knows."""
    x, y = from_field(world.pose, *point)
    place = world.pose.position
    return seconds(math.hypot(x, y), heading(x, y),
                   on_way(world.obstacles, (place.x, place.y), point), is_stuck(world))


def of_mate(world, mate, point) -> float:
    """Of a mate, as far as it is known here: nobody tells that it is stuck."""
    here = mate.pose.position.x, mate.pose.position.y
    return of_pose(mate.pose, point, on_way(world.obstacles, here, point))


def is_stuck(world) -> bool:
    feeling = world.motion.feeling
    return feeling.stuck or feeling.paw_blocked[0] or feeling.paw_blocked[1]


def ball_of(world, lost_frames):
    """Where the ball is on the field for one who has not seen it for so many frames: as itself
    believes, or as its team does if that saw it later; None when nobody knows."""
    ball, team = world.ball, world.team_ball
    own = ball.present and lost_frames <= SURE_FRAMES
    if not own and team.present and team.seconds_since_seen < FRESH_S:
        return team.position.x, team.position.y
    return (ball.position.x, ball.position.y) if ball.present else None


def heard_of(world):
    """Where the team has a ball on the field that this robot has not seen as recently; or None."""
    team, ball = world.team_ball, world.ball
    own_s = ball.seconds_since_seen if ball.present else math.inf
    if (len(world.teammates) == 0 or not team.present or team.seconds_since_seen > FRESH_S or
            own_s < team.seconds_since_seen + LATER_S):
        return None
    x, y, field = team.position.x, team.position.y, world.field
    on_field = -OFF < x < field.width + OFF and -OFF < y < field.length + OFF
    return (x, y) if on_field else None


def unsure(lost_frames) -> float:
    """Seconds for a ball unseen for so many frames: a quadratic bonus that shrinks."""
    return min(LOST_MAX_S, LOST_S * max(0.0, lost_frames - SURE_FRAMES) ** 2)


def to_ball(world, lost_frames, attacked, grabs) -> float:
    """The time to the ball that is sent to the team. `attacked`: attacker in the last frame;
    `grabs`: about to grab the ball, or holding it."""
    ball = ball_of(world, lost_frames)
    if ball is None:
        return NEVER_S
    return (to_point(world, ball) + unsure(lost_frames) + behind(world, ball) +
            (0.0 if attacked else ATTACKER_S) + (0.0 if grabs else GRAB_S))


def behind(world, ball) -> float:
    """Seconds round the ball for who runs with it to the opponents' goal."""
    if not rulebook.runs(world):
        return 0.0
    field, here = world.field, world.pose.position
    goal = math.degrees(math.atan2(field.length - ball[1], 0.5 * field.width - ball[0]))
    way = math.degrees(math.atan2(ball[1] - here.y, ball[0] - here.x))
    return ROUND_S * abs(wrap(goal - way)) / 180.0


def grabs_now(world, memory) -> int:
    """What the team hears of a grab: HOLDS while the body feels the ball in one, SOON while one
    has begun or is approached within its last 40 cm."""
    if memory.grab_lost <= 1:
        return kelpie.HOLDS if world.motion.feeling.ball_held else kelpie.GRABS_SOON
    near = memory.approach_lost <= 1 and world.ball.distance < APPROACH
    return kelpie.GRABS_SOON if near else kelpie.GRABS_NOT
