# SPDX-License-Identifier: Apache-2.0
"""The times and angles of a goalie's head: points of its scan, glances, surveys, and the search of
2004."""
import math
from types import SimpleNamespace

import kelpie
import pytest
from goalie_world import world_at
from situation.memory import Memory
from skills.head.ellipse_head import EllipseHead
from skills.head.goalie_head import GoalieHead, Hints
from skills.head.point_scan import PointScan


def down(request, made):
    """deg of the view below the horizon."""
    return made.stance.body_tilt_deg - request.neck_tilt_deg - request.head_nod_deg


# The point scan: four beacons for 0.22 s each, five low points for 0.26 s each, 2.18 s in all. From
# (180, 20) the beacons lie 59.5 and 26.9 deg aside.

@pytest.mark.parametrize('seconds, pan', [
    (0.01, 59.5), (0.21, 59.5), (0.23, 26.9), (0.45, -26.9), (0.67, -59.5), (0.87, -59.5),
    (0.89, -88.0), (1.13, -88.0), (1.15, -44.0), (1.41, 0.0), (1.67, 44.0), (1.93, 88.0),
    (2.17, 88.0), (2.19, 59.5), (4.35, 88.0), (4.37, 59.5)])
def test_a_round_looks_at_four_beacons_and_five_low_points_from_right_to_left(seconds, pan):
    made = world_at()
    scan = PointScan(made)
    made.time_s = seconds
    request = scan.step(made)
    assert request.head_pan_deg == pytest.approx(pan, abs=0.1)
    low = seconds % 2.18 > 0.88
    assert (scan.branch == 'low') is low
    assert low or down(request, made) == pytest.approx(12.0)
    assert scan.rounds(made) == int(seconds / 2.18) and not scan.searches_near(made)
    assert scan.turn_side(made) == 0.0


def test_a_low_look_shows_the_carpet_28_cm_from_the_neck():
    made = world_at()
    scan = PointScan(made)
    made.time_s = 1.5
    look = scan.step(made)
    lean = math.radians(made.stance.body_tilt_deg - look.neck_tilt_deg)
    angle = math.radians(down(look, made))
    ahead = 8.0 * math.sin(lean) + 8.1 * math.cos(angle) - 1.46 * math.sin(angle)
    above = 11.95 + 8.0 * math.cos(lean) - 8.1 * math.sin(angle) - 1.46 * math.cos(angle)
    assert ahead + above / math.tan(angle) == pytest.approx(28.0, abs=2.0)


@pytest.mark.parametrize('side', [1.0, -1.0])
@pytest.mark.parametrize('seconds, pan, turn', [
    (0.01, 0.0, 0.0), (0.23, 0.0, 0.0), (0.25, 44.0, 0.0), (0.49, 44.0, 0.0), (0.51, -44.0, 0.0),
    (0.89, -44.0, 0.0), (0.91, 44.0, 1.0), (1.64, 44.0, 1.0), (1.66, -44.0, -1.0),
    (3.14, -44.0, -1.0)])
def test_a_ball_lost_close_by_is_looked_for_on_its_side_and_the_other_for_3_15_s(side, seconds,
                                                                                pan, turn):
    made = world_at()
    scan = PointScan(made, side)
    made.time_s = seconds
    assert scan.step(made).head_pan_deg == pytest.approx(side * pan)
    assert scan.turn_side(made) == side * turn
    assert scan.searches_near(made) and scan.branch == 'near' and scan.rounds(made) == 0


def test_after_the_near_points_the_rounds_begin():
    made = world_at()
    scan = PointScan(made, 1.0)
    made.time_s = 3.16
    assert scan.step(made).head_pan_deg == pytest.approx(59.5, abs=0.1)
    assert not scan.searches_near(made) and scan.turn_side(made) == 0.0


@pytest.mark.parametrize('seconds, pan', [(0.1, 60.0), (0.3, 27.0), (0.5, -27.0), (0.7, -60.0)])
def test_beacons_out_of_reach_are_replaced_by_where_they_are_seen_from_the_middle(seconds, pan):
    made = world_at(heading=-90.0)
    scan = PointScan(made)
    made.time_s = seconds
    assert scan.step(made).head_pan_deg == pytest.approx(pan)


@pytest.mark.parametrize('seconds, said', [(0.1, ('beacon', 1)), (0.5, ('beacon', 3)),
                                           (1.0, ('low', 1)), (2.1, ('low', 5))])
