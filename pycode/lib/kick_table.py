# SPDX-License-Identifier: Apache-2.0
# What a kick will do with the ball, read from the kick map (data/kick_map.py), and with what chance
# that makes a goal. Places in cm in the robot frame, directions in degrees left of straight ahead,
# both as the kick's motion begins; a walking robot goes on till then (at_kick). An outcome is a
# tuple: chance that the ball goes, its direction, standard deviation (sd), how far it rolls in cm,
# sd; direction and distance are of balls that go. A place that is 1 cm off is in the sd. Keeps
# nothing. Fails for a ball that still rolls.
import math

import kelpie
from data import kick_map
from lib.geom import Point, clamp, polar, wrap

Outcome = tuple[float, float, float, float, float]

LEFT_OF = {kick: its.mirror for kick, its in kelpie.KICKS.items() if its.mirror < kick}
RIGHT_OF = {left: right for right, left in LEFT_OF.items()}
NOTHING = (0.0, 0.0, 0.0, 0.0, 0.0)
BALL_RADIUS = 4.2   # cm
SD_FLOOR = 2.0      # deg, and cm: no kick is surer than that
TAIL = 3.5          # sd: what lies farther off, 0.05 %, is left out
SLICE = 6.0         # deg of direction over which the way to the goal line changes little


def kicks(held) -> list:
    """The motions that the map knows, for a held ball or for one that lies free."""
    known = list(kick_map.HELD if held else kick_map.STANDING)
    return known + [RIGHT_OF[kick] for kick in known if kick in RIGHT_OF]


def at_kick(x, y, forward, left, turn_deg) -> tuple:
    """Where a resting ball that is at (x, y) as the kick is asked for will be as its motion begins,
    and how far the robot will have turned by then (deg), walking on at those cm/s and deg/s."""
    turn = turn_deg * kick_map.UNTIL_KICK
    lateral, ahead = polar(1.0, 0.5 * turn)
    forward, left = forward * kick_map.UNTIL_KICK, left * kick_map.UNTIL_KICK
    x, y = x - forward * lateral + left * ahead, y - forward * ahead - left * lateral
    angle = math.radians(turn)
    return (x * math.cos(angle) + y * math.sin(angle),
            y * math.cos(angle) - x * math.sin(angle), turn)


def outcome(kick, x, y, walking=False) -> Outcome | None:
    """Of a free ball that lies there; None outside the map, or where no ball can lie. walking: the
    robot walks until the motion begins, else it stands.

    Bilinear between the map's places. Each counts for direction and distance by the share of its
    balls that went: from where none goes, nothing is known of where they would have gone."""
    grid = _table(False, walking).get(LEFT_OF.get(kick, kick))
    if grid is None:
        return None
    side = -1.0 if kick in LEFT_OF or (kick not in RIGHT_OF and x < 0.0) else 1.0
    column, right = _between(grid['aside'], side * x)
    row, further = _between(grid['ahead'], y)
    if column is None or row is None:
        return None
    corners = []
    for i, row_share in ((row, 1.0 - further), (row + 1, further)):
        for j, column_share in ((column, 1.0 - right), (column + 1, right)):
            if row_share * column_share > 0.0:
                corners.append((row_share * column_share, grid['places'][i][j]))
    if any(cell is None for _, cell in corners):
        return None
    return _mirrored(_mean(corners), side)


def held_outcome(kick) -> Outcome | None:
    """Of a ball in the hold; None for a kick that is not made from there."""
    data = kick_map.HELD.get(LEFT_OF.get(kick, kick))
    return data and _measured(data['whole'], _side(kick))


def best_place(kick, walking=False) -> Point:
    """Where a free ball should lie: where the kick does best, and the places about it as well."""
    x, y = _data(kick, False, walking)['best']
    return _side(kick) * x, y


def window(kick, walking=False) -> tuple:
    """The places about the best one from where at least 80 % of the balls go about the same way:
    least x, least y, most x, most y."""
    (left, near), (right, far) = _data(kick, False, walking)['window']
    return (left, near, right, far) if _side(kick) > 0.0 else (-right, near, -left, far)


def window_outcome(kick, walking=False) -> Outcome:
    """Of a free ball that lies anywhere in the kick's window."""
    return _measured(_data(kick, False, walking)['whole'], _side(kick))


def way(kick, held) -> float:
    """deg to the left that the kick sends the ball; as its hint says, or ahead, where the map does
    not know it."""
    if kick in kicks(held):
        return (held_outcome(kick) if held else window_outcome(kick))[1]
    hint = kelpie.KICKS[kick].hint
    return hint[1] if hint else 0.0


def frames(kick, held=False) -> int:
    """Of 1/30 s, that the motion takes."""
    return _data(kick, held)['frames']


def turn_way(kick, held=False, walking=False) -> tuple:
    """Where the robot is after the kick, in the frame that it was asked in: right, ahead, degrees
    that it has turned to the left."""
    right, ahead, turn = _data(kick, held, walking)['way']
    side = _side(kick)
    return side * right, ahead, side * turn


