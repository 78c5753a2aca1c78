# SPDX-License-Identifier: Apache-2.0
# Round a post of the opponents' goal to the ball behind it.
import math

import kelpie
import pytest
from roles.attacker import Attacker
from situation.memory import Memory
from situations import put_ball, world
from skills.walk import round_post
from skills.walk.round_post import BEFORE, RoundPost, posts

FIELD = kelpie.FIELDS['2006']
LEFT, RIGHT = posts(FIELD)
LINE = FIELD.length
IN_MOUTH = RIGHT[0] - 14.0, LINE - 7.0


def who_leans_on_the_right_post():
    """As in a match: beside the post, turned to a ball in the mouth."""
    return world(x=RIGHT[0] + 1.0, y=LINE - 5.0, heading=150.0, ball=IN_MOUTH)


def test_posts_stand_at_the_ends_of_the_mouth():
    assert RIGHT[0] - LEFT[0] == FIELD.goal_width and LEFT[1] == RIGHT[1] == LINE


@pytest.mark.parametrize('here, ball, stands', [
    ((RIGHT[0] + 40.0, LINE - 12.0), IN_MOUTH, True),
    ((LEFT[0] - 40.0, LINE - 12.0), (LEFT[0] + 14.0, LINE - 7.0), True),
    ((RIGHT[0], LINE - 50.0), IN_MOUTH, False),
    ((RIGHT[0] + 40.0, LINE - 12.0), (RIGHT[0] + 12.0, LINE - 60.0), False),
    ((RIGHT[0] + 70.0, LINE - 12.0), (RIGHT[0] + 40.0, LINE - 7.0), False),
    ((IN_MOUTH[0], IN_MOUTH[1] - 0.5), IN_MOUTH, False)])
def test_a_post_is_in_the_way_of_who_comes_from_beside_the_goal(here, ball, stands):
    made = world(x=here[0], y=here[1], ball=ball)
    assert round_post.needed(made) is stands


def test_the_way_of_who_goes_round_is_free_a_little_later():
    for y in range(80):
        made = world(x=RIGHT[0] + 60.0, y=LINE - 5.0 - y, ball=IN_MOUTH)
        if not round_post.needed(made):
            break
    assert y > 10.0 and round_post.needed(made, goes_round=True)


def test_without_a_ball_there_is_no_way():
    made = who_leans_on_the_right_post()
    made.ball.present = False
    assert not round_post.needed(made)


def test_who_leans_on_the_post_walks_away_from_the_line_and_looks_at_the_ball():
    made = who_leans_on_the_right_post()
    walk = RoundPost(Memory()).step(made).walk
    angle = math.radians(made.pose.heading_deg)
    up_field = walk.forward * math.sin(angle) + walk.left * math.cos(angle)
    assert up_field < -20.0


def test_the_attacker_goes_round_and_by_the_theses_rules_does_not():
    for rules, state in ((kelpie.RULES_OF_KELPIE, 'round_post'), (kelpie.RULES_OF_THESIS, 'play')):
        made, memory = who_leans_on_the_right_post(), Memory()
        made.task.rules = rules
        memory.update(made)
        player = Attacker(memory)
        player.step(made)
        player.step(made)
        assert player.playing == state


def test_once_past_the_post_it_plays():
    made, memory = who_leans_on_the_right_post(), Memory()
    memory.update(made)
    player = Attacker(memory)
    player.step(made)
    made.pose.position.x, made.pose.position.y = IN_MOUTH[0], LINE - BEFORE
    put_ball(made, *IN_MOUTH)
    memory.update(made)
    player.step(made)
    assert player.playing == 'play'
