# SPDX-License-Identifier: Apache-2.0
import math

import kelpie
import pytest
from goalie_world import GoalieWorld, run, world_at
from lib import kick_table
from lib.goalie_places import past_ball, to_field
from safety import own_box
from situation.kick_stand import Stand, choose
from skills.ball.attack_ball import AttackBall
from skills.walk.guard_goal import OF_2004, OF_2006, GuardGoal, walk_towards


def still(walk):
    return walk.forward == walk.left == walk.turn_deg == 0.0


# Guarding

@pytest.mark.parametrize('tune', [OF_2006, OF_2004])
def test_moving_begins_beyond_the_laziness_and_ends_within_the_accuracy(tune):
    guard = GuardGoal(tune)
    for off, moves in [(tune.lazy - 0.1, False), (tune.lazy + 0.1, True),
                       (tune.accurate + 0.1, True), (tune.accurate - 0.1, False),
                       (tune.lazy - 0.1, False)]:
        assert still(guard.step(world_at(), (180.0 + off, 20.0, 90.0))) != moves


@pytest.mark.parametrize('tune', [OF_2006, OF_2004])
def test_so_does_turning(tune):
    guard = GuardGoal(tune)
    for off, turns in [(tune.lazy_turn - 0.1, False), (tune.lazy_turn + 0.1, True),
                       (tune.accurate_turn + 0.1, True), (tune.accurate_turn - 0.1, False)]:
        walk = guard.step(world_at(), (180.0, 20.0, 90.0 + off))
        assert (walk.turn_deg > 0.0) == turns and walk.left == 0.0


@pytest.mark.parametrize('heading', [90.0, 20.0, 200.0])
def test_way_to_a_place_is_straight_whatever_the_heading(heading):
    world = world_at(180.0, 20.0, heading)
    walk = walk_towards(world, (200.0, 30.0, 90.0))
    angle = math.radians(heading)
    x = walk.forward * math.cos(angle) - walk.left * math.sin(angle)
    y = walk.forward * math.sin(angle) + walk.left * math.cos(angle)
    assert x > 0 and y / x == pytest.approx(0.5)


# Attacking

def test_from_its_stand_the_ball_lies_where_the_kick_needs_it():
    for kick in kick_table.kicks(False):
        stand = Stand((170.0, 50.0), kick, 120.0)
        angle = math.radians(120.0)
        dx, dy = 170.0 - stand.x, 50.0 - stand.y
        right, ahead = kick_table.best_place(kick)
        assert dx * math.cos(angle) + dy * math.sin(angle) == pytest.approx(ahead)
        assert dx * math.sin(angle) - dy * math.cos(angle) == pytest.approx(right)
        assert stand.direction == 120.0 + kick_table.outcome(kick, right, ahead)[1]


def test_a_ball_far_from_the_box_has_no_stand():
    world = world_at()
    world.ball.position = kelpie.Point2(x=180.0, y=95.0)
    assert choose(world).stand is None
    world.ball.position = kelpie.Point2(x=180.0, y=66.0)
    assert choose(world).stand is not None


def test_stand_is_on_the_own_side_of_the_ball():
    for x in range(125, 240, 10):
        for y in range(30, 65, 5):
            world = world_at()
            world.ball.position = kelpie.Point2(x=float(x), y=float(y))
            stand = choose(world).stand
            assert not past_ball((180.0, 20.0), (stand.x, stand.y), (x, y))


def test_a_direction_in_which_an_opponent_stands_is_avoided():
    world = world_at()
    world.ball.position = kelpie.Point2(x=180.0, y=60.0)
    stand = choose(world).stand
    towards = math.radians(stand.direction)
    world.opponents = [kelpie.OpponentEstimate(position=kelpie.Point2(
        x=180.0 + 30 * math.cos(towards), y=60.0 + 30 * math.sin(towards)))]
    assert abs(choose(world).stand.direction - stand.direction) > 25


class WalkToKick:
    def __init__(self):
        self.attack, self.choice = AttackBall(), None

    def step(self, world):
        self.choice = choose(world, self.choice)
        if self.choice.stand is None:
            return kelpie.Command()
        return kelpie.Command(walk=self.attack.step(world, self.choice.stand))


def test_an_attack_comes_to_where_its_kick_needs_the_ball():
    for ball in (165 + 55j, 180 + 62j, 215 + 50j, 135 + 40j):
        scene, walk = GoalieWorld(), WalkToKick()
        scene.ball = ball
        run(scene, walk.step, 5.0)
        left, ahead = scene.in_robot(scene.ball)
        assert ahead == pytest.approx(walk.attack.stand.far, abs=2.0)
        assert -left == pytest.approx(walk.attack.stand.right, abs=2.0)


def test_the_way_back_into_the_box_is_not_faster_than_the_walk():
    world = world_at(x=20.0, y=-60.0, heading=70.0)
    walk = own_box.inside(world, kelpie.WalkRequest(forward=10.0))
    x, y = to_field(70.0, walk.forward, walk.left)
    assert math.hypot(x, y) == pytest.approx(own_box.SPEED) and x > 0 and y > 0
