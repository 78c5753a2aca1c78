# SPDX-License-Identifier: Apache-2.0
# Walks that would take the ball into the own goal: the push of a body at which it lies, a turn away
# from up-field beside it, and the way back round a ball before the goal. Keeps nothing. The body is
# a rectangle that pushes square to its sides; legs push otherwise, too, by some degrees.
import math

import kelpie
from lib.geom import clamp, from_field
from lib.goalie_places import BALL_RADIUS, MIN_Y, TRUNK, Place, box, middle, off_own_goal, past_ball
from safety.own_box import MARGIN

BODY_SIDE = 7.5      # cm from the neck base, by which the body pushes a ball,
BODY_FRONT = 4.0     # cm ahead of it
CONTACT = 6.0        # cm to the ball
CLOSING = 2.0        # cm/s towards it
PUSHED_OFF = 10.0    # deg off the own goal, at least
LOST = 6.0           # s; a ball unseen for longer may lie anywhere
ROUND_BY = 24.0      # cm from the ball to the side by which it is gone round,
ROUND_MIN = 14.0   # cm where the box ends,
ROUND_DONE = 5.0     # cm up to which from the place's distance to the line
ANY = 180.0          # deg


def would_own_goal(field, pose, walk, ball) -> bool:
    """Whether the body, walking so, pushes a ball that lies at it towards the own goal."""
    x, y = from_field(pose, *ball)
    near_x, near_y = clamp(x, -BODY_SIDE, BODY_SIDE), clamp(y, -TRUNK, BODY_FRONT)
    dx, dy = x - near_x, y - near_y
    if math.hypot(dx, dy) > BALL_RADIUS + CONTACT:
        return False
    turn = math.radians(walk.turn_deg)
    speed_x, speed_y = -walk.left - turn * near_y, walk.forward + turn * near_x
    if dx == dy == 0.0:   # the ball is believed inside the body, and goes along
        dx, dy = speed_x, speed_y
    if speed_x * dx + speed_y * dy <= CLOSING * math.hypot(dx, dy):
        return False
    pushed = pose.heading_deg + math.degrees(math.atan2(-dx, dy))
    return off_own_goal(field, ball, pushed) < PUSHED_OFF


def up_field(now, turn_deg, maximum) -> float:
    """A turn, or 0 if it leads off up-field by more than so many degrees. Deeper than it stands by
    itself the goalie sweeps a ball before its chest into the goal with any such turn."""
    side = math.copysign(1.0, turn_deg)
    deep = now.world.pose.position.y < MIN_Y
    return 0.0 if -side * now.facing.up_deg >= (0.0 if deep else maximum) else turn_deg


def faces_reported_ball(now, walk) -> kelpie.WalkRequest:
    """The filter beside a ball that only mates see: no turn off up-field."""
    if now.reported is not None:
        walk.turn_deg = up_field(now, walk.turn_deg, ANY)
    return walk


def no_own_goal(now, walk) -> kelpie.WalkRequest:
    """The filter: the walk, or its translation or its turn alone, if that takes no ball in."""
    if now.reported is None and not now.sees(LOST):
        return walk
    ball = now.reported or now.ball
    for one in (walk, kelpie.WalkRequest(forward=walk.forward, left=walk.left),
                kelpie.WalkRequest(turn_deg=walk.turn_deg)):
        if not would_own_goal(now.world.field, now.world.pose, one, ball):
            return one
    return kelpie.WalkRequest()


def hold_position(now, walk) -> kelpie.WalkRequest:
    """The filter of who is pressed at a ball at its body: it stands, for 4 s, and after a motion
    for 4 more."""
    return kelpie.WalkRequest() if now.pressed else walk


def round_ball(field, start, place, ball) -> Place:
    """The next place of a way back that does not take a ball before the goal along, which lies
    there: sideways first, by the nearer side, then back, then to the place."""
    left, right, _, _ = box(field, MARGIN)
    x, y, heading = place
    if (abs(ball[0] - middle(field)[0]) > 0.5 * field.goal_width or start[1] - y < ROUND_DONE or
            not past_ball(start, (x, y - TRUNK), ball)):
        return place
    if abs(start[0] - ball[0]) >= ROUND_MIN:
        return start[0], y, heading
    lateral = ROUND_BY if start[0] >= ball[0] else -ROUND_BY
    return clamp(ball[0] + lateral, left, right), start[1], heading
