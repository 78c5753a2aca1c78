# SPDX-License-Identifier: Apache-2.0
import math

import pytest
import kelpie
from lib import geom


@pytest.mark.parametrize('degrees, expected', [(180, 180), (-180, 180), (181, -179), (720, 0),
                                               (-190, 170), (540, 180)])
def test_wrap_gives_the_same_direction_in_one_turn(degrees, expected):
    assert geom.wrap(degrees) == pytest.approx(expected)


def test_left_is_positive():
    assert geom.heading(-10, 10) == pytest.approx(45)
    assert geom.heading(0, 5) == 0.0


def test_polar_is_the_inverse_of_heading():
    x, y = geom.polar(50, 37)
    assert geom.heading(x, y) == pytest.approx(37)
    assert math.hypot(x, y) == pytest.approx(50)


def test_walking_forward_brings_a_point_nearer():
    assert geom.moved(3, 40, kelpie.Odometry(forward=10)) == pytest.approx((3, 30))


def test_stepping_left_moves_a_point_to_the_right():
    assert geom.moved(3, 40, kelpie.Odometry(left=2)) == pytest.approx((5, 40))


def test_turning_left_moves_a_point_ahead_to_the_right():
    x, y = geom.moved(0, 10, kelpie.Odometry(turn_deg=90))
    assert (x, y) == pytest.approx((10, 0))


def test_many_small_steps_equal_the_pose_they_lead_to():
    # A circle of radius 30 to the left, a quarter of it: the robot ends at (30, 30), facing -x.
    x, y = 100.0, 50.0  # field point; start at the origin facing +x
    point = (-y, x)     # in the robot frame
    for _ in range(900):
        point = geom.moved(*point, kelpie.Odometry(forward=30 * math.radians(0.1), turn_deg=0.1))
    pose = kelpie.Pose2(position=kelpie.Point2(x=30.0, y=30.0), heading_deg=90.0)
    assert point == pytest.approx(geom.from_field(pose, x, y), abs=1e-3)


def test_opponent_goal_is_ahead_of_a_robot_facing_up_field():
    pose = kelpie.Pose2(position=kelpie.Point2(x=180.0, y=300.0), heading_deg=90.0)
    assert geom.from_field(pose, 180, 540) == pytest.approx((0, 240))
    assert geom.from_field(pose, 190, 540) == pytest.approx((10, 240))
