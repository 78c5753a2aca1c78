# SPDX-License-Identifier: Apache-2.0
"""Approach, can-grab and the grab (thesis 2006 section 6.3), the aim at gaps, the dodge, the hold's
limits."""
import math

import kelpie
import pytest
from situation import aim, infrared
from situation.aim import Aim
from situation.memory import Memory
from situations import put_ball, world
from skills.ball import dodge
from skills.ball.dodge import Dodge
from skills.ball.grab import (DRAG, FAST_UNTIL, FAST_WITHIN, PREDICTED, SPIN_FROM, SPIN_UNTIL, Grab,
                              approach, can_grab, walk_kind)
from skills.ball.hold import Hold

FIELD = kelpie.FIELDS['2006']
LONG = 100  # frames since a large turn


def at(distance, degrees):
    angle = math.radians(degrees)
    return -distance * math.sin(angle), distance * math.cos(angle)


def test_the_approach_has_no_side_steps_and_turns_10_percent_less():
    walk = approach(at(100.0, 60.0))
    assert (walk.forward, walk.left, walk.turn_deg) == pytest.approx((50.0, 0.0, 54.0))


@pytest.mark.parametrize('lateral, last, kind', [
    (SPIN_FROM + 1.0, kelpie.WALK, kelpie.WALK_TURNING),
    (SPIN_FROM - 1.0, kelpie.WALK, kelpie.WALK),
    (-SPIN_UNTIL - 1.0, kelpie.WALK_TURNING, kelpie.WALK_TURNING),
    (-SPIN_UNTIL + 1.0, kelpie.WALK_TURNING, kelpie.WALK),
    (FAST_WITHIN - 1.0, kelpie.WALK, kelpie.WALK_FAST),
    (FAST_WITHIN + 1.0, kelpie.WALK, kelpie.WALK),
    (FAST_UNTIL - 1.0, kelpie.WALK_FAST, kelpie.WALK_FAST),
    (FAST_UNTIL + 1.0, kelpie.WALK_FAST, kelpie.WALK)])
def test_a_walk_is_left_later_than_it_is_begun(lateral, last, kind):
    assert walk_kind(100.0, lateral, last) == kind


@pytest.mark.parametrize('ball, velocity, turn_lost, wanted', [
    ((0.0, 13.4), (0.0, 0.0), LONG, True),
    ((0.0, 13.6), (0.0, 0.0), LONG, False),
    ((2.9, 12.0), (0.0, 0.0), LONG, True),
    ((3.1, 12.0), (0.0, 0.0), LONG, False),
    ((0.0, 10.0), (0.0, 0.0), 15, True),
    ((0.0, 10.2), (0.0, 0.0), 15, False),
    ((0.0, 10.2), (0.0, 0.0), 16, True),
    ((0.0, 17.0), (0.0, -1.0), LONG, True),
    ((0.0, 18.0), (0.0, -1.0), LONG, False),
    ((0.0, 12.0), (0.0, 2.0), LONG, True),
    ((7.0, 12.0), (-1.2, 0.0), LONG, True),
    ((0.0, -5.0), (0.0, 0.0), LONG, False)])
def test_can_grab_looks_six_frames_ahead(ball, velocity, turn_lost, wanted):
    assert can_grab(ball, velocity, turn_lost) == wanted


def test_a_ball_rolls_4_69_of_its_velocity_in_six_predicted_frames():
    assert sum(DRAG ** i for i in range(PREDICTED)) == pytest.approx(4.69, abs=0.005)


def grabbing(ir):
    """A grab at its begin, with what the filtered infrared reads."""
    memory = Memory()
    memory.chest, memory.turn_lost = ir, LONG
    skill, made = Grab(memory), world(180, 200, 90, (180, 212))
    return skill, made, skill.step(made)


@pytest.mark.parametrize('ir, motion', [(50.0, kelpie.GRAB), (5.0, kelpie.GRAB_QUICK)])
def test_infrared_that_reads_near_halves_the_grab(ir, motion):
    skill, made, command = grabbing(ir)
    assert skill.committed and command.motion == motion
    assert command.walk.kind == kelpie.WALK_DRIBBLE and command.mouth_open


def test_a_grab_is_asked_for_until_it_runs_and_is_done_when_it_has_ended():
    skill, made, _ = grabbing(50.0)
    made.time_s += 0.1
    made.motion.running = kelpie.GRAB
    assert skill.step(made).motion == kelpie.NO_MOTION and not skill.done
    made.time_s += 0.4
    made.motion.running = kelpie.NO_MOTION
    skill.step(made)
    assert skill.done


@pytest.mark.parametrize('ahead, waited', [(8.0, True), (12.0, False)])
def test_the_rules_clock_starts_when_the_ball_lies_between_the_paws(ahead, waited):
    skill, made = Grab(Memory()), world(180.0, 200.0, 90.0, (180.0, 200.0 + ahead))
    made.ball.seconds_since_seen = 1.0  # not seen, not grabbed
    for _ in range(10):
        made.time_s += 1.0 / 30.0
        skill.step(made)
    first = 1.0 / 30.0
    put_ball(made, 180.0, 208.0)
    skill.step(made)
    assert skill.committed and skill.begun_s == pytest.approx(first if waited else made.time_s)


def test_a_grab_that_never_starts_is_given_up():
    skill, made, _ = grabbing(50.0)
    for _ in range(30):
        made.time_s += 1.0 / 30.0
        skill.step(made)
    assert skill.done


# Gaps

def goal_gap(left, right):
    return kelpie.GoalGap(goal=kelpie.GOAL_BLUE, left_deg=left, right_deg=right)


