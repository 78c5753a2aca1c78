# SPDX-License-Identifier: Apache-2.0
# Round the own box to a ball beyond it.
import kelpie
import pytest
from lib.goalie_places import beyond_box
from roles.attacker import Attacker
from safety.own_box import round_box as first_point
from situation.memory import Memory
from situations import put_ball, world
from skills.walk import round_box
from skills.walk.round_box import RoundBox

FIELD = kelpie.FIELDS['2006']
MIDDLE = 0.5 * FIELD.width


def legs(here, place):
    """The points that a robot comes by on its way round the own box."""
    points = [here]
    for _ in range(8):
        points.append(first_point(FIELD, points[-1], place))
        if points[-1] == place:
            return points
    raise AssertionError(f'it goes on for ever: {points}')


LOW = 20.0
LEFT, RIGHT = 60.0, FIELD.width - 60.0


@pytest.mark.parametrize('here, place, count', [
    ((MIDDLE, 300.0), (LEFT, LOW), 1), ((LEFT, LOW), (RIGHT, LOW), 3),
    ((RIGHT, LOW), (LEFT, LOW), 3),
    ((RIGHT, 100.0), (LEFT, LOW), 2), ((LEFT, LOW), (MIDDLE, 200.0), 1),
    ((MIDDLE, 40.0), (MIDDLE, 300.0), 2), ((MIDDLE - 40.0, LOW), (RIGHT, LOW), 4)])
def test_a_way_to_the_other_side_leads_round_the_own_box(here, place, count):
    points = legs(here, place)
    assert len(points) - 1 == count
    for start, end in zip(points[1:], points[2:]):
        for share in range(21):
            at = [start[i] + share / 20.0 * (end[i] - start[i]) for i in (0, 1)]
            assert beyond_box(FIELD, at) > 0.0


@pytest.mark.parametrize('here, ball, lies', [
    ((RIGHT, LOW), (LEFT, LOW), True), ((LEFT, LOW), (RIGHT, LOW), True),
    ((LEFT, 75.0), (MIDDLE + 30.0, 70.0), False), ((MIDDLE, 120.0), (MIDDLE, 72.0), False),
    ((100.0, 150.0), (LEFT, LOW), False), ((LEFT, LOW), (LEFT, 200.0), False),
    ((LEFT, LOW), (LEFT + 10.0, LOW), False)])
def test_the_box_is_in_the_way_of_who_would_walk_through_it(here, ball, lies):
    assert round_box.needed(world(x=here[0], y=here[1], ball=ball)) is lies


def test_without_a_ball_there_is_no_way():
    made = world(x=RIGHT, y=LOW, ball=(LEFT, LOW))
    made.ball.present = False
    assert not round_box.needed(made)


def test_who_goes_round_the_box_keeps_more_of_it_free():
    made = world(x=LEFT, y=FIELD.box_depth + 5.0, ball=(RIGHT, FIELD.box_depth + 5.0))
    assert not round_box.needed(made) and round_box.needed(made, goes_round=True)


def test_it_turns_to_the_corner_and_goes():
    made = world(x=RIGHT, y=LOW, heading=120.0, ball=(LEFT, LOW))
    walk = RoundBox(Memory()).step(made).walk
    assert walk.forward > 25.0 and walk.kind == kelpie.WALK_FAST


@pytest.mark.parametrize('run', [True, False])
@pytest.mark.parametrize('rules, state', [(kelpie.RULES_OF_KELPIE, 'round_box'),
                                          (kelpie.RULES_OF_THESIS, 'play')])
def test_an_attacker_goes_round_and_by_the_theses_rules_does_not(rules, state, run):
    made, memory = world(x=RIGHT, y=LOW, heading=180.0, ball=(LEFT, LOW)), Memory()
    made.task.rules, made.task.run = rules, run
    memory.update(made)
    player = Attacker(memory)
    player.step(made)
    player.step(made)
    assert player.playing == state


def test_once_past_the_box_it_plays():
    made, memory = world(x=RIGHT, y=LOW, heading=180.0, ball=(LEFT, LOW)), Memory()
    memory.update(made)
    player = Attacker(memory)
    player.step(made)
    made.pose.position.x, made.pose.position.y = LEFT, 110.0
    put_ball(made, LEFT, LOW)
    memory.update(made)
    player.step(made)
    assert player.playing == 'play'
