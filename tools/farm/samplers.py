# SPDX-License-Identifier: Apache-2.0
"""What vector is tried next: Optuna's tree of Parzen estimators or CMA-ES, or the thesis' hill
climbing (2006, section 7.2.2) to compare them with. Each has asked() -> vector and told(vector,
figure), begins with the defaults, and asks the same again when it is told the same: a search that
was stopped is played through once more out of the farm's stored matches, and needs no storage of
its own."""

import random

from farm.vector import defaults, kept
from farm.work import Trouble

TPE, CMAES, CLIMB = 'tpe', 'cmaes', 'climb'
STEP = 0.15           # sd of a step of the climb, in shares of a constant's range
CHANGED = 3           # constants that a step moves


class Climb:
    """From the best vector so far some constants are moved; what is better is the next best."""

    def __init__(self, found, seed):
        self.found = found
        self.random = random.Random(seed)
        self.best = defaults(found)
        self.figure = None

    def asked(self):
        vector = dict(self.best)
        if self.figure is not None:
            for one in self.random.sample(self.found, min(CHANGED, len(self.found))):
                step = self.random.gauss(0.0, STEP * (one.high - one.low))
                vector[one.key] = kept(one, vector[one.key] + step)
        return vector

    def told(self, vector, figure):
        if self.figure is None or figure > self.figure:
            self.best, self.figure = vector, figure


class Optuna:
    def __init__(self, found, optuna, sampler):
        self.found = found
        self.study = optuna.create_study(sampler=sampler, direction='maximize')
        self.study.enqueue_trial(defaults(found))
        self.under_way = None

    def asked(self):
        self.under_way = self.study.ask()
        return {one.key: kept(one, self._suggested(one)) for one in self.found}

    def _suggested(self, one):
        if one.counts:
            return self.under_way.suggest_int(one.key, one.low, one.high)
        return self.under_way.suggest_float(one.key, one.low, one.high)

    def told(self, _, figure):
        self.study.tell(self.under_way, figure)


def sampler_of(kind, found, seed):
    if kind == CLIMB:
        return Climb(found, seed)
    try:
        import optuna
    except ImportError:
        raise Trouble('a search needs Optuna: tools/install farm') from None
    optuna.logging.set_verbosity(optuna.logging.ERROR)
    samplers = optuna.samplers
    with_seed = (samplers.CmaEsSampler(seed=seed, warn_independent_sampling=False)
                 if kind == CMAES else samplers.TPESampler(seed=seed))
    return Optuna(found, optuna, with_seed)
