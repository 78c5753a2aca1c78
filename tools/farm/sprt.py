# SPDX-License-Identifier: Apache-2.0
"""A test that stops when it knows which of two sides plays better: the sequential probability ratio
test of Wald on paired results. One observation is a seed's two matches, colours exchanged, as the
first side sees them: their mean. Two hypotheses say what that mean is on average, `low` and `high`;
after each pair the logarithm of their likelihoods' ratio (LLR) is looked at, and once it leaves
-BOUND .. BOUND one of them is decided for.

Scores (a win 1, a draw 0.5, a loss 0) make five kinds of pairs, and the ratio is that of the
likeliest distributions over these five with either mean: the pentanomial model of Fishtest (the
generalised test of github.com/official-stockfish/fishtest/wiki/Fishtest-Mathematics, and
M. Van den Bergh's notes there; here the hypotheses are mean scores and not Elo). Figures of any
other kind, goals among them, take the normal form, in which the variance is that of the sample.

It fails where pairs are not independent of each other, and errs more often than ERROR says where
the sample's variance says little yet: below LEAST pairs it decides nothing. Pure: no files, no
clock, no randomness."""

import math
from typing import NamedTuple

ERROR = 0.05     # share of false decisions, on either side
BOUND = math.log((1.0 - ERROR) / ERROR)   # of the LLR: 2.94
LEAST = 16       # pairs before a decision
SCORES = (0.0, 0.25, 0.5, 0.75, 1.0)   # mean score of a pair: its five kinds
SAME = 64        # pairs that are all the same decide: another kind would be less than one in twenty
ALIKE = 1e-6     # of two pairs that are the same: two teams of whom nothing but a rare rule differs
FEW = 4          # pairs unlike the first, without which the sample's variance says nothing
UNSEEN = 1e-3    # pairs that a kind counts for which has not come yet, so that it stays possible
WIDTH = 0.3      # of the running interval: narrowest after some 90 pairs
ACCEPTED, REJECTED, OPEN = 'accepted', 'rejected', 'open'


class Bounds(NamedTuple):
    """The two hypotheses on the mean: rejected means `low`, accepted means `high`."""
    low: float
    high: float
    pentanomial: bool = False     # observations are scores


class Estimate(NamedTuple):
    mean: float
    low: float
    high: float


def likeliest_shares(shares, values, mean):
    """The distribution over `values` that has this mean and under which what was observed is
    likeliest: each share divided by 1 + x (value - mean), with the one x that gives the mean."""
    offsets = [value - mean for value in values]
    low, high = -1.0 / max(offsets), -1.0 / min(offsets)
    x = 0.0
    for _ in range(60):          # Newton's steps, and halves where they lead out
        terms = [o / (1.0 + x * o) for o in offsets]
        excess = sum(p * t for p, t in zip(shares, terms))
        low, high = (x, high) if excess > 0.0 else (low, x)
        step = excess / sum(p * t * t for p, t in zip(shares, terms))
        before, x = x, x + step if low < x + step < high else 0.5 * (low + high)
        if abs(x - before) < 1e-13:
            break
    return [p / (1.0 + x * o) for p, o in zip(shares, offsets)]


def pentanomial_llr(counts, bounds):
    """`counts`: pairs of each of the five kinds, from two losses to two wins."""
    seen = [max(float(count), UNSEEN) for count in counts]
    shares = [count / sum(seen) for count in seen]
    under_low = likeliest_shares(shares, SCORES, bounds.low)
    under_high = likeliest_shares(shares, SCORES, bounds.high)
    return sum(n * math.log(h / l) for n, h, l in zip(seen, under_high, under_low))


def normal_llr(count, mean, variance, bounds):
    if not variance > 0.0:       # nothing is known of the spread, or there is none
        return math.copysign(BOUND if count >= SAME else 0.0,
                             2.0 * mean - bounds.low - bounds.high)
    return (count * (bounds.high - bounds.low) * (2.0 * mean - bounds.low - bounds.high)
            / (2.0 * variance))


