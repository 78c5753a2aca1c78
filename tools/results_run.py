# SPDX-License-Identifier: Apache-2.0
"""What tools/results and tools/figures share: the built programs, one run with one seed as a job,
and many jobs at a time. A job that fails says the last line of its command."""

import concurrent.futures
import datetime
import json
import os
import re
import signal
import subprocess
import time
from pathlib import Path

from results_data import Missing, Refused, Tree, command_of, words_of

ROOT = Path(__file__).resolve().parent.parent
BIN = Path(os.environ.get("KELPIE_BIN", ROOT / "build/host/bin"))
# Programs read these from the tree while they run: a change needs no build.
READ_AT_RUN_TIME = ("pycode", "teams")


class Programs:
    """The built programs and the commit of which they are."""

    def __init__(self, tree):
        for name in ("kelpie", "kelpie-experiments", "kelpie-agent", "kelpie-world",
                     "kelpie-percepts"):
            if not os.access(BIN / name, os.X_OK):
                raise Refused(f"{BIN / name} is not built: tools/build host {name}")
        said = subprocess.run([BIN / "kelpie", "--version"], capture_output=True, text=True,
                              check=False).stdout
        found = re.search(r"commit ([\w-]+)", said)
        self.commit = found[1] if found else "unknown"
        self.tree = tree
        # Of programs that were built with changes nothing can tell which changes these were.
        self.built = None if self.commit.endswith("-dirty") else Tree(ROOT, self.commit)

    def commit_of(self, paths):
        """The commit to write beside figures; refuses programs that are not of this tree."""
        if self.built is None:
            return self.commit
        differ = [path for path in paths if self.built.digest(path) != self.tree.digest(path)]
        older = [path for path in differ if path not in READ_AT_RUN_TIME]
        if older:
            raise Refused(f"the programs are of {self.commit}, from which the tree differs in "
                          f"{' '.join(older)}: tools/build host")
        return self.commit + ("-dirty" if differ else "")


class Job:
    """One run with one seed, and the file that keeps its whole figures."""

    def __init__(self, name, run, seed, made_by, folder):
        self.name, self.seed = name, seed
        self.seconds, self.alone = run.get("seconds", 0), run.get("alone", False)
        self.path = folder / f"{name}-{seed}.json"
        self.words, self.what = words_of(run, seed), run.get("experiment", name)
        self.made_by = {"command": command_of(run, seed), "seed": seed, **made_by}

    def kept(self):
        """The figures in the file; None where it holds none of this command and these files."""
        try:
            figures = json.loads(self.path.read_text())
            made_by = figures["made_by"]
            fits = all(made_by[field] == self.made_by[field] for field in ("command", "files"))
        except (OSError, ValueError, KeyError, TypeError):
            return None
        return figures if fits else None

    def measure(self, running):
        part = self.path.with_suffix(".part")
        program = BIN / "kelpie" if self.words[0] == "kelpie" else ROOT / self.words[0]
        process = subprocess.Popen([program, *self.words[1:], "--json", part],
                                   stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, text=True, cwd=ROOT)
        running.add(process)
        said = process.stderr.read().strip()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        running.discard(process)
        if process.returncode != 0:
            part.unlink(missing_ok=True)
            last = said.splitlines()[-1] if said else f"ended with {process.returncode}"
            raise Missing(last.removeprefix("kelpie: ").removeprefix(f"{self.what}: "))
        figures = json.loads(part.read_text())
        figures["made_by"] = {**self.made_by, "date": datetime.date.today().isoformat(),
                              "cpu_s": round(usage.ru_utime + usage.ru_stime, 1)}
        part.write_text(json.dumps(figures, indent=1) + "\n")
        part.replace(self.path)
        return figures


def run_jobs(todo, count, ended):
    """Runs the jobs, `count` at a time and the longest ones first, and after them those that time
    by the clock. As each ends, ended(job, its future, how far all are) is called."""
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    todo = sorted(todo, key=lambda job: -job.seconds)
    run_at_once([job for job in todo if not job.alone], count, ended)
    run_at_once([job for job in todo if job.alone], 1, ended)


def run_at_once(todo, count, ended):
    running = set()
    with concurrent.futures.ThreadPoolExecutor(count) as pool:
        started = time.monotonic()
        futures = {pool.submit(job.measure, running): job for job in todo}
        try:
            for done, future in enumerate(concurrent.futures.as_completed(futures), 1):
                ended(futures[future], future, f"{done} of {len(todo)}, after "
                      f"{time.monotonic() - started:.0f} s")
        except KeyboardInterrupt:
            for process in list(running):
                process.terminate()
            pool.shutdown(cancel_futures=True)
            raise
