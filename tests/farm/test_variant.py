# SPDX-License-Identifier: Apache-2.0
# Teams that are Kelpie but for some rules.
import tomllib

import pytest
from farm.variant import KELPIE, PYCODE, RULES, rulebook_without, team_toml, values, write_variant
from farm.work import Trouble

TEXT = (PYCODE / RULES).read_text()


def test_a_rule_has_the_value_of_the_theses_and_nothing_else_changes():
    book = values(rulebook_without(TEXT, ['GLANCES', 'SPUN']))
    before = values(TEXT)
    assert book['Kelpie']['GLANCES'][1] == 'False' and book['Kelpie']['SPUN'][1] == '90'
    changed = [rule for rule in before['Kelpie'] if book['Kelpie'][rule] != before['Kelpie'][rule]]
    assert changed == ['GLANCES', 'SPUN'] and book['Thesis'] == before['Thesis']


def test_every_rule_can_be_left_out():
    rules = [rule for rule in values(TEXT)['Thesis'] if rule != 'THESIS']
    book = values(rulebook_without(TEXT, rules))
    assert all(book['Kelpie'][rule][1] == book['Thesis'][rule][1] for rule in rules)


def test_a_variant_is_a_copy_of_the_behaviours_with_its_switches(tmp_path):
    folder = write_variant(tmp_path / 'team', ['GLANCES'], ['kicks=0', 'dodge=false'])
    assert (folder / 'main.py').read_text() == (PYCODE / 'main.py').read_text()
    assert 'kicks = 0\ndodge = false\n' in (folder / 'team.toml').read_text()


def test_a_variant_of_switches_alone_holds_no_behaviours(tmp_path):
    folder = write_variant(tmp_path / 'team', [], ['kicks=0'])
    assert [path.name for path in folder.iterdir()] == ['team.toml']


@pytest.mark.parametrize('rules, settings, said', [
    (['PARTY'], [], '--without PARTY: rules are'), (['THESIS'], [], '--without THESIS'),
    ([], ['kicks'], '--set kicks: KEY=NUMBER'), ([], [], 'says --without or --set')])
def test_what_is_no_variant_is_refused_and_leaves_no_folder(tmp_path, rules, settings, said):
    with pytest.raises(Trouble, match=said):
        write_variant(tmp_path / 'team', rules, settings)
    assert not (tmp_path / 'team').exists()


def test_no_team_is_overwritten(tmp_path):
    with pytest.raises(Trouble, match='is there already'):
        write_variant(tmp_path, ['GLANCES'], [])
    task = tomllib.loads(team_toml(['kicks=0', 'run=false']))['behaviour']['task']
    kelpie = tomllib.loads(KELPIE.read_text(encoding='utf-8'))['behaviour']['task']
    assert task == {**kelpie, 'kicks': 0, 'run': False}
