# SPDX-License-Identifier: Apache-2.0
# The turn on the spot of a goalie that faces the wrong way (thesis 2006 section 4.3.1). Keeps
# nothing: how far round it goes is situation/facing.py's. Against somebody who holds the robot it
# turns until that has had enough.
import kelpie
from arbiter.skill import Skill
from lib.head import view

PAN = 20.0     # deg of the view ahead of the turn,
DOWN = 6.0     # deg below the horizontal: the height of landmarks
TURN = 120.0   # deg/s


class FaceUpField(Skill):
    NAME = 'face_up_field'

    def __init__(self, world, facing):
        self.facing = facing
        facing.begin_turn(world)

    def step(self, world) -> kelpie.Command:
        side = self.facing.turn_on()
        return kelpie.Command(walk=kelpie.WalkRequest(turn_deg=side * TURN),
                              head=view(side * PAN, DOWN, world.stance))

    def end(self) -> None:
        self.facing.end_turn()

    def explain(self, trace) -> None:
        branch = 'left' if self.facing.side > 0.0 else 'right'
        trace.append((kelpie.LAYER_SKILL, self.NAME, branch,
                      'the own goal was seen ahead {} times', self.facing.own_goal))
