# SPDX-License-Identifier: Apache-2.0
import cmath
import math
import random

import kelpie
import pytest
from goalie_world import BRAKE, DRAG, scene, speed_to_go
from lib import goalie_places as places, kick_table
from situation import clearance as clearance_module, shot_watch
from situation.clearance import (STRIKE, Clearance, clearance, clearing_kick, predicted, side_of,
                                 strikes, walks)
from situation.memory import Memory
from situation.shot_watch import ShotWatch, block_for


# Block choice (checklist A-4.3.1.4)

def seeing(run=shot_watch.SEEN_FRAMES, lost=0):
    memory = Memory()
    memory.ball_run, memory.ball_lost = run, lost
    return memory


def watched(ball, velocity, field=None, memory=None, frames=shot_watch.FRAMES, unseen=0.0):
    """The watch when a ball comes by there, after so many frames in which it rolled (and one more,
    to roll from)."""
    watch = ShotWatch(memory or seeing())
    for before in range(frames, -1, -1):
        world = scene(ball - velocity * before / 30.0, velocity).world
        world.field = field or world.field
        world.ball.seconds_since_seen = unseen
        watch.update(world)
    return watch


@pytest.mark.parametrize('lateral, motion', [
    (0, kelpie.BLOCK), (8.9, kelpie.BLOCK), (-8.9, kelpie.BLOCK), (9.1, kelpie.BLOCK_RIGHT),
    (-9.1, kelpie.BLOCK_LEFT), (30, kelpie.BLOCK_RIGHT), (-30, kelpie.BLOCK_LEFT),
    (60, kelpie.NO_MOTION), (-60, kelpie.NO_MOTION)])
def test_block_is_on_the_side_where_the_ball_passes(lateral, motion):
    wide = kelpie.FieldDescription(goal_width=300.0)  # whatever comes is at the goal
    way = complex(lateral, -60)
    watch = watched(180 + 80j, 170 * way / abs(way), wide)
    assert watch.shot.lateral == pytest.approx(lateral, abs=1e-6)
    assert watch.block() == motion


def way_in(speed, seconds):
    """cm that a ball of that speed rolls, by small steps."""
    way = 0.0
    for _ in range(int(seconds * 1000)):
        way, speed = way + speed * 1e-3, max(0.0, speed - (DRAG * speed + BRAKE) * 1e-3)
    return way


@pytest.mark.parametrize('speed', range(5, 200, 5))
def test_of_balls_straight_ahead_only_the_fastest_are_blocked(speed):
    """40 cm ahead of the goalie; the slower ones its legs stop as it stands."""
    watch = watched(180 + 60j, -1j * speed)
    assert (watch.block() == kelpie.BLOCK) == (speed >= shot_watch.STAND_SPEED)


@pytest.mark.parametrize('speed', range(5, 200, 5))
def test_of_lateral_balls_the_fast_are_blocked_and_the_slow_walked_to(speed):
    """20 cm to the side: a ball that takes 1 s leaves the time for two steps."""
    watch = watched(200 + 60j, -1j * speed)
    comes = speed_to_go(60.0 - shot_watch.SHORT) < speed < shot_watch.FASTEST
    in_time = way_in(speed, shot_watch.LATEST) > 40.0
    assert (watch.block() == kelpie.BLOCK_RIGHT) == (comes and in_time)


@pytest.mark.parametrize('ball, velocity', [
    (180 + 90j, 130j), (180 + 90j, 130 + 0j), (100 + 60j, 30 - 130j), (180 + 90j, 90 - 100j)])
def test_a_ball_that_misses_the_goal_is_not_blocked(ball, velocity):
    assert watched(ball, velocity, frames=5).block() == kelpie.NO_MOTION


def test_a_shot_is_blocked_from_the_second_frame_on():
    assert watched(180 + 90j, -170j, frames=1).block() == kelpie.NO_MOTION
    assert watched(180 + 90j, -170j, frames=2).block() == kelpie.BLOCK


def test_a_velocity_without_a_way_makes_no_block():
    """One bad sighting, and the ball lies where it lay."""
    watch = ShotWatch(seeing())
    for y in (110, 90, 90, 90):
        watch.update(scene(180 + 1j * y, -170j).world)
        assert watch.block() == kelpie.NO_MOTION


def test_an_unseen_ball_is_not_blocked():
    assert watched(180 + 90j, -170j, unseen=shot_watch.SEEN).block() == kelpie.NO_MOTION


def test_a_ball_just_found_is_not_blocked_but_a_single_frame_may_miss_it():
    """Found elsewhere, it seems to have come from where it was believed."""
    memory = seeing()
    watch, ball = ShotWatch(memory), 180 + 120j
    for run, lost, believed in [(shot_watch.SEEN_FRAMES - 2, 0, 0),
                                (shot_watch.SEEN_FRAMES - 1, 0, 0),
                                (shot_watch.SEEN_FRAMES, 0, 1), (0, 1, 2), (1, 0, 3), (0, 1, 4),
                                (0, 2, 0), (1, 0, 0)]:
        memory.ball_run, memory.ball_lost = run, lost
        ball -= 170j / 30.0
        watch.update(scene(ball, -170j).world)
        assert watch.frames == believed


def test_no_kick_is_so_fast():
    watch = watched(180 + 90j, -1j * (shot_watch.FASTEST + 1.0), frames=5)
    assert watch.block() == kelpie.NO_MOTION


