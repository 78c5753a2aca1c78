# SPDX-License-Identifier: Apache-2.0
"""kelpie farm: matches of two teams on many machines until it is known which plays better. Here are
the words of its commands, and what each of them calls."""

import argparse
import json
import os
import shutil
import signal
import socket
import sqlite3
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
sys.dont_write_bytecode = True

from farm import words  # noqa: E402
from farm.children import Children, scheduler_words, worker_words  # noqa: E402
from farm.cluster import Cluster, check_address, need_dask, own_cluster  # noqa: E402
from farm.plan import GOALS, SCORE, VALUE, Judged, Plan, checked_bounds, plan_of  # noqa: E402
from farm.run import Run  # noqa: E402
from farm.samplers import CLIMB, CMAES, TPE, sampler_of  # noqa: E402
from farm.scaling import scaling  # noqa: E402
from farm.search import Asked, Search  # noqa: E402
from farm.store import RED, Store, is_locked  # noqa: E402
from farm.trust import stored_matches, stored_values, trust  # noqa: E402
from farm.variant import write_variant  # noqa: E402
from farm.vector import described, write_team  # noqa: E402
from farm.work import IMAGES, PERCEPTS, ROOT, WORLDS, Trouble, about, portable  # noqa: E402

DONE, UNDECIDED, WRONG_USE, MACHINE, INTERRUPTED = 0, 1, 2, 3, 130
FILE = 'farm.sqlite'
PORT = 8786                # Dask's own


class Parser(argparse.ArgumentParser):
    """A mistake is one line."""

    def error(self, message):
        raise Trouble(f'{message} (kelpie farm --help)')


def leave(*_):
    """Of who is asked to stop before anything has begun that must be ended."""
    os.write(2, b'kelpie: stopped\n')
    os._exit(INTERRUPTED)


class Stop:
    """Remembers that somebody asked to stop."""

    def __init__(self):
        self.asked = False
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            signal.signal(number, self._ask)

    def _ask(self, *_):
        self.asked = True

    def __call__(self):
        return self.asked


def say(line):
    print(line, file=sys.stderr, flush=True)


def whole(low, high):
    def number(text):
        value = int(text)
        if not low <= value <= high:
            raise argparse.ArgumentTypeError(f'{text}: from {low} to {high}')
        return value
    return number


def figure(low, high):
    def number(text):
        value = float(text)
        if not low <= value <= high:
            raise argparse.ArgumentTypeError(f'{text}: from {low:g} to {high:g}')
        return value
    return number


