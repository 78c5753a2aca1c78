# SPDX-License-Identifier: Apache-2.0
"""Where a rolling ball is met (lib/intercept.py), against a ball that is rolled step by step."""
import math

import pytest
from lib import intercept
from situations import put_ball, world


def rolling(vx, vy, ball=(180.0, 260.0), **where):
    made = world(ball=ball, **where)
    speed = math.hypot(vx, vy)
    stop = intercept.rolled(speed, 60.0) / max(speed, 1e-9)
    made.ball.velocity.x, made.ball.velocity.y = vx, vy
    made.ball.stopping_point.x = ball[0] + stop * vx
    made.ball.stopping_point.y = ball[1] + stop * vy
    return made


@pytest.mark.parametrize('speed', [20.0, 50.0, 80.0, 150.0])
@pytest.mark.parametrize('seconds', [0.3, 1.0, 4.0])
def test_the_way_of_a_ball_is_that_of_its_equation_of_motion(speed, seconds):
    way, v, step = 0.0, speed, 0.0005
    for _ in range(round(seconds / step)):
        way, v = way + v * step, max(0.0, v - step * (intercept.DRAG * v + intercept.FRICTION))
    assert intercept.rolled(speed, seconds) == pytest.approx(way, rel=0.005)


def test_a_lying_ball_is_walked_to_itself():
    made = world()
    assert intercept.meeting(made) == (made.ball.relative.x, made.ball.relative.y)


@pytest.mark.parametrize('vx, vy', [(60, 0), (-60, 0), (0, -50), (40, -40), (70, 20)])
def test_the_ball_is_at_the_meeting_when_the_robot_can_be(vx, vy):
    made = rolling(vx, vy, ball=(180.0, 300.0))
    x, y = intercept.meeting(made)
    seconds = intercept.needed(x, y)
    there = intercept.Rolling(made.ball).at(seconds)
    field_x, field_y = 180.0 + x, 200.0 + y  # the robot looks up-field
    assert math.dist(there, (field_x, field_y)) < 12.0


def test_a_ball_across_is_met_ahead_of_where_it_is():
    made = rolling(60.0, 0.0, ball=(120.0, 260.0))
    assert intercept.meeting(made)[0] > made.ball.relative.x + 10.0


def test_an_old_velocity_and_a_switched_off_intercept_tell_the_balls_own_place():
    made = rolling(60.0, 0.0)
    made.ball.seconds_since_seen = 0.5
    assert intercept.meeting(made) == (made.ball.relative.x, made.ball.relative.y)
    made = rolling(60.0, 0.0)
    made.task.intercept = False
    assert intercept.target(made) == (made.ball.relative.x, made.ball.relative.y)


def test_the_velocity_of_the_robot_frame_is_turned_with_the_robot():
    made = rolling(30.0, 40.0, heading=0.0)
    assert intercept.relative_velocity(made) == pytest.approx((-40.0, 30.0))
    put_ball(made, 180.0, 260.0)
