# SPDX-License-Identifier: Apache-2.0
# The tests of the goalie's rules (thesis 2006 algorithm 4.1), each of a GoalieSituation and of the
# state that is played: why its state is due, with the numbers that decided, or None. They keep and
# change nothing. The order is the player's (players/goalie.py).
import math

import kelpie
from lib import rulebook
from lib.goalie_places import beyond_box
from lib.paths import point_of
from situation import opponents
from situation.shot import coming, speed
from situation.shot_watch import NAMES

CONSTANTS = kelpie.constants.goalie  # behaviour/constants.toml: defaults and ranges
BETWEEN_PAWS = CONSTANTS.between_paws  # s that a ball may lie between the paws; the rules allow 3
COMING = CONSTANTS.coming  # cm/s of a ball that is moved into the way of,
COMING_BESIDE = 15.0  # cm beside the mouth at most,
COMING_SHORT = 25.0  # cm short of the line at most,
COMING_LATEST = 4.0  # s; a ball that takes longer is guarded against as one that lies
STANDS = CONSTANTS.stands  # s after a motion: the ball seen by a robot that lies or gets up
                     # is up to 8 cm off, and the kick misses
NEAR = CONSTANTS.near  # cm beyond the box; the neck stays in, the legs reach farther
LEAVE = 15.0         # cm beyond the box; thesis 2004 section 4.2.2
FAST = CONSTANTS.fast  # cm/s; a faster ball is not run after
CLEARS = CONSTANTS.clears  # cm round the box in which a ball is run through,
OWN = 12.0           # cm, in which it is the goalie's whoever is nearer: mates keep off the box


def faces_wrong(now, playing):
    return now.facing.wrong


def shot_comes(now, playing):
    motion = now.shots.block()
    if motion not in NAMES:
        return None
    shot = now.shots.shot
    return (NAMES[motion] + ' block: at {} cm/s it passes {} cm right in {} s', shot.speed,
            shot.lateral, shot.seconds)


def stands_over_ball(now, playing):
    """A ball under the chin counts as held. Of 22 goalies that were taken out for it 20 had the
    ball in their goal within 6 s."""
    seconds = now.paws.for_s if rulebook.of(now.world).YIELDS else 0.0
    return ('stands over the ball for {} s', seconds) if seconds > BETWEEN_PAWS else None


def ball_comes(now, playing):
    if not (now.sees() and now.seen_since_motion):
        return None
    shot = coming(now.world, COMING_BESIDE, COMING_SHORT, COMING)
    if shot is None or shot.seconds > COMING_LATEST:
        return None
    return 'a ball comes at {} cm/s, to {} cm right', shot.speed, shot.lateral


def mate_grabs(now, playing):
    """A held ball is nobody else's to kick."""
    yields = rulebook.of(now.world).YIELDS and opponents.mate_grabs(now.world)
    return ('a mate grabs the ball',) if yields else None


def can_clear_at_once(now, playing):
    """Of who runs with the ball: a kick brings one farther than running through it."""
    return can_clear(now, playing) if rulebook.runs(now.world) else None


def can_run(now, playing):
    """Of who runs with the ball: one at the box is the goalie's, and so is one near it while no
    mate is nearer. Waiting for it beside the line, as against a kick, lets it be pushed in."""
    world = now.world
    if not rulebook.runs(world) or not now.sees() or now.pose_lost:
        return None
    away = beyond_box(world.field, now.ball)
    if away > CLEARS or not (away < OWN or nearest(world, now.ball)):
        return None
    return 'the ball is {} cm beyond the box', away


def nearest(world, place) -> bool:
    """Whether no mate is nearer to a place of the field."""
    here = math.dist(point_of(world.pose), place)
    return all(here < math.dist(point_of(mate.pose), place) for mate in world.teammates)


def opponent_has_ball(now, playing):
    """Who tries to kick it is beside the ball when it is shot, not between it and the goal."""
    return ('an opponent has the ball',) if now.opponent_has_ball else None


def can_clear(now, playing):
    if now.world.time_s - now.moved_s <= STANDS or now.clearance is None:
        return None
    best = now.clearance
    return ('worth {}, to {} deg, {} deg off the own goal',
            best.utility, best.direction, best.off_goal)


def can_attack(now, playing):
    """Not for a ball that it has lost on the way: walking on, it took such into its goal. It stands
    then, or goes where mates see it."""
    world, attacks = now.world, playing == 'attack'
    away = beyond_box(world.field, now.ball)
    if (not now.sees() or not now.seen_since_motion or away > (LEAVE if attacks else NEAR) or
            too_fast(world) or world.time_s < now.rest_s or now.pose_lost or
            now.kick_stand(attacks) is None):
        return None
    return 'the ball is {} cm beyond the box', away


def too_fast(world) -> bool:
    return rulebook.of(world).ATTACKS_BRIEFLY and speed(world.ball) > FAST


def guards(now, playing):
    return 'the ball is {} cm away', now.world.ball.distance
