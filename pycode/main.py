# SPDX-License-Identifier: Apache-2.0
# Where the host starts: decide(world) -> Command, once per camera frame. What a robot remembers
# lives in the player made here; an edited file makes a new one.
import kelpie
from decisions.roles import goes_forward
from decisions.tree import rows
from players.challenger import Challenger
from players.ellipse_goalie import EllipseGoalie
from players.forward import Forward
from players.goalie import Goalie
from players.single import SKILLS, OneSkill

MAKERS = {kelpie.FORWARD: Forward, kelpie.GOALIE: Goalie, kelpie.GOALIE_2004: EllipseGoalie,
          kelpie.CHALLENGER: Challenger, kelpie.ONE_SKILL: OneSkill}
players = {}


def decide(world) -> kelpie.Command:
    kind = kelpie.FORWARD if goes_forward(world) else world.task.player
    if kind not in players:
        players[kind] = MAKERS[kind]()
    return players[kind].step(world)


def tree() -> list:
    """The decision tree for a drawing: (id, id above, answer that leads here, text, leaf?)."""
    return rows()


def skill_names() -> list:
    """What `kelpie vectors` can draw, in the order of world.task.skill."""
    return list(SKILLS)
