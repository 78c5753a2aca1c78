# SPDX-License-Identifier: Apache-2.0
# The kick of a robot that holds the ball, asked in every frame of skills/ball/grab_dribble.py: by
# the rules of the thesis (decisions/kick_choice.py) once it has aimed, or by the map of where kicks
# go (decisions/kick_map_choice.py); or a pass of a higher utility (decisions/passing.py). Keeps the
# contest's latch of the attacker, the memory, and the mate of the pass. Answers None while the
# robot should turn or carry on.
import kelpie
from decisions import kick_choice, kick_map_choice, passing
from decisions.kick_choice import Hold
from lib import kick_table, rulebook
from lib.geom import wrap
from situation.aim import mouth
from situation.memory import own_goal_at
from skills.ball.grab_dribble import STOP_INSIDE

UPENN_PLANS = {'grab_upenn_left': kelpie.UPENN_LEFT, 'grab_upenn_right': kelpie.UPENN_RIGHT}
PASSES = {kick_choice.PASS_LEFT: kelpie.UPENN_LEFT, kick_choice.PASS_RIGHT: kelpie.UPENN_RIGHT}
NOWHERE = 1e3         # deg


class HeldChoice:
    def __init__(self, memory, contested):
        self.memory = memory
        self.contested = contested
        self.pass_to = 0     # the mate's number; 0: the last choice was no pass

    def start(self) -> None:
        """Of a new grab no pass is chosen."""
        self.pass_to = 0

    def choose(self, world, dribble, overdue) -> tuple | None:
        """(kick or kick_choice.RELEASE, reason, numbers...) or None. `dribble`: the GrabDribble;
        `overdue`: the rules leave no more time. Nobody kicks at an own goal that he sees."""
        chosen = self.by_pose(world, dribble, overdue)
        if chosen is None or not own_goal_at(self.memory, way_of(chosen[0])):
            return chosen
        self.pass_to = 0
        return (kick_choice.RELEASE, 'out of time, the own goal is ahead') if overdue else None

    def by_pose(self, world, dribble, overdue):
        if rulebook.passes(world) and len(world.teammates) > 0:
            passed = self.pass_on(world, dribble)
            if passed is not None:
                return passed
        self.pass_to = 0
        return self.alone(world, dribble, overdue)

    def pass_on(self, world, dribble):
        """To a mate with whom the ball has a higher utility than the own kick, once aimed; by a
        margin to begin with, since the stop for it is lost otherwise."""
        best = passing.best(world, kick_map_choice.held_ball(world))
        if best is None:
            return None
        gap = dribble.aim.gap or mouth(world)
        middle = wrap(0.5 * (gap[0] + gap[1])) if gap is not None else 0.0
        own = max(kick_map_choice.utility_of(world, kick, gap, middle)
                  for kick in kick_map_choice.AHEAD)
        utility, kick, player = best
        if utility < own + (0.0 if self.pass_to == player else passing.MIN_GAIN):
            return None
        self.pass_to = player
        return kick, 'pass to player {}: worth {}, own kick {}', player, utility, own

    def alone(self, world, dribble, overdue):
        if rulebook.by_kick_map(world):
            return kick_map_choice.choose(world, dribble, overdue)
        strike = UPENN_PLANS.get(dribble.plan)
        if strike is not None:
            return strike, 'struck back into the field at once'
        if dribble.plan == 'grab_dribble_stop' and not overdue:
            inside = dribble.line_distance(world) >= STOP_INSIDE
            return (kick_choice.RELEASE, 'carried back into the field') if inside else None
        return self.by_rules(world, dribble, overdue)

    def by_rules(self, world, dribble, overdue):
        aim = dribble.aim
        aimed = aim.aimed and aim.points_into_gap
        hold = Hold(world, self.memory, self.contested.now, aim.gap, aimed, dribble.searched,
                    dribble.search_side)
        if overdue:
            return as_motion(kick_choice.out_of_time(hold))
        if aim.aimed and not dribble.should_carry(world):
            chosen = kick_choice.by_rules(hold)
        elif aim.gap is None and dribble.searched >= kick_choice.SPUN and not (
                rulebook.of(world).SPINS_UNTIL_SEEN):
            chosen = kick_choice.goal_not_seen(hold)
        else:
            return None
        return None if chosen[0] == kick_choice.SPIN_AWAY else as_motion(chosen)


def way_of(kick) -> float:
    """deg to the left that a kick of a held ball sends it; a ball that is let go stays."""
    return NOWHERE if kick == kick_choice.RELEASE else kick_table.way(kick, True)


def as_motion(chosen) -> tuple:
    """A pass across is a UPenn kick to that side."""
    return (PASSES.get(chosen[0], chosen[0]), *chosen[1:])
