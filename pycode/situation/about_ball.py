# SPDX-License-Identifier: Apache-2.0
# Where opponents are round the ball: those that vision tells by their uniform, and whoever's feet
# the last images showed where no mate is. From in front a robot of white body shows next to no
# uniform: of an opponent 125 cm ahead of the ball, who looks at it, nothing else is known. Keeps
# nothing; the feet are the memory's. Some are nobody's: points by a line, or of who has left; the
# obstacle map, which forgets slowly, has more of them. A mate that is not heard of is taken for
# an opponent.
import math

from lib.paths import point_of

SEEN_S = 2.0         # s; opponents seen longer ago have moved
REACH = 145.0        # cm from the ball, in x and in y, within which feet count
FOOT = 18.0          # cm, within which
IMAGES = 4           # images showed feet that are somebody's
BODY = 30.0          # cm about somebody within which more feet are his own
MATE = 40.0          # cm from a mate within which feet are the mate's
FROM_LINE = 4.0      # cm inside the goal lines, where posts are


def seen(world) -> list:
    """Where those are whose uniform was seen recently, as all here in cm on the field."""
    return [point_of(one) for one in world.opponents if one.seconds_since_seen < SEEN_S]


def opponents(world, memory) -> list:
    found = seen(world)
    feet = feet_of_others(world, memory, found)
    while feet:
        x, y, _ = feet[-1]    # of the newest image
        body = [foot for foot in feet if math.hypot(foot[0] - x, foot[1] - y) < FOOT]
        if len({image for *_, image in body}) >= IMAGES:
            found.append(middle(body))
            feet = [foot for foot in feet if not near(foot, found[-1:], BODY)]
        else:
            feet.pop()
    return found


def feet_of_others(world, memory, known) -> list:
    """(x, y, image) near the ball that neither a mate's nor a known opponent's are."""
    ball, top = world.ball.position, world.field.length - FROM_LINE
    mates = [point_of(mate.pose) for mate in world.teammates]
    return [foot for foot in memory.feet
            if abs(foot[0] - ball.x) < REACH and abs(foot[1] - ball.y) < REACH and
            FROM_LINE < foot[1] < top and not near(foot, mates, MATE) and
            not near(foot, known, BODY)]


def near(foot, points, reach) -> bool:
    return any(math.hypot(foot[0] - x, foot[1] - y) < reach for x, y in points)


def middle(body) -> tuple:
    return (sum(foot[0] for foot in body) / len(body), sum(foot[1] for foot in body) / len(body))
