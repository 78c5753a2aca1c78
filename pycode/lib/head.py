# SPDX-License-Identifier: Apache-2.0
# Which head joints look at a point. The chain in the plane of the view: body tilt, neck of 8.0 cm,
# nod axis, camera 8.1 cm ahead of it and 1.46 cm below (facts-2005 section 2.2). Exact for pan 0;
# with the neck far down and the head far aside it is a few degrees off, which the image forgives.
import math

import kelpie
from lib.geom import clamp, heading

NECK_ABOVE_SHOULDER = 1.95
NECK = 8.0
CAMERA_BELOW = 1.46
NOD_SHARE = 0.35
LEAST_NECK = -32.0  # lower, and the chin touches a ball at the feet (8.4 cm high)
LEAST_NOD = -5.0    # with the neck that high (openr.md 5.6: head collision limits)


def split(pitch):
    """Neck tilt and nod that add up to a pitch relative to the body, up positive."""
    if pitch >= 0.0:
        return 0.0, min(pitch, 45.0)
    nod = max(LEAST_NOD, NOD_SHARE * pitch)
    return clamp(pitch - nod, LEAST_NECK, 0.0), nod


def pitch_to(distance, height, stance):
    """Pitch of the view, down positive, from the horizontal to a point that far ahead."""
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


def view(pan, down, stance, speed=0.0):
    neck, nod = split(stance.body_tilt_deg - down)
    return kelpie.HeadRequest(neck_tilt_deg=neck, head_nod_deg=nod,
                              head_pan_deg=clamp(pan, -88.0, 88.0), speed_deg=speed)


def look_at(x, y, height, stance):
    return view(heading(x, y), pitch_to(math.hypot(x, y), height, stance), stance)
