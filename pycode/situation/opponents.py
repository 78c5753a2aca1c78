# SPDX-License-Identifier: Apache-2.0
# Where somebody else is at the ball or at the own body, in the four senses that a player acts on:
# at a ball (a kick would leave it there), having it (it is theirs for now), at hand (who turns
# sweeps the ball in), and a mate that grabs it. Keeps nothing. Opponents that nobody has seen
# recently are not there; whoever no uniform shows is recognised by its feet alone.
import math

import kelpie
from lib.paths import point_of
from situation.obstacles import OWN_BODY

AT_BALL = 30.0       # cm from the ball to an opponent's neck. Of 38 kicks with one in 25 half left
                     # the ball within 20 cm for 0.4 s, of 53 alone a quarter
HAS_BALL = 45.0      # cm from there to one that has it, or has it before it is kicked: in 87 % of
                     # 314 frames with one within 33 cm somebody is believed so near (within 18 cm
                     # in 32 %), in 7 % of 153 with all beyond 45 cm
SEEN_S = 1.0         # s since it was seen
AT_HAND = 50.0       # cm to an opponent: the ball is between the two
BALL_SEEN_S = 0.2    # s; feet are looked for at a ball of this image only
FEET = 24.0          # cm from the ball to feet in the image,
FEET_MIN = 2       # points of them at least: there in 60 % of 252 frames with an opponent within
                     # 25 cm, in none of 228 with all beyond 33 cm
FEET_MATE = 45.0     # cm from the ball to a mate that they may be of
MATE = 30.0          # cm from the ball to a mate's neck that grabs it: both own goals of 20 matches
                     # were kicks of goalies against their own attacker's hold


def within(world, place, reach, seconds=SEEN_S) -> bool:
    """Whether an opponent that was seen so recently (s) is so near (cm) to a place of the field."""
    return any(other.seconds_since_seen < seconds and math.dist(point_of(other), place) < reach
               for other in world.opponents)


def at_ball(world, place) -> bool:
    """Whether an opponent is at a ball that lies at that place of the field: half of the kicks then
    leave it where it lay, or nearly."""
    return within(world, place, AT_BALL)


def at_hand(world) -> bool:
    """Whether an opponent is near the own neck."""
    return within(world, point_of(world.pose), AT_HAND)


def has_ball(world) -> bool:
    """Whether an opponent holds the ball, or will before it is kicked."""
    near = world.ball.present and within(world, point_of(world.ball), HAS_BALL)
    return near or feet_at_ball(world)


def feet_at_ball(world) -> bool:
    """Whether somebody's feet stand at the ball in this image, and no mate's: of who comes head on,
    or is at a ball that the head looks down at, no uniform shows, and it is not known of."""
    ball = world.ball
    if not ball.present or ball.seconds_since_seen > BALL_SEEN_S:
        return False
    feet = sum(math.hypot(foot.position.x, foot.position.y) > OWN_BODY and
               math.hypot(foot.position.x - ball.relative.x,
                          foot.position.y - ball.relative.y) < FEET
               for foot in world.percepts.obstacles)
    return feet >= FEET_MIN and not any(
        ball_is_near(world, mate.pose.position, FEET_MATE) for mate in world.teammates)


def mate_grabs(world) -> bool:
    """Whether a mate at the ball says that it grabs or holds it: who kicks there, too, sends the
    ball back past himself."""
    return any(mate.note.grabs != kelpie.GRABS_NOT and
               ball_is_near(world, mate.pose.position, MATE) for mate in world.teammates)


def ball_is_near(world, place, reach) -> bool:
    """Whether a place of the field is so near (cm) to the ball."""
    ball = world.ball.position
    return world.ball.present and math.hypot(place.x - ball.x, place.y - ball.y) < reach
