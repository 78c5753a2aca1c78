# SPDX-License-Identifier: Apache-2.0
# Where a goalie stands and what it must keep clear of, as plane geometry on the field (cm,
# degrees): three rules for the place to guard, the own goal as seen from a ball, the goal box, and
# the wall beside the goal. Keeps nothing. A rule believes ball and pose: it is as wrong as they
# are. With a ball behind the end line no rule makes sense; it is then taken to lie on the line.
import math

from lib.geom import Point, clamp, from_field, wrap

Place = tuple[float, float, float]  # x, y of the neck base on the field, heading in degrees

UP_FIELD = 90.0       # deg
DOWN_FIELD = -90.0    # deg
BALL_RADIUS = 4.2     # cm
STAND_Y = 20.0        # cm from the goal line, thesis 2006 section 4.3.1
MIN_Y = 10.0          # cm; nearer to the line the hind legs stand in the goal's back wall
CLIP_X = 35.0         # cm from the middle; facts-2005 section 7.2
CLIP_HEADING = 60.0   # deg from up-field; facts-2005 section 7.2
ELLIPSE_ACROSS = 45.0  # cm, half axes; checklist U18
ELLIPSE_OUT = 25.0  # cm
ROUND = 18.0          # cm; a straight way that comes nearer to the ball pushes it,
TRUNK = 16.0          # cm that the trunk reaches behind the neck base
MARGIN = 10.0         # cm that the neck base keeps inside the box; the pose is off by 2.6 cm, and
                      # others push


def middle(field) -> Point:
    """The middle of the own goal's mouth."""
    return 0.5 * field.width, 0.0


def posts(field) -> tuple[Point, Point]:
    """The own goal's posts, the one at smaller x first."""
    x, half = 0.5 * field.width, 0.5 * field.goal_width
    return (x - half, 0.0), (x + half, 0.0)


def direction(start, end) -> float:
    """Heading (deg) from one point of the field to another."""
    return math.degrees(math.atan2(end[1] - start[1], end[0] - start[0]))


def bisector(field, ball) -> Point:
    """Unit vector from a ball that halves the angle between its lines to the two posts."""
    x = y = 0.0
    for post in posts(field):
        dx, dy = post[0] - ball[0], post[1] - ball[1]
        away = max(math.hypot(dx, dy), 1e-6)
        x, y = x + dx / away, y + dy / away
    length = max(math.hypot(x, y), 1e-6)
    return x / length, y / length


def facing(place, ball) -> Place:
    """A place with the heading towards the ball, but never far from up-field."""
    off_deg = wrap(direction(place, ball) - UP_FIELD)
    return place[0], place[1], UP_FIELD + clamp(off_deg, -CLIP_HEADING, CLIP_HEADING)


def bisector_place(field, ball) -> Place:
    """On the bisector at y = 20 cm; with a ball nearer to the line than 40 cm, half as far from it
    as the ball."""
    return on_bisector(field, ball, clamp(0.5 * max(ball[1], 1.0), MIN_Y, STAND_Y))


def fixed_bisector_place(field, ball) -> Place:
    """On the bisector at y = 20 cm (thesis 2006 section 4.3.1, checklist G15)."""
    return on_bisector(field, ball, STAND_Y)


def on_bisector(field, ball, y) -> Place:
    """Where it crosses that y, but never farther to the side than the mouth."""
    ball_y = max(ball[1], 1.0)
    dx, dy = bisector(field, (ball[0], ball_y))
    x = ball[0] + dx * (ball_y - y) / max(-dy, 1e-6) if ball_y > y else ball[0]
    x0 = middle(field)[0]
    return facing((clamp(x, x0 - CLIP_X, x0 + CLIP_X), y), ball)


def ellipse_place(field, ball) -> Place:
    """Where the line from the ball to the goal's middle crosses the ellipse around the mouth
    (thesis 2004 section 4.2.1)."""
    x0, y0 = middle(field)
    dx, dy = ball[0] - x0, max(ball[1], 0.0) - y0
    if math.hypot(dx, dy) < 1e-6:
        dy = 1.0
    share = 1.0 / math.hypot(dx / ELLIPSE_ACROSS, dy / ELLIPSE_OUT)
    return facing((x0 + share * dx, y0 + share * dy), ball)


def past_ball(start, end, ball) -> bool:
    """Whether the straight way comes near the ball before its end."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    length2 = dx * dx + dy * dy
    if length2 < 1.0:
        return False
    along = ((ball[0] - start[0]) * dx + (ball[1] - start[1]) * dy) / length2
    if not 0.0 < along < 0.9:
        return False
    return math.hypot(ball[0] - start[0] - along * dx, ball[1] - start[1] - along * dy) < ROUND


def central_place(field, y=STAND_Y) -> Place:
    """Where to wait for a ball of which nothing is known."""
    return middle(field)[0], y, UP_FIELD


def box(field, margin=0.0) -> tuple[float, float, float, float]:
    """The goal box less a margin: left, right, near, far."""
    x0, half = 0.5 * field.width, 0.5 * field.box_width
    return x0 - half + margin, x0 + half - margin, margin, field.box_depth - margin


def clip_to_box(field, point, margin=0.0) -> Point:
    """The point of the box, less a margin, that is nearest to a point."""
    left, right, near, far = box(field, margin)
    return clamp(point[0], left, right), clamp(point[1], near, far)


def beyond_box(field, point, margin=0.0) -> float:
    """cm from a point to the nearest one of the box; 0 inside."""
    x, y = clip_to_box(field, point, margin)
    return math.hypot(point[0] - x, point[1] - y)


def own_goal_cone(field, ball) -> tuple[float, float]:
    """The directions between which a ball goes into the own goal, a ball's radius beyond the posts
    included: deg from straight down-field, the end at smaller x (negative) first."""
    ball_y = max(ball[1], 0.1)
    left, right = posts(field)
    return (math.degrees(math.atan2(left[0] - BALL_RADIUS - ball[0], ball_y)),
            math.degrees(math.atan2(right[0] + BALL_RADIUS - ball[0], ball_y)))


def off_own_goal(field, ball, direction_deg) -> float:
    """Degrees between a direction of the field and the nearest one that leads into the own goal;
    negative inside the cone."""
    low, high = own_goal_cone(field, ball)
    off_deg = wrap(direction_deg - DOWN_FIELD)
    if low <= off_deg <= high:
        return max(low - off_deg, off_deg - high)
    return min(abs(wrap(off_deg - low)), abs(wrap(off_deg - high)))


def to_field(heading_deg, forward, left) -> Point:
    """A velocity of the robot frame as one of the field frame."""
    angle = math.radians(heading_deg)
    return (forward * math.cos(angle) - left * math.sin(angle),
            forward * math.sin(angle) + left * math.cos(angle))


def to_robot(heading_deg, x, y) -> tuple[float, float]:
    """A velocity of the field frame as forward and left."""
    angle = math.radians(heading_deg)
    return (x * math.cos(angle) + y * math.sin(angle), y * math.cos(angle) - x * math.sin(angle))


def beside(pose, right) -> Point:
    """The point of the field so far (cm) to the right of the neck base."""
    x, y = to_field(pose.heading_deg, 0.0, -right)
    return pose.position.x + x, pose.position.y + y
