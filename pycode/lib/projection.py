# SPDX-License-Identifier: Apache-2.0
# Where the sight through a pixel meets the carpet, from the sensed head joints and the stance
# (thesis 2006 section 6.2.1 projects so; lengths of facts-2005 section 2.2). Keeps nothing. The
# lens is a pinhole of 56.9 x 45.2 deg: off by up to 1 deg in the corners of the image, and by what
# the body leans beyond its stance.
import math

from lib.geom import Point
from lib.head import CAMERA_BELOW, NECK, NECK_ABOVE_SHOULDER

WIDTH = 208.0   # px
HEIGHT = 160.0  # px
FOCAL = 0.5 * WIDTH / math.tan(math.radians(0.5 * 56.9))  # px
FACE = 8.1          # cm, nod axis to the camera
FARTHEST = 1000.0   # cm; beyond it an error of the tilt decides everything


def sine_and_cosine(degrees) -> tuple[float, float]:
    angle = math.radians(degrees)
    return math.sin(angle), math.cos(angle)


class Camera:
    """Where it is in one frame and how it is turned, by three joint angles whose sines are worked
    out once. `place`: in the robot frame, cm: x, y and above the carpet."""

    def __init__(self, world):
        head, stance = world.head, world.stance
        self.nod = sine_and_cosine(head.head_nod_deg)
        self.pan = sine_and_cosine(head.head_pan_deg)
        self.lean = sine, cosine = sine_and_cosine(head.neck_tilt_deg - stance.body_tilt_deg)
        x, y, z = self.turned((0.0, FACE, -CAMERA_BELOW))
        base = stance.shoulder_height + NECK_ABOVE_SHOULDER
        self.place = x, -NECK * sine + y, base + NECK * cosine + z

    def turned(self, vector):
        """A vector of the camera's frame (right, ahead, up) in the robot frame: raised by the nod,
        turned to the left by the pan, raised by neck and body."""
        x, y, z = vector
        sine, cosine = self.nod
        y, z = y * cosine - z * sine, y * sine + z * cosine
        sine, cosine = self.pan
        x, y = x * cosine - y * sine, x * sine + y * cosine
        sine, cosine = self.lean
        return x, y * cosine - z * sine, y * sine + z * cosine


def ground_through(world, pixel_x, pixel_y) -> Point | None:
    """The point of the carpet (robot frame, cm) behind a pixel, x from the left and y from the top
    of the image; None when the sight does not meet it within FARTHEST."""
    camera = Camera(world)
    sight = camera.turned((pixel_x - 0.5 * WIDTH, FOCAL, 0.5 * HEIGHT - pixel_y))
    x, y, above = camera.place
    if sight[2] >= 0.0:
        return None
    share = -above / sight[2]
    x, y = x + share * sight[0], y + share * sight[1]
    return (x, y) if math.hypot(x, y) <= FARTHEST else None


def off_axis(world, place) -> float:
    """Degrees between the camera's axis and the sight to a point of the robot frame (x, y, z)."""
    camera = Camera(world)
    axis = camera.turned((0.0, 1.0, 0.0))
    sight = [a - b for a, b in zip(place, camera.place)]
    along = sum(a * b for a, b in zip(axis, sight))
    return math.degrees(math.acos(max(-1.0, min(1.0, along / max(math.hypot(*sight), 1e-9)))))
