# SPDX-License-Identifier: Apache-2.0
"""How often the sequential test errs, shown on matches that were played. Two of them are drawn for
a pair, each seen by either side at random, so that both sides are equal; and one side's goals are
taken away, each with the same probability, until the other is better by as much as is wanted. That
mean is known, since the share of every result can be counted. The matches of a pair are drawn by
themselves: two names of the same behaviours play the same match twice by one seed. Of values, which
are no counts, a stored pair is drawn with either sign, and what is wanted is added. It fails where
too few matches are stored to tell what results there are."""

import json
import math
import random

from farm.plan import GOALS, SCORE, VALUE, Plan, is_void, of_pair
from farm.sprt import ACCEPTED, OPEN, REJECTED, SequentialTest
from farm.store import BLUE, RED, Store, is_result
from farm.work import IMAGES, Trouble

FEWEST = 8          # stored matches
LONGEST = 20000     # pairs of one test


def results_of_journal(path):
    """Of a league (tools/league): a line for each match behind the first."""
    try:
        with open(path, encoding='ascii') as file:
            return [json.loads(line) for line in file][1:]
    except ValueError:
        raise Trouble(f'{path}: no journal of a league') from None


def results_of_store(path):
    store = Store(path)
    return [result for test, _, _ in store.tests() for result in store.results(test).values()]


def stored_matches(path):
    """[(red's goals, blue's goals)] of all matches of a farm's store or of a league's journal."""
    read = results_of_journal if str(path).endswith('.jsonl') else results_of_store
    results = read(path)
    if not all(isinstance(result, dict) and is_result(result) for result in results):
        raise Trouble(f'{path}: results without goals')
    matches = [(result['red_goals'], result['blue_goals']) for result in results
               if not is_void(result)]
    if len(matches) < FEWEST:
        raise Trouble(f'{path}: {len(matches)} matches, at least {FEWEST} are needed')
    return matches


def stored_values(path):
    """Of each pair of a farm's store, the value that its first side has; its own mean is taken
    away with its sign."""
    if str(path).endswith('.jsonl'):
        raise Trouble(f'{path}: a league keeps no values; a farm.sqlite has them')
    store = Store(path)
    pairs = []
    for test, _, _ in store.tests():
        results = store.results(test)
        for seed in {seed for seed, _ in results}:
            both = [results.get((seed, colour)) for colour in (RED, BLUE)]
            if None not in both and all(VALUE in one for one in both):
                pairs.append(of_pair(*both, VALUE))
    pairs = [pair for pair in pairs if math.isfinite(pair)]
    if len(pairs) < FEWEST:
        raise Trouble(f'{path}: {len(pairs)} pairs with a value, at least {FEWEST} are needed')
    return pairs


class ShiftedPairs:
    """Of two sides of which the first has that mean value."""

    def __init__(self, pairs, mean, seed):
        middle = sum(pairs) / len(pairs)
        self.pairs, self.mean = [pair - middle for pair in pairs], mean
        self.draw = random.Random(seed)

    def pair(self):
        return self.draw.choice((1.0, -1.0)) * self.draw.choice(self.pairs) + self.mean


def figure(own, others, by):
    return float(own - others) if by == GOALS else 0.5 + 0.5 * ((own > others) - (own < others))


def mean_without(matches, by, share):
    """Of the side that keeps all its goals, when the other's are taken away with that probability:
    over all stored matches, seen by both sides, and all ways to take goals away."""
    total = count = 0.0
    for match in matches:
        for own, others in (match, match[::-1]):
            count += 1
            for left in range(others + 1):
                chance = (math.comb(others, left) * (1.0 - share) ** left
                          * share ** (others - left))
                total += chance * figure(own, left, by)
    return total / count


def share_for(matches, by, mean):
    """Which share to take away so that the other side has that mean."""
    if mean_without(matches, by, 1.0) < mean:
        raise Trouble(f'no team is so weak that the mean {by} against it is {mean:g}')
    low, high = 0.0, 1.0
    for _ in range(50):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if mean_without(matches, by, middle) < mean else (low, middle)
    return low


class DrawnPairs:
    """Of two sides of which the first has that mean."""

    def __init__(self, matches, by, mean, seed):
        equal = 0.5 if by == SCORE else 0.0
        self.matches, self.by = matches, by
        self.better = mean >= equal
        self.share = share_for(matches, by, mean if self.better else 2.0 * equal - mean)
        self.draw = random.Random(seed)
        self.equal = equal

    def pair(self):
        seen = 0.5 * (self._match() + self._match())
        return seen if self.better else 2.0 * self.equal - seen

    def _match(self):
        own, others = self.draw.choice(self.matches)
        if self.draw.random() < 0.5:
            own, others = others, own
        return figure(own, self._left(others), self.by)

    def _left(self, goals):
        return sum(self.draw.random() >= self.share for _ in range(goals))


def shown(matches, by, bounds, mean, runs, seed):
    """What becomes of so many tests of a side that has that mean."""
    drawn = (ShiftedPairs(matches, mean, seed) if by == VALUE
             else DrawnPairs(matches, by, mean, seed))
    ends, lengths = [], []
    for _ in range(runs):
        test = SequentialTest(bounds)
        while test.decision == OPEN and test.count < LONGEST:
            test.add(drawn.pair())
        ends.append(test.decision)
        lengths.append(test.count)
    return {'mean': round(mean, 4), 'accepted': ends.count(ACCEPTED) / runs,
            'rejected': ends.count(REJECTED) / runs, 'pairs': sum(lengths) / runs}


def trust(matches, by, low, high, runs, seed):
    """Of a side that is equal, of one that is weaker, and of one that is better by that much.
    `matches`: of stored_matches(), by value of stored_values()."""
    plan = Plan('', '', 0, 0.0, '', IMAGES, by, low, high)
    equal = 0.5 if by == SCORE else 0.0
    means = {'equal': equal, 'weaker': equal - (high - low), 'better': high}
    return {'by': by, 'low': low, 'high': high, 'runs': runs, 'stored_matches': len(matches), **{
        name: shown(matches, by, plan.bounds, mean, runs, f'{seed} {name}')
        for name, mean in means.items()}}
