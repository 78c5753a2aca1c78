# SPDX-License-Identifier: Apache-2.0
# A test as it is played: what is handed out, what becomes of trouble and losses, when it ends.
import random

import pytest
from farm.plan import Plan
from farm.run import Run
from farm.store import Store
from farm.work import Trouble

PLAN = Plan('a', 'b', 1, 2.0, '4v4', 'images', 'score', 0.5, 0.6, 'v')


def drawn(match):
    """A match that the side called a wins more often."""
    draw = random.Random(f'{match.red} {match.seed}')
    goals = {'a': draw.choice((0, 1, 2, 3)), 'b': draw.choice((0, 0, 1, 2))}
    return {'trouble': '', 'red_goals': goals[match.red], 'blue_goals': goals[match.blue]}


class HandmadeCluster:
    """Plays at once, and gives back what was handed out last first."""
    client = 'there'

    def __init__(self, workers=3, outcome=drawn):
        self.workers, self.outcome = workers, outcome
        self.handed_out, self.waiting = [], []

    def capacity(self):
        return self.workers

    def submit(self, key, match, _):
        self.handed_out.append(key)
        self.waiting.append((key, match))

    def finished(self, _):
        key, match = self.waiting.pop()
        return [(key, self.outcome(match))]


@pytest.fixture(name='store')
def open_store(tmp_path):
    return Store(tmp_path / 'farm.sqlite', writes=True)


def run(store, cluster, most=500, stop=lambda: False, said=None):
    said = [] if said is None else said
    made = Run(PLAN, store, cluster, most, said.append, stop)
    made.decided = made.until_decided(lambda judged: said.append(judged.pairs))
    return made


def test_a_test_ends_when_it_is_decided_and_everything_counted_is_kept(store):
    made = run(store, HandmadeCluster())
    assert made.decided and made.judged.test.decision == 'accepted'
    kept = store.results(PLAN.id)
    assert all((seed, colour) in kept for seed in range(1, 1 + made.judged.pairs)
               for colour in ('red', 'blue'))


def test_the_decision_is_the_same_on_any_number_of_machines(tmp_path):
    ends = set()
    for workers in (1, 3, 40):
        made = run(Store(tmp_path / f'{workers}.sqlite', writes=True), HandmadeCluster(workers))
        ends.add((made.judged.test.decision, made.judged.pairs, made.judged.test.llr))
    assert len(ends) == 1


def test_no_match_is_handed_out_twice_and_few_more_than_there_are_workers(store):
    cluster = HandmadeCluster(8)
    run(store, cluster)
    assert len(cluster.handed_out) == len(set(cluster.handed_out))
    assert len(cluster.waiting) <= 11       # 8 workers, a quarter more, and one


def test_a_match_that_comes_back_last_holds_up_the_others_in_the_end(store):
    """Handed out last is given back first here: the first match would come back never."""
    cluster = HandmadeCluster(8)
    made = run(store, cluster)
    seeds = [seed for seed, _ in cluster.handed_out]
    assert max(seeds) <= made.judged.pairs + 2 * 8 + 8


def test_a_farm_that_was_stopped_plays_on_where_it_was(store):
    left = iter([False] * 30 + [True] * 10)
    first = HandmadeCluster()
    made = run(store, first, stop=lambda: next(left))
    assert not made.decided
    kept = set(store.results(PLAN.id))
    second = HandmadeCluster()
    assert run(store, second).decided
    assert kept and not kept & set(second.handed_out)


def test_a_test_that_is_decided_plays_nothing(store):
    run(store, HandmadeCluster())
    again = HandmadeCluster()
    assert run(store, again).decided and again.handed_out == []


def test_a_test_gives_up_after_as_many_pairs_as_it_may_play(store):
    made = run(store, HandmadeCluster(), most=6)
    assert not made.decided and made.judged.pairs == 6 and len(store.results(PLAN.id)) == 12


def test_what_is_lost_with_its_worker_is_played_again(store):
    losses = {}

    def outcome(match):
        losses[match] = losses.get(match, 0) + 1
        return None if losses[match] < 4 and match.seed == 2 else drawn(match)
    cluster = HandmadeCluster(outcome=outcome)
    assert run(store, cluster).judged.voids == 0
    assert cluster.handed_out.count((2, 'red')) == 4 and cluster.handed_out.count((3, 'red')) == 1


def test_a_match_that_kills_every_worker_is_void_in_the_end(store):
    cluster = HandmadeCluster(outcome=lambda m: None if m[:3] == ('a', 'b', 2) else drawn(m))
    assert run(store, cluster).judged.voids == 1
    assert store.results(PLAN.id)[2, 'red'] == {'trouble': 'its worker died 10 times'}


def test_a_match_in_trouble_is_played_once_more_and_then_void(store):
    bad = {'trouble': 'the world died'}
    cluster = HandmadeCluster(outcome=lambda m: bad if m.seed == 2 else drawn(m))
    said = []
    assert run(store, cluster, said=said).judged.voids == 1
    assert cluster.handed_out.count((2, 'red')) == 2
    assert said.count('once more, seed 2: the world died') == 2
    assert store.results(PLAN.id)[2, 'blue'] == bad


def test_a_farm_where_nothing_but_trouble_comes_back_gives_up(store):
    bad = {'trouble': 'another version plays here'}
    cluster = HandmadeCluster(outcome=lambda m: bad)
    with pytest.raises(Trouble, match='8 matches in a row failed: another version plays here'):
        run(store, cluster)
    assert len(cluster.handed_out) < 20


def test_a_match_that_goes_well_between_those_in_trouble_keeps_the_farm_going(store):
    """Of eight that come back seven are in trouble."""
    back = iter(range(1, 1000))
    cluster = HandmadeCluster(
        outcome=lambda m: drawn(m) if next(back) % 8 == 0 else {'trouble': 'stuck'})
    assert run(store, cluster, most=6).judged.pairs == 6
