# SPDX-License-Identifier: Apache-2.0
import itertools
import math
import random

import kelpie
import pytest
from goalie_world import GoalieWorld, anywhere, run, scene, shot
from lib import goalie_places as places
from players.ellipse_goalie import UNSEEN_NEAR, EllipseGoalie, attack_due, attack_failed
from skills.ball.paw_kick import Paw, PawKick
from test_goalie import scramble


@pytest.mark.parametrize('in_box, near', itertools.product([False, True], repeat=2))
def test_attack_begins_for_a_ball_of_gps_in_the_box_or_a_seen_one_at_the_nose(in_box, near):
    world = scene(180 + (64j if in_box else 66j)).world
    world.percepts.ball.distance = Paw.VISUAL + (-0.1 if near else 0.1)
    assert attack_due(world) == (in_box or near)
    world.percepts.ball.present = False
    assert attack_due(world) == in_box


@pytest.mark.parametrize('ball, heading, failed', [
    (180 + 79.9j, 0.0, False), (180 + 80.1j, 0.0, True), (259.9 + 40j, 0.0, False),
    (260.1 + 40j, 0.0, True), (180 + 60j, 39.9, False), (180 + 60j, 40.1, True),
    (180 + 60j, -39.9, False), (180 + 60j, -40.1, True)])
def test_attack_ends_15_cm_beyond_the_box_or_40_deg_off(ball, heading, failed):
    world = scene(ball).world
    world.percepts.ball.heading_deg = heading
    assert (attack_failed(world) is not None) == failed


@pytest.mark.parametrize('side', [1.0, -1.0])
def test_the_front_leg_that_is_nearer_at_first_meets_the_ball_to_the_end(side):
    world, skill = scene(180 + 60j).world, PawKick()
    world.ball.relative.x, world.ball.relative.y = 5.0 * side, 20.0
    assert skill.step(world).turn_deg == 0.0
    world.ball.relative.x = -2.0 * side
    assert skill.step(world).turn_deg * side > 0.0


def test_attack_ends_when_the_ball_is_unseen_for_long():
    world = scene(180 + 60j).world
    world.percepts.ball.present = False
    world.ball.seconds_since_seen = UNSEEN_NEAR - 0.1
    assert attack_failed(world) is None
    world.ball.seconds_since_seen = UNSEEN_NEAR + 0.1
    assert attack_failed(world) is not None


def test_goalie_takes_its_place_on_the_ellipse_and_stays():
    world, player = GoalieWorld(), EllipseGoalie()
    world.ball = 260 + 150j
    run(world, player.step, 4.0)
    x, y, heading = places.ellipse_place(world.field, (260, 150))
    assert abs(world.at - complex(x, y)) < 15.0
    stood = world.at
    run(world, player.step, 2.0)
    assert abs(world.at - stood) < 0.5 and player.skill.moving is False


def test_goalie_waits_in_the_middle_for_a_ball_unseen_for_long():
    world = scene(260 + 150j).world
    world.ball.seconds_since_seen = 10.0
    assert EllipseGoalie().place(world) == places.central_place(world.field)


def test_goalie_of_2004_never_leaves_its_box_either():
    chance = random.Random(18)
    for seed in range(300):
        world = anywhere(seed, chance)
        player = EllipseGoalie(paw=seed % 2 == 1)
        run(world, player.step, 2.0)
        assert world.outside == 0


def test_goalie_does_not_back_into_the_wall_beside_the_goal():
    world, player = scene(180 + 200j), EllipseGoalie()
    world.world.pose.position = kelpie.Point2(x=125.0, y=12.0)
    command = player.step(world.world)
    x, y = places.to_field(90.0, command.walk.forward, command.walk.left)
    assert x > 0 and y >= 0


def test_balls_in_the_box_are_cleared_without_own_goals():
    chance, cleared = random.Random(17), 0
    for seed in range(40):
        world, player = GoalieWorld(seed, noise=1.0), EllipseGoalie()
        world.ball = complex(chance.uniform(120, 240), chance.uniform(30, 63))
        run(world, player.step, 10.0)
        assert not world.conceded
        cleared += places.beyond_box(world.field, (world.ball.real, world.ball.imag)) > 15.0
    assert cleared >= 32


def test_hard_shots_go_in_more_often_than_with_the_goalie_of_2006():
    from players.goalie import Goalie
    old = sum(shot(EllipseGoalie().step, seed).conceded for seed in range(60))
    new = sum(shot(Goalie().step, seed).conceded for seed in range(60))
    assert new < old < 45


@pytest.mark.parametrize('paw', [False, True])
def test_random_worlds_never_stop_it(paw):
    chance, player, states = random.Random(19), EllipseGoalie(paw), set()
    world = GoalieWorld().world
    for _ in range(30000):    # a slow ball in a kick's place is seldom
        scramble(world, chance)
        world.percepts.ball.heading_deg = chance.uniform(-60, 60)
        command = player.step(world)
        assert math.isfinite(command.walk.forward + command.walk.left + command.walk.turn_deg)
        assert len(command.trace) <= 9
        states.add(player.state.__name__)
    assert states == ({'guard', 'attack'} if paw else {'guard', 'attack', 'clear'})
