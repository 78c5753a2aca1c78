# SPDX-License-Identifier: Apache-2.0
# Where who does not play the ball stands, by the trees of thesis 2006 section 4.5.2 (algorithms 4.7
# to 4.9; misprints: checklist G20, G22). Plain functions from a ball on the field to a place on it,
# in cm. BallOnString keeps the ball that they are asked for: the places jump by 80 to 220 cm where
# zones meet, and a ball that lies there is seen 5 cm to either side. They know no other robot.
import math

import kelpie

CONSTANTS = kelpie.constants.positions  # behaviour/constants.toml: defaults and ranges
STRIKER_SIDE = CONSTANTS.striker_side  # cm from the side line (G21)
BEHIND_BALL = CONSTANTS.behind_ball  # algorithms 4.7 and 4.8: yOffset
LESS_BEHIND = 0.65       # of it, in the middle zone
FRONT = 2.0 / 3.0        # of the length; the text has 0.6 (G19)
SUPPORTER_SIDE = 70.0  # cm
SUPPORTER_MIN_Y = 120.0  # cm
DEFENDER_BEHIND = CONSTANTS.defender_behind  # cm
BEFORE_BOX = 20.0  # cm
DEFENDER_REACH = CONSTANTS.defender_reach  # cm from the middle, at most
DROP_IN_Y = 300.0        # beyond it the defender stands behind the drop-in points,
DROP_IN_SIDE = 0.35      # for a ball in those shares of the width
DROP_IN_X = 50.0  # cm
STRING = 20.0            # cm to either side (facts-2005 section 7.2, side hysteresis)


def striker(field, ball):
    """Algorithm 4.7: on the other side than the ball, and not too far back."""
    x, y = ball
    place_x = STRIKER_SIDE if x > 0.5 * field.width else field.width - STRIKER_SIDE
    half = 0.5 * field.length
    if y < half:
        return place_x, half + BEHIND_BALL
    if y < FRONT * field.length:
        return place_x, max(y - LESS_BEHIND * BEHIND_BALL, half)
    return place_x, min(y - BEHIND_BALL, field.length - BEHIND_BALL)


def supporter(field, ball):
    """Algorithm 4.8: behind the attacker."""
    x, y = ball
    return (min(max(x, SUPPORTER_SIDE), field.width - SUPPORTER_SIDE),
            max(y - BEHIND_BALL, SUPPORTER_MIN_Y))


def defender(field, ball):
    """Algorithm 4.9: between the ball and the own goal, nearer to the middle than the ball."""
    x, y = ball
    middle = 0.5 * field.width
    place_y = max(field.box_depth + BEFORE_BOX, y - DEFENDER_BEHIND)
    if y <= DROP_IN_Y:
        return middle + DEFENDER_REACH * (x - middle) / middle, place_y
    if x < DROP_IN_SIDE * field.width:
        return DROP_IN_X, place_y
    if x > (1.0 - DROP_IN_SIDE) * field.width:
        return field.width - DROP_IN_X, place_y
    return middle + 0.5 * (x - middle), place_y


# By role: the place for a ball, and shares of width and length without one.
PLACES = {kelpie.STRIKER: striker, kelpie.SUPPORTER: supporter, kelpie.DEFENDER: defender}
WITHOUT_BALL = {kelpie.STRIKER: (0.7, 0.65), kelpie.SUPPORTER: (0.5, 0.4),
                kelpie.DEFENDER: (0.5, 0.22)}


class BallOnString:
    """Follows a ball on a string."""

    def __init__(self):
        self.at = None

    def update(self, ball, string=STRING):
        """The place of the followed ball, at most so many cm behind it; `ball` None leaves it."""
        if ball is None or self.at is None:
            self.at = ball if self.at is None else self.at
            return self.at
        dx, dy = ball[0] - self.at[0], ball[1] - self.at[1]
        away = math.hypot(dx, dy)
        if away > string:
            share = (away - string) / away
            self.at = self.at[0] + share * dx, self.at[1] + share * dy
        return self.at
