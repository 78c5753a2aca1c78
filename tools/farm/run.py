# SPDX-License-Identifier: Apache-2.0
"""A test as it is played: hands out matches, keeps their results, and ends when the test is
decided. The state that counts is the store's; a farm that was killed goes on from there. It gives
up when nothing but trouble comes back."""

from farm.plan import Judged, is_void, matches_to_play
from farm.work import Trouble

AHEAD = 0.25       # share of matches more than workers that are handed out, so that none waits
WINDOW = 2         # pairs for each worker, and 8, that are played beyond one that is still missing
LOSSES = 10        # times that a match may be lost with its worker before it is void
HOPELESS = 8       # matches in trouble, one after the other
WAIT = 0.5         # s


class Run:
    """`cluster` as in cluster.py; `say` takes lines for people; `stop` says whether to."""

    def __init__(self, plan, store, cluster, most, say, stop):
        self.plan, self.store, self.cluster = plan, store, cluster
        self.most, self.say, self.stop = most, say, stop
        self.results = store.results(plan.id)
        self.judged = Judged(plan)
        self.flying = set()
        self.tries = {}          # how often a match was in trouble
        self.losses = {}         # and how often lost
        self.in_a_row = 0        # matches in trouble

    def until_decided(self, tell):
        """`tell(judged)` after each pair. True: decided; false: as many pairs as were allowed, or
        stopped."""
        while not self._is_over(tell):
            if self.cluster.client is None:
                self.cluster.open()
            self._fill()
            for key, result in self.cluster.finished(WAIT):
                self._land(key, result)
        return self.judged.decided

    def _is_over(self, tell):
        if self.judged.take(self.results):
            tell(self.judged)
        return self.judged.decided or self.judged.pairs >= self.most or self.stop()

    def _fill(self):
        workers = self.cluster.capacity()
        room = 1 + int(workers * (1.0 + AHEAD)) - len(self.flying)
        if room <= 0:
            return
        done = self.results.keys() | self.flying
        most = min(self.most, self.judged.pairs + WINDOW * workers + 8)
        for key in matches_to_play(self.plan, self.judged, done, most):
            attempt = self.tries.get(key, 0) + self.losses.get(key, 0)
            self.cluster.submit(key, self.plan.match(*key), attempt)
            self.flying.add(key)
            room -= 1
            if room == 0:
                return

    def _land(self, key, result):
        self.flying.discard(key)
        if result is None:
            result = self._lost(key)
        elif is_void(result):
            result = self._in_trouble(key, result)
        else:
            self.in_a_row = 0
        if result and self.store.add(self.plan.id, *key, result):
            self.results[key] = result

    def _lost(self, key):
        """Nothing, so that it is played again; or that it is void."""
        self.losses[key] = self.losses.get(key, 0) + 1
        if self.losses[key] < LOSSES:
            return None
        return {'trouble': f'its worker died {LOSSES} times'}

    def _in_trouble(self, key, result):
        """Once more, then it is void."""
        self.in_a_row += 1
        self.tries[key] = self.tries.get(key, 0) + 1
        if self.in_a_row >= HOPELESS:
            raise Trouble(f"{HOPELESS} matches in a row failed: {result['trouble']}")
        if self.tries[key] > 1:
            return result
        self.say(f"once more, seed {key[0]}: {result['trouble']}")
        return None
