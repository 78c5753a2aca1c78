# SPDX-License-Identifier: Apache-2.0
"""Where the head looks in the course of time: at the ball with glances at the goal, to and fro in
search of either, at the field's features, and as one does who waits."""
import math

import kelpie
import pytest
from situation.memory import Memory
from situations import put_ball, world
from skills.head.track_ball import TrackBall
from skills.head.watch import Scan, Sweep, WatchBall
from skills.head.watch_field import WatchField, in_reach
from skills.head.watch_play import WatchPlay


def down(request, made):
    """deg of the view below the horizon."""
    return made.stance.body_tilt_deg - request.neck_tilt_deg - request.head_nod_deg


class Mouth:
    """A goal at a point of the robot frame, or None."""

    def __init__(self, point=None):
        self.point = point

    def where(self, made):
        return self.point


def glance_at(seconds, point=None, away=100.0, unseen_s=0.0):
    """The looks of somebody that watches a ball straight ahead, at these times."""
    made, watch, goal = world(180.0, 200.0, 90.0, (180.0, 200.0 + away)), WatchBall(), Mouth(point)
    made.ball.seconds_since_seen = unseen_s
    looks = []
    for made.time_s in seconds:
        looks.append(watch.step(made, goal))
    return looks, made


# Watching the ball: of every 2.5 s the last 0.7 are for the goal.

def test_a_far_ball_is_looked_at_for_1_8_s_and_the_goal_for_0_7():
    looks, made = glance_at((0.0, 1.79, 1.81, 2.49, 2.5, 4.29, 4.31), (-50.0, 50.0))
    assert [round(look.head_pan_deg) for look in looks] == [0, 0, 45, 45, 0, 0, 45]
    assert down(looks[2], made) == pytest.approx(6.0) != pytest.approx(down(looks[0], made))


def test_who_does_not_know_where_the_goal_is_glances_60_deg_to_the_right_and_left_in_turn():
    looks, _ = glance_at((0.0, 2.0, 2.6, 4.9, 5.2, 7.5))
    assert [look.head_pan_deg for look in looks] == pytest.approx([0, -60, 0, 60, 0, -60])


@pytest.mark.parametrize('bearing, pan', [(79.0, 79.0), (-79.0, -79.0), (81.0, -60.0),
                                          (-81.0, -60.0), (180.0, -60.0)])
def test_a_goal_more_than_80_deg_to_a_side_is_not_glanced_at(bearing, pan):
    angle = math.radians(bearing)
    looks, _ = glance_at((0.0, 2.0), (-90.0 * math.sin(angle), 90.0 * math.cos(angle)))
    assert looks[1].head_pan_deg == pytest.approx(pan)


@pytest.mark.parametrize('away, unseen_s, glances', [
    (16.1, 0.0, True), (15.9, 0.0, False), (50.0, 0.39, True), (50.0, 0.41, False)])
def test_a_ball_nearer_than_16_cm_or_unseen_for_0_4_s_keeps_the_head(away, unseen_s, glances):
    looks, _ = glance_at((0.0, 2.0), (-50.0, 50.0), away, unseen_s)
    assert (looks[1].head_pan_deg > 40.0) is glances


@pytest.mark.parametrize('away', [30.0, 60.0, 150.0])
def test_the_ball_is_looked_at_5_cm_above_the_carpet(away):
    """By the chain of neck, nod and camera (facts-2005 section 2.2), as in ideal_world.py."""
    (look,), made = glance_at((0.0,), away=away)
    lean = math.radians(made.stance.body_tilt_deg - look.neck_tilt_deg)
    angle = math.radians(down(look, made))
    ahead = 8.0 * math.sin(lean) + 8.1 * math.cos(angle) - 1.46 * math.sin(angle)
    above = 11.95 + 8.0 * math.cos(lean) - 8.1 * math.sin(angle) - 1.46 * math.cos(angle)
    assert above - (away - ahead) * math.tan(angle) == pytest.approx(5.0, abs=0.7)


# Scans

@pytest.mark.parametrize('passed, pan, pitch', [
    (0.0, 0.0, 32.0), (0.6, 75.0, 32.0), (1.8, -75.0, 32.0), (2.39, 0.0, 32.0), (3.0, 75.0, 12.0),
    (4.2, -75.0, 12.0), (5.4, 75.0, 32.0)])
def test_a_scan_sweeps_75_deg_to_each_side_in_2_4_s_low_and_high_in_turn(passed, pan, pitch):
    made = world()
    request = Scan().step(made, passed)
    assert (request.head_pan_deg, down(request, made)) == pytest.approx((pan, pitch), abs=2.0)


@pytest.mark.parametrize('passed, pan', [(0.0, 0.0), (0.6, 85.0), (1.2, 0.0), (1.8, -85.0),
                                         (3.0, 85.0)])
def test_a_sweep_for_landmarks_is_level_and_85_deg_wide(passed, pan):
    made = world()
    request = Sweep().step(made, passed)
    assert request.head_pan_deg == pytest.approx(pan, abs=1e-6)
    assert down(request, made) == pytest.approx(6.0)


# The challenger's looks at the field

