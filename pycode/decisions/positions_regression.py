# SPDX-License-Identifier: Apache-2.0
# Where who does not play the ball stands, by regression over examples of a person (thesis 2006
# section 4.5.3) in place of trees: from ball, the attacker's direction to it and whether the team
# attacks to places and headings of the defender and of the last robot. Keeps the examples of
# data/examples.py with their mirror images, scaled as checklist G25 says. As good as the
# examples: what nobody wrote down is drawn from what lies near.
import math

import kelpie
from data.examples import EXAMPLES
from lib.geom import clamp, wrap
from lib.regression import Regression

WIDTH = 360.0   # cm,
LENGTH = 540.0  # cm, of the field that the examples are for
SCALES = (0.5 * WIDTH, 0.5 * LENGTH, 90.0, 1.0)
# Of those scales: the four cases of figure 4.7 come out to within 10 cm, and places follow the ball
# without jumps.
BANDWIDTH = 0.42
MARGIN = 20.0                            # cm to the lines, and to the own box


def mirrored(inputs, outputs):
    x, y, angle, attacks = inputs
    dx, dy, dh, sx, sy, sh = outputs
    return ((WIDTH - x, y, -angle, attacks),
            (WIDTH - dx, dy, wrap(180.0 - dh), WIDTH - sx, sy, wrap(180.0 - sh)))


def both_halves(examples) -> list:
    """Headings as their cosine and sine: their mean is a direction, that of 179 and -179 is not."""
    return [(inputs, unrolled(outputs)) for inputs, outputs in
            [*examples, *[mirrored(*row) for row in examples]]]


def unrolled(outputs):
    dx, dy, dh, sx, sy, sh = outputs
    return (dx, dy, *unit(dh), sx, sy, *unit(sh))


def unit(degrees):
    return math.cos(math.radians(degrees)), math.sin(math.radians(degrees))


class RegressedPositions:
    def __init__(self, examples=EXAMPLES):
        self.regression = Regression(both_halves(examples), SCALES, BANDWIDTH)

    def place(self, field, ball, angle, attacks, which) -> tuple:
        """(x, y, heading) of the defender (0) or of the last robot (1), on any field."""
        wide, long = field.width / WIDTH, field.length / LENGTH
        x, y, cosine, sine = self.regression.answer(
            (ball[0] / wide, ball[1] / long, angle, 1.0 if attacks else 0.0), 4 * which,
            4 * which + 4)
        return (clamp(wide * x, MARGIN, field.width - MARGIN),
                clamp(long * y, field.box_depth + MARGIN, field.length - MARGIN),
                math.degrees(math.atan2(sine, cosine)))

    def answer(self, field, ball, angle, attacks) -> tuple:
        """Of both."""
        return tuple([self.place(field, ball, angle, attacks, which) for which in (0, 1)])


def attacker_angle(attacker, ball) -> float:
    """From an attacker at (x, y) to the ball, degrees left of up-field; 0 when it has it."""
    dx, dy = ball[0] - attacker[0], ball[1] - attacker[1]
    return math.degrees(math.atan2(-dx, dy)) if math.hypot(dx, dy) > HAS else 0.0


def attacks(ball, attacker, holds, opponents, field) -> bool:
    """The one bit: the own team has the ball or is nearer to it than any opponent that is known;
    where none is, the ball is in their half."""
    if holds:
        return True
    nearest = min((math.hypot(one.position.x - ball[0], one.position.y - ball[1])
                   for one in opponents), default=None)
    if nearest is None:
        return ball[1] > 0.5 * field.length
    return math.hypot(attacker[0] - ball[0], attacker[1] - ball[1]) < nearest


HAS = 20.0   # cm
PLACE = {kelpie.DEFENDER: 0, kelpie.STRIKER: 1, kelpie.SUPPORTER: 1}
