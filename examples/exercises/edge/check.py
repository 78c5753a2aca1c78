# SPDX-License-Identifier: Apache-2.0
"""Rows of brightness across the edge of a painted line, blurred and noisy, carpet first."""

import math
import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from exercise import checked, report  # noqa: E402



def rows(seed, count=400):
    draw = random.Random(seed)
    for _ in range(count):
        carpet, line = draw.uniform(50.0, 110.0), draw.uniform(130.0, 220.0)
        edge, blur = draw.uniform(12.0, 28.0), draw.uniform(0.8, 2.0)
        share = [1.0 / (1.0 + math.exp(-1.7 * (i - edge) / blur)) for i in range(40)]
        yield edge, [carpet + (line - carpet) * s + draw.gauss(0.0, 6.0) for s in share]


module = checked(__file__)
errors = [abs(module.edge_of(row) - edge) for edge, row in rows(11)]
report("mean error, pixels", sum(errors) / len(errors))
