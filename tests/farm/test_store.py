# SPDX-License-Identifier: Apache-2.0
# The farm's memory: each match once, whatever comes twice, is killed or is no store at all.
import sqlite3

import pytest
from farm.store import Store, is_locked
from farm.work import Trouble

WON = {'trouble': '', 'red_goals': 2, 'blue_goals': 1}
LOST = {'trouble': '', 'red_goals': 0, 'blue_goals': 3}


@pytest.fixture(name='store')
def open_store(tmp_path):
    made = Store(tmp_path / 'farm.sqlite', writes=True)
    made.begin('t', {'seed': 1})
    return made


def test_a_match_has_the_result_that_came_first(store):
    assert store.add('t', 5, 'red', WON)
    assert not store.add('t', 5, 'red', LOST)
    assert store.results('t') == {(5, 'red'): WON}


def test_the_other_colour_and_another_seed_and_test_are_other_matches(store):
    store.begin('u', {})
    for test, seed, colour in (('t', 5, 'red'), ('t', 5, 'blue'), ('t', 6, 'red'), ('u', 5, 'red')):
        assert store.add(test, seed, colour, WON)
    assert len(store.results('t')) == 3 and len(store.results('u')) == 1


def test_what_was_added_is_there_for_another_process_at_once_and_after_a_kill(store):
    store.add('t', 5, 'red', WON)
    reader = Store(store.path)      # the writer has closed nothing
    assert reader.results('t') == {(5, 'red'): WON}
    assert [test for test, _, _ in reader.tests()] == ['t']


def test_void_matches_are_forgotten_on_request_and_no_others(store):
    store.add('t', 5, 'red', WON)
    store.add('t', 5, 'blue', {'trouble': 'the world died'})
    store.forget_voids('t')
    assert list(store.results('t')) == [(5, 'red')]


def test_a_test_that_begins_again_keeps_its_plan_and_its_results(store):
    store.add('t', 5, 'red', WON)
    store.begin('t', {'seed': 2})
    assert store.tests()[0][1] == {'seed': 1} and len(store.results('t')) == 1


def test_two_farms_do_not_write_to_one_store(store):
    assert is_locked(store.path)
    with pytest.raises(Trouble, match='another farm writes to it'):
        Store(store.path, writes=True)
    store.close()
    assert not is_locked(store.path)
    Store(store.path, writes=True).close()


def test_a_file_that_is_no_store_is_refused_in_one_line(tmp_path):
    path = tmp_path / 'farm.sqlite'
    path.write_text('goals and glory\n' * 100)
    for writes in (False, True):
        with pytest.raises(Trouble, match='not a database'):
            Store(path, writes=writes)


def test_somebody_elses_database_is_refused_and_left_as_it_is(tmp_path):
    path = tmp_path / 'farm.sqlite'
    other = sqlite3.connect(path)
    other.execute('create table songs (title text)')
    other.commit()
    with pytest.raises(Trouble, match="no store of the farm's"):
        Store(path, writes=True)
    assert other.execute('select count(*) from sqlite_master').fetchone() == (1,)


def test_who_only_reads_makes_no_file(tmp_path):
    with pytest.raises(Trouble, match='no such file'):
        Store(tmp_path / 'none.sqlite')
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize('text', ['{', '[1]', '{"trouble": ""}', '""'])
def test_a_damaged_row_is_told_in_one_line(tmp_path, text):
    store = Store(tmp_path / 'farm.sqlite', writes=True)
    store.add('t', 5, 'red', WON)
    store.base.execute('update matches set result = ?', (text,))
    with pytest.raises(Trouble, match='damaged: a row says'):
        store.results('t')
    store.begin('t', {'seed': 1})
    store.base.execute("update tests set plan = '{nope'")
    with pytest.raises(Trouble, match='damaged: a row says'):
        store.tests()
