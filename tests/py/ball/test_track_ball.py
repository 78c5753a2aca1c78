# SPDX-License-Identifier: Apache-2.0
import math
import random

import kelpie
import pytest
from ideal_world import IdealWorld
from lib.projection import FOCAL, Camera, ground_through
from situation.memory import Memory
from skills.head.track_ball import TrackBall

RADIUS = 4.2  # cm


def world_looking(pan, neck, nod):
    world = kelpie.WorldFrame(field=kelpie.FIELDS['2006'])
    world.head.head_pan_deg, world.head.neck_tilt_deg, world.head.head_nod_deg = pan, neck, nod
    world.stance.body_tilt_deg = 14.25
    return world


def show(world, x, y):
    """Puts a ball's image into the percepts: its centre by the camera's axes, one by one, so that
    this is not the inverse of ground_through() by its own formula."""
    eye = Camera(world).place
    axes = [Camera(world).turned(axis) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    away = (x - eye[0], y - eye[1], RADIUS - eye[2])
    right, ahead, up = (sum(a * b for a, b in zip(away, axis)) for axis in axes)
    ball = world.percepts.ball
    ball.present = True
    ball.centre.x, ball.centre.y = 104.0 + FOCAL * right / ahead, 80.0 - FOCAL * up / ahead
    ball.radius = FOCAL * RADIUS / math.sqrt(right * right + ahead * ahead + up * up)
    ball.distance, ball.heading_deg = math.hypot(x, y), math.degrees(math.atan2(-x, y))


def test_a_camera_looking_ahead_is_where_the_lengths_say():
    world = world_looking(0.0, 0.0, 14.25)
    lean = math.radians(14.25)
    x, y, z = Camera(world).place
    assert (x, y) == pytest.approx((0.0, 8.0 * math.sin(lean) + 8.1))
    assert z == pytest.approx(11.95 + 8.0 * math.cos(lean) - 1.46)


@pytest.mark.parametrize('pan', [-60.0, 0.0, 60.0])
def test_a_pixel_of_the_axis_meets_the_carpet_on_the_axis(pan):
    world = world_looking(pan, -20.0, -5.0)
    x, y, above = Camera(world).place
    ahead = Camera(world).turned((0.0, 1.0, 0.0))
    point = ground_through(world, 104.0, 80.0)
    share = above / -ahead[2]
    assert point == pytest.approx((x + share * ahead[0], y + share * ahead[1]))


@pytest.mark.parametrize('place', [(0.0, 25.0), (30.0, 60.0), (-80.0, 120.0), (10.0, 250.0)])
def test_the_projected_point_lies_behind_the_top_of_the_ball(place):
    world = world_looking(math.degrees(math.atan2(-place[0], place[1])), -10.0, 0.0)
    show(world, *place)
    ball = world.percepts.ball
    point = ground_through(world, ball.centre.x, ball.centre.y - ball.radius)
    x, y, above = Camera(world).place
    away = math.hypot(place[0] - x, place[1] - y)
    behind = math.hypot(point[0] - x, point[1] - y)
    # By similar triangles the sight falls from the camera to the carpet over `behind`, and passes
    # the ball's top, at most its radius off the vertical, at about 2 radii.
    assert above * (1.0 - away / behind) == pytest.approx(2.0 * RADIUS, abs=1.0)


def test_a_sight_above_the_horizon_meets_nothing():
    assert ground_through(world_looking(0.0, 0.0, 20.0), 104.0, 80.0) is None
    assert ground_through(world_looking(0.0, 0.0, 13.5), 104.0, 80.0) is None  # 15 m away


def test_projection_is_the_first_choice_and_does_not_depend_on_the_distance():
    world = world_looking(0.0, -10.0, 0.0)
    show(world, 10.0, 80.0)
    track = TrackBall()
    near = track.step(world).target
    world.percepts.ball.distance = 150.0
    far = track.step(world).target
    assert track.projected and near.z == 0.0
    assert (near.x, near.y) == (far.x, far.y)


@pytest.mark.parametrize('wrong', ['not seen', 'top out of the image', 'above the horizon'])
def test_without_a_projection_distance_and_heading_tell(wrong):
    world = world_looking(0.0, -10.0, 0.0)
    show(world, 10.0, 80.0)
    world.ball.relative.x, world.ball.relative.y = 30.0, 50.0
    ball = world.percepts.ball
    if wrong == 'not seen':
        ball.present = False
    elif wrong == 'top out of the image':
        ball.centre.y, ball.radius = 20.0, 21.0
    else:
        world.head.head_nod_deg = 45.0
    track = TrackBall()
    target = track.step(world).target
    expected = (30.0, 50.0) if wrong == 'not seen' else (10.0, 80.0)
    assert not track.projected
    assert (target.x, target.y, target.z) == pytest.approx((*expected, 8.4))


def test_a_close_ball_is_remembered():
    memory = Memory()
    for distance, lost in ((31.0, 1), (29.0, 0)):
        memory.close_lost = 0
        world = world_looking(0.0, -30.0, -5.0)
        show(world, 0.0, distance)
        memory.update(world)
        TrackBall(memory).step(world)
        assert memory.close_lost == lost


def test_a_rolling_ball_is_aimed_at_where_it_will_be_four_frames_later():
    world = world_looking(0.0, -10.0, 0.0)
    world.pose.heading_deg = 90.0
    ball = world.ball
    ball.present, ball.distance, ball.relative.y, ball.velocity.x = True, 100.0, 100.0, 60.0
    assert TrackBall().step(world).target.x == pytest.approx(8.0)
    ball.seconds_since_seen = 1.0  # an old velocity tells nothing
    assert TrackBall().step(world).target.x == pytest.approx(0.0)


def test_a_turning_robot_aims_at_where_the_ball_will_be_in_its_frame():
    world = world_looking(0.0, -10.0, 0.0)
    world.ball.present, world.ball.distance, world.ball.relative.y = True, 100.0, 100.0
    world.odometry.turn_deg = 3.0
    target = TrackBall().step(world).target
    assert math.degrees(math.atan2(-target.x, target.y)) == pytest.approx(-12.0)


def turned_towards(world, request):
    """One frame of a head that goes 12 deg a frame at most, aimed by the camera's own place."""
    x, y, above = Camera(world).place
    target = request.target
    pan = math.degrees(math.atan2(-target.x, target.y))
    pitch = math.degrees(math.atan2(target.z - above, math.hypot(target.x - x, target.y - y)))
    neck = max(-32.0, min(0.0, pitch + 14.25))
    wanted = {'head_pan_deg': pan, 'neck_tilt_deg': neck, 'head_nod_deg': pitch + 14.25 - neck}
    for name, angle in wanted.items():
        now = getattr(world.head, name)
        setattr(world.head, name, now + max(-12.0, min(12.0, angle - now)))


def in_image(ball) -> bool:
    return 0.0 < ball.centre.x < 208.0 and 0.0 < ball.centre.y < 160.0


def test_a_rolling_ball_stays_in_the_middle_third_of_the_image_in_spite_of_noise():
    chance, losses, outside, frames = random.Random(1), 0, 0, 0
    for _ in range(40):
        world = world_looking(0.0, -10.0, 0.0)
        place = complex(chance.uniform(-60, 60), chance.uniform(60, 200))
        speed = complex(chance.uniform(-60, 60), chance.uniform(-40, 40)) / 30.0
        track = TrackBall()
        for frame in range(60):
            place += speed * 0.975 ** frame
            show(world, place.real, max(30.0, place.imag))
            ball = world.percepts.ball
            if frame > 20:
                frames += 1
                losses += not in_image(ball)
                outside += abs(ball.centre.x - 104.0) > 208.0 / 6.0
            ball.present = in_image(ball) and chance.random() > 0.05
            ball.centre.x += chance.gauss(0.0, 1.0)
            ball.distance *= 1.0 + chance.gauss(0.0, 0.05)
            x, y = place.real, max(30.0, place.imag)
            world.ball.relative.x, world.ball.relative.y = x, y
            turned_towards(world, track.step(world))
            world.head.head_pan_deg += chance.gauss(0.0, 0.5)
    assert losses <= 0.01 * frames and outside <= 0.05 * frames


def test_an_ideal_robot_that_walks_to_a_ball_does_not_lose_it():
    ideal, track, lost = IdealWorld(7), TrackBall(), 0
    ideal.ball = ideal.at + 150.0 * ideal.facing
    ideal.see()
    for frame in range(80):
        ideal.step(kelpie.Command(head=track.step(ideal.world),
                                  walk=kelpie.WalkRequest(forward=30.0, turn_deg=15.0)))
        lost += frame > 5 and not ideal.world.percepts.ball.present
    assert lost == 0
