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
    assert chosen(world(180.0, 270.0), overdue=True)[0] in ahead
    assert chosen(blocked(world(180.0, 270.0)), overdue=True)[0] not in ahead + (RELEASE,)
    assert chosen(blocked(world(180.0, 450.0)), overdue=True)[0] in ahead


def test_a_ball_is_not_kicked_at_somebody_under_the_nose_before_time_is_out():
    assert chosen(world(180.0, 490.0), overdue=False)[0] in kick_map_choice.AHEAD
    assert chosen(blocked(world(180.0, 490.0)), overdue=False) is None