def test_it_says_which_point_it_looks_at(seconds, said):
    made, trace = world_at(), []
    scan = PointScan(made)
    made.time_s = seconds
    scan.step(made)
    scan.explain(trace)
    assert (trace[0][2], trace[0][4]) == said


def test_before_its_first_frame_it_is_at_the_first_beacon():
    trace = []
    PointScan(world_at()).explain(trace)
    assert (trace[0][2], trace[0][4]) == ('beacon', 1)


# Glances and surveys

def tracking(seconds=10.0, away=150.0, sd=3.0, head=GoalieHead):
    """A head that has looked at a seen, resting ball for so long, without a glance so far."""
    made, eyes = world_at(), head(Memory())
    made.ball.seconds_since_seen, made.ball.distance, made.ball.relative.y = 0.0, away, away
    made.position_sd = sd
    eyes.enter(made, eyes.track)
    eyes.glanced_s, made.time_s = 0.0, seconds
    return eyes, made


@pytest.mark.parametrize('seconds, sd, heading_sd, glances', [
    (3.1, 5.9, 3.9, False), (3.3, 5.9, 3.9, True), (1.6, 6.1, 3.9, False), (1.8, 6.1, 3.9, True),
    (1.8, 5.9, 4.1, True), (1.8, 5.9, 3.9, False)])
def test_a_glance_is_due_after_1_7_s_and_after_3_2_with_a_pose_sure_to_6_cm_and_4_deg(
        seconds, sd, heading_sd, glances):
    eyes, made = tracking(seconds, sd=sd)
    made.heading_sd_deg = heading_sd
    eyes.step(made, True)
    assert (eyes.state == eyes.localise) is glances


@pytest.mark.parametrize('away, sd, glances', [
    (119.0, 3.0, False), (121.0, 3.0, True), (59.0, 10.0, False), (61.0, 10.0, True)])
def test_a_ball_within_60_cm_is_not_left_alone_nor_within_120_while_the_pose_is_sure(away, sd,
                                                                                    glances):
    eyes, made = tracking(10.0, away, sd)
    eyes.step(made, True)
    assert (eyes.state == eyes.localise) is glances


@pytest.mark.parametrize('since, speed, glances', [
    (0.69, 0.0, False), (0.71, 0.0, True), (5.0, -14.0, True), (5.0, -16.0, False),
    (5.0, 50.0, True)])
def test_a_glance_needs_0_7_s_of_tracking_a_ball_that_comes_slower_than_15_cm_a_second(since,
                                                                                      speed,
                                                                                      glances):
    eyes, made = tracking(since)
    eyes.glanced_s, made.ball.velocity.y = -10.0, speed
    eyes.step(made, True)
    assert (eyes.state == eyes.localise) is glances


def test_glances_are_counted_and_told():
    eyes, made = tracking()
    for count in (1, 2):
        eyes.enter(made, eyes.track)
        made.time_s += 10.0
        eyes.step(made, True)
        assert eyes.glances == count and eyes.numbers[0] == count


@pytest.mark.parametrize('free', [True, False])
def test_a_glance_lasts_0_3_s_unless_the_head_is_needed(free):
    eyes, made = tracking()
    eyes.step(made, True)
    made.percepts.landmarks = [kelpie.LandmarkPercept(kind=eyes.skill.kind)]
    made.time_s = 10.29
    eyes.step(made, free)
    assert (eyes.state == eyes.localise) is free
    made.time_s = 10.31
    eyes.step(made, free)
    assert eyes.state != eyes.localise


@pytest.mark.parametrize('seen_kind, state', [('own', 'believed'), ('other', 'survey'),
                                              (None, 'survey')])
def test_a_glance_that_did_not_show_its_landmark_is_followed_by_a_survey(seen_kind, state):
    eyes, made = tracking()
    eyes.step(made, True)
    kinds = {'own': [eyes.skill.kind], None: [],
             'other': [mark.kind for mark in made.field.landmarks if mark.kind != eyes.skill.kind]}
    made.percepts.landmarks = [kelpie.LandmarkPercept(kind=kind) for kind in kinds[seen_kind]]
    made.time_s = 10.1
    eyes.step(made, True)
    made.percepts.landmarks, made.time_s = [], 10.31
    made.ball.seconds_since_seen = 0.31
    eyes.step(made, True)
    assert eyes.state.__name__ == state


@pytest.mark.parametrize('seconds, pan', [(0.01, 75.0), (0.25, 75.0), (0.27, 25.0), (0.53, -25.0),
                                          (0.79, -75.0), (1.03, -75.0)])
