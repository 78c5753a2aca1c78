# SPDX-License-Identifier: Apache-2.0
# The constants as a vector: what is searched, and the team's folder that a vector is.
import tomllib

import pytest
from farm.variant import KELPIE
from farm.vector import defaults, described, kept, name_of, team_text, write_team
from farm.work import Trouble

CARRY_TO = 'behaviour.constants.dribble.carryTo'
OVER_TURN = 'behaviour.constants.dribble.overTurn'


def test_some_groups_or_all_are_searched():
    assert {one.group for one in described('dribble,roles')} == {'dribble', 'roles'}
    assert len(described()) > 40
    with pytest.raises(Trouble, match='--groups party: there are grab, run, dribble'):
        described('dribble,party')


def test_a_number_is_kept_in_its_range_and_a_count_whole():
    of = {one.key: one for one in described('dribble')}
    assert kept(of[CARRY_TO], 1000.0) == 130.0 and kept(of[CARRY_TO], 70.12345) == 70.1235
    assert kept(of[OVER_TURN], 5.6) == 6 and kept(of[OVER_TURN], -1) == 4


def test_a_vector_of_defaults_is_a_team_that_says_nothing():
    found = described('dribble')
    kelpie = tomllib.loads(KELPIE.read_text(encoding='utf-8'))
    assert tomllib.loads(team_text(found, defaults(found), 'nothing')) == kelpie


def test_a_team_says_what_differs_with_its_unit(tmp_path):
    found = described()
    folder = write_team(tmp_path / 'team', found, {CARRY_TO: 80.0, OVER_TURN: 5}, 'why')
    text = (folder / 'team.toml').read_text()
    kelpie = tomllib.loads(KELPIE.read_text(encoding='utf-8'))['behaviour']
    changed = {'constants': {'dribble': {'carryTo': '80.0cm', 'overTurn': 5}}}
    assert tomllib.loads(text)['behaviour'] == kelpie | changed
    assert '# why' in text


def test_vectors_have_names_of_their_own_in_any_order():
    one = name_of({CARRY_TO: 80.0, OVER_TURN: 5})
    assert one == name_of({OVER_TURN: 5, CARRY_TO: 80.0}) != name_of({CARRY_TO: 81.0, OVER_TURN: 5})
