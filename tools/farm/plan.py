# SPDX-License-Identifier: Apache-2.0
"""What a test is: two teams, the matches between them, and what is to be decided; and what its
results say. Each seed is played twice with colours exchanged; the two together are one pair. Pairs
are judged in the order of their seeds, so that a test is decided by its matches alone, whichever
machines play them and how fast. A pair of which a match is void counts for nothing."""

import hashlib
import json
import math
from pathlib import Path
from typing import NamedTuple

from farm.sprt import OPEN, Bounds, SequentialTest
from farm.store import BLUE, RED
from farm.work import Match, Trouble

SCORE, GOALS, VALUE = 'score', 'goals', 'value'
# A win is 1, a draw 0.5; goals a match; expected goals a match, in which the same lead is less,
# since the value takes both teams for equally good.
USUAL = {SCORE: (0.5, 0.55), GOALS: (0.0, 0.25), VALUE: (0.0, 0.1)}
IN_SCENES = {**USUAL, GOALS: (0.0, 0.02), VALUE: (0.0, 0.004)}   # of 15 to 20 s


class Plan(NamedTuple):
    """`first` and `second` are folders; the test asks whether the first side's mean is `low` or
    `high`. By score: of a match's points; by goals: of its goals less the other's; by value: of the
    `value` that a match's result holds, as red sees it. `scenes`: kinds of situations, one a seed
    in turn, in place of matches of these minutes and robots."""
    first: str
    second: str
    seed: int
    minutes: float
    robots: str
    world: str
    by: str
    low: float
    high: float
    about: str = ''
    scenes: tuple = ()
    rules: str = '2006'

    @property
    def id(self):
        """A test is another one when anything of it is: nobody looks at results first and chooses
        the bounds then."""
        return hashlib.sha256(json.dumps(self).encode()).hexdigest()[:12]

    @property
    def names(self):
        return Path(self.first).name, Path(self.second).name

    @property
    def bounds(self):
        return Bounds(self.low, self.high, self.by == SCORE)

    def match(self, seed, colour):
        """`colour`: of the first side."""
        red, blue = (self.first, self.second) if colour == RED else (self.second, self.first)
        return Match(red, blue, seed, self.minutes, self.robots, self.world, self.about,
                     self.scene(seed), self.rules)

    def scene(self, seed):
        return self.scenes[(seed - self.seed) % len(self.scenes)] if self.scenes else ''


def plan_of(stored):
    try:
        return Plan(**{**stored, 'scenes': tuple(stored['scenes'])})
    except (KeyError, TypeError):
        raise Trouble('a test of another version of the farm') from None


def checked_bounds(by, words, scenes=False):
    """LOW,HIGH as two numbers; `words` may be empty."""
    if not words:
        return (IN_SCENES if scenes else USUAL)[by]
    try:
        low, high = map(float, words.split(','))
    except ValueError:
        raise Trouble(f'--bounds {words}: two numbers, LOW,HIGH') from None
    if not -1e6 <= low < high <= 1e6:
        raise Trouble(f'--bounds {words}: LOW is below HIGH')
    if by == SCORE and not 0.0 < low < high < 1.0:
        raise Trouble(f'--bounds {words}: scores are between 0 and 1')
    return low, high


def figure(result, colour, by):
    """What the side of this colour has of a match."""
    own, others = RED, BLUE
    if colour == BLUE:
        own, others = BLUE, RED
    goals = result[f'{own}_goals'] - result[f'{others}_goals']
    if by == SCORE:
        return 0.5 + 0.5 * ((goals > 0) - (goals < 0))
    if by == GOALS:
        return float(goals)
    if VALUE not in result:
        raise Trouble('the matches of this kelpie have no value: --by score, or goals')
    return result[VALUE] if colour == RED else -result[VALUE]


def is_void(result):
    return bool(result['trouble'])


class Judged:
    """What the results say up to the first seed that lacks one: the sequential test, the goals of
    its pairs, and how many are void. Keeps its place, so that each pair is looked at once."""

    def __init__(self, plan):
        self.plan = plan
        self.test = SequentialTest(plan.bounds)
        self.next_seed = plan.seed
        self.goals = [0, 0]      # of the first side, of the second
        self.voids = 0           # pairs

    @property
    def decided(self):
        return self.test.decision != OPEN

    @property
    def pairs(self):
        """Played, void ones included."""
        return self.next_seed - self.plan.seed

    def take(self, results):
        """Goes on as far as `results` reach. True: there was something new."""
        before = self.next_seed
        while not self.decided:
            both = [results.get((self.next_seed, colour)) for colour in (RED, BLUE)]
            if None in both:
                break
            self.next_seed += 1
            self._judge(*both)
        return self.next_seed > before

    def _judge(self, as_red, as_blue):
        if is_void(as_red) or is_void(as_blue):
            self.voids += 1
            return
        self.goals[0] += as_red['red_goals'] + as_blue['blue_goals']
        self.goals[1] += as_red['blue_goals'] + as_blue['red_goals']
        self.test.add(of_pair(as_red, as_blue, self.plan.by))


def of_pair(as_red, as_blue, by):
    """What the first side has of a seed; not a number where a match is void."""
    if is_void(as_red) or is_void(as_blue):
        return math.nan
    return 0.5 * (figure(as_red, RED, by) + figure(as_blue, BLUE, by))


def estimate_only(plan):
    """The same matches with nothing to decide."""
    return plan._replace(low=0.0, high=0.0)


def matches_to_play(plan, judged, done, most):
    """(seed, colour) of those that are still to be played, in the order of seeds, up to `most`
    pairs of the test. `done`: results and matches under way."""
    for seed in range(judged.next_seed, plan.seed + most):
        for colour in (RED, BLUE):
            if (seed, colour) not in done:
                yield seed, colour
