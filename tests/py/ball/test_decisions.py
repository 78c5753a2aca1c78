# SPDX-License-Identifier: Apache-2.0
"""The decision tree and what it asks, thesis 2006 chapter 5; boundaries as its algorithms print
them, misprints as in checklist G27 to G33."""
import math
import random

import kelpie
import pytest
from decisions import tree
from decisions.leaf_by_map import LeafByMap, run_in
from lib import zones
from situation import contested
from situation.at_ball import Situation
from situation.contested import Contested
from situation.memory import Memory
from situations import facing_up_point, put_ball, world

FIELD = kelpie.FIELDS['2006']
GRABS = set(tree.WITH_GRAB)


@pytest.mark.parametrize('y, zone', [(0, 0), (215.9, 0), (216, 1), (323.9, 1), (324, 2), (540, 2)])
def test_the_field_has_three_zones_of_40_20_and_40_percent(y, zone):
    assert zones.zone(FIELD, y) == zone


@pytest.mark.parametrize('x, y, number', [
    (10, 100, 1), (180, 100, 2), (350, 100, 3), (10, 270, 4), (350, 270, 5), (180, 270, 6),
    (180, 400, 7), (49.9, 400, 8), (310.1, 400, 9), (20, 500, 10), (340, 500, 11), (180, 500, 12),
    (94, 535, 10)])
def test_the_twelve_sub_zones_lie_as_in_figure_5_2(x, y, number):
    assert zones.sub_zone(FIELD, (x, y)) == number


def test_every_point_around_the_field_is_in_one_sub_zone():
    chance = random.Random(5)
    for _ in range(2000):
        point = chance.uniform(-50, 410), chance.uniform(-50, 590)
        assert 1 <= zones.sub_zone(FIELD, point) <= 12


def leaf(made, contested_now=False, about_to_grab=False):
    return tree.decide(Situation(made, contested_now, about_to_grab))[0]


def sort(name):
    """Left and right alike; every leaf with a grab is a GrabDribble of the thesis."""
    return 'grab' if name in GRABS else name.replace('_left', '').replace('_right', '')


@pytest.mark.parametrize('degrees, wanted', [
    (0, 'dribble'), (10, 'dribble'), (10.1, 'head'), (44.9, 'head'), (45, 'upenn'),
    (69.9, 'upenn'), (70, 'grab'), (100, 'grab'), (179, 'grab')])
@pytest.mark.parametrize('side', [1, -1])
def test_defensive_leaves_go_by_the_bearing_of_up_field(degrees, wanted, side):
    assert sort(leaf(facing_up_point(side * degrees, (180, 150)))) == wanted


@pytest.mark.parametrize('degrees, wanted', [
    (0, 'grab'), (20, 'grab'), (20.1, 'head'), (44.9, 'head'), (45, 'upenn'), (109.9, 'upenn'),
    (110, 'grab'), (179, 'grab')])
@pytest.mark.parametrize('side', [1, -1])
def test_midfield_leaves_go_by_the_bearing_of_up_field(degrees, wanted, side):
    assert sort(leaf(facing_up_point(side * degrees, (180, 270)))) == wanted


@pytest.mark.parametrize('y', [60.0, 150.0, 210.0])
@pytest.mark.parametrize('way', [-170, -100, -80, -30, 30, 80, 100, 170])
def test_a_contested_ball_is_never_driven_on_towards_the_own_goal(y, way):
    looks = math.radians(90.0 + way)
    made = world(180.0 - 30.0 * math.cos(looks), y - 30.0 * math.sin(looks), 90.0 + way, (180.0, y))
    found = leaf(made, contested_now=True)
    assert found != tree.DRIBBLE or abs(way) < 90


@pytest.mark.parametrize('y, elsewhere', [(150, 'dribble'), (270, 'grab'), (400, 'grab')])
@pytest.mark.parametrize('degrees, strikes', [(34.9, False), (35, True), (69.9, True), (70, False)])
def test_a_contested_ball_is_struck_when_up_field_is_35_to_70_deg_off(y, elsewhere, degrees,
                                                                      strikes):
    found = sort(leaf(facing_up_point(degrees, (180, y)), contested_now=True))
    assert found == ('upenn' if strikes else elsewhere)


