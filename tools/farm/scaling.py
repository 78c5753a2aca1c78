# SPDX-License-Identifier: Apache-2.0
"""What the farm itself costs with many workers: a real scheduler, real workers and the farm's own
loop, all of them in one process, and matches that only wait as long as a match takes. So the cost
that is found holds for scheduler, workers and farm together, which share a core here and do not
among machines."""

import asyncio
import math
import tempfile
import time
from pathlib import Path

from farm.children import SETTINGS
from farm.cluster import Cluster, need_dask
from farm.plan import Plan
from farm.run import Run
from farm.store import Store
from farm.work import IMAGES

ROUNDS = 4       # matches for each worker


async def wait_as_a_match(match):
    """A match is drawn 1 : 1 after as many minutes as it has."""
    await asyncio.sleep(60.0 * match[3])
    return {'trouble': '', 'red_goals': 1, 'blue_goals': 1, 'machine': 'here'}


def scaling(workers, seconds):
    """How long the matches take, which share of that the workers play, and the processor time of
    scheduler, farm and all workers together for each match."""
    need_dask()
    import dask
    import distributed
    dask.config.set(SETTINGS)
    matches = 2 * math.ceil(ROUNDS * workers / 2)
    with tempfile.TemporaryDirectory() as folder, distributed.LocalCluster(
            n_workers=workers, threads_per_worker=1, processes=False, protocol='tcp://',
            dashboard_address='127.0.0.1:0', memory_limit=0, local_directory=folder) as machines:
        cluster = Cluster(machines.scheduler_address, player=wait_as_a_match)
        cluster.open()
        store = Store(Path(folder) / 'farm.sqlite', writes=True)
        plan = Plan('a', 'b', 1, seconds / 60.0, '4v4', IMAGES, 'score', 0.4999, 0.5001)
        begun, computed = time.monotonic(), time.process_time()
        Run(plan, store, cluster, matches // 2, print, lambda: False).until_decided(lambda _: None)
        took, computed = time.monotonic() - begun, time.process_time() - computed
        cluster.close()
        store.close()
    return {'workers': workers, 'matches': matches, 'seconds': seconds, 'took': round(took, 3),
            'efficiency': round(matches * seconds / (workers * took), 4),
            'overhead_ms': round(1000.0 * computed / matches, 2),
            'cores': round(computed / took, 3)}
