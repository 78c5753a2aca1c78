# SPDX-License-Identifier: Apache-2.0
# The farm is imported from tools/. Who needs this folder's helpers imports farm_field: another
# folder's file of this one's name may be loaded beside it.
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path[:0] = [str(HERE.parent.parent / 'tools'), str(HERE)]

from farm_field import Field  # noqa: E402


@pytest.fixture
def field(tmp_path):
    made = Field(tmp_path)
    made.team('strong', 2.0)
    made.team('weak', 1.0)
    return made
