# SPDX-License-Identifier: Apache-2.0
"""What the checks of all exercises share: the file that is checked, and the line with its figure.
`python3 NAME/check.py` checks NAME/start.py, `python3 NAME/check.py FILE` another file."""

import importlib.util
import sys
from pathlib import Path


def checked(check):
    """The module that is checked; `check` is the __file__ of check.py."""
    path = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(check).parent / "start.py"
    if not path.is_file():
        sys.exit(f"{path}: no such file")
    sys.dont_write_bytecode = True
    spec = importlib.util.spec_from_file_location("checked", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def report(what, figure):
    print(f"{what}: {figure:.2f}")
