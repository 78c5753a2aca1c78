# SPDX-License-Identifier: Apache-2.0
"""Processes that serve the farm and end with it. Keeps their commands and starts again whoever has
ended; the kernel kills them when the farm is killed. What they print goes to one file."""

import os
import socket
import subprocess
import sys
import time
from pathlib import Path

TOOLS = Path(__file__).resolve().parents[1]
REST = 1.0       # s before a process is started again, so that one that cannot live costs little
GRACE = 3.0      # s to end by itself
# Dask looks at itself a hundred times a second; the cores are for the matches.
SETTINGS = {'distributed.worker.profile.enabled': False,
            'distributed.admin.tick.interval': '1s',
            'distributed.admin.system-monitor.interval': '10s',
            'distributed.logging.distributed': 'warning'}
PAGES = ['--no-dashboard', '--dashboard-address', '127.0.0.1:0']   # that Dask serves all the same
ENVIRONMENT = {'PYTHONPATH': str(TOOLS), 'PYTHONDONTWRITEBYTECODE': '1', **{
    'DASK_' + name.replace('.', '__').replace('-', '_').upper(): str(value)
    for name, value in SETTINGS.items()}}


def free_port(host='127.0.0.1'):
    with socket.socket() as tried:
        tried.bind((host, 0))
        return tried.getsockname()[1]


def scheduler_words(host, port):
    return ['-m', 'distributed.cli.dask_scheduler', '--host', host, '--port', str(port),
            *PAGES, '--no-show']


def worker_words(address, host, folder):
    words = ['-m', 'distributed.cli.dask_worker', address, '--no-nanny', '--nthreads', '1',
             *PAGES, '--memory-limit', '0', '--death-timeout', '20',
             '--local-directory', str(folder)]
    return words + (['--host', host] if host else [])


class Children:
    """`commands`: words for Python, one list a process; none runs before keep_alive()."""

    def __init__(self, log, commands):
        self.log = open(log, 'ab')
        self.commands = [[sys.executable, *words] for words in commands]
        self.running = [None] * len(commands)
        self.started = [-REST] * len(commands)   # s

    def _start(self, command):
        return subprocess.Popen(['setpriv', '--pdeathsig', 'KILL', *command],
                                env={**os.environ, **ENVIRONMENT}, stdin=subprocess.DEVNULL,
                                stdout=self.log, stderr=self.log, start_new_session=True)

    def keep_alive(self):
        """To be called now and then."""
        for i, process in enumerate(self.running):
            ended = process is None or process.poll() is not None
            if ended and time.monotonic() > self.started[i] + REST:
                self.running[i] = self._start(self.commands[i])
                self.started[i] = time.monotonic()

    def end(self):
        running = [process for process in self.running if process]
        for process in running:
            process.terminate()
        until = time.monotonic() + GRACE
        for process in running:
            try:
                process.wait(max(0.0, until - time.monotonic()))
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        self.log.close()
