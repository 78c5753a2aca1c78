# SPDX-License-Identifier: Apache-2.0
import cmath
import math
import random

import kelpie
import pytest
from roles.attacker import BOX_WAIT_FRAMES, Attacker
from situation.memory import Memory
from skills.walk.avoid_own_box import (EDGE, LATERAL, AvoidOwnBox, clear_of, in_own_box,
                                       place_to_stand, triggered)

FIELD = kelpie.FIELDS['2006']
FRAME_S = 1.0 / 30.0
NOSE, TAIL = 18.0, 20.0  # cm of the body ahead of the neck and behind it


@pytest.mark.parametrize('in_box', [False, True])
@pytest.mark.parametrize('grabbed', [False, True])
@pytest.mark.parametrize('started', [False, True])
def test_truth_table_of_the_trigger(in_box, grabbed, started):
    only = (True, False, False)
    assert triggered(in_box, grabbed, started) is ((in_box, grabbed, started) == only)


@pytest.mark.parametrize('x, y, inside', [
    (180.0, 64.9, True), (180.0, 65.1, False), (115.1, 30.0, True), (114.9, 30.0, False),
    (245.1, 30.0, False), (180.0, -20.0, True), (180.0, 520.0, False)])
def test_only_the_own_box_counts(x, y, inside):
    assert in_own_box(FIELD, x, y) is inside


def test_an_unseen_ball_is_in_no_box():
    world = kelpie.WorldFrame(field=FIELD)
    world.ball.position.x, world.ball.position.y = 180.0, 30.0
    assert not AvoidOwnBox.needed(world, False)
    world.ball.present = True
    assert AvoidOwnBox.needed(world, False) and not AvoidOwnBox.needed(world, True)


@pytest.mark.parametrize('robot, ball, branch', [
    ((180.0, 161.0), (180.0, 60.0), 'far'), ((180.0, 159.0), (180.0, 60.0), 'aside'),
    ((60.0, 40.0), (140.0, 40.0), 'corner'), ((300.0, 40.0), (220.0, 40.0), 'corner'),
    ((60.0, 40.0), (170.0, 40.0), 'far'), ((100.0, 95.0), (150.0, 50.0), 'aside')])
def test_branches_of_algorithm_43(robot, ball, branch):
    assert place_to_stand(FIELD, robot, ball)[0] == branch


def test_beside_the_box_the_nearest_front_corner_is_walked_to():
    left, right, top = clear_of(FIELD)
    assert place_to_stand(FIELD, (60.0, 40.0), (130.0, 40.0))[1] == (left, top)
    assert place_to_stand(FIELD, (300.0, 40.0), (230.0, 40.0))[1] == (right, top)


@pytest.mark.parametrize('robot_x, ball_x, x', [
    (190.0, 180.0, 180.0 + LATERAL),
    (170.0, 180.0, 180.0 - LATERAL),
    (230.0, 240.0, 240.0 - LATERAL)])
def test_before_the_box_it_walks_to_its_own_side_of_the_ball(robot_x, ball_x, x):
    place = place_to_stand(FIELD, (robot_x, 100.0), (ball_x, 50.0))[1]
    assert place[0] == x and place[1] > FIELD.box_depth


