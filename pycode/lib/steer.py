# SPDX-License-Identifier: Apache-2.0
# Requests for legs and head that go to a point of the robot frame. Keeps nothing. The way is
# straight: who has obstacles to mind asks situation/obstacles.py first.
import math

import kelpie
from lib.geom import Point, clamp, heading

BALL_TOP = 8.4           # cm
# Gates of facts-2005 section 7.2: a point within the first is walked to at full speed, one beyond
# the second is turned to on the spot.
AHEAD_WITHIN = 30.0      # deg
ON_THE_SPOT = 80.0  # deg
SPEED = 34.0             # cm/s
SLOW_DOWN = 1.2          # 1/s: from 28 cm on the speed falls with the distance
TURN_GAIN = 1.8          # deg/s per deg
TURN_SPEED = 90.0        # deg/s; at 100 and more the images of a turning robot smear
# Of who runs (any_way).
FULL = 60.0              # cm/s asked for; the fast walk makes 46 of it
STRAFE = 35.0            # cm/s of the normal walk, in any direction
FAST_WITHIN = 30.0       # deg off ahead within which the fast walk goes; it cannot strafe as well
RUN_GAIN = 3.0           # deg/s per deg
RUN_TURN = 150.0         # deg/s; the legs could do 235, but then the images smear
TURNS_FIRST = 60.0       # deg off ahead of who walks slowly meanwhile,
SLOWLY = 10.0            # cm/s: the legs go fast only ahead


def towards(point: Point, near=0.0, speed=SPEED) -> kelpie.WalkRequest:
    """Walks to a point and faces it; stops walking, but not facing, `near` cm before it."""
    off_deg = heading(*point)
    left = max(0.0, math.hypot(*point) - near)
    share = clamp((ON_THE_SPOT - abs(off_deg)) / (ON_THE_SPOT - AHEAD_WITHIN), 0.0, 1.0)
    return kelpie.WalkRequest(forward=share * min(speed, SLOW_DOWN * left),
                              turn_deg=clamp(TURN_GAIN * off_deg, -TURN_SPEED, TURN_SPEED))


def facing(point: Point, off_deg, near=0.0, speed=SPEED) -> kelpie.WalkRequest:
    """Walks to a point in any direction while turning by `off_deg` deg; stops `near` cm before."""
    away = math.hypot(*point)
    pace = min(speed, SLOW_DOWN * max(0.0, away - near)) / max(away, 1e-6)
    return kelpie.WalkRequest(forward=pace * point[1], left=-pace * point[0],
                              turn_deg=clamp(TURN_GAIN * off_deg, -TURN_SPEED, TURN_SPEED))


def any_way(way, face, speed) -> kelpie.WalkRequest:
    """Goes in the direction `way` and turns to `face`, both in deg left of ahead."""
    turn = clamp(RUN_GAIN * face, -RUN_TURN, RUN_TURN)
    ahead, left = speed * math.cos(math.radians(way)), speed * math.sin(math.radians(way))
    if abs(way) < FAST_WITHIN:
        return kelpie.WalkRequest(forward=ahead, left=left, turn_deg=turn, kind=kelpie.WALK_FAST)
    share = min(1.0, STRAFE / max(speed, 1.0))
    return kelpie.WalkRequest(forward=share * ahead, left=share * left, turn_deg=turn)


def full_ahead(off_deg) -> float:
    """The speed of who runs to a point so many deg off ahead, and turns first when that is far."""
    return FULL if abs(off_deg) < TURNS_FIRST else SLOWLY


def aim_at(x, y, height=BALL_TOP) -> kelpie.HeadRequest:
    """The camera's axis through a point of the robot frame, `height` cm above the carpet."""
    return kelpie.HeadRequest(aim=kelpie.AIM_POINT, target=kelpie.Point3(x=x, y=y, z=height))


def filtered(now, walk, filters):
    """The WalkRequest that is left of a walk: each filter of safety/ is a pure function
    filter(now, walk) -> walk that takes away what would do harm; `now` is the situation of the
    frame, of which a filter reads what it names."""
    for one in filters:
        walk = one(now, walk)
    return walk