def test_a_survey_rests_0_26_s_in_each_of_four_directions_from_left_to_right(seconds, pan):
    eyes, made = tracking()
    eyes.enter(made, eyes.survey)
    made.time_s += seconds
    request = eyes.step(made, True)
    assert request.head_pan_deg == pan and down(request, made) == pytest.approx(6.0)
    made.time_s = 11.05
    eyes.step(made, True)
    assert eyes.state != eyes.survey


@pytest.mark.parametrize('since, surveys', [(1.9, False), (2.1, True)])
def test_a_lost_pose_is_surveyed_again_after_2_s(since, surveys):
    eyes, made = tracking(away=15.0)
    eyes.hints = Hints()
    eyes.hints.pose_lost, eyes.surveyed_s = True, 10.0 - since
    eyes.step(made, True)
    assert (eyes.state == eyes.survey) is surveys


def test_a_head_that_is_needed_makes_no_survey():
    eyes, made = tracking(away=15.0)
    eyes.hints = Hints()
    eyes.hints.pose_lost = True
    eyes.step(made, False)
    assert eyes.state == eyes.track


# A lost ball

@pytest.mark.parametrize('unseen, state', [(0.24, 'track'), (0.26, 'believed')])
def test_a_ball_is_lost_after_0_25_s(unseen, state):
    eyes, made = tracking(0.3)
    made.ball.seconds_since_seen = unseen
    eyes.step(made, False)
    assert eyes.state.__name__ == state


@pytest.mark.parametrize('seconds, present, state', [(0.39, True, 'believed'),
                                                     (0.41, True, 'search'),
                                                     (0.1, False, 'search')])
def test_it_is_looked_for_0_4_s_where_it_is_believed_then_by_the_scan(seconds, present, state):
    eyes, made = tracking()
    eyes.enter(made, eyes.believed)
    made.ball.seconds_since_seen, made.ball.present = 5.0, present
    made.time_s += seconds
    eyes.step(made, True)
    assert eyes.state.__name__ == state


@pytest.mark.parametrize('away, bearing, near', [
    (59.0, 30.0, 1.0), (59.0, -30.0, -1.0), (59.0, 0.0, 1.0), (61.0, 30.0, 0.0)])
def test_a_ball_lost_within_60_cm_is_looked_for_low_on_its_side_first(away, bearing, near):
    eyes, made = tracking(away=away)
    eyes.step(made, False)
    made.ball.heading_deg = bearing
    scan = eyes.scan(made)
    made.time_s += 0.3
    assert scan.searches_near(made) is (near != 0.0)
    if near:
        assert scan.step(made).head_pan_deg == near * 44.0


@pytest.mark.parametrize('since, looks', [(0.1, True), (0.49, True), (0.51, False), (1.9, False),
                                          (2.1, True)])
def test_where_mates_see_it_is_looked_at_for_0_5_of_every_2_s(since, looks):
    eyes, made = tracking()
    made.ball.seconds_since_seen = 9.0
    eyes.hints = Hints()
    eyes.hints.reported = (280.0, 120.0)
    eyes.enter(made, eyes.search, PointScan(made))
    made.time_s += since
    pan = eyes.step(made, True).head_pan_deg
    assert (pan == pytest.approx(-45.0)) is looks


@pytest.mark.parametrize('x, near, first', [
    (-40.0, True, 44.0), (40.0, True, -44.0), (-70.0, False, None), (70.0, False, None)])
def test_after_mates_have_lost_it_too_it_is_looked_for_on_that_side_if_they_saw_it_near(x, near,
                                                                                      first):
    eyes, made = tracking()
    made.ball.seconds_since_seen = 9.0
    eyes.hints, eyes.mates_saw = Hints(), (180.0 + x, 20.0)
    eyes.enter(made, eyes.search, PointScan(made))
    eyes.step(made, True)
    assert eyes.searches_near(made) is near and eyes.mates_saw is None
    if near:
        made.time_s += 0.3
        assert eyes.step(made, True).head_pan_deg == first


@pytest.mark.parametrize('place, seconds, unseen, state', [
    ((280.0, 120.0), 0.3, 9.0, 'expected'), ((280.0, 120.0), 0.41, 9.0, 'search'),
    ((280.0, 120.0), 0.2, 0.1, 'track'), ((280.0, 120.0), 0.2, 0.22, 'expected')])
