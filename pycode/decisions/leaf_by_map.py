# SPDX-License-Identifier: Apache-2.0
# Whether the leaf of the decision tree is what the kick map would do too: each kick of a free ball
# for how the robot comes to it, against a grab and the aimed kick that follows, by the ball's
# utility afterwards (decisions/kick_map_choice.py) less what the time costs. Where the map is used
# the tree's strikes from an edge, of which every second one left the field, are grabs, and so are
# all of a contested ball, which brought it 16 cm up-field where a kick from the hold brings
# 63.
import math

import kelpie
from decisions import tree
from decisions.kick_map_choice import AHEAD, utility_of_way
from lib import kick_table
from lib.geom import wrap

CONSTANTS = kelpie.constants.leaf  # behaviour/constants.toml: defaults and ranges
# The leaves that kick a free ball, those whose kick goes farthest first.
FREE = {kelpie.KICKS[kick].leaf: kick
        for kick in sorted(kick_table.kicks(False), key=lambda kick: -kelpie.KICKS[kick].distance)
        if kelpie.KICKS[kick].leaf}
GRAB = 'grab'
WAYS = (GRAB, *FREE)
SECOND = 0.02          # utility of a second: a kick of 170 cm takes 7 s, the walk after it counted
KEEP = CONSTANTS.keep  # utility by which another leaf must be better than the one that
                       # is played
GRAB_S = CONSTANTS.grab  # grab, feel, stand, kick
TURN_S = 1.0 / 100.0   # of a degree with the ball
FREE_S = CONSTANTS.free  # steps to the ball's place
LINE = 35.0            # cm before the goal line, between the posts: the ball is run in


class LeafByMap:
    """Keeps the utility of each way to play the ball when it was last worked out: one of them in
    every second frame, as all of them are a third of what the robot can spend on behaviours."""

    def __init__(self):
        self.utilities = {}
        self.next = 0

    def choose(self, world, situation, leaf, played=None) -> tuple:
        """(leaf, reason, *numbers): a grab of a contested ball, else the tree's own leaf where the
        map has nothing better. `played`: the leaf of the frame before."""
        if situation.contested:
            return tree.grab_leaf(situation), 'contested'
        if run_in(world, situation, leaf):
            return leaf, 'as the tree says'
        self.update(world, situation)
        grab = self.utilities[GRAB] + (KEEP if played in tree.WITH_GRAB else 0.0)
        free, kick = max((utility + (KEEP if way == played else 0.0), way)
                         for way, utility in self.utilities.items() if way != GRAB)
        if free > grab:
            return kick, 'worth {} at once, {} with a grab', free, grab
        if leaf not in tree.WITH_GRAB:
            leaf = tree.grab_leaf(situation)
        return leaf, 'worth {} with a grab, {} at once', grab, free

    def update(self, world, situation):
        """All ways at first, then one after the other."""
        if self.utilities and world.frame % 2:
            return
        way = wrap(world.pose.heading_deg + situation.ball_bearing)
        due = WAYS if not self.utilities else WAYS[self.next:self.next + 1]
        self.next = (self.next + 1) % len(WAYS)
        for name in due:
            self.utilities[name] = (grab_utility(world, situation, way) if name == GRAB
                                    else free_utility(world, situation, name, way))


def run_in(world, situation, leaf) -> bool:
    """Close before the open goal nothing is quicker than to run the ball in."""
    lateral = abs(situation.ball[0] - 0.5 * world.field.width)
    return (leaf == tree.DRIBBLE and situation.line_distance < LINE and
            lateral < 0.5 * world.field.goal_width and abs(situation.facing) < 60.0)


def free_utility(world, situation, leaf, way) -> float:
    outcome = kick_table.window_outcome(FREE[leaf])
    return utility_of_way(world, situation.ball, way, outcome) - SECOND * FREE_S


def grab_utility(world, situation, way) -> float:
    """The best kick from the hold, aimed at the goal's middle."""
    ball = situation.ball
    goal = math.degrees(math.atan2(world.field.length - ball[1],
                                   0.5 * world.field.width - ball[0]))
    utility = max(utility_of_way(world, ball, goal, kick_table.held_outcome(kick))
                  for kick in AHEAD)
    return utility - SECOND * (GRAB_S + TURN_S * abs(wrap(goal - way)))
