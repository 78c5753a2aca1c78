# SPDX-License-Identifier: Apache-2.0
"""Who grabs and holds the ball by the theses' rules alone, and how Kelpie differs: made situations,
with the numbers of thesis 2006 sections 6.3 and 6.4."""
import math

import kelpie
import pytest
from decisions import kick_choice, tree
from decisions.held_choice import HeldChoice
from lib import hints
from situation.contested import Contested
from situation.memory import Memory
from situations import world
from skills.ball import dodge
from skills.ball.grab import Grab
from skills.ball.grab_dribble import GrabDribble
from skills.ball.hold import Hold
from test_own_goal_seen import seeing

KELPIE, THESIS = kelpie.RULES_OF_KELPIE, kelpie.RULES_OF_THESIS
BOTH = pytest.mark.parametrize('rules', [KELPIE, THESIS], ids=['kelpie', 'thesis'])
FRAME_S = 1.0 / 30.0


def by(rules, made):
    """The same world, played by those rules."""
    made.task = kelpie.Task(rules=rules)
    return made


# Grab, section 6.3

@pytest.mark.parametrize('rules, degrees, turn', [
    (THESIS, 30.0, 27.0), (THESIS, 60.0, 54.0), (KELPIE, 30.0, 54.0), (KELPIE, 60.0, 180.0)])
def test_the_ball_is_turned_to_with_nine_tenths_of_its_heading(rules, degrees, turn):
    """walk(d cos h, 0, 0.9 h); Kelpie twice as fast, and on the spot to a ball far aside."""
    angle = math.radians(90.0 + degrees)
    ball = 180.0 + 80.0 * math.cos(angle), 200.0 + 80.0 * math.sin(angle)
    walk = Grab(Memory()).step(by(rules, world(ball=ball))).walk
    assert walk.turn_deg == pytest.approx(turn) and walk.left == 0.0
    assert (walk.forward > 0.0) is (rules == THESIS or degrees < 50.0)


def grabbing(rules):
    """A grab whose motion has just begun, the ball not close by infrared yet."""
    memory = Memory()
    memory.chest = 50.0
    skill, made = Grab(memory), by(rules, world(180.0, 200.0, 90.0, (180.0, 212.0)))
    motion = kelpie.GRAB_LIFT if rules == THESIS else kelpie.GRAB
    assert skill.step(made).motion == motion
    made.time_s, made.motion.running = FRAME_S, motion
    return skill, made


@pytest.mark.parametrize('rules, degrees, pan', [
    (THESIS, 12.0, 12.0), (THESIS, -12.0, -12.0), (THESIS, 50.0, 30.0), (KELPIE, 12.0, 0.0)])
def test_the_head_is_turned_to_the_ball_in_a_grab(rules, degrees, pan):
    """Section 6.3.5: by where the ball was seen last."""
    skill, made = grabbing(rules)
    made.ball.heading_deg = degrees
    assert skill.step(made).head.head_pan_deg == pan


@pytest.mark.parametrize('rules, motion', [(THESIS, kelpie.GRAB_QUICK), (KELPIE, kelpie.NO_MOTION)])
def test_a_grab_that_has_begun_counts_twice_once_infrared_says_near(rules, motion):
    """Alg 6.4; Kelpie's infrared is asked as it begins."""
    skill, made = grabbing(rules)
    assert skill.step(made).motion == kelpie.NO_MOTION
    skill.memory.chest = 5.0
    assert skill.step(made).motion == motion
    made.motion.running = kelpie.GRAB_QUICK
    assert skill.step(made).motion == kelpie.NO_MOTION and not skill.done


def test_a_grab_about_to_end_is_not_hurried():
    skill, made = grabbing(THESIS)
    skill.memory.chest, made.time_s = 5.0, 0.35
    assert skill.step(made).motion == kelpie.NO_MOTION


@pytest.mark.parametrize('rules, meets', [(THESIS, False), (KELPIE, True)])
def test_by_the_theses_a_rolling_ball_is_walked_at_where_it_is(rules, meets):
    made = by(rules, world(ball=(180.0, 280.0)))
    made.ball.velocity.x, made.ball.stopping_point.x = 60.0, 240.0
    assert (Grab(Memory()).step(made).walk.turn_deg < -1.0) is meets


# Turn and aim, sections 6.4.2 and 6.4.3

