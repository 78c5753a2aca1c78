# SPDX-License-Identifier: Apache-2.0
import math
import random

import kelpie
import pytest
from goalie_world import CIRCLE, circle_place
from lib import goalie_places as places
from safety import own_box, own_goal, rear_wall
from situation import shot

FIELD = kelpie.FIELDS['2006']
OLD = kelpie.FIELDS['2004']
BALLS = [(x, y) for x in range(20, 350, 30) for y in (45, 60, 90, 150, 270, 400)]


def pose(x, y, heading):
    return kelpie.Pose2(position=kelpie.Point2(x=x, y=y), heading_deg=heading)


def angle(a, apex, b):
    """Degrees at the apex between the ways to a and b."""
    ax, ay, bx, by = a[0] - apex[0], a[1] - apex[1], b[0] - apex[0], b[1] - apex[1]
    return math.degrees(math.atan2(abs(ax * by - ay * bx), ax * bx + ay * by))


@pytest.mark.parametrize('ball', BALLS)
def test_goalie_halves_the_angle_between_the_ball_and_the_posts(ball):
    x, y, heading = places.bisector_place(FIELD, ball)
    if abs(x - 180) < places.CLIP_X - 1e-9:
        left, right = (angle(post, ball, (x, y)) for post in ((140, 0), (220, 0)))
        assert y == 20 and left == pytest.approx(right, abs=1e-6)
        towards = math.degrees(math.atan2(ball[1] - y, ball[0] - x))
        if abs(towards - 90) < places.CLIP_HEADING:
            assert heading == pytest.approx(towards, abs=1e-6)


def test_most_balls_ahead_need_no_clipping():
    free = [b for b in BALLS if abs(places.bisector_place(FIELD, b)[0] - 180) < places.CLIP_X]
    assert len(free) > 0.75 * len(BALLS)


@pytest.mark.parametrize('ball', [(20, 2), (340, 2), (140, 0), (180, 0), (180, -20), (60, 10)])
def test_place_for_a_ball_near_the_line_is_in_the_mouth(ball):
    x, y, heading = places.bisector_place(FIELD, ball)
    assert 145 <= x <= 215 and places.MIN_Y <= y <= 20 and 30 <= heading <= 150


def test_place_does_not_jump_as_the_ball_comes_to_the_line():
    stands = [places.bisector_place(FIELD, (150, 0.1 * y)) for y in range(1000, 5, -1)]
    for a, b in zip(stands, stands[1:]):
        assert math.hypot(a[0] - b[0], a[1] - b[1]) < 1.0


@pytest.mark.parametrize('ball', BALLS + [(180, 5), (150, 3)])
def test_ellipse_place_is_on_the_ellipse_and_on_the_line_to_the_goals_middle(ball):
    x, y, _ = places.ellipse_place(FIELD, ball)
    assert ((x - 180) / 45) ** 2 + (y / 25) ** 2 == pytest.approx(1, abs=1e-6)
    assert (x - 180) * ball[1] - y * (ball[0] - 180) == pytest.approx(0, abs=1e-6 * 400)
    assert (x - 180) * (ball[0] - 180) + y * ball[1] > 0


def test_circle_is_wider_for_a_farther_ball():
    def radius(ball):
        x, y, _ = circle_place(FIELD, ball)
        return math.hypot(x - 180, y)
    radii = [radius((180, y)) for y in (40, 60, 100, 150, 200, 250, 400)]
    assert radii == sorted(radii) and radii[0] == CIRCLE[0]
    assert radii[-1] == pytest.approx(CIRCLE[1])
    assert radius((100, 120)) == pytest.approx(radius((260, 120)))


@pytest.mark.parametrize('field', [FIELD, OLD])
def test_all_rules_are_mirrored(field):
    for rule in (places.bisector_place, places.fixed_bisector_place, places.ellipse_place,
                 circle_place):
        for x, y in BALLS:
            a, b = rule(field, (x, y)), rule(field, (field.width - x, y))
            assert a[0] + b[0] == pytest.approx(field.width)
            assert a[1] == pytest.approx(b[1]) and a[2] + b[2] == pytest.approx(180)


def test_box_of_2006_is_130_wide_and_65_deep():
    assert places.box(FIELD) == (115, 245, 0, 65)
    assert places.beyond_box(FIELD, (180, 30)) == 0
    assert places.beyond_box(FIELD, (180, 80)) == pytest.approx(15)
    assert places.beyond_box(FIELD, (112, 69)) == pytest.approx(5)


def test_directions_at_the_own_goal_are_inside_the_cone():
    chance = random.Random(2)
    for _ in range(2000):
        ball = chance.uniform(0, 360), chance.uniform(1, 540)
        direction = chance.uniform(-180, 180)
        away = math.cos(math.radians(direction)), math.sin(math.radians(direction))
        x = ball[0] - away[0] / away[1] * ball[1] if away[1] < 0 else math.inf
        off = places.off_own_goal(FIELD, ball, direction)
        assert off < 0 or abs(x - 180) >= 40 + places.BALL_RADIUS - 1e-6
        assert off > 0 or abs(x - 180) <= 40 + places.BALL_RADIUS + 1e-6


