# SPDX-License-Identifier: Apache-2.0
# Where the goalie guards in this frame (thesis 2006 section 4.3.1): by the ball, or by where mates
# see it; nowhere else while it is looked for at first, all round if it was lost close by; then in
# the middle, and at last so near to the line that no ball can lie behind the robot unseen. Keeps
# nothing. By a wrong pose every place is wrong.
from lib import rulebook
from lib.goalie_places import MIN_Y, central_place
from lib.paths import point_of
from safety.own_goal import round_ball

UNSEEN = 1.6     # s; then it goes to the middle, unless it still looks close by,
LOST = 6.0       # s; then to the line: the head sees 26 deg past the sides


def guard_place(now, eyes, rule):
    """(x, y, heading) of the field, or None: it stands, or turns to look. `eyes`: the head, whose
    survey looks elsewhere: its time is none of looking for the ball. `rule`: from the field and a
    ball to a place."""
    world = now.world
    if not rulebook.of(world).SPARES_OWN_GOAL:
        known = world.ball.present and now.lost_for < UNSEEN
        return rule(world.field, now.ball) if known else central_place(world.field)
    if now.reported is not None:
        return place_for(world, rule, now.reported)
    lost = now.lost_for if now.pose_settled else 0.0
    if lost > LOST:
        return central_place(world.field, MIN_Y)
    if eyes.searches_near(world):
        return None
    if min(lost, world.time_s - eyes.surveyed_s) > UNSEEN:
        return central_place(world.field)
    if not (now.pose_settled and now.sees() and now.seen_since_motion) or eyes.surveys:
        return None
    return place_for(world, rule, now.ball)


def place_for(world, rule, ball):
    return round_ball(world.field, point_of(world.pose), rule(world.field, ball), ball)