def holding(rules, x=180.0, y=300.0, heading=90.0, sure=True, plan=tree.GRAB_TURN_KICK):
    """A robot that feels the ball in its arms and has no goal in sight."""
    made, memory = by(rules, world(x, y, heading)), Memory()
    made.heading_sd_deg = 2.0 if sure else 60.0
    made.motion.feeling.ball_held = True
    skill = GrabDribble(memory, HeldChoice(memory, Contested()).choose, plan)
    skill.hold = Hold(made, made.time_s)
    skill.enter(made, skill.turn)
    return made, skill


def run(made, skill, frames, moves=False):
    """The Commands of so many frames; `moves`: the robot turns as it is asked to."""
    commands = []
    for _ in range(frames):
        made.time_s += FRAME_S
        skill.memory.update(made)
        commands.append(skill.step(made))
        if skill.hint is not None:
            skill.memory.set_hint(*skill.hint)
        if moves:
            made.odometry.turn_deg = commands[-1].walk.turn_deg * FRAME_S
            made.pose.heading_deg += made.odometry.turn_deg
    return commands


def show_goal(made, middle=0.0, half=8.0):
    made.percepts.gaps = [kelpie.GoalGap(goal=kelpie.GOAL_BLUE, left_deg=middle + half,
                                         right_deg=middle - half)]
    return seeing(made, middle, kelpie.GOAL_BLUE, 2.0 * half)


@pytest.mark.parametrize('rules, y, speed', [
    (THESIS, 390.0, 50.0), (THESIS, 410.0, 40.0), (KELPIE, 390.0, 100.0), (KELPIE, 410.0, 80.0)])
def test_a_goal_that_nobody_knows_of_is_turned_for_at_one_speed(rules, y, speed):
    made, skill = holding(rules, y=y, heading=-80.0, sure=False)
    assert [command.walk.turn_deg for command in run(made, skill, 5)] == pytest.approx([speed] * 5)


@pytest.mark.parametrize('rules, side', [(THESIS, 1.0), (KELPIE, -1.0)])
def test_the_goal_is_searched_the_shorter_way_to_it_not_to_up_field(rules, side):
    """Beside the goal at the right, looking up-field and a little to the left."""
    made, skill = holding(rules, 304.0, 488.0, 101.0, sure=False)
    assert run(made, skill, 1)[0].walk.turn_deg * side > 0.0


@pytest.mark.parametrize('rules, wanted', [(THESIS, [50.0] * 3), (KELPIE, [130.0] * 3)])
def test_in_the_own_half_the_pose_says_which_way_and_the_theses_turn_at_that_speed(rules, wanted):
    made, skill = holding(rules, y=150.0, heading=20.0)
    assert [command.walk.turn_deg for command in run(made, skill, 3)] == pytest.approx(wanted)


@pytest.mark.parametrize('rules, y, spins', [
    (THESIS, 300.0, True), (THESIS, 400.0, True), (THESIS, 250.0, False), (KELPIE, 300.0, False),
    (KELPIE, 400.0, False)])
def test_in_the_front_half_it_spins_until_it_sees_the_goal(rules, y, spins):
    """However sure the pose, and also after the 30 frames of Alg 6.11: time ends it."""
    made, skill = holding(rules, y=y)
    commands = run(made, skill, 40)
    assert all(command.walk.turn_deg != 0.0 and command.motion == kelpie.NO_MOTION
               for command in commands) is spins
    if spins:
        show_goal(made)
        assert skill.state == skill.turn
        run(made, skill, 5)
        assert skill.state == skill.steady


@pytest.mark.parametrize('y, motion', [
    (100.0, kelpie.HARD_FORWARD), (300.0, kelpie.HARD_FORWARD), (330.0, kelpie.WEDGE),
    (400.0, kelpie.HEAD_SWIPE_LEFT)])
def test_out_of_time_a_kick_is_issued_without_sight_of_the_goal(y, motion):
    """Alg 6.8 and 6.11: it has turned left for more than 30 frames."""
    made, skill = holding(THESIS, y=y, heading=-80.0, sure=False)
    commands = run(made, skill, 82)
    assert commands[-1].motion == motion


@pytest.mark.parametrize('frames, kicks', [(3, False), (4, True)])
def test_four_aimed_frames_make_a_kick_and_those_by_the_pose_do_not_count(frames, kicks):
    """Alg 6.6."""
    made, skill = holding(THESIS, y=150.0)
    run(made, skill, 3)
    assert skill.aim.aimed_frames == 3
    show_goal(made)
    run(made, skill, frames)
    assert (skill.state == skill.steady) is kicks


def test_a_pose_that_says_it_faces_the_goal_is_over_turned_for_8_frames_then_kicked():
    made, skill = holding(THESIS, y=150.0)
    run(made, skill, 3)
    over = run(made, skill, 9)
    turns = [command.walk.turn_deg for command in over]
    assert [abs(turn) for turn in turns[:8]] == pytest.approx([50.0] * 8) and turns[8] == 0.0
    assert skill.state == skill.steady