@pytest.mark.parametrize('left, right, side', [
    (None, (5, -5), aim.RIGHT), ((5, -5), None, aim.LEFT), ((20, 5), (5, 0), aim.LEFT),
    ((5, 0), (0, -9), aim.RIGHT), ((10, 5), (0, -5), aim.RIGHT)])
def test_the_wider_gap_is_taken_and_ties_go_to_the_right(left, right, side):
    assert aim.best_side(left, right) == side


def test_a_locked_gap_is_kept_when_the_other_becomes_wider():
    made, target = world(), Aim()
    made.percepts.gaps = [goal_gap(-2, -6), goal_gap(12, 4)]
    target.update(made)
    assert target.gap == (12, 4)
    made.percepts.gaps = [goal_gap(0, -20), goal_gap(12, 4)]
    target.update(made)
    assert target.gap == (12, 4)


def test_it_has_aimed_after_four_frames_that_need_not_follow_one_another():
    made, target = world(), Aim()
    reported = []
    for left, right in [(4, -4), (20, 12), (4, -4), (4, -4), (30, 22), (4, -4)]:
        made.percepts.gaps = [goal_gap(left, right)]
        target.update(made)
        reported.append(target.aimed)
    assert reported == [False] * 5 + [True]


def test_the_padding_grows_with_the_gap():
    widths = []
    for half in (6, 9, 14):
        target, made = Aim(), world()
        made.percepts.gaps = [goal_gap(half, -half)]
        target.update(made)
        widths.append(target.padding)
    assert widths == sorted(widths) and widths[0] < widths[-1]


def test_a_gap_out_of_sight_is_carried_by_odometry_for_15_frames_then_the_pose_tells():
    made, target = world(180, 400, 90), Aim()
    made.percepts.gaps = [goal_gap(20, 10)]
    target.update(made)
    made.percepts.gaps = []
    made.odometry.turn_deg = 1.0
    for _ in range(15):
        target.update(made)
    assert target.gap == pytest.approx((5.0, -5.0)) and target.by_sight
    target.update(made)
    assert not target.by_sight and target.middle == pytest.approx(0.0)


def test_who_aims_by_pose_does_not_look_at_gaps():
    made, target = world(180, 400, 90), Aim()
    made.task.aiming = kelpie.AIMING_BY_POSE
    made.percepts.gaps = [goal_gap(20, 10)]
    target.update(made)
    assert target.middle == pytest.approx(0.0) and not target.by_sight


# Dodge

@pytest.mark.parametrize('x, y, side', [
    (59.9, 200, -1), (300.1, 200, 1), (99, 499, -1), (261, 499, 1), (150, 400, -1),
    (210, 400, 1), (150, 200, 1), (210, 200, -1), (150, 270, 1), (150, 271, -1)])
def test_the_side_of_a_dodge_goes_by_the_place(x, y, side):
    """Alg 6.7: away from edges and corners; in the front half to the centre, else to the side."""
    assert dodge.side_by_place(FIELD, x, y) == side


def test_before_the_goal_the_wider_gap_tells_the_side_else_the_goal_itself():
    assert dodge.side_by_gaps((30, 10), (0, -5), 0.0) == 1.0
    assert dodge.side_by_gaps((30, 28), (0, -15), 0.0) == -1.0
    assert dodge.side_by_gaps(None, None, -8.0) == -1.0


@pytest.mark.parametrize('y, frames', [(440, 7), (300, 30)])
def test_a_dodge_goes_on_until_the_way_was_free_for_some_frames(y, frames):
    made, memory = world(180, y, 90), Memory()
    made.sensors.head_near_distance = 15.0
    step = Dodge(made, memory)
    for _ in range(10):
        step.step(made)
    assert not step.done
    made.sensors.head_near_distance = 50.0
    for _ in range(frames - 1):
        step.step(made)
    assert not step.done
    step.step(made)
    assert step.done


def test_one_near_reading_makes_a_dodge_go_on_for_all_its_frames_again():
    made = world(180, 440, 90)
    made.sensors.head_near_distance = 15.0
    step = Dodge(made, Memory())
    distances = [50.0] * 6 + [15.0] + [50.0] * 6
    for made.sensors.head_near_distance in distances:
        step.step(made)
    assert not step.done


@pytest.mark.parametrize('threshold, away, near', [
    (None, 19.9, True), (None, 20.0, False), (15.2, 15.1, True), (15.2, 15.3, False)])
def test_infrared_says_near_below_what_this_robots_sensor_was_calibrated_to(threshold, away, near):
    """Without a calibration 20 cm, as in the final of 2006."""
    made = world()
    made.sensors = kelpie.WorldSensors(head_near_distance=away)
    if threshold is not None:
        made.sensors.head_near_threshold = threshold
    assert infrared.somebody_near(made) is near


# The rules of holding

def test_a_hold_knows_how_far_it_was_carried_around_turns():
    made = world()
    hold = Hold(made, made.time_s)
    made.odometry.forward = 1.0
    for turn in [0.0] * 20 + [90.0] + [0.0] * 20:
        made.odometry.turn_deg = turn
        made.time_s += 1.0 / 30.0
        hold.update(made)
    assert hold.way == pytest.approx(math.hypot(21.0, 20.0))
    assert hold.seconds(made) == pytest.approx(41.0 / 30.0)


def test_a_ball_that_is_not_felt_for_a_third_of_a_second_has_slipped_out():
    made = world()
    hold = Hold(made, made.time_s)
    slipped = []
    for frame in range(40):
        made.time_s += 1.0 / 30.0
        hold.update(made)
        slipped.append(hold.slipped)
    assert slipped.index(True) == 22  # 0.45 s until the feeling counts, then ten frames
