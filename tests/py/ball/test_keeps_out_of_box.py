# SPDX-License-Identifier: Apache-2.0
"""Who plays the ball or holds it stays out of its own box (thesis 2006 section 4.3.2): the neck
base inside it for a second costs 30 s. Box: 115 to 245 cm across, up to 65 cm deep."""
import cmath
import math
import random

import kelpie
import pytest
from arbiter.skill import Skill
from ideal_world import IdealWorld
from lib.geom import polar
from players.forward import Forward
from roles.attacker import Attacker
from safety.own_box import ball_outside_box
from situation.memory import Memory
from situations import world
from skills.ball.grab_dribble import GrabDribble
from skills.ball.hold import Hold
from skills.walk.step_back import StepBack

BOTH = pytest.mark.parametrize('rules', [kelpie.RULES_OF_KELPIE, kelpie.RULES_OF_THESIS],
                               ids=['kelpie', 'thesis'])


class Now:
    def __init__(self, made):
        self.world = made


def left_of(made, forward=0.0, left=0.0):
    """(across, up-field) in cm/s of what the filter leaves of a walk."""
    walk = ball_outside_box(Now(made), kelpie.WalkRequest(forward=forward, left=left))
    x, y = polar(1.0, made.pose.heading_deg - 90.0)
    return walk.forward * x - walk.left * y, walk.forward * y + walk.left * x


# Place, heading, speed ahead; across and up-field of what is left of it
@pytest.mark.parametrize('x, y, heading, ahead, wanted', [
    (180.0, 120.0, -90.0, 40.0, (0.0, -40.0)),       # far before it
    (180.0, 82.0, -90.0, 40.0, (0.0, -31.4)),        # 11 cm from 6 cm before it, in 0.35 s
    (180.0, 71.0, -90.0, 40.0, (0.0, 0.0)),
    (180.0, 80.0, 90.0, -40.0, (0.0, -25.7)),        # backwards
    (180.0, 71.0, -45.0, 40.0, (28.3, 0.0)),         # along it
    (109.0, 30.0, 0.0, 30.0, (0.0, 0.0)),            # from the side
    (251.0, 30.0, 180.0, 30.0, (0.0, 0.0)),
    (109.0, 30.0, 180.0, 30.0, (-30.0, 0.0)),
    (180.0, 60.0, -90.0, 30.0, (0.0, 0.0)),          # inside it goes no deeper,
    (180.0, 60.0, 90.0, 30.0, (0.0, 30.0)),          # but out
    (125.0, 20.0, 0.0, 30.0, (0.0, 0.0)),
    (125.0, 20.0, 180.0, 30.0, (-30.0, 0.0)),
    (60.0, 30.0, -90.0, 40.0, (0.0, -40.0))])        # beside it
def test_a_walk_ends_at_the_box_and_leads_out_of_it(x, y, heading, ahead, wanted):
    assert left_of(world(x, y, heading), ahead) == pytest.approx(wanted, abs=0.1)


class Walks(Skill):
    """A skill that wants to walk, whatever the place."""

    def __init__(self, forward):
        self.forward = forward

    def step(self, world) -> kelpie.Command:
        return kelpie.Command(walk=kelpie.WalkRequest(forward=self.forward, turn_deg=20.0))


def playing(made, rules, skill):
    made.task = kelpie.Task(rules=rules)
    player = Attacker(Memory())
    skill.committed = True
    player.enter(made, player.play, skill)
    return player


@BOTH
@pytest.mark.parametrize('heading, forward', [(-90.0, 20.0), (90.0, -24.0)])
def test_whatever_is_played_stops_before_the_box_and_turns_on(rules, heading, forward):
    made = world(180.0, 71.0, heading, (180.0, 90.0))
    walk = playing(made, rules, Walks(forward)).step(made).walk
    assert walk.forward == pytest.approx(0.0) and walk.turn_deg == 20.0


def test_who_backs_off_from_somebody_stops_before_it():
    """An attacker of the theses does not back off: algorithm 4.2 has no such line."""
    made = world(180.0, 71.0, 90.0, (180.0, 250.0))
    made.motion.feeling.paw_blocked = [True, True]
    player = Attacker(Memory())
    command = player.step(made)
    assert player.playing == 'back_off' and command.walk.forward == pytest.approx(0.0)


@pytest.mark.parametrize('y, backwards', [(71.0, 0.0), (90.0, 50.0)])
def test_so_does_who_steps_back_from_a_ball_that_it_let_go(y, backwards):
    made = world(180.0, y, 90.0)
    skill = GrabDribble(Memory(), None)
    skill.hold = Hold(made, made.time_s)
    skill.enter(made, skill.step_back, StepBack(made))
    player = Attacker(Memory())
    player.enter(made, player.play, skill)
    assert player.step(made).walk.forward == pytest.approx(-backwards)


@BOTH
@pytest.mark.parametrize('waited, goes_in', [(90, False), (91, True)])
def test_without_a_goalie_a_ball_in_the_box_is_still_fetched(rules, waited, goes_in):
    made = world(180.0, 75.0, -90.0, (180.0, 40.0))
    player = playing(made, rules, Walks(30.0))
    player.box_frames = waited
    assert (player.step(made).walk.forward == pytest.approx(30.0)) is goes_in


class BeforeOwnBox(IdealWorld):
    """The ball lies near the own box, and the robot comes from anywhere up-field of it."""

    def __init__(self, seed):
        super().__init__(seed)
        draw = random.Random(seed)
        self.ball = complex(draw.uniform(100, 260), draw.uniform(67, 110))
        self.at = self.ball + complex(draw.uniform(-120, 120), draw.uniform(20, 150))
        self.facing = cmath.rect(1, draw.uniform(-math.pi, math.pi))
        self.see()

    def in_view(self, point, height):
        return any(super(BeforeOwnBox, self).in_view(point, each) for each in (height, 3.0))


@BOTH
def test_a_ball_just_before_the_box_is_got_from_there_without_entering_it(rules):
    entered, away = 0, []
    for seed in range(12):
        ideal, player = BeforeOwnBox(seed), Forward()
        ideal.world.task = kelpie.Task(rules=rules)
        while ideal.world.time_s < 12.0:
            ideal.step(player.step(ideal.world))
            entered += ideal.at.imag < 65.0 and abs(ideal.at.real - 180.0) < 65.0
        away.append(ideal.ball.imag)
    assert entered == 0 and sorted(away)[6] > 150.0
