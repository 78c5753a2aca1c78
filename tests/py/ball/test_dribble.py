# SPDX-License-Identifier: Apache-2.0
"""The ball that is driven on without a grab."""
import pytest
from situation.memory import Memory
from situations import world
from skills.ball.dribble import Dribble


@pytest.mark.parametrize('away, ends', [(39.0, True), (41.0, False), (150.0, False)])
def test_a_far_ball_is_walked_to_from_whatever_side(away, ends):
    """As the way to it changes where it would go."""
    skill = Dribble(Memory(), lambda _: 150.0)
    skill.step(world(180.0, 200.0, 90.0, (180.0, 200.0 + away)))
    assert skill.done is ends


@pytest.mark.parametrize('goal_deg, ends', [(0.0, False), (90.0, False), (-90.0, False),
                                            (150.0, True), (-150.0, True)])
def test_a_ball_ahead_is_driven_on_unless_that_is_away_from_the_goal(goal_deg, ends):
    made = world(180.0, 200.0, 90.0, (180.0, 230.0))
    skill = Dribble(Memory(), lambda _: goal_deg)
    walk = skill.step(made).walk
    assert skill.done == ends and (walk.forward > 20.0) != ends
