# SPDX-License-Identifier: Apache-2.0
"""What the checks of all exercises share: the file that is checked, and the line with its figure.
`python3 NAME/check.py` checks NAME/start.py, `python3 NAME/check.py FILE` another file."""

import importlib.util
import math
import signal
import sys
from importlib.machinery import SourceFileLoader
from pathlib import Path

LIMIT_S = 120


def checked(check):
    """The module that is checked; `check` is the __file__ of check.py."""
    path = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(check).parent / "start.py"
    if not path.is_file():
        sys.exit(f"{path}: no such file")
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(path.resolve().parent))
    signal.signal(signal.SIGALRM, lambda *_: sys.exit(f"{path}: not done after {LIMIT_S} s"))
    signal.alarm(LIMIT_S)
    spec = importlib.util.spec_from_loader("checked", SourceFileLoader("checked", str(path)))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def report(what, figure):
    if not math.isfinite(figure):
        sys.exit(f"{what}: {figure}, which is no figure")
    print(f"{what}: {figure:.2f}")
