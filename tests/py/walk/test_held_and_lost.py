# SPDX-License-Identifier: Apache-2.0
"""The times and speeds of who backs off, and the places of who walks about for a lost ball."""
import math

import kelpie
import pytest
from situations import world
from skills.walk.paw_stuck import PawStuck
from skills.walk.roam import Roam, beside, hiding


# Backing off

def felt(time_s=0.0, paws=(False, False), stuck=False, forward=0.0, ball=None):
    made = kelpie.WorldFrame(time_s=time_s)
    made.motion.feeling.paw_blocked = list(paws)
    made.motion.feeling.stuck, made.last_command.walk.forward = stuck, forward
    if ball is not None:
        made.ball.present, made.ball.distance = True, ball
        made.ball.seconds_since_seen = 0.0
    return made


@pytest.mark.parametrize('paws, left', [((True, True), 0.0), ((True, False), -18.0),
                                        ((False, True), 18.0)])
def test_it_backs_at_24_cm_a_second_and_18_to_the_side_that_is_free(paws, left):
    skill, made = PawStuck(), felt(0.0, paws)
    assert skill.needed(made)
    walk = skill.step(made).walk
    assert (walk.forward, walk.left) == (-24.0, left)
    assert skill.step(made).head.elevation_deg == -10.0


@pytest.mark.parametrize('ball, backs', [(29.0, False), (31.0, True), (None, True)])
def test_a_paw_within_30_cm_of_the_ball_may_push_at_it(ball, backs):
    assert PawStuck().needed(felt(0.0, (True, False), ball=ball)) is backs


@pytest.mark.parametrize('forward, backs', [(7.9, False), (8.1, True)])
def test_who_is_held_backs_off_when_it_walks_ahead_by_8_cm_a_second(forward, backs):
    assert PawStuck().needed(felt(0.0, stuck=True, forward=forward)) is backs


def test_it_backs_for_0_8_s_and_heeds_no_paw_for_0_5_s_after():
    skill, found = PawStuck(), {}
    skill.needed(felt(0.0, (True, False)))
    for time_s in (0.79, 0.81, 1.29, 1.31):
        found[time_s] = skill.needed(felt(time_s, (time_s > 1.0, False)))
    assert found == {0.79: True, 0.81: False, 1.29: False, 1.31: True}


def test_who_backs_into_something_goes_on_after_0_5_s_and_heeds_no_paw_for_2_5_s():
    skill = PawStuck()
    skill.needed(felt(0.0, (True, False)))
    assert skill.needed(felt(0.49, stuck=True, forward=-24.0))
    assert not skill.needed(felt(0.51, stuck=True, forward=-24.0))
    assert not skill.needed(felt(3.0, (True, True)))
    assert skill.needed(felt(3.02, (True, True)))


@pytest.mark.parametrize('again_s, left', [(3.9, -18.0), (4.1, 0.0)])
def test_whoever_was_met_head_on_within_4_s_is_passed_on_the_right(again_s, left):
    skill = PawStuck()
    skill.needed(felt(0.0, (True, True)))
    skill.needed(felt(0.9))
    made = felt(again_s, (True, True))
    assert skill.needed(made) and skill.step(made).walk.left == left


# Walking about

def at(x, y, opponents=(), since=0.0):
    made = world(x, y)
    made.opponents = [kelpie.OpponentEstimate(position=kelpie.Point2(x=a, y=b),
                                              seconds_since_seen=since) for a, b in opponents]
    return made


@pytest.mark.parametrize('here, robot, place', [
    ((260.0, 100.0), (260.0, 270.0), (210.0, 285.0)), ((100.0, 100.0), (100.0, 270.0),
                                                       (150.0, 285.0)),
    ((260.0, 440.0), (260.0, 270.0), (210.0, 255.0)), ((60.0, 400.0), (200.0, 400.0),
                                                       (215.0, 350.0)),
    ((60.0, 140.0), (200.0, 140.0), (215.0, 190.0)), ((300.0, 140.0), (160.0, 140.0),
                                                      (145.0, 190.0))])
def test_a_robot_is_passed_50_cm_aside_and_15_beyond_on_the_side_of_the_fields_middle(here, robot,
                                                                                      place):
    made = at(*here)
    away = math.hypot(robot[0] - here[0], robot[1] - here[1])
    assert beside(made, away, *robot) == pytest.approx(place)


def test_places_are_30_cm_from_the_lines():
    """A robot before the upper right corner, and one before the lower left."""
    assert beside(at(180.0, 535.0), 150.0, 330.0, 535.0)[0] == 330.0
    assert beside(at(10.0, 180.0), 160.0, 10.0, 20.0)[1] == 30.0
    assert beside(at(400.0, 500.0), 100.0, 400.0, 600.0) == (330.0, 510.0)
    assert beside(at(-40.0, 50.0), 100.0, -40.0, -50.0) == (30.0, 30.0)


@pytest.mark.parametrize('away, since, hides', [
    (29.0, 0.0, False), (31.0, 0.0, True), (249.0, 9.9, True), (251.0, 0.0, False),
    (100.0, 10.1, False)])
def test_a_ball_may_be_hidden_by_who_is_30_to_250_cm_off_and_was_seen_within_10_s(away, since,
                                                                                  hides):
    made = at(180.0, 100.0, [(180.0, 100.0 + away)], since)
    assert list(hiding(made)) == ([(pytest.approx(away), 180.0, 100.0 + away)] if hides else [])


@pytest.mark.parametrize('moved, again', [(59.0, False), (61.0, True)])
def test_a_robot_within_60_cm_of_where_one_was_is_the_same(moved, again):
    made = at(180.0, 100.0, [(180.0, 250.0)])
    roam = Roam(made)
    roam.step(made)
    made.opponents[0].position.x += moved
    made.pose.position.x, made.pose.position.y = roam.place
    roam.step(made)
    assert (roam.place not in ((180.0, 351.0), (180.0, 189.0))) is again


@pytest.mark.parametrize('away, seconds, goes_on', [
    (31.0, 1.0, True), (29.0, 1.0, False), (200.0, 8.9, True), (200.0, 9.1, False)])
def test_a_place_counts_as_reached_within_30_cm_and_is_given_up_after_9_s(away, seconds, goes_on):
    made = at(180.0, 100.0)
    made.time_s = 5.0
    roam = Roam(made)
    roam.step(made)
    made.pose.position.y, made.time_s = 351.0 - away, 5.0 + seconds
    roam.step(made)
    assert (roam.place == (180.0, 351.0)) is goes_on


@pytest.mark.parametrize('y, first', [(269.0, 351.0), (271.0, 189.0)])
def test_the_other_half_is_looked_through_first_then_both_in_turn(y, first):
    made = at(100.0, y)
    roam, found = Roam(made), []
    for _ in range(3):
        roam.step(made)
        found.append(roam.place)
        made.pose.position.x, made.pose.position.y = roam.place
    assert [place[1] for place in found] == pytest.approx([first, 540.0 - first, first])
    assert {place[0] for place in found} == {180.0}
