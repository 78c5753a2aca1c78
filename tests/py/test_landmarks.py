# SPDX-License-Identifier: Apache-2.0
import kelpie
import pytest
from lib.landmarks import choose_landmark, look_at_landmark, off_axis, widest_axis

EAST, WEST = kelpie.BEACON_PINK_ON_BLUE, kelpie.BEACON_BLUE_ON_PINK  # x = 375 and -15, y = 405


def world_at(x, y, heading_deg, covariance=(1.0, 0.0, 0.0, 1.0)):
    xx, xy, yx, yy = covariance
    world = kelpie.WorldFrame(field=kelpie.FIELDS['2006'])
    world.pose.position.x, world.pose.position.y = x, y
    world.pose.heading_deg = heading_deg
    world.covariance = [xx, xy, 0.0, yx, yy, 0.0, 0.0, 0.0, 0.01]
    return world


def kind_chosen(world, *limits):
    mark = choose_landmark(world, *limits)
    return None if mark is None else mark.kind


@pytest.mark.parametrize('covariance, axis, wider', [
    ([9.0, 0.0, 0.0, 1.0], 0.0, 3.0), ([1.0, 0.0, 0.0, 9.0], 90.0, 3.0),
    ([5.0, 4.0, 4.0, 5.0], 45.0, 3.0), ([5.0, -4.0, -4.0, 5.0], -45.0, 3.0),
    ([5.0, -4.0, 7.0, -4.0, 5.0, 7.0, 7.0, 7.0, 7.0], -45.0, 3.0)])
def test_the_widest_axis_of_a_covariance_and_how_wide_it_is(covariance, axis, wider):
    assert widest_axis(covariance) == pytest.approx((axis, wider))


@pytest.mark.parametrize('direction, axis, apart', [
    (30.0, 10.0, 20.0), (190.0, 10.0, 0.0), (-80.0, 90.0, 10.0), (100.0, 10.0, 90.0)])
def test_a_line_has_no_sense_of_direction(direction, axis, apart):
    assert off_axis(direction, axis) == pytest.approx(apart)


def test_of_two_beacons_the_one_along_the_widest_axis_is_chosen():
    # From (180, 250), facing up-field, the upper beacons are at 38.5 and 141.5 deg on the field.
    assert kind_chosen(world_at(180, 250, 90, (50.0, 40.0, 40.0, 50.0))) == EAST
    assert kind_chosen(world_at(180, 250, 90, (50.0, -40.0, -40.0, 50.0))) == WEST


def test_a_round_covariance_leaves_the_choice_to_the_shorter_turn_of_the_head():
    world = world_at(180, 250, 90)
    assert choose_landmark(world, 70.0, 40.0).kind == WEST
    assert choose_landmark(world, 70.0, -40.0).kind == EAST


def test_a_goal_is_looked_at_only_without_a_beacon():
    assert kind_chosen(world_at(180, 250, 90), 40.0) == kelpie.GOAL_BLUE
    assert kind_chosen(world_at(180, 250, 90), 60.0) in (EAST, WEST)


@pytest.mark.parametrize('pan_limit, found', [(51.0, kelpie.GOAL_BLUE), (52.0, EAST)])
def test_the_pan_limit_is_kept(pan_limit, found):
    # 51.5 deg to the right of straight ahead
    world = world_at(180, 250, 90, (50.0, 40.0, 40.0, 50.0))
    assert kind_chosen(world, pan_limit) == found


def test_a_landmark_too_near_for_the_image_is_not_chosen():
    assert kind_chosen(world_at(310, 405, 0), 10.0) is None       # 65 cm
    assert kind_chosen(world_at(300, 405, 0), 10.0) == EAST       # 75 cm


def test_the_head_aims_at_the_middle_of_a_far_beacon_and_higher_at_a_near_one():
    far = look_at_landmark(world_at(175, 405, 0), choose_landmark(world_at(175, 405, 0)))
    near = look_at_landmark(world_at(275, 405, 0), choose_landmark(world_at(275, 405, 0)))
    assert (far.aim, far.target.z, near.target.z) == (kelpie.AIM_POINT, 20.0, 30.0)
    assert (far.target.x, far.target.y) == pytest.approx((0.0, 200.0))
