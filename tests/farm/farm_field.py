# SPDX-License-Identifier: Apache-2.0
# A folder in which a test farms, with fake_kelpie, to which a team is a number.
import os
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
MAIN = ROOT / 'tools/farm/main.py'
FAKE = HERE / 'fake_kelpie'


class Field:
    """A folder with teams, the farm's results and the list of what was played."""

    def __init__(self, folder):
        self.folder = folder
        self.played = folder / 'played'
        self.played.touch()

    def team(self, name, strength):
        (self.folder / name).mkdir(exist_ok=True)
        (self.folder / name / 'strength').write_text(str(strength))

    def environment(self, **more):
        return {**os.environ, 'KELPIE_PROGRAM': str(FAKE), 'FAKE_PLAYED': str(self.played), **more}

    def farm(self, *words, **more):
        return subprocess.run([sys.executable, MAIN, *map(str, words)], capture_output=True,
                              text=True, cwd=self.folder, env=self.environment(**more),
                              timeout=120, check=False)

    def start(self, *words, **more):
        return subprocess.Popen([sys.executable, MAIN, *map(str, words)], cwd=self.folder,
                                env=self.environment(**more), stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True)

    def matches_played(self):
        return self.played.read_text().split('\n')[:-1]
