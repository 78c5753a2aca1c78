# SPDX-License-Identifier: Apache-2.0
"""Who plays the matches: the workers of a Dask scheduler, on this machine or on many. A match that
was handed out comes back with its result, or as lost: its worker or the scheduler died. Keeps the
connection and mends it; with a cluster of its own it starts the scheduler and the workers, and
starts again those that die. What is lost is not played again by itself."""

import logging
import queue
import re
import socket
import time

from farm.children import Children, free_port, scheduler_words, worker_words
from farm.work import Trouble, play

try:
    import distributed
except ImportError:
    distributed = None

ADDRESS = re.compile(r'(tcp|tls)://[^/:]+:\d{1,5}')
CONNECTING = 30.0      # s of waiting for a scheduler
ONE_TRY = 5.0          # s of each try; a client that never connected waits twice that at its end
LOOK = 2.0             # s between looks at how many workers there are


def check_address(address):
    if not ADDRESS.fullmatch(address) or int(address.rsplit(':', 1)[1]) > 65535:
        raise Trouble(f'{address}: tcp://HOST:PORT or tls://HOST:PORT')


def need_dask():
    if distributed is None:
        raise Trouble('the farm needs Dask: tools/install farm')


class Cluster:
    def __init__(self, address, children=None, player=play):
        """`children`: those of a cluster of one's own, which are ended with it. `player` plays a
        match on a worker."""
        check_address(address)
        need_dask()
        logging.disable(logging.CRITICAL)     # what goes wrong is mended, or told in one line
        self.address = address
        self.children = children
        self.player = player
        self.client = None
        self.flying = {}           # by key: Dask's future, if it took the match
        self.landed = queue.Queue()   # (client, key)
        self.looked = -LOOK
        self.workers = 0
        self.broken = False

    def open(self):
        """Waits until there is a scheduler. Before it nothing else can be asked."""
        until = time.monotonic() + CONNECTING
        while self.client is None:
            self._keep_children()
            try:
                self._try_to_open()
            except OSError as error:
                if time.monotonic() > until:
                    raise Trouble(f'no scheduler answers at {self.address}: {error}') from None
                time.sleep(0.1)

    def _try_to_open(self):
        """Only where something listens does Dask try, whose failed tries leave threads behind."""
        host, port = self.address.split('://')[1].rsplit(':', 1)
        socket.create_connection((host, int(port)), timeout=2.0).close()
        self.client = distributed.Client(self.address, timeout=ONE_TRY, set_as_default=False)

    def _keep_children(self):
        if self.children:
            self.children.keep_alive()

    def capacity(self):
        """Matches at a time: one for each worker."""
        if self.client and time.monotonic() > self.looked + LOOK:
            self.looked = time.monotonic()
            info = self._asked(lambda client: client.scheduler_info())
            self.workers = len(info['workers']) if info else 0
        return self.workers

    def _asked(self, call):
        """What Dask answers; nothing when it cannot, whatever it calls that: it is mended then."""
        try:
            return call(self.client)
        except Exception:  # pylint: disable=broad-except
            self.broken = True
            return None

    def submit(self, key, match, attempt):
        client = self.client
        name = f'match-{key[0]}-{key[1]}-{attempt}-{time.time_ns()}'
        future = self._asked(lambda client: client.submit(self.player, tuple(match), key=name,
                                                          pure=False))
        self.flying[key] = future
        if future:
            future.add_done_callback(lambda _: self.landed.put((client, key)))

    def finished(self, seconds):
        """[(key, result)] of what has come back within that time; no result: lost."""
        self._keep_children()
        back = self._mended()
        try:
            while True:
                client, key = self.landed.get(timeout=0.0 if back else seconds)
                if client is self.client and key in self.flying:
                    back.append((key, self._result(self.flying.pop(key))))
        except queue.Empty:
            return back

    def _result(self, future):
        """What a worker cannot give any more, because it died, is lost, whatever Dask calls it."""
        if future.status != 'finished':
            return None
        try:
            result = future.result(timeout=10.0)
        except Exception:  # pylint: disable=broad-except
            return None
        return result if isinstance(result, dict) and 'trouble' in result else None

    def _mended(self):
        """With another connection all that was under way is lost."""
        states = [future.status for future in self.flying.values() if future]
        if not (self.broken or self.client.status != 'running' or 'cancelled' in states
                or 'lost' in states):
            return []
        lost = [(key, None) for key in self.flying]
        self.flying.clear()
        self._disconnect()
        self.broken = False
        self.open()
        return lost

    def _disconnect(self):
        client, self.client = self.client, None
        if client:
            try:
                client.close(timeout=1.0)
            except Exception:  # pylint: disable=broad-except
                client.status = 'closed'   # it was broken; else its end waits for it once more
        self.looked = -LOOK

    def close(self):
        self._disconnect()
        if self.children:
            self.children.end()


def own_cluster(workers, folder):
    """A scheduler and workers of this machine, which no other machine can reach."""
    port = free_port()
    address = f'tcp://127.0.0.1:{port}'
    commands = [scheduler_words('127.0.0.1', port)]
    commands += [worker_words(address, '127.0.0.1', folder / f'worker-{number}')
                 for number in range(workers)]
    return Cluster(address, Children(folder / 'cluster.log', commands))