def test_a_kicked_ball_is_expected_for_0_4_s_where_it_should_be(place, seconds, unseen, state):
    eyes, made = tracking()
    eyes.expect(made, place)
    made.time_s += seconds
    made.ball.seconds_since_seen = unseen
    request = eyes.step(made, True)
    assert eyes.state.__name__ == state
    if state == 'expected':
        assert request.head_pan_deg == pytest.approx(-45.0)


@pytest.mark.parametrize('x, side', [(280.0, -1.0), (80.0, 1.0)])
def test_a_kicked_ball_that_is_not_there_is_looked_for_low_on_that_side(x, side):
    eyes, made = tracking()
    eyes.expect(made, (x, 120.0))
    made.time_s, made.ball.seconds_since_seen = 10.41, 9.0
    eyes.step(made, True)
    made.time_s += 0.3
    assert eyes.step(made, True).head_pan_deg == side * 44.0


@pytest.mark.parametrize('side', [1.0, -1.0])
@pytest.mark.parametrize('unseen, searches', [(0.2, False), (0.3, True)])
def test_after_a_block_the_ball_is_looked_for_close_by_unless_it_is_seen(side, unseen, searches):
    eyes, made = tracking()
    made.ball.seconds_since_seen = unseen
    eyes.look_near(made, side)
    assert eyes.searches_near(made) is searches
    made.time_s += 0.3
    if searches:
        assert eyes.step(made, True).head_pan_deg == side * 44.0


# The head of 2004

@pytest.mark.parametrize('state, seconds, pan, pitch', [
    ('horizon', 0.0, 88.0, 18.0), ('horizon', 0.5, 28.0, 18.0), ('horizon', 1.46, -87.2, 18.0),
    ('feet', 0.0, 88.0, 48.0), ('feet', 0.4, -12.0, 48.0), ('feet', 0.7, -87.0, 48.0)])
def test_the_search_of_2004_pans_at_120_deg_a_second_at_the_horizon_and_250_at_the_feet(
        state, seconds, pan, pitch):
    made, eyes = world_at(), EllipseHead(Memory())
    made.ball.seconds_since_seen = 9.0
    eyes.enter(made, getattr(eyes, state))
    made.time_s += seconds
    request = eyes.step(made, True)
    assert eyes.state.__name__ == state
    assert request.head_pan_deg == pytest.approx(pan)
    assert down(request, made) == pytest.approx(pitch, abs=2.0)


@pytest.mark.parametrize('state, seconds, after', [('horizon', 1.48, 'feet'),
                                                   ('feet', 0.71, 'horizon')])
def test_its_two_sweeps_take_turns(state, seconds, after):
    made, eyes = world_at(), EllipseHead(Memory())
    made.ball.seconds_since_seen = 9.0
    eyes.enter(made, getattr(eyes, state))
    made.time_s += seconds
    eyes.step(made, True)
    assert eyes.state.__name__ == after


@pytest.mark.parametrize('seconds, after', [(0.24, 'last_angle'), (0.26, 'believed')])
def test_the_angle_of_before_is_held_for_0_25_s_after_a_glance_of_2004(seconds, after):
    eyes, made = tracking(head=EllipseHead)
    made.head = SimpleNamespace(neck_tilt_deg=-20.0, head_pan_deg=33.0, head_nod_deg=12.0)
    eyes.step(made, False)
    eyes.enter(made, eyes.last_angle)
    made.time_s += seconds
    made.ball.seconds_since_seen = 9.0
    request = eyes.step(made, True)
    assert eyes.state.__name__ == after
    if after == 'last_angle':
        assert (request.neck_tilt_deg, request.head_pan_deg, request.head_nod_deg) == (
            -20.0, 33.0, 12.0)


@pytest.mark.parametrize('glances, limit', [(0, 45.0), (1, 80.0), (2, 45.0), (3, 80.0)])
def test_in_every_second_glance_of_2004_only_45_deg_to_the_front_count(glances, limit):
    eyes, made = tracking(head=EllipseHead)
    goal = [mark for mark in made.field.landmarks if mark.position.y == 540.0]
    eyes.glances, made.field, found = glances, SimpleNamespace(landmarks=goal), []
    for bearing in (44.0, 46.0, 79.0, 81.0):
        made.pose.heading_deg = 90.0 - bearing   # the far goal's middle is that far to the left
        found.append(eyes.next_landmark(made) is not None)
    assert found == [bearing <= limit for bearing in (44.0, 46.0, 79.0, 81.0)]