def workers_here(world):
    """A match from images wants two cores, one without them is one process."""
    cores = len(os.sched_getaffinity(0))
    return cores if world == PERCEPTS else max(1, cores // 2)


def asked_scenes(words, known):
    """Kinds, in the order of `known`; none: matches."""
    kinds = known if words == 'all' else [word for word in words.split(',') if word]
    if words and not kinds:
        raise Trouble(f"--scenes {words}: all, or some of {', '.join(known)}")
    for kind in kinds:
        if kind not in known:
            raise Trouble(f"--scenes {kind}: there are {', '.join(known)}")
    return tuple(kind for kind in known if kind in kinds)


def checked_folders(folders):
    for folder in folders:
        if not folder or not Path(folder).is_dir():
            raise Trouble(f'{folder or "an empty name"}: no such folder')
    return folders


def asked_plan(options):
    checked_folders(options.team)
    low, high = checked_bounds(options.by, options.bounds, bool(options.scenes))
    plan = Plan(*map(portable, options.team), options.seed, options.minutes, options.robots,
                options.world, options.by, low, high, rules=options.rules)
    if plan.names[0] == plan.names[1]:
        raise Trouble(f"both teams are called '{plan.names[0]}'")
    said, scenes = about(plan.match(options.seed, RED))
    return plan._replace(about=said, scenes=asked_scenes(options.scenes, scenes))


def play(options):
    plan = asked_plan(options)
    folder, store = opened_store(options)
    store.begin(plan.id, plan._asdict())
    if options.again:
        store.forget_voids(plan.id)
    cluster, stop = opened_cluster(options, folder)
    say(f'test {plan.id}: {words.question(plan)}')
    run = Run(plan, store, cluster, options.most, say, stop)
    try:
        decided = run.until_decided(lambda judged: say(words.running(judged)))
    finally:
        cluster.close()
    print(words.decision(run.judged))
    for line in words.voids(run.results):
        print(line)
    if stop():
        say('kelpie: stopped; the same command goes on')
        return INTERRUPTED
    return DONE if decided else UNDECIDED


def opened_store(options):
    """(folder, store) to write to, once all else that was asked for is right."""
    if options.scheduler:
        check_address(options.scheduler)
    folder = Path(options.out)
    return folder, Store(folder / FILE, writes=True)


def opened_cluster(options, folder):
    """(cluster, stop). Who only waits for a scheduler elsewhere may be stopped at once."""
    if options.scheduler:
        cluster = Cluster(options.scheduler)
        cluster.open()
        return cluster, Stop()
    stop = Stop()
    return own_cluster(options.workers or workers_here(options.world), folder), stop


def asked_search(options):
    pool = tuple(map(portable, checked_folders(options.pool.split(','))))
    plan = Plan(pool[0], pool[0], options.seed, options.minutes, options.robots, options.world,
                options.by, 0.0, 0.0, rules=options.rules)
    for team in pool:
        _, scenes = about(plan._replace(first=team, second=other_than(team)).match(options.seed,
                                                                                   RED))
    return Asked(plan._replace(scenes=asked_scenes(options.scenes, scenes)), pool, options.pairs,
                 options.trials, options.sampler)


def other_than(folder):
    """Some team of another name, to ask kelpie about."""
    return portable(ROOT / 'teams' / ('thesis' if Path(folder).name == 'kelpie' else 'kelpie'))


def search(options):
    found = described(options.groups)
    asked = asked_search(options)
    folder, store = opened_store(options)
    say(words.search(asked, found))
    sampler = sampler_of(options.sampler, found, options.seed)
    cluster, stop = opened_cluster(options, folder)
    try:
        one = Search(asked, found, folder, store, cluster, say, stop)
        champion = one.run(sampler, lambda number, tried: say(words.tried(number, tried)))
    finally:
        cluster.close()
    if champion is None:
        if stop():
            say('kelpie: stopped; the same command goes on')
            return INTERRUPTED
        print('no vector is another one than the defaults: they stay')
        return UNDECIDED
    named = write_team(champion_folder(folder, store.champions(), champion.vector), found,
                       champion.vector, words.gain(champion, asked))
    champion = champion._replace(folder=str(named))
    store.add_champion(champion, words.search(asked, found))
    print(words.gain(champion, asked))
    print(f'{named}: a team of it; kelpie farm play {named} {asked.pool[0]} decides')
    return DONE


def champion_folder(folder, champions, vector):
    """Another vector's team stays where the history says that it is."""
    taken = {Path(where): its for where, _, its, *_ in champions}
    number, named = 1, folder / 'champion'
    while taken.get(named, vector) != vector:
        number += 1
        named = folder / f'champion-{number}'
    return named


def history(options):
    store = Store(Path(options.out) / FILE)
    for row in store.champions():
        print('\n'.join(words.champion(*row)))
    for test, stored, _ in store.tests():
        plan = plan_of(stored)
        if plan.low < plan.high:
            judged = Judged(plan)
            judged.take(store.results(test))
            print(f'test {test}: {words.question(plan)}\n  {words.decision(judged)}')
    return DONE


def status(options):
    path = Path(options.out) / FILE
    store = Store(path)
    print('a farm plays' if is_locked(path) else 'no farm plays now')
    for test, stored, _ in store.tests():
        plan = plan_of(stored)
        if plan.low == plan.high:      # a vector of a search
            continue
        results = store.results(test)
        judged = Judged(plan)
        judged.take(results)
        print('\n'.join(words.status(judged, results, store.times(test), time.time())))
    return DONE


def serve(options, commands):
    """Keeps processes alive until somebody stops it."""
    need_dask()
    folder = Path(options.out)
    folder.mkdir(parents=True, exist_ok=True)
    stop = Stop()
    children = Children(folder / 'cluster.log', commands)
    try:
        while not stop():
            children.keep_alive()
            time.sleep(0.5)
    finally:
        children.end()
    return DONE


def check_free(host, port):
    """A scheduler that cannot listen says so in its log alone."""
    try:
        socket.create_server((host, port)).close()
    except OSError as error:
        raise Trouble(f'tcp://{host}:{port}: {error.strerror or error}') from None


def scheduler(options):
    check_free(options.host, options.port)
    say(f'workers and farms of this network: tcp://{options.host}:{options.port}')
    return serve(options, [scheduler_words(options.host, options.port)])


def worker(options):
    check_address(options.scheduler)
    folder = Path(options.out)
    return serve(options, [worker_words(options.scheduler, options.host, folder / f'worker-{i}')
                           for i in range(options.workers or workers_here(IMAGES))])


def show_trust(options):
    low, high = checked_bounds(options.by, options.bounds)
    matches = (stored_values if options.by == VALUE else stored_matches)(options.results)
    print(json.dumps(trust(matches, options.by, low, high, options.runs, options.seed), indent=1))
    return DONE


def show_scaling(options):
    for workers in options.workers:
        print(json.dumps(scaling(workers, options.seconds)), flush=True)
    return DONE


def named_folder(text):
    if not text:
        raise argparse.ArgumentTypeError('a folder')
    return text


def add_search(commands):
    command = commands.add_parser('search', help='searches the constants of the behaviours')
    command.set_defaults(run=search)
    command.add_argument('--pool', default='teams/kelpie,teams/thesis', metavar='TEAM,TEAM',
                         help='folders of the teams that each vector plays')
    command.add_argument('--trials', type=whole(1, 100000), default=100, help='vectors (100)')
    command.add_argument('--pairs', type=whole(2, 100000), default=26,
                         help='of each vector against each team (26)')
    command.add_argument('--sampler', choices=(TPE, CMAES, CLIMB), default=TPE,
                         help="Optuna's two, or the thesis' hill climbing")
    command.add_argument('--groups', default='', metavar='GROUP,GROUP',
                         help='of behaviour/constants.toml (all)')
    command.add_argument('--by', choices=(SCORE, GOALS, VALUE), default=VALUE)
    add_world(command, 'all')
    add_workers(command)


def add_world(command, scenes):
    """What is played, and with which seeds."""
    command.add_argument('--minutes', type=figure(0.1, 60.0), default=10.0)
    command.add_argument('--seed', type=whole(0, 8000000000000000), default=1)
    command.add_argument('--robots', default='4v4')
    command.add_argument('--rules', choices=('2005', '2006'), default='2006',
                         help='of holding the ball: 3 s, or 3 s and 50 cm')
    command.add_argument('--world', choices=tuple(WORLDS), default=PERCEPTS,
                         help='matches without images (percepts), from images, or from images on '
                         'bodies with masses (physical)')
    command.add_argument('--scenes', default=scenes, metavar='KINDS',
                         help='all, or kinds as corner,edge: situations in place of matches, one a '
                         'seed in turn (kelpie play --scene)')
    command.add_argument('--scheduler', default='', metavar='tcp://HOST:PORT',
                         help='plays on the workers of that one, and not by itself')


def add_play(commands):
    command = commands.add_parser('play', help='plays two teams until it is known which is better')
    command.set_defaults(run=play)
    command.add_argument('team', nargs=2, help='folders of two teams; the test is of the first')
    command.add_argument('--by', choices=(SCORE, GOALS, VALUE), default=SCORE,
                         help='points of a match, goals, or the value of its result')
    command.add_argument('--bounds', default='', metavar='LOW,HIGH',
                         help='the two means to decide between (score 0.5,0.55; goals 0,0.25)')
    add_world(command, '')
    command.add_argument('--most', type=whole(1, 1000000), default=2000, metavar='PAIRS',
                         help='gives up after so many (2000)')
    command.add_argument('--again', action='store_true', help='plays void matches once more')
    add_workers(command)


def add_workers(command):
    command.add_argument('--workers', type=whole(1, 256), default=0,
                         help='matches at a time here (one a core; from images one for two)')


def add_cluster(commands):
    command = commands.add_parser('scheduler', help='what workers and farms of machines meet at')
    command.set_defaults(run=scheduler)
    command.add_argument('--host', default='127.0.0.1', help='address to listen at (127.0.0.1)')
    command.add_argument('--port', type=whole(1, 65535), default=PORT)
    command = commands.add_parser('worker', help='plays matches for a scheduler')
    command.set_defaults(run=worker)
    command.add_argument('scheduler', metavar='tcp://HOST:PORT')
    command.add_argument('--host', default='', help='address of this machine in the network')
    add_workers(command)


def variant(options):
    rules = [rule for rule in options.without.split(',') if rule]
    folder = write_variant(options.team, rules, options.set)
    try:
        about(Plan(portable(folder), other_than(folder), 0, 1.0, '4v4', PERCEPTS, SCORE, 0.0,
                   0.0).match(0, RED))
    except Trouble:
        shutil.rmtree(folder)
        raise
    print(folder)
    return DONE


def add_variant(commands):
    command = commands.add_parser('variant', help='makes a team that is Kelpie but for some rules')
    command.set_defaults(run=variant)
    command.add_argument('team', metavar='FOLDER', help='a new one')
    command.add_argument('--without', default='', metavar='RULE,RULE',
                         help="rules of pycode/lib/rulebook.py that are the theses' there")
    command.add_argument('--set', action='append', default=[], metavar='KEY=NUMBER',
                         help='a switch of [behaviour.task]')


def add_figures(commands):
    command = commands.add_parser('trust', help='how often the test errs, by stored matches')
    command.set_defaults(run=show_trust)
    command.add_argument('results', help='a farm.sqlite, or the league.jsonl of two teams')
    command.add_argument('--by', choices=(SCORE, GOALS, VALUE), default=SCORE)
    command.add_argument('--bounds', default='', metavar='LOW,HIGH')
    command.add_argument('--runs', type=whole(1, 100000), default=200)
    command.add_argument('--seed', type=int, default=1)
    command = commands.add_parser('scaling', help='what the farm costs with many workers')
    command.set_defaults(run=show_scaling)
    command.add_argument('workers', nargs='+', type=whole(1, 5000))
    command.add_argument('--seconds', type=figure(0.01, 3600.0), default=30.0, help='of a match')


def parser():
    made = Parser(prog='kelpie farm', description=__doc__.split('. ')[0] + '.')
    commands = made.add_subparsers(required=True, metavar='COMMAND', parser_class=Parser)
    add_play(commands)
    add_search(commands)
    commands.add_parser('history', help='champions, and what was decided').set_defaults(run=history)
    commands.add_parser('status', help='what the tests have come to').set_defaults(run=status)
    add_cluster(commands)
    add_variant(commands)
    add_figures(commands)
    for command in commands.choices.values():
        command.add_argument('--out', default='out/farm', metavar='FOLDER', type=named_folder,
                             help='of results and logs (out/farm)')
    return made


def joined(arguments):
    """The same, with --bounds and what follows as one word: a bound may begin with a minus."""
    if '--bounds' not in arguments[:-1]:
        return arguments
    at = arguments.index('--bounds')
    return [*arguments[:at], f'--bounds={arguments[at + 1]}', *arguments[at + 2:]]


def main():
    signal.signal(signal.SIGINT, leave)
    try:
        options = parser().parse_args(joined(sys.argv[1:]))
        return options.run(options)
    except Trouble as trouble:
        say(f'kelpie: {trouble}')
        return WRONG_USE
    except (OSError, sqlite3.Error) as error:
        say(f'kelpie: {error}')
        return MACHINE


if __name__ == '__main__':
    sys.exit(main())