def test_degrees_off_the_own_goal():
    assert places.off_own_goal(FIELD, (180, 40), -90) < -40
    assert places.off_own_goal(FIELD, (180, 40), 90) == pytest.approx(180 - 47.9, abs=0.1)
    assert places.off_own_goal(FIELD, (100, 1), 180) > 150


def test_legs_are_the_corners_of_a_rectangle_behind_the_neck():
    assert sorted(rear_wall.legs(pose(100, 50, 90))) == pytest.approx(
        [(93, 37), (93, 50), (107, 37), (107, 50)])
    assert min(y for _, y in rear_wall.legs(pose(100, 50, 0))) == pytest.approx(43)


@pytest.mark.parametrize('x, y, heading, at_wall', [
    (120, 16, 90, False), (120, 14, 90, True),        # a hind leg comes within 2 cm
    (120, 9.5, 0, False), (120, 8.5, 0, True),        # a side does
    (180, 5, 90, False), (180, 5, -90, False)])       # in the mouth there is no wall
def test_rear_wall_zone_is_two_centimetres_beside_the_goal(x, y, heading, at_wall):
    assert rear_wall.at_rear_wall(FIELD, pose(x, y, heading)) == at_wall


def test_wall_of_2004_stands_as_far_in_as_the_border_is_wide():
    assert rear_wall.at_rear_wall(OLD, pose(80, 24, 90))
    assert not rear_wall.at_rear_wall(OLD, pose(80, 26, 90))


def test_near_the_wall_only_the_move_across_is_left():
    near, free = pose(120, 12, 60), pose(120, 40, 60)
    x, y = places.to_field(60, *rear_wall.off_rear_wall(FIELD, near, -20.0, 5.0))
    asked = places.to_field(60, -20.0, 5.0)
    assert (x, y) == pytest.approx((asked[0], 0))
    assert rear_wall.off_rear_wall(FIELD, free, -20.0, 5.0) == (-20.0, 5.0)
    assert rear_wall.off_rear_wall(FIELD, near, 20.0, 0.0) == (20.0, 0.0)


def test_no_wish_takes_the_goalie_out_of_its_box():
    chance = random.Random(3)
    for _ in range(1000):
        left, right, near, far = places.box(FIELD, own_box.MARGIN)
        at = pose(chance.uniform(left, right), chance.uniform(near, far), chance.uniform(-180, 180))
        forward, left = chance.uniform(-40, 40), chance.uniform(-40, 40)
        for _ in range(60):
            ahead, lateral = own_box.kept_in_box(FIELD, at, forward, left, own_box.MARGIN,
                                               own_box.SECONDS)
            x, y = places.to_field(at.heading_deg, ahead, lateral)
            at.position.x += x / 30
            at.position.y += y / 30
            at.heading_deg += 2
        assert places.beyond_box(FIELD, (at.position.x, at.position.y), own_box.MARGIN) < 1e-6


def test_from_outside_every_wish_leads_back():
    forward, left = own_box.kept_in_box(FIELD, pose(180, 75, 90), 30.0, 10.0, 6.0, 0.35)
    assert forward < -20 and left == pytest.approx(10)


def test_rolling_time_is_that_of_small_steps():
    for speed in (40.0, 90.0, 160.0):
        v, way, t = speed, 0.0, 0.0
        while v > 5.0:
            way, v, t = way + v * 1e-4, v - (0.76 * v + 6.0) * 1e-4, t + 1e-4
            if abs(t - 0.5) < 5e-5:
                assert shot.seconds_to_roll(way, speed) == pytest.approx(t, abs=1e-3)
        assert shot.seconds_to_roll(way, speed) == pytest.approx(t, abs=0.02)
    assert shot.seconds_to_roll(200.0, 90.0) == math.inf


def test_crossing_of_a_line():
    point, way = shot.crossing((10, 40), (-3, -4), 0)
    assert point == pytest.approx((-20, 0)) and way == pytest.approx(50)
    assert shot.crossing((10, 40), (3, 4), 0) is None
    assert shot.crossing((10, 40), (3, 0), 0) is None


@pytest.mark.parametrize('ball, walk, taken', [
    ((180, 4), dict(forward=-20), True), ((180, 4), dict(forward=20), False),
    ((180, 36), dict(forward=20), False), ((192, 16), dict(left=-20), False),
    ((192, 3), dict(left=-20), True), ((168, 14), dict(left=20), False),
    ((188, 3), dict(turn_deg=-100), True), ((188, 3), dict(turn_deg=100), False),
    ((172, 3), dict(turn_deg=100), True), ((180, 14), dict(forward=-20), True)])
def test_a_body_that_walks_into_a_ball_takes_it_the_way_that_side_faces(ball, walk, taken):
    """The goalie at (180, 24) looks up-field: its rump sends a ball in, its flank one on the line,
    and its rump beside it when it turns."""
    pose = kelpie.Pose2(position=kelpie.Point2(x=180.0, y=24.0), heading_deg=90.0)
    assert own_goal.would_own_goal(FIELD, pose, kelpie.WalkRequest(**walk), ball) == taken
