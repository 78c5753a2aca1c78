# SPDX-License-Identifier: Apache-2.0
"""A search over the constants of the behaviours. Each vector plays so many pairs against every team
of a pool, and its figure is the mean over them of what it has more than they: of value, goals or
score. Every vector has seeds of its own, since what is best on the same few seeds is best there
alone; all pool teams share them. At the end the best few and the defaults play on fresh seeds, four
times as many, and the best of these is the champion: its gain over the defaults is measured on the
same seeds, and is no decision yet; that is the sequential test's (`kelpie farm play`).

State: the farm's store. The same search goes on where it was stopped."""

import math
from typing import NamedTuple

from farm.plan import Plan, estimate_only, of_pair
from farm.run import Run
from farm.store import BLUE, RED
from farm.vector import defaults, name_of, write_team
from farm.work import Trouble, about, portable

FINALISTS = 4
THOROUGH = 4          # times the pairs of a vector in the finals
FINALS = 1_000_000    # seeds beyond the first one at which the finals begin


class Asked(NamedTuple):
    """What a search is: `plan` is played by each vector, its `first` and `second` left open."""
    plan: Plan
    pool: tuple       # folders
    pairs: int        # of a vector against each team
    trials: int
    sampler: str


class Tried(NamedTuple):
    vector: dict
    folder: str
    mean: float
    sd: float         # of that mean


class Champion(NamedTuple):
    vector: dict
    folder: str
    gain: float       # over the defaults
    low: float        # 95 % interval, of a fixed number of pairs
    high: float


class Search:
    """`tell(number, tried)` after each vector."""

    def __init__(self, asked, found, folder, store, cluster, say, stop):
        self.asked, self.found, self.folder = asked, found, folder
        self.store, self.cluster = store, cluster
        self.say, self.stop = say, stop

    def run(self, sampler, tell):
        """The champion; nothing when stopped."""
        tried = []
        for number in range(self.asked.trials):
            vector = sampler.asked()
            one = self.try_out(vector, number * self.asked.pairs, self.asked.pairs)
            if one is None:
                return None
            sampler.told(vector, one.mean)
            tried.append(one)
            tell(number, one)
        return self._final(tried)

    def try_out(self, vector, after, pairs):
        """A vector on the seeds from the first one on plus `after`; nothing when stopped."""
        differences = self._differences(vector, after, pairs)
        return None if differences is None else tried_of(vector, self._team(vector), differences)

    def _team(self, vector):
        folder = self.folder / 'vectors' / name_of(vector)
        return str(write_team(folder, self.found, vector, 'A vector that a search tries.'))

    def _differences(self, vector, after, pairs):
        """Of each seed, the mean over the pool."""
        by_team = []
        for team in self.asked.pool:
            plan = self._plan(self._team(vector), team, after)
            judged = self._played(plan, pairs)
            if judged is None:
                return None
            by_team.append(judged)
        return [sum(one) / len(one) for one in zip(*by_team)]

    def _plan(self, first, second, after):
        plan = estimate_only(self.asked.plan)
        plan = plan._replace(first=portable(first), second=portable(second),
                             seed=plan.seed + after)
        return plan._replace(about=about(plan.match(plan.seed, RED))[0])

    def _played(self, plan, pairs):
        """What each pair has come to; nothing when stopped."""
        self.store.begin(plan.id, plan._asdict())
        run = Run(plan, self.store, self.cluster, pairs, self.say, self.stop)
        run.until_decided(lambda _: None)
        if self.stop():
            return None
        return [of_pair(run.results[seed, RED], run.results[seed, BLUE], plan.by)
                for seed in range(plan.seed, plan.seed + pairs)]

    def _final(self, tried):
        """The best of the finals against the defaults, both on the same fresh seeds."""
        pairs = THOROUGH * self.asked.pairs
        base = self._differences(defaults(self.found), FINALS, pairs)
        if base is None:
            return None
        best = None
        for one in finalists(tried, defaults(self.found)):
            played = self._differences(one.vector, FINALS, pairs)
            if played is None:
                return None
            champion = champion_of(one, [p - b for p, b in zip(played, base) if known(p, b)])
            if best is None or champion.gain > best.gain:
                best = champion
        return best


def known(*numbers):
    return all(map(math.isfinite, numbers))


def tried_of(vector, folder, differences):
    numbers = [number for number in differences if known(number)]
    mean, sd = mean_and_sd(numbers)
    return Tried(vector, folder, mean, sd)


def champion_of(one, gains):
    mean, sd = mean_and_sd(gains)
    return Champion(one.vector, one.folder, mean, mean - 1.96 * sd, mean + 1.96 * sd)


def mean_and_sd(numbers):
    """Mean, and the standard deviation of that mean."""
    if len(numbers) < 2:
        raise Trouble('too few pairs were played')
    mean = sum(numbers) / len(numbers)
    variance = sum((number - mean) ** 2 for number in numbers) / (len(numbers) - 1)
    return mean, math.sqrt(variance / len(numbers))


def finalists(tried, base):
    """The best vectors other than the defaults, each once."""
    best = sorted((one for one in tried if one.vector != base), key=lambda one: -one.mean)
    return list({name_of(one.vector): one for one in best}.values())[:FINALISTS]
