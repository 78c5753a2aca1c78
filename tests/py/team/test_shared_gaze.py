# SPDX-License-Identifier: Apache-2.0
"""The gaze that shows a landmark beside the ball."""
import copy
import math

import kelpie
import pytest
from lib.geom import from_field, heading, polar, wrap
from lib.shared_gaze import (BALL, EVERY, HORIZON_IN, IMAGE_HALF_WIDTH, IMAGE_UP, INSIDE,
                             MAX_PAN_OFF, SharedGaze, pan_for, up_for)


def world_at(x, y, degrees):
    world = kelpie.WorldFrame(field=kelpie.FIELDS['2006'])
    world.pose.position.x, world.pose.position.y, world.pose.heading_deg = x, y, degrees
    world.stance.body_tilt_deg = 14.25
    return world


def nearest_off(world, pan):
    return min((abs(wrap(heading(*from_field(world.pose, m.position.x, m.position.y)) - pan))
                for m in world.field.landmarks
                if 70 <= math.hypot(*from_field(world.pose, m.position.x, m.position.y)) <= 550))


def test_it_turns_just_so_far_that_the_nearest_landmark_is_in_the_image():
    world, turned = world_at(180.0, 270.0, 90.0), 0
    for pan in range(-90, 91, 5):
        off = pan_for(world, pan)
        before, after = nearest_off(world, pan), nearest_off(world, pan + off)
        assert abs(off) <= MAX_PAN_OFF
        if off:
            turned += 1
            assert after == pytest.approx(IMAGE_HALF_WIDTH - INSIDE) and before > after
        else:
            inside = IMAGE_HALF_WIDTH - INSIDE
            assert before <= inside or before > inside + MAX_PAN_OFF
    assert turned


@pytest.mark.parametrize('distance', range(20, 300, 5))
def test_the_ball_stays_whole_in_the_image_and_a_far_one_in_its_middle(distance):
    up = up_for(distance)
    assert 0.0 <= up <= max(0.0, IMAGE_UP - math.degrees(BALL / distance))
    assert distance < 53 or up == 0.0


def test_at_45_cm_the_horizon_comes_into_the_image():
    down = math.degrees(math.atan2(17.0, 45.0))
    assert IMAGE_UP - (down - up_for(45.0)) == pytest.approx(HORIZON_IN)


def test_without_a_landmark_near_the_view_it_looks_at_the_ball():
    world = world_at(180.0, 270.0, 90.0)
    world.field = copy.copy(world.field)
    world.field.landmarks = []
    world.ball.distance = 100.0
    point = polar(100.0, 20.0)
    target = SharedGaze().beside(world, point, 8.4).target
    assert (target.x, target.y, target.z) == pytest.approx((*point, 8.4))


def test_how_far_it_turns_is_worked_out_anew_in_every_third_frame():
    world, gaze, offsets = world_at(180.0, 270.0, 90.0), SharedGaze(), []
    world.ball.distance = 100.0
    for frame in range(3 * EVERY):
        pan = 5.0 * frame
        aim = gaze.beside(world, polar(100.0, pan), 8.4).target
        offsets.append(round(wrap(heading(aim.x, aim.y) - pan), 6))
    for start in range(0, 3 * EVERY, EVERY):
        assert offsets[start] == pytest.approx(pan_for(world, 5.0 * start), abs=1e-5)
        assert len(set(offsets[start:start + EVERY])) == 1
