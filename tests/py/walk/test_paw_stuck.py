# SPDX-License-Identifier: Apache-2.0
import math
import random

import kelpie
import pytest
from skills.walk.paw_stuck import BACK_S, DEAF_S, FELT_S, HELD_DEAF_S, PUSHES_ON_S, PawStuck

FRAME_S = 1.0 / 30.0


def world_with(left, right, time_s=0.0):
    world = kelpie.WorldFrame(time_s=time_s)
    world.motion.feeling.paw_blocked = [left, right]
    return world


@pytest.mark.parametrize('left, right, backs, goes', [
    (True, True, True, 0.0), (True, False, True, -1.0), (False, True, True, 1.0),
    (False, False, False, 0.0)])
def test_three_cases_of_paws(left, right, backs, goes):
    skill, world = PawStuck(), world_with(left, right)
    assert skill.needed(world) is backs
    walk = skill.step(world).walk
    assert (walk.forward < 0.0) is backs and (walk.left > 0) - (walk.left < 0) == goes
    assert walk.turn_deg == 0.0


def test_who_backs_off_looks_ahead_and_a_little_down():
    skill, world = PawStuck(), world_with(True, True)
    assert skill.needed(world)
    head = skill.step(world).head
    assert head.aim == kelpie.AIM_DIRECTION and head.direction_deg == 0.0
    assert -20.0 < head.elevation_deg < 0.0


def test_it_backs_for_a_certain_time_after_the_paw_is_free():
    skill = PawStuck()
    assert skill.needed(world_with(True, False))
    assert skill.needed(world_with(False, False, BACK_S - 0.01))
    assert skill.step(world_with(False, False, BACK_S - 0.01)).walk.left < 0.0
    assert not skill.needed(world_with(False, False, BACK_S + 0.01))


def test_asking_twice_in_a_frame_is_asking_once():
    once, twice = PawStuck(), PawStuck()
    for frame in range(60):
        world = world_with(frame == 3, False, frame * FRAME_S)
        assert twice.needed(world) is twice.needed(world) is once.needed(world)


def test_a_paw_at_the_ball_is_not_stuck():
    world = world_with(True, True)
    world.ball.present, world.ball.distance = True, 15.0
    assert not PawStuck().needed(world)
    world.ball.distance = 35.0
    assert PawStuck().needed(world)


@pytest.mark.parametrize('forward, backs', [(20.0, True), (0.0, False), (-20.0, False)])
def test_a_robot_that_is_held_while_it_walks_ahead_backs_straight(forward, backs):
    skill, world = PawStuck(), world_with(False, False)
    world.motion.feeling.stuck, world.last_command.walk.forward = True, forward
    assert skill.needed(world) is backs
    assert skill.step(world).walk.left == 0.0


def test_met_head_on_again_it_goes_to_the_right():
    skill = PawStuck()
    skill.needed(world_with(True, True))
    world = world_with(True, True, 2.0)
    assert skill.needed(world) and skill.step(world).walk.left < 0.0
    world = world_with(True, True, 10.0)
    assert skill.needed(world) and skill.step(world).walk.left == 0.0


def test_a_robot_that_backs_into_something_stops_that_and_heeds_no_paw_for_a_while():
    skill, felt_s = PawStuck(), FELT_S + 0.01
    skill.needed(world_with(True, False))
    held = world_with(True, False, felt_s)
    held.motion.feeling.stuck, held.last_command.walk.forward = True, -24.0
    assert not skill.needed(held)
    assert not skill.needed(world_with(True, True, felt_s + HELD_DEAF_S - 0.01))
    assert skill.needed(world_with(True, True, felt_s + HELD_DEAF_S + 0.01))


def test_what_held_it_from_ahead_is_still_felt_when_the_backing_begins():
    skill, held = PawStuck(), world_with(False, False)
    held.motion.feeling.stuck, held.last_command.walk.forward = True, 20.0
    assert skill.needed(held)
    held.time_s, held.last_command.walk.forward = FELT_S - 0.01, -24.0
    assert skill.needed(held)


