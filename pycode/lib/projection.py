# SPDX-License-Identifier: Apache-2.0
# Where the sight through a pixel meets the carpet, from the sensed head joints and the stance
# (thesis 2006 section 6.2.1 projects so; lengths of facts-2005 section 2.2). Keeps nothing. The
# lens is a pinhole of 56.9 x 45.2 deg: off by up to 1 deg in the corners of the image, and by what
# the body leans beyond its stance.
import math

from lib.geom import Point
from lib.head import CAMERA_BELOW, NECK, NECK_ABOVE_SHOULDER

WIDTH, HEIGHT = 208.0, 160.0  # px
FOCAL = 0.5 * WIDTH / math.tan(math.radians(0.5 * 56.9))  # px
FACE = 8.1          # cm, nod axis to the camera
FARTHEST = 1000.0   # cm; beyond it an error of the tilt decides everything


def raised(vector, degrees):
    """A vector (right, ahead, up) turned up about the axis to the right."""
    x, y, z = vector
    angle = math.radians(degrees)
    return (x, y * math.cos(angle) - z * math.sin(angle), y * math.sin(angle) + z * math.cos(angle))


def panned(vector, degrees):
    """And turned to the left."""
    x, y, z = vector
    angle = math.radians(degrees)
    return (x * math.cos(angle) - y * math.sin(angle), x * math.sin(angle) + y * math.cos(angle), z)


def from_face(world, vector):
    """A vector of the camera's frame (right, ahead, up) in the robot frame."""
    head = world.head
    vector = panned(raised(vector, head.head_nod_deg), head.head_pan_deg)
    return raised(vector, head.neck_tilt_deg - world.stance.body_tilt_deg)


def camera(world):
    """Place of the camera in the robot frame, cm: x, y and above the carpet."""
    neck = raised((0.0, 0.0, NECK), world.head.neck_tilt_deg - world.stance.body_tilt_deg)
    face = from_face(world, (0.0, FACE, -CAMERA_BELOW))
    base = world.stance.shoulder_height + NECK_ABOVE_SHOULDER
    return face[0], neck[1] + face[1], base + neck[2] + face[2]


def ground_through(world, pixel_x, pixel_y) -> Point | None:
    """The point of the carpet (robot frame, cm) behind a pixel, x from the left and y from the top
    of the image; None when the sight does not meet it within FARTHEST."""
    sight = from_face(world, (pixel_x - 0.5 * WIDTH, FOCAL, 0.5 * HEIGHT - pixel_y))
    x, y, above = camera(world)
    if sight[2] >= 0.0:
        return None
    share = -above / sight[2]
    x, y = x + share * sight[0], y + share * sight[1]
    return (x, y) if math.hypot(x, y) <= FARTHEST else None


def off_axis(world, place) -> float:
    """Degrees between the camera's axis and the sight to a point of the robot frame (x, y, z)."""
    axis = from_face(world, (0.0, 1.0, 0.0))
    sight = [a - b for a, b in zip(place, camera(world))]
    along = sum(a * b for a, b in zip(axis, sight))
    return math.degrees(math.acos(max(-1.0, min(1.0, along / max(math.hypot(*sight), 1e-9)))))