@pytest.mark.parametrize('seconds, blocked', [(0.05, False), (0.1, True), (0.8, True), (1, False)])
def test_block_neither_too_late_nor_too_early(seconds, blocked):
    shot = type('Shot', (), dict(lateral=25.0, seconds=seconds, speed=100.0))
    assert (block_for(shot) != kelpie.NO_MOTION) == blocked


# Clearing (A-4.3.1.5)

def test_a_clear_never_goes_towards_the_own_goal():
    chance, kicks = random.Random(5), 0
    for _ in range(5000):
        at = complex(chance.uniform(115, 245), chance.uniform(0, 65))
        heading = math.radians(chance.uniform(-180, 180))
        facing = complex(math.cos(heading), math.sin(heading))
        ball = at + complex(chance.uniform(10, 17), chance.uniform(-9, 9)) * facing
        world = scene(ball, at=at, facing=facing).world
        best = clearing_kick(world)
        if best is None:
            continue
        kicks += 1
        (x, y), _ = predicted(world, 0.1)
        lateral, sd = kick_table.outcome(best.kick, x, y)[1:3]
        for off in (-3.0 * sd, 0.0, 3.0 * sd):
            direction = math.degrees(heading) + lateral + off
            assert places.off_own_goal(world.field, (ball.real, ball.imag), direction) > 0
    assert kicks > 1500


@pytest.mark.parametrize('right, ahead, kicks', [
    (0.0, 14.0, True), (5.0, 13.0, True), (-5.0, 13.0, True), (8.0, 12.0, True),
    (14.0, 12.0, False), (0.0, 23.0, False), (0.0, 7.0, False)])
def test_a_ball_before_the_goalie_is_kicked_where_a_kick_reaches_it(right, ahead, kicks):
    best = clearing_kick(scene(complex(180 + right, 30 + ahead), at=180 + 30j).world)
    assert (best is not None) == kicks
    if kicks:
        assert best.off_goal > 70 and abs(best.direction - 90) < 90


@pytest.mark.parametrize('heading, sides', [
    (90, {-1.0, 1.0}), (40, {1.0}), (140, {-1.0})])
def test_no_kick_to_a_side_whose_ball_an_opponent_could_turn_into_the_goal(heading, sides):
    """Held against, the ball goes 106 deg off."""
    world = scene(180 + 30j).world
    world.pose.heading_deg = heading
    found = set()
    for kick in kick_table.kicks(False):
        outcome = kick_table.window_outcome(kick)
        if side_of(kick) != 0.0 and Clearance(world, kick, (180.0, 30.0), outcome, heading).safe:
            found.add(side_of(kick))
    assert found == sides


def test_a_ball_between_goalie_and_goal_is_not_kicked():
    for right in (-4, 0, 4):
        world = scene(complex(180 - right, 16), at=180 + 30j, facing=-1j).world
        best = clearing_kick(world)
        assert best is None or abs(best.direction + 90) > 70


def test_a_clear_passes_an_opponent_ahead():
    world = scene(180 + 44j, at=180 + 30j).world
    free = clearing_kick(world)
    world.opponents = [kelpie.OpponentEstimate(position=kelpie.Point2(
        x=180 + 25 * math.cos(math.radians(free.direction)),
        y=44 + 25 * math.sin(math.radians(free.direction))))]
    other = clearing_kick(world)
    assert other is None or abs(other.direction - free.direction) > 25


def test_a_lying_ball_is_kicked_where_a_walking_goalie_has_it_at_the_motions_beginning():
    world = scene(180 + 58j, at=180 + 30j).world
    world.elapsed_s = 1.0 / 30.0
    assert predicted(world, 0.1)[0] == pytest.approx((0.0, 28.0))
    world.odometry.forward, world.odometry.left = 1.0, 0.5
    assert predicted(world, 0.1)[0] == pytest.approx((1.5, 25.0))


def test_a_rolling_ball_is_kicked_where_the_strike_meets_it():
    """0.3 s after it is asked for at 18 cm/s, slowed down by 0.76 /s and 6 cm/s2: 4.6 cm on."""
    world = scene(180 + 46j, at=180 + 30j).world
    world.ball.velocity.y = -18.0
    place, ball = predicted(world, 0.1)
    assert place == pytest.approx((0.0, 16.0 - 4.6), abs=0.05)
    assert ball == pytest.approx((180.0, 46.0 - 4.6), abs=0.05)


@pytest.mark.parametrize('strike, kicked', [(0.0, True), (STRIKE, False)])
def test_no_kick_at_a_ball_that_rolls_in_under_it(monkeypatch, strike, kicked):
    """An own goal (seed 149007, 53 s), of a kick that took the ball as at the motion's beginning:
    the paw grazed it beside the leg."""
    monkeypatch.setattr(clearance_module, 'STRIKE', strike)
    world = scene(184.4 + 36.6j, at=177.1 + 24.2j,
                  facing=cmath.rect(1.0, math.radians(85.0))).world
    world.ball.velocity.x, world.ball.velocity.y = 8.4, -17.5
    world.odometry.forward, world.odometry.left = -0.1, -0.7
    world.elapsed_s = 1.0 / 30.0
    assert (clearing_kick(world) is not None) == kicked


def test_a_kick_from_a_walk_is_read_from_the_map_of_walking_robots():
    world = scene(187 + 41.5j, at=180 + 30j).world
    world.elapsed_s = 1.0 / 30.0
    assert not walks(world)
    standing = clearance(world, kelpie.UPENN_LEFT, strikes(world))
    world.odometry.left = 4.0 / 30.0
    assert walks(world)
    walking = clearance(world, kelpie.UPENN_LEFT, strikes(world))
    assert standing.direction != walking.direction