def test_what_holds_it_from_ahead_does_not_end_the_backing():
    skill, held = PawStuck(), world_with(False, False)
    held.motion.feeling.stuck, held.last_command.walk.forward = True, 20.0
    assert skill.needed(held) and skill.needed(held)


def test_a_paw_that_stays_blocked_lets_it_play_between_two_times_of_backing():
    skill = PawStuck()
    backs = [skill.needed(world_with(True, False, frame * FRAME_S)) for frame in range(300)]
    assert backs[0] and backs.count(False) >= 6 * DEAF_S / FRAME_S


class Walker:
    """A robot as a disc of 14 cm that walks to its place and feels what is ahead of its paws."""

    def __init__(self, at, place):
        self.at, self.place, self.stuck = at, place, PawStuck()

    def step(self, other, time_s, avoid=True):
        ahead = (self.place - self.at) / (abs(self.place - self.at) or 1.0)
        met = (other.at - self.at) / ahead
        touched = 0.0 < met.real < 34.0 and abs(met.imag) < 22.0
        world = world_with(touched and met.imag > -8.0, touched and met.imag < 8.0, time_s)
        walk = kelpie.WalkRequest(forward=min(30.0, 3.0 * abs(self.place - self.at)))
        if avoid and self.stuck.needed(world):
            walk = self.stuck.step(world).walk
        self.at += FRAME_S * complex(walk.forward, walk.left) * ahead
        between = self.at - other.at
        if abs(between) < 28.0:  # they slide along each other
            self.at = other.at + 28.0 * between / abs(between)

    @property
    def arrived(self):
        return abs(self.place - self.at) < 7.0


def both_arrive(lateral, avoid=True) -> bool:
    one, two = Walker(0j, 200 + 0j), Walker(200 + lateral * 1j, lateral * 1j)
    for frame in range(round(45.0 / FRAME_S)):
        one.step(two, frame * FRAME_S, avoid)
        two.step(one, frame * FRAME_S, avoid)
        if one.arrived and two.arrived:
            return True
    return False


@pytest.mark.parametrize('lateral', range(-25, 26, 5))
def test_two_robots_that_walk_head_on_reach_their_places_in_the_ready_time(lateral):
    assert both_arrive(float(lateral))


def test_without_backing_off_they_do_not():
    assert not both_arrive(0.0, avoid=False)


def test_random_paws_never_stop_it_for_good():
    chance, skill, backs = random.Random(3), PawStuck(), 0
    for frame in range(20000):
        pressed = chance.random() < 0.01, chance.random() < 0.01
        world = world_with(*pressed, frame * FRAME_S)
        if skill.needed(world):
            backs += 1
            walk = skill.step(world).walk
            assert walk.forward < 0.0 and math.isfinite(walk.left)
    assert 0 < backs < 20000
    assert not skill.needed(world_with(False, False, 1e6))


def runner(time_s, stuck, run=True):
    world = kelpie.WorldFrame(time_s=time_s)
    world.task.run, world.motion.feeling.stuck = run, stuck
    world.motion.feeling.paw_blocked = [stuck, stuck]
    return world


def test_who_runs_with_the_ball_pushes_on_for_a_while_at_what_holds_it():
    skill = PawStuck(pushes_on=True)
    backs = []
    for frame in range(60):
        world = runner(frame * FRAME_S, True)
        skill.update(world)
        backs.append(skill.needed(world))
    assert backs.index(True) == pytest.approx(PUSHES_ON_S / FRAME_S, abs=2)


def test_without_running_it_backs_off_at_once():
    skill, world = PawStuck(pushes_on=True), runner(0.0, True, run=False)
    skill.update(world)
    assert skill.needed(world)


def test_a_ball_pushed_ahead_that_comes_no_nearer_holds_nobody():
    skill = PawStuck(pushes_on=True)
    for frame in range(120):
        world = runner(frame * FRAME_S, False)
        world.ball.present, world.ball.distance = True, 25.0
        world.ball.seconds_since_seen, world.last_command.walk.forward = 0.0, 40.0
        skill.update(world)
        assert not skill.needed(world)