def chance_of_rolling(outcome, distance) -> float:
    """That a ball that goes gets at least so far, in cm."""
    return 1.0 - _normal((distance - outcome[3]) / max(outcome[4], SD_FLOOR))


def chance_of_goal(pose, ball, outcome, field, gap=None, blocked=(), heading_sd=0.0) -> float:
    """That the ball, kicked from its place on the field (x, y), rolls into the opponents' goal.

    pose: of the robot as it kicks, heading_sd of it in degrees. gap: the only directions that are
    free, (low, high) in degrees left of ahead; None: all. blocked: directions that are not, a list
    of such pairs, of opponents and the goalie. The ball has to get over the line as a whole."""
    chance, direction, sd, distance, distance_sd = outcome
    sd = max(math.hypot(sd, heading_sd), SD_FLOOR)
    to_line = max(field.length + BALL_RADIUS - ball[1], BALL_RADIUS)
    if to_line > distance + TAIL * max(distance_sd, SD_FLOOR):
        return 0.0  # in most of the field, and at once
    heading = pose.heading_deg + direction
    total = 0.0
    for low, high in _free(_mouth(pose, ball, field), gap, blocked):
        middle = wrap(0.5 * (low + high) - direction)
        start = max(middle - 0.5 * (high - low), -TAIL * sd)
        end = min(middle + 0.5 * (high - low), TAIL * sd)
        if start < end:
            total += _chance_over_line(outcome, sd, to_line, heading, (start, end))
    return chance * total


def _chance_over_line(outcome, sd, to_line, heading, between) -> float:
    """That a ball goes between two directions, given from the mean one, and rolls as far as the
    line is in each; heading: the mean one on the field."""
    start, end = between
    count = math.ceil((end - start) / SLICE)
    step = (end - start) / count
    total, before = 0.0, _normal(start / sd)
    for i in range(count):
        up_field = math.sin(math.radians(heading + start + (i + 0.5) * step))
        upto = _normal((start + (i + 1) * step) / sd)
        if up_field > 0.0:
            total += (upto - before) * chance_of_rolling(outcome, to_line / up_field)
        before = upto
    return total


def _side(kick) -> float:
    return -1.0 if kick in LEFT_OF else 1.0


def _table(held, walking) -> dict:
    if held:
        return kick_map.HELD
    return kick_map.WALKING if walking else kick_map.STANDING


def _data(kick, held, walking=False) -> dict:
    return _table(held, walking)[LEFT_OF.get(kick, kick)]


def _between(places, at) -> tuple:
    """The place before, and the share of the way to the next; None outside."""
    if not places[0] <= at <= places[-1]:
        return None, 0.0
    before = 0
    while before < len(places) - 2 and places[before + 1] <= at:
        before += 1
    return before, (at - places[before]) / (places[before + 1] - places[before])


def _mean(weighted) -> Outcome:
    """Of weights that add up to 1 and the map's outcomes, in which chances are in percent."""
    chance = sum(weight * cell[0] for weight, cell in weighted)
    if chance <= 0.0:
        return NOTHING
    means = [sum(weight * cell[0] * cell[i] for weight, cell in weighted) / chance
             for i in range(1, 5)]
    return (min(0.01 * chance, 1.0), *means)


def _measured(cell, side) -> Outcome:
    """As the map has it, where a chance is in percent and falls are given too."""
    return 0.01 * cell[0], side * cell[1], cell[2], cell[3], cell[4]


def _mirrored(outcome, side) -> Outcome:
    return (outcome[0], side * outcome[1]) + outcome[2:]


def _normal(z) -> float:
    """The share of a normal distribution below z standard deviations."""
    return 0.5 * (1.0 + math.erf(z * math.sqrt(0.5)))


def _mouth(pose, ball, field) -> Point:
    """The directions, low and high, between which a ball from there passes the posts."""
    ahead = max(field.length - ball[1], 1.0)
    half = 0.5 * field.goal_width - BALL_RADIUS
    left, right = (math.degrees(math.atan2(ahead, 0.5 * field.width + lateral - ball[0]))
                   for lateral in (-half, half))
    low = wrap(right - pose.heading_deg)
    return low, low + left - right


def _free(mouth, gap, blocked) -> list:
    """What is left of the mouth inside the gap and beside what is blocked."""
    middle = 0.5 * (mouth[0] + mouth[1])
    parts = [mouth]
    if gap is not None:
        low, high = _about(middle, gap)
        parts = [(max(low, mouth[0]), min(high, mouth[1]))]
    for pair in blocked:
        low, high = _about(middle, pair)
        parts = [part for start, end in parts
                 for part in ((start, min(end, low)), (max(start, high), end))]
        parts = [(start, end) for start, end in parts if start < end]
    return [(start, end) for start, end in parts if start < end]


def _about(middle, pair) -> Point:
    """The same directions as numbers near that of the middle."""
    low, high = (middle + wrap(degrees - middle) for degrees in pair)
    return (low, high) if low <= high else (low - 360.0, high)
