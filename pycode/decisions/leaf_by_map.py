# SPDX-License-Identifier: Apache-2.0
# Whether the leaf of the decision tree is what the kick map would do too: each kick of a free ball
# for how the robot comes to it, against a grab and the aimed kick that follows, by what the ball is
# worth afterwards (decisions/kick_map_choice.py) less what the time costs. Only for a ball that
# nobody contests; there the tree knows more. Keeps nothing. Where the map is used the tree's strikes
# from an edge, of which every second one left the field, are grabs.
import math

import kelpie
from decisions import tree
from decisions.kick_map_choice import held_outcomes, worth_of_way
from lib import kick_table
from lib.geom import wrap

FREE = {tree.UPENN_LEFT: kelpie.UPENN_LEFT, tree.UPENN_RIGHT: kelpie.UPENN_RIGHT,
        tree.HEAD_LEFT: kelpie.HEAD_SWIPE_LEFT, tree.HEAD_RIGHT: kelpie.HEAD_SWIPE_RIGHT,
        tree.KICK_AHEAD: kelpie.KICK_FORWARD}
SECOND = 0.02          # worth of a second: a kick of 170 cm takes 7 s, the walk after it counted
KEEP = 0.04            # worth by which another leaf must be better than the one that is played
GRAB_S = 1.3           # grab, feel, stand, kick
TURN_S = 1.0 / 100.0   # of a degree with the ball
FREE_S = 0.6           # steps to the ball's place
LINE = 35.0            # cm before the goal line, between the posts: the ball is run in


def choose(world, situation, leaf, played=None) -> tuple:
    """(leaf, reason, *numbers); the tree's own leaf where the map has nothing better. `played`:
    the leaf of the frame before."""
    if situation.contested or run_in(world, situation, leaf):
        return leaf, 'as the tree says'
    way = wrap(world.pose.heading_deg + situation.ball_bearing)
    grab = grab_worth(world, situation, way)
    free, kick = max((free_worth(world, situation, kick, way) + (KEEP if kick == played else 0.0),
                      kick) for kick in FREE)
    if free > grab + (KEEP if played in tree.WITH_GRAB else 0.0):
        return kick, 'worth {} at once, {} with a grab', free, grab
    if leaf in tree.WITH_GRAB:
        return leaf, 'worth {} with a grab, {} at once', grab, free
    region = tree.with_grab(situation.zone)
    return (tree.decide(situation, region)[0], 'worth {} with a grab, {} at once', grab, free)


def run_in(world, situation, leaf) -> bool:
    """Close before the open goal nothing is quicker than to run the ball in."""
    aside = abs(situation.ball[0] - 0.5 * world.field.width)
    return (leaf == tree.DRIBBLE and situation.line_distance < LINE and
            aside < 0.5 * world.field.goal_width and abs(situation.facing) < 60.0)


def free_worth(world, situation, leaf, way) -> float:
    outcome = kick_table.window_outcome(FREE[leaf])
    return worth_of_way(world, situation.ball, way, outcome) - SECOND * FREE_S


def grab_worth(world, situation, way) -> float:
    """The best kick from the hold, aimed at the goal's middle."""
    ball = situation.ball
    goal = math.degrees(math.atan2(world.field.length - ball[1],
                                   0.5 * world.field.width - ball[0]))
    worth = max(worth_of_way(world, ball, goal - outcome[1], outcome)
                for outcome in held_outcomes())
    return worth - SECOND * (GRAB_S + TURN_S * abs(wrap(goal - way)))
