# SPDX-License-Identifier: Apache-2.0
# Keeps the legs of a goalie off the wall beside its goal (thesis 2004 section 4.2.4). Keeps
# nothing. The legs are four points, as the thesis models them.
import math

from lib.geom import Point
from lib.goalie_places import posts, to_field, to_robot

LEG_SIDE = 7.0       # cm; legs at the corners of a rectangle, the neck base at the middle of its
LEG_BACK = 13.0      # cm front edge (thesis 2004 figure 4.8; sizes of the ERS-7)
WALL_ZONE = 2.0      # cm out from the wall


def legs(pose) -> list[Point]:
    """The four legs of the 2004 model (figure 4.8a) on the field."""
    angle = math.radians(pose.heading_deg)
    ahead = (math.cos(angle), math.sin(angle))
    right = (math.sin(angle), -math.cos(angle))
    return [(pose.position.x + side * LEG_SIDE * right[0] + back * ahead[0],
             pose.position.y + side * LEG_SIDE * right[1] + back * ahead[1])
            for side in (-1.0, 1.0) for back in (0.0, -LEG_BACK)]


def at_rear_wall(field, pose) -> bool:
    """Whether a leg is in the zone of the wall beside the goal (figure 4.8b); on a field without
    one the end line stands for its foot."""
    left, right = posts(field)
    return any(y < field.border_width + WALL_ZONE and not left[0] < x < right[0]
               for x, y in legs(pose))


def off_rear_wall(field, pose, forward, left) -> tuple[float, float]:
    """A wished velocity, without what would take a leg into the rear wall: near it only the part
    across the field is left of a move. The thesis cancels moves away from the wall, too, and then
    the robot does not come off it; here those stay."""
    x, y = to_field(pose.heading_deg, forward, left)
    if y < 0.0 and at_rear_wall(field, pose):
        return to_robot(pose.heading_deg, x, 0.0)
    return forward, left


def off_wall(now, walk):
    """The filter."""
    walk.forward, walk.left = off_rear_wall(now.world.field, now.world.pose, walk.forward,
                                            walk.left)
    return walk