@pytest.mark.parametrize('y', [60.0, 150.0, 270.0, 400.0, 520.0])
@pytest.mark.parametrize('degrees', range(-170, 180, 20))
def test_with_the_kick_map_a_contested_ball_is_grabbed(y, degrees):
    made = facing_up_point(degrees, (180.0, y))
    situation = Situation(made, True, False)
    assert LeafByMap().choose(made, situation, tree.decide(situation)[0])[0] in GRABS


def test_who_is_about_to_grab_a_contested_ball_of_its_own_third_grabs_it():
    made = facing_up_point(0.0, (180, 150))
    assert sort(leaf(made, True, True)) == 'grab' and leaf(made, True, False) == 'dribble'


def test_a_strike_goes_to_the_side_on_which_up_field_is():
    for y in (150, 270):
        assert leaf(facing_up_point(50, (180, y))) == tree.UPENN_LEFT
        assert leaf(facing_up_point(-50, (180, y))) == tree.UPENN_RIGHT
        assert leaf(facing_up_point(30, (180, y))) == tree.HEAD_LEFT
        assert leaf(facing_up_point(-30, (180, y))) == tree.HEAD_RIGHT


@pytest.mark.parametrize('heading, wanted', [
    (19.9, 'grab'), (20.1, None), (159.9, None), (160.1, 'grab'), (270, 'grab')])
def test_at_an_edge_a_ball_that_is_not_up_field_is_grabbed(heading, wanted):
    made = world(30, 100, heading, (30, 100))
    put_ball_ahead(made, 25.0)
    found = sort(leaf(made))
    assert found == wanted if wanted else found in ('upenn', 'head')


def put_ball_ahead(made, away):
    angle = math.radians(made.pose.heading_deg)
    bx, by = made.ball.position.x, made.ball.position.y
    made.pose.position.x = bx - away * math.cos(angle)
    made.pose.position.y = by - away * math.sin(angle)
    put_ball(made, bx, by)


@pytest.mark.parametrize('ball, heading, wanted', [
    ((180, 515), 90, 'dribble'),          # close to the goal line
    ((180, 509), 90, 'grab'),
    ((180, 330), 90, 'grab'),             # 210 cm from the goal
    ((55, 500), 70, 'upenn'),             # a corner, the goal's front 61 deg off
    ((55, 500), 20, 'grab')])
def test_offensive_leaves(ball, heading, wanted):
    made = world(ball[0], ball[1], heading, ball)
    put_ball_ahead(made, 25.0)
    assert sort(leaf(made)) == wanted


MAP_NEEDS_NO_PLAN = {tree.GRAB_UPENN_LEFT, tree.GRAB_UPENN_RIGHT, tree.GRAB_DRIBBLE_STOP}


@pytest.mark.parametrize('task, unmet', [
    (kelpie.Task(), MAP_NEEDS_NO_PLAN | {tree.AVOID_OWN_GOAL}),
    (kelpie.Task(kicks=kelpie.KICKS_BY_RULES), {tree.AVOID_OWN_GOAL}),
    (kelpie.Task(rules=kelpie.RULES_OF_THESIS), set())], ids=['map', 'rules', 'thesis'])
def test_every_leaf_is_reached_that_has_an_effect_in_what_is_played(task, unmet):
    """The theses' own twelve all are."""
    chance = random.Random(7)
    met = set()
    for _ in range(30000):
        ball = chance.uniform(0, 360), chance.uniform(0, 540)
        made = world(ball[0], ball[1], chance.uniform(-180, 180), ball)
        made.task = task
        put_ball_ahead(made, 30.0)
        met.add(leaf(made, chance.random() < 0.2, chance.random() < 0.3))
    drawn = {row[3] for row in tree.rows() if row[4]}
    assert drawn == set(tree.LEAVES) and drawn - met == unmet and len(tree.LEAVES) == 12


