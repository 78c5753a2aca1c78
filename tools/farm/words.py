# SPDX-License-Identifier: Apache-2.0
"""What the farm tells people: lines of text from a test's state, and nothing else."""

import math
import time

from farm.sprt import ACCEPTED, BOUND, OPEN
from farm.plan import SCORE, is_void
from farm.work import IMAGES, PERCEPTS, PHYSICAL

WORLD_WORDS = {PERCEPTS: 'no images', IMAGES: 'from images', PHYSICAL: 'bodies with masses'}
UNITS = {'score': 'of a match', 'goals': 'goals a match', 'value': 'of a match'}


def question(plan):
    first, second = plan.names
    return (f'{first} against {second}, {played(plan)}: is the mean {plan.by} of {first} '
            f'{plan.low:g} or {plan.high:g}?')


def played(plan):
    rules = '' if plan.rules == '2006' else f', rules of {plan.rules}'
    if plan.scenes:
        return f"scenes ({', '.join(plan.scenes)}), {WORLD_WORDS[plan.world]}{rules}"
    return f'{plan.minutes:g} min, {plan.robots}, {WORLD_WORDS[plan.world]}{rules}'


def search(asked, found):
    return (f'{asked.sampler} over {len(found)} constants, {asked.trials} vectors, {asked.pairs} '
            f"pairs against each of {', '.join(asked.pool)}; {played(asked.plan)}; by "
            f'{asked.plan.by}, from seed {asked.plan.seed}')


def tried(number_of, one):
    return f'vector {number_of}: {number(one.mean)} +- {one.sd:.2f} {one.folder}'


def gain(champion, asked):
    return (f'{number(champion.gain)} {asked.plan.by} ({number(champion.low)} .. '
            f"{number(champion.high)}) of a {'scene' if asked.plan.scenes else 'match'} over the "
            'defaults, on fresh seeds')


def champion(folder, searched, vector, mean, low, high, at):
    """One line of what it gained, one of how it was found."""
    day = time.strftime('%Y-%m-%d', time.gmtime(at))
    return [f'{day} {folder}: {number(mean)} ({number(low)} .. {number(high)}), {len(vector)} '
            'constants', f'  {searched}']


def number(value):
    return f'{value:+.2f}' if math.isfinite(value) else '?'


def estimate(judged):
    """Mean with the interval that holds at any time."""
    mean, low, high = judged.test.estimate()
    if judged.plan.by == SCORE:
        return f'{mean:.3f} ({max(low, 0.0):.3f} .. {min(high, 1.0):.3f})'
    return f'{number(mean)} ({number(low)} .. {number(high)})'


def remaining(judged):
    pairs = judged.test.remaining()
    return f'about {math.ceil(2.0 * pairs)}' if math.isfinite(pairs) else 'nobody knows how many'


def running(judged):
    """One line after each pair."""
    plan, test = judged.plan, judged.test
    first, second = plan.names
    return (f'pair {judged.pairs}: {first} {judged.goals[0]} : {judged.goals[1]} {second}; '
            f'{plan.by} {estimate(judged)}; LLR {test.llr_now():+.2f} of +-{BOUND:.2f}; '
            f'{remaining(judged)} matches to go')


def decision(judged):
    """What the test has come to."""
    plan, test = judged.plan, judged.test
    if test.decision == OPEN:
        return f'undecided after {judged.pairs} pairs'
    mean = plan.high if test.decision == ACCEPTED else plan.low
    other = plan.low if test.decision == ACCEPTED else plan.high
    return (f'{test.decision} after {judged.pairs} pairs, {2 * judged.pairs} matches: the mean '
            f'{plan.by} of {plan.names[0]} is {mean:g} rather than {other:g}; '
            f'LLR {test.llr:+.2f}; {plan.by} {estimate(judged)} {UNITS[plan.by]}')


def voids(results):
    """The troubles of void matches, each kind once with how often it came."""
    troubles = [result['trouble'] for result in results.values() if is_void(result)]
    return [f'void: {trouble} ({troubles.count(trouble)} x)' for trouble in sorted(set(troubles))]


def speed(times, now):
    """Matches an hour of the last hour, from when they were written."""
    recent = [at for at in times if at > now - 3600.0]
    if len(recent) < 2:
        return ''
    return f'{(len(recent) - 1) * 3600.0 / max(recent[-1] - recent[0], 1e-3):.0f} matches an hour'


def machines(results):
    """How many matches each machine has played."""
    hosts = [result.get('machine', '?').split(':')[0] for result in results.values()]
    return ', '.join(f'{host} {hosts.count(host)}' for host in sorted(set(hosts)))


def status(judged, results, times, now):
    """All of a test."""
    lines = [f'test {judged.plan.id}: {question(judged.plan)}', f'  {running(judged)}',
             f'  {decision(judged)}', f'  {len(results)} matches: {machines(results)}']
    fast = speed(times, now)
    lines += [f'  {fast}'] if fast else []
    return lines + [f'  {line}' for line in voids(results)]
