# SPDX-License-Identifier: Apache-2.0
import math

import kelpie
import pytest
from lib import geom
from situation.pose_watch import (BACK_CM, BACK_DEG, BLIND, BLIND_SURE, LIKELY, LONGEST, SURE_CM,
                                  PoseWatch, moved, torn)


class Walk:
    """A robot on a circle: informed where it is, and once where it is not."""

    def __init__(self):
        self.world = kelpie.WorldFrame()
        self.world.odometry = kelpie.Odometry(forward=1.0, left=0.3, turn_deg=2.0)
        self.world.position_sd, self.world.heading_sd_deg = 2.0, 1.0
        self.pose = (180.0, 20.0, 90.0)
        self.watch = PoseWatch()

    def step(self, off=(0.0, 0.0, 0.0)):
        self.pose = moved(self.pose, self.world.odometry)
        self.world.time_s += 1.0 / 30.0
        x, y, heading = (a + b for a, b in zip(self.pose, off))
        self.world.pose = kelpie.Pose2(position=kelpie.Point2(x=x, y=y), heading_deg=heading)
        self.watch.update(self.world)
        return self.watch.doubtful


def test_a_walk_is_not_doubted():
    walk = Walk()
    assert not any(walk.step() for _ in range(200))


@pytest.mark.parametrize('off', [(50.0, 0.0, 0.0), (0.0, -40.0, 0.0), (0.0, 0.0, 60.0)])
def test_a_jump_is_doubted_until_it_is_taken_back(off):
    walk = Walk()
    walk.step()
    assert [walk.step(off) for _ in range(5)] == [True] * 5
    assert not walk.step() and not walk.watch.settled(walk.world)
    for _ in range(30):
        walk.step()
    assert walk.watch.settled(walk.world)


def test_a_jump_that_lasts_is_believed():
    walk = Walk()
    walk.step()
    doubts, gave_in = [], 0
    for _ in range(100):
        doubts.append(walk.step((100.0, 50.0, 0.0)))
        gave_in += walk.watch.gave_in
    assert gave_in == 1
    assert doubts == sorted(doubts, reverse=True)
    assert sum(doubts) == pytest.approx(30 * LONGEST, abs=2)


def test_small_corrections_are_not_doubted():
    walk = Walk()
    walk.step()
    assert not any(walk.step((15.0 * math.sin(i), 10.0, 10.0)) for i in range(60))


def test_many_small_turns_lead_round():
    pose = (0.0, 0.0, 0.0)
    for _ in range(360):
        pose = moved(pose, kelpie.Odometry(forward=math.radians(10.0), turn_deg=1.0))
    assert pose[:2] == pytest.approx((0.0, 0.0), abs=1e-9)


def test_a_jump_from_a_pose_that_was_not_sure_is_believed():
    walk = Walk()
    walk.world.position_sd = 15.0
    walk.step()
    assert not walk.step((100.0, 0.0, 0.0))


def test_world_of_the_carried_pose_has_the_ball_where_the_robot_sees_it():
    walk = Walk()
    for _ in range(3):
        walk.step()
    ball = walk.world.ball
    ball.position = kelpie.Point2(x=150.0, y=90.0)
    ball.velocity = kelpie.Point2(x=-30.0, y=-100.0)
    ball.stopping_point = kelpie.Point2(x=140.0, y=-20.0)
    assert walk.step((120.0, 80.0, 140.0))
    carried = walk.watch.believed(walk.world)
    assert (carried.pose.position.x, carried.pose.heading_deg) == pytest.approx(
        (walk.pose[0], walk.pose[2]))
    turned = geom.from_field(walk.world.pose, 150.0, 90.0)
    assert geom.from_field(carried.pose, carried.ball.position.x,
                           carried.ball.position.y) == pytest.approx(turned)
    assert carried.ball.distance == ball.distance and carried.field is walk.world.field
    speed = math.hypot(carried.ball.velocity.x, carried.ball.velocity.y)
    assert speed == pytest.approx(math.hypot(30.0, 100.0))
    end = geom.from_field(walk.world.pose, 140.0, -20.0)
    assert geom.from_field(carried.pose, carried.ball.stopping_point.x,
                           carried.ball.stopping_point.y) == pytest.approx(end)


@pytest.mark.parametrize('sd, seconds', [(2.0, BLIND_SURE), (SURE_CM, BLIND)])
def test_a_pose_without_a_landmark_is_lost_the_sooner_the_less_sure_it_is(sd, seconds):
    walk = Walk()
    walk.world.position_sd = sd
    walk.world.percepts.landmarks = [kelpie.LandmarkPercept()]
    for _ in range(90):
        walk.step()
    assert not walk.watch.lost(walk.world)
    walk.world.percepts.landmarks = []
    lost = []
    for _ in range(180):
        walk.step()
        lost.append(walk.watch.lost(walk.world))
    assert lost == sorted(lost) and sum(lost) == pytest.approx(180 - 30 * seconds, abs=1)


@pytest.mark.parametrize('weight, away, lateral, is_torn', [
    (LIKELY - 0.01, BACK_CM + 1, 0.0, True), (LIKELY - 0.01, 0.0, BACK_DEG + 1, True),
    (LIKELY + 0.01, 100.0, 90.0, False), (0.4, BACK_CM - 1, BACK_DEG - 1, False)])
def test_two_likely_modes_far_from_each_other_tear_the_pose(weight, away, lateral, is_torn):
    def mode(weight, x, heading):
        pose = kelpie.Pose2(position=kelpie.Point2(x=x, y=20.0), heading_deg=heading)
        return kelpie.PoseMode(weight=weight, pose=pose)
    world = kelpie.WorldFrame()
    world.modes = [mode(weight, 180.0, 170.0), mode(1.0 - weight, 180.0 + away, 170.0 + lateral)]
    assert torn(world) is is_torn


def test_one_mode_alone_is_not_torn():
    assert not torn(kelpie.WorldFrame())