# Kicks, section 6.4.7

@pytest.mark.parametrize('rules, turn', [(THESIS, -50.0), (KELPIE, 0.0)])
def test_who_has_aimed_at_its_own_goal_spins_away_from_it(rules, turn):
    """Alg 6.8, whatever the pose says."""
    made, skill = holding(rules, y=150.0)
    seeing(made, 3.0, wide=24.0)
    run(made, skill, 13)
    assert skill.state == (skill.spin_away if rules == THESIS else skill.turn)
    assert run(made, skill, 1)[0].walk.turn_deg == pytest.approx(turn)
    show_goal(made)
    run(made, skill, 1)
    assert skill.state == skill.turn


@BOTH
def test_out_of_time_in_sight_of_its_own_goal_it_lets_go(rules):
    made, skill = holding(rules, y=150.0)
    skill.memory.update(seeing(made, 0.0, wide=40.0))
    assert skill.choose(made, skill, True)[0] == kick_choice.RELEASE


@pytest.mark.parametrize('rules, kick', [(THESIS, kelpie.WEDGE), (KELPIE, None)])
def test_a_contested_ball_of_the_midfield_is_kicked_softly(rules, kick):
    made, skill = holding(rules, y=250.0)
    show_goal(made)
    contested = Contested()
    contested.frames = 0
    run(made, skill, 4)
    chosen = HeldChoice(skill.memory, contested).choose(made, skill, False)
    assert chosen is not None and (chosen[0] == kick or rules == KELPIE)


@pytest.mark.parametrize('plan, motion', [(tree.GRAB_UPENN_LEFT, kelpie.UPENN_LEFT),
                                          (tree.GRAB_UPENN_RIGHT, kelpie.UPENN_RIGHT)])
def test_by_the_theses_the_leaf_says_of_a_held_ball_to_strike_it(plan, motion):
    made, skill = holding(THESIS, 40.0, 480.0, 180.0, plan=plan)
    assert run(made, skill, 8)[-1].motion == motion


def test_by_the_theses_nobody_plays_to_a_mate():
    made, skill = holding(THESIS, y=150.0)
    made.task.passing = True
    made.teammates = [kelpie.TeammateEstimate(player=2)]
    made.teammates[0].pose.position.x, made.teammates[0].pose.position.y = 180.0, 300.0
    run(made, skill, 4)
    assert HeldChoice(skill.memory, Contested()).choose(made, skill, False)[0] == (
        kelpie.HARD_FORWARD)


# Dodge, section 6.4.4

@pytest.mark.parametrize('rules, infrared, pixels, seen_before, dodges', [
    (THESIS, 19.0, 0, 0.0, True), (THESIS, 50.0, 12, 0.0, True), (THESIS, 50.0, 0, 20.0, False),
    (KELPIE, 19.0, 0, 0.0, True), (KELPIE, 50.0, 12, 0.0, True), (KELPIE, 50.0, 0, 20.0, True)])
def test_infrared_and_dark_pixels_say_that_somebody_is_in_the_way(rules, infrared, pixels,
                                                                  seen_before, dodges):
    made = by(rules, world())
    made.sensors.head_near_distance, made.percepts.obstacles_ahead = infrared, pixels
    cell = kelpie.ObstacleCell(own=seen_before)
    cell.position.x, cell.position.y = 180.0, 230.0
    made.obstacles = [cell]
    assert dodge.in_the_way(made) is dodges


def test_by_the_theses_who_stands_in_the_way_is_dodged_whatever_the_switch_says():
    made, skill = holding(THESIS, 100.0, 200.0)
    made.task.dodge, made.sensors.head_near_distance = False, 19.0
    show_goal(made)
    assert run(made, skill, 1)[0].walk.left > 0.0 and skill.state == skill.dodge


# Edge, section 6.4.5: heading, forward, left; at the left line, where the way in is to the right
EDGE_WALKS = [(90.0, 0.0, -14.0), (-90.0, 0.0, 14.0), (180.0, -14.0, 0.0), (135.0, -9.9, -9.9),
              (-135.0, -9.9, 9.9)]


@pytest.mark.parametrize('heading, forward, left', EDGE_WALKS)
def test_by_the_theses_a_robot_leaves_the_edge_backward_sideways_and_diagonally(heading, forward,
                                                                               left):
    made, skill = holding(THESIS, 20.0, 200.0, heading)
    walk = run(made, skill, 2)[-1].walk
    assert skill.state == skill.off_edge
    assert (walk.forward, walk.left, walk.turn_deg) == pytest.approx((forward, left, 0.0), abs=0.05)


