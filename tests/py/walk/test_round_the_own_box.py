# SPDX-License-Identifier: Apache-2.0
"""How fast and where to an attacker walks while its goalie has the ball. The box is 130 cm wide and
65 deep, and 28 cm around it are kept free: from x 87 to 273, up to y 93."""
import kelpie
import pytest
from situations import world
from skills.walk import avoid_own_box
from skills.walk.avoid_own_box import AvoidOwnBox

FIELD = kelpie.FIELDS['2006']
FREE = 87.0, 273.0, 93.0


def test_28_cm_around_the_box_are_kept_free():
    assert avoid_own_box.clear_of(FIELD) == FREE


@pytest.mark.parametrize('away, speed', [(100.0, 26.0), (18.0, 26.0), (10.0, 15.0), (6.1, 9.15),
                                         (5.9, 0.0)])
def test_a_place_is_walked_to_at_26_cm_a_second_and_slower_from_17_cm_on(away, speed):
    for dx, dy in ((away, 0.0), (-away, 0.0), (0.0, away), (0.6 * away, 0.8 * away)):
        vx, vy = avoid_own_box.step_towards(FIELD, (180.0, 300.0), (180.0 + dx, 300.0 + dy))
        assert (vx, vy) == pytest.approx((speed * dx / away, speed * dy / away))


@pytest.mark.parametrize('robot, way', [
    ((90.0, 50.0), (-15.0, 0.0)), ((270.0, 50.0), (15.0, 0.0)), ((180.0, 85.0), (0.0, 20.0))])
def test_who_is_inside_leaves_by_the_nearest_side_until_12_cm_beyond(robot, way):
    assert avoid_own_box.way_out(*FREE, *robot) == way
    vx, vy = avoid_own_box.step_towards(FIELD, robot, (180.0, 300.0))
    assert (vx * way[0] > 0.0, vy * way[1] > 0.0) == (way[0] != 0.0, way[1] != 0.0)


@pytest.mark.parametrize('robot, ball, place', [
    ((200.0, 130.0), (180.0, 50.0), (235.0, 93.0)), ((160.0, 130.0), (180.0, 50.0), (125.0, 93.0)),
    ((180.0, 130.0), (180.0, 50.0), (235.0, 93.0)), ((260.0, 130.0), (244.0, 50.0), (299.0, 93.0)),
    ((60.0, 100.0), (40.0, 60.0), (95.0, 93.0)), ((50.0, 100.0), (79.0, 60.0), (134.0, 93.0)),
    ((50.0, 100.0), (81.0, 60.0), (26.0, 93.0)), ((300.0, 100.0), (282.0, 60.0), (227.0, 93.0)),
    ((300.0, 100.0), (279.0, 60.0), (334.0, 93.0))])
def test_before_the_box_the_place_is_55_cm_beside_the_ball_and_25_from_the_side_lines(robot, ball,
                                                                                     place):
    assert avoid_own_box.place_to_stand(FIELD, robot, ball) == ('aside', place)


@pytest.mark.parametrize('robot, place', [
    ((86.0, 50.0), (87.0, 93.0)), ((274.0, 50.0), (273.0, 93.0))])
def test_beside_what_is_kept_free_the_place_is_its_corner(robot, place):
    ball = (120.0, 50.0) if robot[0] < 180.0 else (240.0, 50.0)
    assert avoid_own_box.place_to_stand(FIELD, robot, ball) == ('corner', place)


@pytest.mark.parametrize('robot, branch', [
    ((86.0, 92.0), 'corner'), ((88.0, 92.0), 'aside'), ((86.0, 94.0), 'aside'),
    ((274.0, 92.0), 'corner'), ((272.0, 92.0), 'aside')])
def test_only_who_is_beside_goes_to_a_corner(robot, branch):
    ball = (130.0, 60.0) if robot[0] < 180.0 else (230.0, 60.0)
    assert avoid_own_box.place_to_stand(FIELD, robot, ball)[0] == branch


@pytest.mark.parametrize('heading', [90.0, 0.0, -90.0])
def test_it_walks_to_any_side_and_turns_to_the_ball(heading):
    """From (200, 130) to (235, 93), 50.9 cm: 17.9 to the right and 18.9 down the field."""
    made = world(200.0, 130.0, heading, (180.0, 50.0))
    walk = AvoidOwnBox().step(made).walk
    vx, vy = 17.87, -18.89
    forward, left = {90.0: (vy, -vx), 0.0: (vx, vy), -90.0: (-vy, vx)}[heading]
    assert (walk.forward, walk.left) == pytest.approx((forward, left), abs=0.02)
    turn = max(-90.0, min(90.0, 1.8 * made.ball.heading_deg))
    assert walk.turn_deg == pytest.approx(turn)


@pytest.mark.parametrize('robot, branch', [
    ((200.0, 130.0), 'aside'), ((86.0, 50.0), 'corner'), ((180.0, 200.0), 'far')])
def test_it_says_which_of_the_three_it_does(robot, branch):
    ball = (130.0, 50.0) if branch == 'corner' else (180.0, 50.0)
    skill, trace = AvoidOwnBox(), []
    skill.step(world(*robot, 90.0, ball))
    skill.explain(trace)
    assert trace[0][2] == branch and branch in ('aside', 'corner', 'far')
    assert trace[0][3] == avoid_own_box.WHY[branch]
