# SPDX-License-Identifier: Apache-2.0
# One skill alone, begun anew in every frame: what it does at its first step from any place. For
# drawings (`kelpie vectors`, the first iteration of thesis 2006 section 7.1.3). Keeps nothing.
import kelpie
from arbiter.skill import Skill
from decisions.held_choice import HeldChoice
from decisions.tree import GRAB_DRIBBLE_GOAL
from roles.attacker import Attacker
from situation.contested import Contested
from situation.goal import OpponentGoal
from situation.memory import Memory
from skills.ball.find_ball import FindBall
from skills.ball.grab_dribble import GrabDribble
from skills.ball.kick_ball import KickBall
from skills.ball.line_up_kick import LineUpKick
from skills.walk.avoid_own_box import AvoidOwnBox


def grab_dribble(world, memory):
    return GrabDribble(memory, HeldChoice(memory, Contested()).choose, GRAB_DRIBBLE_GOAL)


def attacker(world, memory):
    role = Attacker(memory)
    role.enter(world, role.play)
    return role


def line_up_kick(world, memory):
    goal = OpponentGoal()
    goal.update(world)
    return LineUpKick(memory, goal)


def free_kick(kick):
    return lambda world, memory: KickBall(memory, kick)


SKILLS = {
    'attacker': attacker,
    'avoid_own_box': lambda world, memory: AvoidOwnBox(memory),
    'find_ball': FindBall,
    'grab_dribble': grab_dribble,
    'line_up_kick': line_up_kick,
    **{facts.leaf: free_kick(kick) for kick, facts in kelpie.KICKS.items() if facts.leaf},
}


class OneSkill(Skill):
    LAYER = kelpie.LAYER_PLAYER
    NAME = 'single'

    def step(self, world) -> kelpie.Command:
        memory = Memory()
        memory.update(world)
        makers = list(SKILLS.values())
        if world.task.skill >= len(makers):
            return kelpie.Command()
        return makers[world.task.skill](world, memory).step(world)