def test_of_three_looks_of_a_second_the_third_is_at_the_wall_to_the_right_and_left_in_turn():
    made, watch, looks = world(180.0, 200.0), WatchField(), []
    for second in range(6):
        for part in (0.0, 0.5, 0.97):
            made.time_s = second + part
            looks.append((watch.step(made).head_pan_deg, watch.target))
    assert [pan for pan, _ in looks[6:9]] == [-40.0] * 3
    assert [pan for pan, _ in looks[15:18]] == [40.0] * 3
    targets = [target for _, target in looks]
    assert [target is None for target in targets] == [second in (2, 5) for second in range(6)
                                                      for _ in range(3)]
    for second in (0, 1, 3, 4):
        assert len(set(targets[3 * second:3 * second + 3])) == 1
    assert targets[0] != targets[3] and targets[9] != targets[12]


def test_a_look_at_the_wall_is_level():
    made, watch = world(180.0, 200.0), WatchField()
    for made.time_s in (0.0, 1.0, 2.0):
        request = watch.step(made)
    assert down(request, made) == pytest.approx(4.0)


def test_a_feature_is_looked_at_on_the_carpet():
    made, watch = world(180.0, 200.0), WatchField()
    request = watch.step(made)
    x, y = watch.target[0] - 180.0, watch.target[1] - 200.0
    assert request.head_pan_deg == pytest.approx(math.degrees(math.atan2(-x, y)))
    assert down(request, made) > math.degrees(math.atan2(18.0, math.hypot(x, y)))


def test_where_no_feature_is_in_reach_it_looks_at_the_wall():
    made, watch = world(180.0, 640.0, 90.0), WatchField()
    assert watch.step(made).head_pan_deg == -40.0 and watch.target is None


HERE = kelpie.Pose2(position=kelpie.Point2(x=100.0, y=100.0), heading_deg=90.0)


@pytest.mark.parametrize('ahead, side, good', [
    (14.0, 0.0, False), (16.0, 0.0, True), (199.0, 0.0, True), (201.0, 0.0, False),
    (19.0, 100.0, True), (16.0, 100.0, False), (19.0, -100.0, True), (16.0, -100.0, False),
    (-50.0, 0.0, False)])
def test_features_are_in_reach_from_15_to_200_cm_and_80_deg_to_either_side(ahead, side, good):
    place = 100.0 + side, 100.0 + ahead
    assert in_reach(HERE, [place], []) == in_reach(HERE, [], [place]) == ([place] if good else [])


def test_features_come_by_kind_the_corners_first_and_the_nearest_of_each():
    corners, middles = [(100.0, 250.0), (100.0, 200.0)], [(100.0, 150.0), (100.0, 140.0)]
    assert in_reach(HERE, corners, middles) == [(100.0, 200.0), (100.0, 250.0), (100.0, 140.0),
                                                (100.0, 150.0)]


# Who waits

@pytest.mark.parametrize('lost, present, look', [
    (0, True, 'ball'), (15, True, 'ball'), (16, True, 'team'), (0, False, 'team'),
    (44, True, 'team'), (45, True, 'scan'), (89, True, 'scan'), (90, True, 'team')])
def test_an_unseen_ball_is_looked_for_where_the_team_has_it_and_around_for_45_frames_each(
        lost, present, look):
    made, memory = world(180.0, 200.0, 90.0, (180.0, 300.0)), Memory(ball_lost=lost)
    made.ball.present = present
    memory.localised_lost = 0
    request = WatchPlay(memory).step(made, (280.0, 200.0))
    if look == 'scan':
        assert request.aim == kelpie.AIM_JOINTS
    else:
        x, y = (0.0, 100.0) if look == 'ball' else (100.0, 0.0)
        assert (request.target.x, request.target.y) == pytest.approx((x, y), abs=1e-6)


def test_without_any_ball_who_waits_looks_around():
    made, memory = world(), Memory()
    memory.localised_lost, made.ball.present = 0, False
    assert WatchPlay(memory).step(made, None).aim == kelpie.AIM_JOINTS


def test_a_ball_that_is_seen_again_during_a_scan_is_followed_at_once():
    made, memory = world(180.0, 200.0, 90.0, (150.0, 300.0)), Memory(ball_lost=60)
    memory.localised_lost = 0
    watch = WatchPlay(memory)
    assert watch.step(made, None).aim == kelpie.AIM_JOINTS
    memory.ball_lost = 0
    put_ball(made, 150.0, 300.0)
    assert watch.step(made, None).target.x == pytest.approx(-30.0, abs=15.0)


@pytest.mark.parametrize('away, beside', [(27.0, False), (29.0, True)])
def test_the_gaze_leaves_the_middle_of_a_ball_28_cm_off_for_a_landmark(away, beside):
    """The beacon at (-15, 405) is 25 deg to the left of the way to the ball."""
    made = world(180.0, 250.0, 76.2, (180.0, 250.0))
    made.pose.heading_deg = math.degrees(math.atan2(155.0, -195.0)) - 25.0
    angle = math.radians(made.pose.heading_deg)
    put_ball(made, 180.0 + away * math.cos(angle), 250.0 + away * math.sin(angle))
    made.percepts.ball.present = False
    target = TrackBall().step(made).target
    assert (abs(target.x) > 0.5) is beside and target.y > 0.0
