# SPDX-License-Identifier: Apache-2.0
"""A ball that rolls along a line and is slowed by the carpet, seen thirty times a second."""

import math
import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from exercise import checked, report  # noqa: E402

FRAME_S, SLOWED = 1.0 / 30.0, 25.0  # s; cm/s each second


def rolls(seed, count=60):
    """True places and seen ones of each roll; None where the ball was hidden."""
    draw = random.Random(seed)
    for _ in range(count):
        place, speed = draw.uniform(-200.0, 0.0), draw.uniform(40.0, 150.0)
        truth, seen = [], []
        for _ in range(90):
            place, speed = place + speed * FRAME_S, max(0.0, speed - SLOWED * FRAME_S)
            truth.append(place)
            seen.append(None if draw.random() < 0.2 else draw.gauss(place, 8.0))
        yield truth, seen


module, squares = checked(__file__), []
for truth, seen in rolls(5):
    ball = module.Ball()
    for i, (true, z) in enumerate(zip(truth, seen)):
        told = ball.step(z)
        if i >= 10:
            squares.append((told - true) ** 2)
report("root mean square error, cm", math.sqrt(sum(squares) / len(squares)))