@pytest.mark.parametrize('heading', [90.0, 180.0, -90.0])
def test_kelpie_turns_inwards_on_the_spot(heading):
    made, skill = holding(KELPIE, 20.0, 330.0, heading, sure=False)
    walk = run(made, skill, 2)[-1].walk
    assert skill.state == skill.off_edge
    assert walk.forward == walk.left == 0.0 and walk.turn_deg != 0.0


@pytest.mark.parametrize('x, heading, off', [(27.0, 90.0, False), (29.0, 90.0, True),
                                             (20.0, 40.0, True)])
def test_it_walks_on_until_the_ball_is_28_cm_inside_or_it_looks_in(x, heading, off):
    made, skill = holding(THESIS, x, 200.0, heading)
    skill.enter(made, skill.off_edge)
    run(made, skill, 1)
    assert (skill.state == skill.turn) is off


def test_out_of_a_corner_it_goes_away_from_both_lines():
    made, skill = holding(THESIS, 15.0, 15.0, -135.0)
    walk = run(made, skill, 2)[-1].walk
    assert (walk.forward, walk.left) == pytest.approx((-14.0, 0.0), abs=0.05)


@pytest.mark.parametrize('heading, forward, left', [(90.0, -14.0, 0.0), (180.0, 0.0, 14.0),
                                                    (-90.0, 14.0, 0.0)])
def test_beside_the_goal_the_ball_is_carried_back_45_cm_and_let_go(heading, forward, left):
    """Section 5.8: it is not dribbled across the goal line."""
    made, skill = holding(THESIS, 270.0, 515.0, heading, plan=tree.GRAB_DRIBBLE_STOP)
    walk = run(made, skill, 2)[-1].walk
    assert (walk.forward, walk.left, walk.turn_deg) == pytest.approx((forward, left, 0.0), abs=0.05)
    made.pose.position.y = 480.0
    run(made, skill, 2)
    assert skill.state == skill.steady
    assert skill.choose(made, skill, False)[0] == kick_choice.RELEASE


# The rules of holding, section 6.4.1

@BOTH
@pytest.mark.parametrize('seconds, way, overdue', [
    (2.15, 0.0, False), (2.25, 0.0, True), (0.5, 34.0, False), (0.5, 36.0, True)])
def test_a_hold_ends_within_3_s_and_50_cm(rules, seconds, way, overdue):
    made, skill = holding(rules, heading=-80.0, sure=False)
    made.time_s = seconds - FRAME_S
    skill.hold.x = way
    run(made, skill, 1)
    assert (skill.state == skill.overdue) is overdue


@BOTH
@pytest.mark.parametrize('time, distance, seconds, way', [(4.0, 50.0, 3.2, 35.0),
                                                          (3.0, 90.0, 2.2, 75.0)])
def test_and_within_what_the_rules_of_another_field_allow(rules, time, distance, seconds, way):
    for held, gone, overdue in ((seconds - 0.05, way - 1.0, False), (seconds + 0.05, 0.0, True),
                                (0.5, way + 1.0, True)):
        made, skill = holding(rules, heading=-80.0, sure=False)
        made.field = kelpie.FieldDescription(rules=kelpie.Rules(holding_time=time,
                                                                holding_distance=distance),
                                             width=360.0, length=540.0)
        made.time_s, skill.hold.x = held - FRAME_S, gone
        run(made, skill, 1)
        assert (skill.state == skill.overdue) is overdue


@pytest.mark.parametrize('rules, hurries', [(THESIS, False), (KELPIE, True)])
def test_kelpie_has_less_time_with_somebody_ahead(rules, hurries):
    made, skill = holding(rules, y=400.0, heading=-80.0, sure=False)
    made.sensors.head_near_distance, made.time_s = 19.0, 1.8
    run(made, skill, 1)
    assert (skill.state == skill.overdue) is hurries


@pytest.mark.parametrize('rules, steps', [(THESIS, False), (KELPIE, True)])
def test_kelpie_steps_back_from_a_ball_that_it_let_go(rules, steps):
    made, skill = holding(rules)
    skill.fire(made, (kick_choice.RELEASE, 'let go'))
    made.motion.running = kelpie.RELEASE
    run(made, skill, 2)
    made.motion.running = kelpie.NO_MOTION
    run(made, skill, 2)
    assert (skill.state == skill.step_back) is steps and skill.done is not steps
    assert skill.memory.hint[:2] == hints.LEFT_LYING