def test_a_reason_fits_a_trace_and_has_a_number_for_each_mark():
    chance = random.Random(8)
    for _ in range(5000):
        ball = chance.uniform(0, 360), chance.uniform(0, 540)
        made = world(ball[0], ball[1], chance.uniform(-180, 180), ball)
        put_ball_ahead(made, 30.0)
        _, _, reason, *numbers = tree.decide(Situation(made, chance.random() < 0.3, False))
        assert len(reason) <= 80 and reason.count('{}') == len(numbers) <= 3


def test_the_drawing_has_one_row_a_node_and_each_hangs_below_another():
    rows = tree.rows()
    names = [row[0] for row in rows]
    assert len(set(names)) == len(names) and rows[0][1] == ''
    assert all(row[1] in names for row in rows[1:])


def test_the_place_of_a_leaf_is_its_row_of_the_drawing():
    chance = random.Random(9)
    drawn = {row[0]: row[3] for row in tree.rows() if row[4]}
    for _ in range(2000):
        ball = chance.uniform(0, 360), chance.uniform(0, 540)
        made = world(ball[0], ball[1], chance.uniform(-180, 180), ball)
        put_ball_ahead(made, 30.0)
        chosen, place, *_ = tree.decide(Situation(made, chance.random() < 0.3, False))
        assert drawn[place] == chosen


# Contested

def close_ball():
    return world(180, 200, 90, (180, 230))


def test_a_ball_that_nobody_else_is_at_is_not_contested():
    memory = Memory()
    assert not contested.triggered(close_ball(), memory)


@pytest.mark.parametrize('witness', ['paw', 'infrared', 'robot', 'map'])
def test_each_witness_alone_makes_a_close_ball_contested_but_no_far_one(witness):
    for away, wanted in ((30.0, True), (60.0, False)):
        made, memory = world(180, 200, 90, (180, 200 + away)), Memory()
        if witness == 'paw':
            made.motion.feeling.paw_blocked = [False, True]
        elif witness == 'infrared':
            memory.ir = away - contested.IR_NEARER - 0.1
        elif witness == 'robot':
            made.percepts.robots = [kelpie.RobotPercept(distance=away + 20.0)]
        else:
            cell = kelpie.ObstacleCell(own=12.0)
            cell.position.x, cell.position.y = 180.0, 215.0 + away
            made.obstacles = [cell]
        assert contested.triggered(made, memory) == wanted


def test_a_contest_lasts_15_frames_after_its_last_trigger():
    latch, memory, made = Contested(), Memory(), close_ball()
    made.motion.feeling.paw_blocked = [True, False]
    assert latch.update(made, memory)
    made.motion.feeling.paw_blocked = [False, False]
    assert [latch.update(made, memory) for _ in range(16)] == [True] * 15 + [False]


@pytest.mark.parametrize('x, away, runs', [
    (180.0, 34.0, True), (180.0, 36.0, False), (216.0, 30.0, True), (224.0, 30.0, False)])
def test_a_ball_within_35_cm_of_the_line_and_between_the_posts_is_run_in(x, away, runs):
    y = FIELD.length - away
    made = world(x, y - 30.0, 90.0, (x, y))
    assert run_in(made, Situation(made, False, False), tree.DRIBBLE) is runs
    assert not run_in(made, Situation(made, False, False), tree.GRAB_TURN_SHOOT)
    leaf, why, *_ = LeafByMap().choose(made, Situation(made, False, False), tree.DRIBBLE)
    assert (leaf == tree.DRIBBLE) is (why == 'as the tree says') is runs


@pytest.mark.parametrize('y, third', [(150, 'defensive'), (270, 'middle'), (450, 'offensive')])
def test_the_reason_of_a_leaf_begins_with_the_third_of_the_field(y, third):
    _, _, reason, *_ = tree.decide(Situation(facing_up_point(0, (180, y)), False, False))
    assert reason.startswith(third)
