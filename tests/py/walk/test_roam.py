# SPDX-License-Identifier: Apache-2.0
import math

import kelpie
import pytest
from lib.geom import from_field
from skills.walk.roam import Roam, beside

FIELD = kelpie.FIELDS['2006']


def world_at(x, y, opponents=()):
    world = kelpie.WorldFrame(field=FIELD)
    world.pose.position.x, world.pose.position.y, world.pose.heading_deg = x, y, 90.0
    world.opponents = [kelpie.OpponentEstimate(position=kelpie.Point2(x=a, y=b))
                       for a, b in opponents]
    return world


def places(world, count):
    """The places that a roaming robot goes to when it is at each at once."""
    roam, found = Roam(world), []
    for _ in range(count):
        roam.step(world)
        found.append(roam.place)
        world.pose.position.x, world.pose.position.y = roam.place
        world.time_s += 1.0
    return found


def test_both_halves_are_visited_in_turn_the_other_one_first():
    assert places(world_at(100.0, 100.0), 4) == [(180.0, 351.0), (180.0, 189.0)] * 2
    assert places(world_at(100.0, 400.0), 2) == [(180.0, 189.0), (180.0, 351.0)]


def test_a_place_that_is_not_reached_is_given_up():
    world = world_at(100.0, 100.0)
    roam = Roam(world)
    roam.step(world)
    first, world.time_s = roam.place, 9.1
    roam.step(world)
    assert roam.place != first


def test_robots_that_may_hide_the_ball_are_passed_first_each_once_the_nearest_first():
    world = world_at(180.0, 100.0, [(180.0, 300.0), (100.0, 180.0)])
    first, second, third = places(world, 3)
    assert math.hypot(first[0] - 100.0, first[1] - 180.0) < 55.0
    assert math.hypot(second[0] - 180.0, second[1] - 300.0) < 55.0
    assert third in ((180.0, 351.0), (180.0, 189.0))


@pytest.mark.parametrize('opponent, since', [((180.0, 400.0), 0.0), ((180.0, 300.0), 11.0)])
def test_robots_that_are_far_or_long_unseen_hide_nothing(opponent, since):
    world = world_at(180.0, 100.0, [opponent])
    world.opponents[0].seconds_since_seen = since
    assert places(world, 1) == [(180.0, 351.0)]


@pytest.mark.parametrize('here', [(180.0, 100.0), (60.0, 250.0), (300.0, 420.0)])
def test_from_beside_a_robot_what_lies_behind_it_is_in_sight(here):
    robot, world = (190.0, 260.0), world_at(*here)
    away = math.hypot(robot[0] - here[0], robot[1] - here[1])
    place = beside(world, away, *robot)
    along = (robot[0] - here[0]) / away, (robot[1] - here[1]) / away
    ball = robot[0] + 32.0 * along[0], robot[1] + 32.0 * along[1]
    # How near to the robot's middle the sight from the place to the ball passes.
    sight = ball[0] - place[0], ball[1] - place[1]
    off = abs(sight[0] * (robot[1] - place[1]) - sight[1] * (robot[0] - place[0]))
    assert off / math.hypot(*sight) > 25.0
    assert 40.0 < math.hypot(place[0] - robot[0], place[1] - robot[1]) < 60.0


def test_a_place_beside_a_robot_is_on_the_field():
    world = world_at(20.0, 100.0)
    x, y = beside(world, 400.0, 20.0, 500.0)
    assert 30.0 <= x <= 330.0 and 30.0 <= y <= 510.0


def test_it_walks_to_the_place():
    world = world_at(180.0, 100.0)
    walk = Roam(world).step(world).walk
    assert walk.forward > 25.0 and abs(walk.turn_deg) < 1.0
    assert from_field(world.pose, 180.0, 351.0)[1] > 200.0
