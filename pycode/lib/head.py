# SPDX-License-Identifier: Apache-2.0
# Which head joints look at a point. Keeps nothing. The chain in the plane of the view: body tilt,
# neck of 8.0 cm, nod axis, camera 8.1 cm ahead of it and 1.46 cm below (facts-2005 section 2.2).
# Exact for pan 0; with the neck far down and the head panned far to a side it is a few degrees
# off, which the image forgives: it is 57 deg wide and 45 deg high.
import math

import kelpie
from lib.geom import clamp, heading

NECK_ABOVE_SHOULDER = 1.95  # cm
NECK = 8.0                  # cm
CAMERA_BELOW = 1.46         # cm
NOD_SHARE = 0.35            # of a pitch below the body's plane
MIN_NECK = -32.0  # deg; lower, and the chin touches a ball at the feet (8.4 cm high)
MIN_NOD = -5.0    # deg, with the neck that high (openr.md 5.6: head collision limits)
MAX_NOD = 45.0    # deg
MAX_PAN = 88.0    # deg to either side


def split(pitch) -> tuple[float, float]:
    """Neck tilt and nod (deg) that add up to a pitch relative to the body, up positive."""
    if pitch >= 0.0:
        return 0.0, min(pitch, MAX_NOD)
    nod = max(MIN_NOD, NOD_SHARE * pitch)
    return clamp(pitch - nod, MIN_NECK, 0.0), nod


def pitch_to(distance, height, stance) -> float:
    """Pitch of the view (deg, down positive) from the horizontal to a point that far ahead of the
    shoulders and that high above the carpet (cm). Four rounds, since the neck that the answer asks
    for moves the camera."""
    lean = stance.body_tilt_deg
    base = stance.shoulder_height + NECK_ABOVE_SHOULDER
    down = 0.0
    for _ in range(4):
        neck = math.radians(lean - split(lean - down)[0])
        ahead = distance - NECK * math.sin(neck)
        above = base + NECK * math.cos(neck) - height
        away = max(math.hypot(ahead, above), 2.0 * CAMERA_BELOW)
        down = math.degrees(math.atan2(above, ahead) - math.asin(CAMERA_BELOW / away))
    return down


def view(pan, down, stance, speed=0.0) -> kelpie.HeadRequest:
    """The head turned by `pan` (deg, left positive) and the view `down` below the horizontal."""
    neck, nod = split(stance.body_tilt_deg - down)
    return kelpie.HeadRequest(neck_tilt_deg=neck, head_nod_deg=nod,
                              head_pan_deg=clamp(pan, -MAX_PAN, MAX_PAN), speed_deg=speed)


def look_at(x, y, height, stance) -> kelpie.HeadRequest:
    """The head towards a point of the robot frame, `height` cm above the carpet."""
    return view(heading(x, y), pitch_to(math.hypot(x, y), height, stance), stance)
