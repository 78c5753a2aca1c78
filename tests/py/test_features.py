# SPDX-License-Identifier: Apache-2.0
"""The places of a field that a robot looks at are made from the field that it knows."""
import ast
import pathlib

import kelpie
import pytest
from ideal_world import play
from lib import features
from players.forward import Forward

PYCODE = pathlib.Path(__file__).resolve().parent.parent.parent / 'pycode'


def near(places, x, y):
    return sum(abs(p[0] - x) < 2.0 and abs(p[1] - y) < 2.0 for p in places)


def test_primary_features_are_corners_crossings_and_the_middle_each_once():
    places = features.primary(kelpie.FIELDS['2006'])
    corners = [(x, y) for x in (0, 360) for y in (0, 270, 540)]
    boxes = [(x, y) for x in (115, 245) for y in (0, 65, 475, 540)]
    assert all(near(places, *p) == 1 for p in [*corners, *boxes, (180, 270)])
    assert len(places) == 15


def test_secondary_features_lie_between_them_and_in_no_goal():
    places = features.secondary(kelpie.FIELDS['2006'])
    halves = [(0, 135), (360, 135), (0, 405), (360, 405), (90, 270), (270, 270), (180, 65),
              (180, 475), (57, 0), (303, 0), (57, 540), (303, 540)]
    assert all(near(places, *p) == 1 for p in halves)
    assert not near(places, 180, 0) and not near(places, 180, 540)


def test_a_smaller_field_has_its_own_features():
    places = features.primary(kelpie.FIELDS['2004'])
    assert near(places, 145, 220) == 1 and not near(places, 180, 270)
    assert max(y for _, y in places) < 440


@pytest.mark.parametrize('name', list(kelpie.FIELDS))
def test_the_forward_scores_on_every_field(name):
    goals = [play(Forward().step, seed, 60.0, field=name).scored for seed in range(10)]
    assert sum(goals) >= 9


# What a length of some field is by chance: turns in degrees, how far vision sees a ball and kicks
# send it, and places of examples, which are written for the field of 2006.
NO_SIZES = {'geom.py': {360.0}, 'kick_table.py': {360.0}, 'lost_ball.py': {360.0},
            'facing.py': {270.0}, 'doubt.py': {220.0}, 'kick_map.py': {220.0},
            'examples.py': {220.0, 270.0, 290.0, 360.0, 440.0},
            'positions_regression.py': {360.0, 540.0}}


def test_no_size_of_a_field_stands_in_the_behaviours():
    sizes = {size for field in kelpie.FIELDS.values()
             for size in (field.width, field.length, 0.5 * field.length)}
    for path in PYCODE.rglob('*.py'):
        numbers = {float(node.value) for node in ast.walk(ast.parse(path.read_text()))
                   if isinstance(node, ast.Constant) and type(node.value) in (int, float)}
        assert (numbers & sizes) <= NO_SIZES.get(path.name, set()), path