def remaining_pairs(llr, mean, variance, bounds):
    """How many more pairs a decision takes on average, if the mean is what it seems to be now: the
    way of a Brownian motion from here to either bound (Wald's identity)."""
    if not variance > 0.0:
        return math.inf
    step = bounds.high - bounds.low
    drift = step * (2.0 * mean - bounds.low - bounds.high) / (2.0 * variance)
    spread = step * step / variance
    down, up = llr + BOUND, BOUND - llr     # to the bounds
    if down <= 0.0 or up <= 0.0:
        return 0.0
    pull = 2.0 * drift / spread
    if abs(pull) * BOUND < 1e-5:            # as good as none: the walk's own spread brings it there
        return down * up / spread
    return (chance_up(pull, down, up) * (down + up) - down) / drift


def chance_up(pull, down, up):
    """That a Brownian motion whose drift is half of `pull` times its variance is first at the upper
    of two bounds. Exponents below 0 alone, which cannot overflow."""
    if pull > 0.0:
        return math.expm1(-pull * down) / math.expm1(-pull * (down + up))
    return math.exp(pull * up) * math.expm1(pull * down) / math.expm1(pull * (down + up))


def interval_at_any_time(count, mean, variance):
    """Holds the true mean in 95 % of tests whenever one looks, also when a test has stopped just
    because its figures looked good: Robbins' mixture of normal distributions, in the form for a
    variance that is estimated (Waudby-Smith and others 2021, "Time-uniform central limit theory").
    Wider than the interval of a fixed number of pairs."""
    if not variance > 0.0:       # nothing is known of the spread
        return Estimate(mean, -math.inf, math.inf)
    scaled = count * WIDTH * WIDTH + 1.0
    half = math.sqrt(2.0 * scaled / (count * WIDTH) ** 2 * math.log(math.sqrt(scaled) / 0.05))
    half *= math.sqrt(variance)
    return Estimate(mean, mean - half, mean + half)


class SequentialTest:
    """A test as it goes on. Keeps how many pairs of each kind, their mean and spread, and the
    decision, which the first pair makes that takes the LLR over a bound; later ones change none of
    it."""

    def __init__(self, bounds):
        self.bounds = bounds
        self.count = 0
        self.mean = 0.0
        self.squares = 0.0       # of the deviations from the mean
        self.others = 0          # pairs that are unlike the first
        self.first = None
        self.counts = [0] * len(SCORES)
        self.llr = 0.0
        self.decision = OPEN

    def add(self, observation):
        """The pairs must come in an order that has nothing to do with how they ended."""
        if self.decision != OPEN:
            return
        self.count += 1
        self.first = observation if self.first is None else self.first
        self.others += abs(observation - self.first) > ALIKE
        change = observation - self.mean
        self.mean += change / self.count
        self.squares += change * (observation - self.mean)
        if self.bounds.pentanomial:
            self.counts[SCORES.index(observation)] += 1
        knows = self.bounds.pentanomial or self.others >= FEW
        if self.count >= (LEAST if knows else SAME):
            self._decide()

    def _decide(self):
        self.llr = self.llr_now()
        if self.llr >= BOUND:
            self.decision = ACCEPTED
        elif self.llr <= -BOUND:
            self.decision = REJECTED

    def llr_now(self):
        if self.bounds.low == self.bounds.high:      # an estimate is wanted, and no decision
            return 0.0
        if self.bounds.pentanomial:
            return pentanomial_llr(self.counts, self.bounds)
        return normal_llr(self.count, self.mean, self.variance, self.bounds)

    @property
    def variance(self):
        return self.squares / (self.count - 1) if self.count > 1 else 0.0

    def estimate(self):
        return interval_at_any_time(self.count, self.mean, self.variance)

    def remaining(self):
        """Pairs; infinite while nothing is known of the spread."""
        if self.decision != OPEN:
            return 0.0
        if not self.variance > 0.0 and self.count >= LEAST:
            return SAME - self.count
        return max(LEAST - self.count,
                   remaining_pairs(self.llr_now(), self.mean, self.variance, self.bounds))
