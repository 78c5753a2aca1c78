# SPDX-License-Identifier: Apache-2.0
"""The kick of a held ball by the map: when it waits, and what it does when time is out."""
import math

import pytest
from decisions import kick_map_choice
from decisions.kick_choice import RELEASE
from lib import kick_table
from situation.aim import Aim
from situation.memory import Memory
from situations import world
from skills.ball.grab_dribble import GrabDribble
from skills.ball.hold import Hold


def chosen(made, overdue):
    dribble = GrabDribble(Memory(), None)
    dribble.hold, dribble.aim = Hold(made, made.time_s), Aim()
    return kick_map_choice.choose(made, dribble, overdue)


def test_without_goal_or_pose_it_waits_until_time_is_out():
    made = world(180.0, 300.0, -90.0)
    made.heading_sd_deg = 60.0
    assert chosen(made, overdue=False) is None
    assert chosen(made, overdue=True)[0] in kick_table.kicks(True)


@pytest.mark.parametrize('heading', range(-150, -29, 10))
def test_out_of_time_before_the_own_goal_it_is_not_kicked_at_it(heading):
    made = world(180.0, 60.0, float(heading))
    kick = chosen(made, overdue=True)[0]
    if kick != RELEASE:
        _, down_field = kick_map_choice.held_ball(made)
        _, direction, _, distance, _ = kick_table.held_outcome(kick)
        down_field += distance * math.sin(math.radians(heading + direction))
        assert down_field > kick_map_choice.OWN_END


def test_out_of_time_a_ball_is_not_kicked_to_a_lower_utility_than_where_it_lies():
    """The best kick leads from y = 134 to 46."""
    assert chosen(world(60.0, 140.0, -135.0), overdue=True)[0] == RELEASE


def test_out_of_time_where_each_kick_goes_to_the_own_end_the_ball_is_let_go():
    assert chosen(world(180.0, 25.0, -90.0), overdue=True)[0] == RELEASE


@pytest.mark.parametrize('heading, side', [(10.0, 1.0), (170.0, -1.0)])
def test_out_of_time_beside_the_goal_it_is_kicked_to_that_side(heading, side):
    kick = chosen(world(180.0, 420.0, heading), overdue=True)[0]
    assert side * kick_table.held_outcome(kick)[1] > 30.0


def test_out_of_time_before_the_goal_it_is_kicked_at_it():
    assert chosen(world(180.0, 450.0), overdue=True)[0] in kick_map_choice.AHEAD


def blocked(made):
    made.sensors.head_near_distance = 5.0
    return made


def test_against_somebody_under_the_nose_it_is_kicked_sideways_in_midfield_ahead_before_the_goal():
    ahead = kick_map_choice.AHEAD
    assert chosen(world(180.0, 270.0, 70.0), overdue=True)[0] in ahead
    assert chosen(blocked(world(180.0, 270.0, 70.0)), overdue=True)[0] not in ahead + (RELEASE,)
    assert chosen(blocked(world(180.0, 450.0)), overdue=True)[0] in ahead


def test_a_ball_is_not_kicked_at_somebody_under_the_nose_before_time_is_out():
    assert chosen(world(180.0, 490.0), overdue=False)[0] in kick_map_choice.AHEAD
    assert chosen(blocked(world(180.0, 490.0)), overdue=False) is None


@pytest.mark.parametrize('half, carries, kicks', [
    (12.0, True, True), (3.0, True, False), (3.0, False, True)])
def test_a_ball_that_could_be_carried_on_is_kicked_where_that_is_good_enough(half, carries, kicks):
    """Through a gap of so many deg to each side, 202 cm before the goal."""
    made = world(180.0, 330.0)
    dribble = GrabDribble(Memory(), None)
    dribble.hold, dribble.aim = Hold(made, made.time_s), Aim()
    dribble.aim.gap, dribble.should_carry = (half, -half), lambda one: carries
    found = kick_map_choice.choose(made, dribble, False)
    assert (found is not None) is kicks
    assert found is None or carries is False or found[2] >= kick_map_choice.GOOD


def test_a_ball_has_a_utility_from_45_cm_before_the_own_line_on_and_less_below():
    field = world().field
    assert kick_map_choice.nearness(field, 180.0, 46.0) > 0.0
    assert kick_map_choice.nearness(field, 180.0, 44.0) == -0.5


def test_a_balls_utility_falls_from_0_6_in_the_goal_by_a_third_of_it_in_217_cm():
    field = world().field
    assert kick_map_choice.nearness(field, 180.0, 539.99) == pytest.approx(0.6, abs=0.001)
    assert kick_map_choice.nearness(field, 180.0, 323.3) == pytest.approx(0.4, abs=0.001)


@pytest.mark.parametrize('x, y', [(0.0, 300.0), (360.0, 300.0), (100.0, 540.0)])
def test_a_ball_out_of_the_field_keeps_half_its_utility(x, y):
    field, out = world().field, -0.01 if x == 0.0 else 0.01
    inside = kick_map_choice.nearness(field, abs(x - 0.01), min(y, 539.99))
    outside = kick_map_choice.nearness(field, x + (0.0 if y == 540.0 else out), y)
    assert outside == pytest.approx(0.5 * inside, abs=0.001)


def test_a_ball_that_is_let_go_keeps_0_7_of_its_places_utility():
    made = world(180.0, 300.0)
    there = kick_map_choice.nearness(made.field, 180.0, 308.0)
    assert kick_map_choice.utility_let_go(made) == pytest.approx(0.7 * there)


def test_a_held_ball_lies_8_cm_ahead_of_the_neck():
    assert kick_map_choice.held_ball(world(100.0, 200.0, 0.0)) == pytest.approx((108.0, 200.0))
    assert kick_map_choice.held_ball(world(100.0, 200.0, 90.0)) == pytest.approx((100.0, 208.0))


def test_somebody_under_the_nose_leaves_four_of_ten_kicks_ahead_their_utility():
    free = world(180.0, 450.0)
    kick, gap = kick_map_choice.AHEAD[0], (20.0, -20.0)
    wanted = 0.4 * kick_map_choice.utility_of(free, kick, gap, 0.0) + \
        0.6 * kick_map_choice.utility_let_go(free)
    assert kick_map_choice.utility_now(blocked(free), kick, gap) == pytest.approx(wanted)


def test_a_kick_that_works_every_second_time_is_worth_half_of_where_the_ball_goes():
    made, outcome = world(180.0, 150.0), (0.5, 0.0, 5.0, 100.0, 10.0)
    there = kick_map_choice.nearness(made.field, 180.0, 258.0)
    found = kick_map_choice.utility_of_way(made, (180.0, 158.0), 90.0, outcome)
    assert found == pytest.approx(0.5 * there, rel=0.01)