class Scene:
    """A robot that does what it is asked, with a ball that the goalie pushes about in the box."""

    def __init__(self, chance, noise=0.0, ball_moves=0.03):
        self.chance, self.noise, self.ball_moves = chance, noise, ball_moves
        self.at = self.outside()
        self.facing = cmath.rect(1.0, chance.uniform(-math.pi, math.pi))
        self.ball = complex(chance.uniform(116, 244), chance.uniform(1, 64))
        self.skill = AvoidOwnBox()

    def outside(self):
        while True:
            at = complex(self.chance.uniform(15, 345), self.chance.uniform(15, 200))
            if not in_own_box(FIELD, at.real, at.imag):
                return at

    def step(self):
        world = kelpie.WorldFrame(field=FIELD)
        wrong = complex(self.chance.gauss(0, self.noise), self.chance.gauss(0, self.noise))
        pose = self.at + wrong
        world.pose.position.x, world.pose.position.y = pose.real, pose.imag
        world.pose.heading_deg = math.degrees(cmath.phase(self.facing))
        ball, away = world.ball, (self.ball - self.at) / self.facing
        ball.present, ball.distance = True, abs(away)
        ball.relative.x, ball.relative.y = -away.imag, away.real
        ball.position.x, ball.position.y = self.ball.real, self.ball.imag
        walk = self.skill.step(world).walk
        self.at += FRAME_S * complex(walk.forward, walk.left) * self.facing
        self.facing *= cmath.rect(1.0, FRAME_S * math.radians(walk.turn_deg))
        if self.chance.random() < self.ball_moves:
            self.ball = complex(self.chance.uniform(116, 244), self.chance.uniform(1, 64))

    def entered(self, ahead=0.0) -> bool:
        point = self.at + ahead * self.facing
        return in_own_box(FIELD, point.real, point.imag)

    def free(self) -> bool:
        left, right, top = clear_of(FIELD)
        return self.at.imag >= top or not left < self.at.real < right


def test_it_never_enters_the_box_in_1000_random_scenes():
    for seed in range(1000):
        scene = Scene(random.Random(seed))
        began_free = scene.free()
        for _ in range(120):
            scene.step()
            assert not scene.entered(), seed
            # Who began in the margin may have its nose over the line already.
            assert not began_free or not (scene.entered(NOSE) or scene.entered(-TAIL)), seed


def test_it_never_enters_the_box_with_a_pose_off_by_5_cm():
    for seed in range(200):
        scene = Scene(random.Random(seed), noise=5.0)
        for _ in range(120):
            scene.step()
            assert not scene.entered(), seed


def test_whoever_is_inside_leaves_by_the_shortest_way():
    scene = Scene(random.Random(1))
    for start in (130 + 20j, 230 + 20j, 180 + 55j):
        scene.at = start
        for _ in range(120):
            scene.step()
        assert not scene.entered(NOSE) and not scene.entered(-TAIL)


def test_the_goalies_way_is_free_in_the_end():
    for seed in range(50):
        scene = Scene(random.Random(seed), ball_moves=0.0)
        scene.ball = complex(scene.ball.real, 50.0)
        scene.at = complex(scene.ball.real + (seed - 25), 110.0)
        for _ in range(200):
            scene.step()
        assert abs(scene.at.real - scene.ball.real) > 40.0
        assert EDGE - 1.0 <= scene.at.real <= FIELD.width - EDGE + 1.0


def test_far_from_the_ball_it_stands_and_says_so():
    world = kelpie.WorldFrame(field=FIELD)
    world.pose.position.x, world.pose.position.y, world.pose.heading_deg = 180.0, 250.0, -90.0
    world.ball.present, world.ball.distance = True, 200.0
    world.ball.position.x, world.ball.position.y, world.ball.relative.y = 180.0, 50.0, 200.0
    skill, trace = AvoidOwnBox(), []
    walk = skill.step(world).walk
    assert (walk.forward, walk.left) == (0.0, 0.0)
    skill.explain(trace)
    assert trace == [(kelpie.LAYER_SKILL, 'avoid_own_box', 'far',
                      'the ball in the own box is {} cm away: wait', 200.0)]


def test_the_wait_for_a_goalie_may_end_in_the_frame_in_which_the_box_is_met():
    memory = Memory()
    memory.ball_lost = 0
    attacker = Attacker(memory)
    world = kelpie.WorldFrame(field=FIELD)
    world.pose.position.x, world.pose.position.y, world.pose.heading_deg = 180.0, 250.0, -90.0
    world.ball.present, world.ball.distance = True, 200.0
    world.ball.position.x, world.ball.position.y, world.ball.relative.y = 180.0, 50.0, 200.0
    world.ball.seconds_since_seen = 0.0
    attacker.box_frames = BOX_WAIT_FRAMES
    attacker.step(world)
    assert attacker.state == attacker.avoid_box
    attacker.step(world)
    assert attacker.state != attacker.avoid_box
