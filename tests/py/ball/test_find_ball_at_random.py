# SPDX-License-Identifier: Apache-2.0
"""The search in worlds drawn at random: it finds every ball of an ideal field, and no world makes
it raise, ask for what is not finite, or stay in one step for good."""
import math
import random

import kelpie
import pytest
from ideal_world import IdealWorld
from situation.memory import Memory
from skills.ball.find_ball import FindBall

FRAMES_PER_S = 30


def seconds_to_find(seed) -> float:
    """From a random start, for a ball anywhere on the field that is seen from 250 cm away."""
    ideal, chance = IdealWorld(seed), random.Random(seed + 1000)
    ideal.ball = complex(chance.uniform(30.0, 330.0), chance.uniform(30.0, 510.0))
    ideal.see()
    memory = Memory()
    skill = FindBall(ideal.world, memory)
    for frame in range(60 * FRAMES_PER_S):
        memory.update(ideal.world)
        if ideal.world.percepts.ball.present:
            return frame / FRAMES_PER_S
        ideal.step(skill.step(ideal.world))
    return 60.0


def test_every_ball_of_the_field_is_found_within_15_seconds():
    seconds = [seconds_to_find(seed) for seed in range(200)]
    assert max(seconds) < 15.0 and sorted(seconds)[100] < 3.0


class OddWorld:
    """A world in which everything the search looks at jumps about."""

    def __init__(self, seed):
        self.chance = random.Random(seed)
        self.world = kelpie.WorldFrame(field=kelpie.FIELDS['2006'])

    def next(self):
        chance, world = self.chance, self.world
        world.time_s += chance.choice((0.0, 1.0 / 30.0, 1.0 / 30.0, 0.5))
        world.head.head_pan_deg = chance.uniform(-90.0, 90.0)
        world.head.head_nod_deg = chance.uniform(-15.0, 45.0)
        world.odometry.turn_deg = chance.uniform(-8.0, 8.0)
        world.odometry.forward = chance.uniform(-2.0, 2.0)
        world.pose.position.x = chance.uniform(-100.0, 500.0)
        world.pose.position.y = chance.uniform(-100.0, 700.0)
        world.pose.heading_deg = chance.uniform(-180.0, 180.0)
        world.heading_sd_deg = chance.choice((0.0, 5.0, 180.0))
        world.sensors.head_near_distance = chance.choice((5.0, 50.0))
        world.motion.running = chance.choice((kelpie.NO_MOTION, kelpie.BLOCK))
        if chance.random() < 0.02:
            self.move_ball()
        world.percepts.ball.present = chance.random() < 0.005
        world.opponents = [kelpie.OpponentEstimate(position=kelpie.Point2(
            x=chance.uniform(0.0, 360.0), y=chance.uniform(0.0, 540.0)))] * chance.randrange(3)
        return world

    def move_ball(self):
        ball, chance = self.world.ball, self.chance
        ball.present = chance.random() < 0.5
        x, y = chance.choice(((0.0, 0.0), (chance.uniform(-300, 300), chance.uniform(-300, 300))))
        ball.relative.x, ball.relative.y = x, y
        ball.distance, ball.heading_deg = math.hypot(x, y), math.degrees(math.atan2(-x, y))
        ball.covariance = [chance.choice((0.0, 1.0, 1e6)) for _ in range(4)]
        ball.seconds_since_seen = chance.uniform(0.0, 5.0)
        ball.velocity.x = chance.uniform(-300.0, 300.0)


def numbers(command):
    walk, head = command.walk, command.head
    return [walk.forward, walk.left, walk.turn_deg, head.neck_tilt_deg, head.head_pan_deg,
            head.head_nod_deg, head.speed_deg, head.direction_deg, head.elevation_deg,
            head.target.x, head.target.y, head.target.z]


@pytest.mark.parametrize('search', [kelpie.SEARCH_BY_CHAIN, kelpie.SEARCH_BY_SPIN])
def test_no_odd_world_makes_it_raise_or_ask_for_what_is_not_finite(search):
    odd, memory, steps = OddWorld(search), Memory(), {}
    odd.world.task.search = search
    skill, longest, run, last = FindBall(odd.world, memory), 0, 0, None
    for _ in range(20000):
        world = odd.next()
        memory.update(world)
        chance = odd.chance
        if chance.random() < 0.01:
            memory.set_hint(chance.uniform(0.0, 60.0), chance.uniform(-180.0, 180.0))
        if chance.random() < 0.01:
            skill.force(chance.choice((None, 50.0)), memory.frame + chance.randrange(40))
        command = skill.step(world)
        assert all(math.isfinite(number) for number in numbers(command))
        assert abs(command.walk.forward) <= 50.0 and abs(command.walk.turn_deg) <= 130.0
        step = skill.state.__name__
        steps[step] = steps.get(step, 0) + 1
        run = run + 1 if step == last else 0
        longest, last = max(longest, run), step
    if search == kelpie.SEARCH_BY_CHAIN:
        assert len(steps) == 9 and longest < 1000
    else:
        assert set(steps) == {'spin'}
