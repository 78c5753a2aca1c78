# SPDX-License-Identifier: Apache-2.0
"""The leaves of chapter 5 of thesis 2006 as a table: for each question of algorithms 5.1 to 5.7 the
numbers just before and beyond its bounds, and both sides. Degrees are left positive."""
from types import SimpleNamespace

import kelpie
import pytest
from decisions import leaf_by_map, tree
from decisions.leaf_by_map import LeafByMap, free_utility, grab_utility
from lib import rulebook, zones
from situation.at_ball import Situation
from situations import world

FIELD = kelpie.FIELDS['2006']
KICK, SHOOT, CARRY, STOP = (tree.GRAB_TURN_KICK, tree.GRAB_TURN_SHOOT, tree.GRAB_DRIBBLE_GOAL,
                            tree.GRAB_DRIBBLE_STOP)
DEFENSIVE, MIDDLE, OFFENSIVE = 0, 1, 2


def leaf(zone, **changes):
    """The leaf for a free ball in the middle of a zone, straight up-field; `changes` of that."""
    asked = {'zone': zone, 'contested': False, 'about_to_grab': False, 'side_edge': 0, 'corner': 0,
             'edge': 0, 'strike_side': 0, 'facing': 0.0, 'up': 0.0, 'to_goal': 0.0, 'crossing': 0.0,
             'off_goal': 0.0, 'across': 90.0, 'goal_distance': 200.0, 'line_distance': 190.0,
             'near_centre': True, 'own_goal_ahead': False, 'by_kick_map': False,
             'rules': rulebook.Kelpie}
    assert not set(changes) - set(asked)
    return tree.decide(SimpleNamespace(**{**asked, **changes}))[0]


# Algorithm 5.2, the own 40 %

@pytest.mark.parametrize('up, wanted', [
    (0.0, 'dribble'), (10.0, 'dribble'), (10.1, 'head'), (44.9, 'head'), (45.0, 'upenn'),
    (69.9, 'upenn'), (70.0, None), (180.0, None)])
def test_in_the_own_third_a_free_ball_is_driven_swiped_struck_or_grabbed(up, wanted):
    for side, name in ((1.0, '_left'), (-1.0, '_right')):
        found = leaf(DEFENSIVE, up=side * up)
        if wanted is None:
            assert found == KICK
        else:
            assert found == ('dribble' if wanted == 'dribble' else wanted + name)


# Algorithm 5.5, midfield

@pytest.mark.parametrize('up, wanted', [
    (0.0, None), (20.0, None), (20.1, 'head'), (44.9, 'head'), (45.0, 'upenn'), (109.9, 'upenn'),
    (110.0, None)])
def test_in_midfield_a_free_ball_ahead_is_grabbed(up, wanted):
    for side, name in ((1.0, '_left'), (-1.0, '_right')):
        assert leaf(MIDDLE, up=side * up) == (CARRY if wanted is None else wanted + name)


# Algorithm 5.7, the last 40 %

@pytest.mark.parametrize('changes, wanted', [
    ({}, CARRY), ({'goal_distance': 251.0}, 'dribble'), ({'goal_distance': 249.0}, CARRY),
    ({'goal_distance': 260.0, 'to_goal': 14.0}, 'dribble'),
    ({'goal_distance': 260.0, 'to_goal': -14.0}, 'dribble'),
    ({'goal_distance': 260.0, 'to_goal': 16.0}, CARRY),
    ({'goal_distance': 260.0, 'to_goal': -16.0}, CARRY),
    ({'goal_distance': 260.0, 'near_centre': False}, CARRY),
    ({'line_distance': 29.0}, 'dribble'), ({'line_distance': 31.0}, CARRY),
    ({'goal_distance': 169.0}, SHOOT), ({'goal_distance': 171.0}, CARRY)])
def test_offensive_balls_are_driven_from_far_and_at_the_line_and_else_grabbed(changes, wanted):
    assert leaf(OFFENSIVE, **changes) == wanted


@pytest.mark.parametrize('corner', [1, -1])
@pytest.mark.parametrize('crossing, strikes', [(29.9, False), (30.0, True), (74.9, True),
                                               (75.0, False)])
def test_in_a_corner_a_ball_is_struck_before_the_goal_that_is_30_to_75_deg_aside(corner, crossing,
                                                                               strikes):
    """A goal to the left of the way to the ball has a negative crossing."""
    for side, wanted in ((-1.0, tree.UPENN_LEFT), (1.0, tree.UPENN_RIGHT)):
        found = leaf(OFFENSIVE, corner=corner, edge=corner, crossing=side * crossing)
        assert found == (wanted if strikes else CARRY)


# Algorithm 5.4, edges

@pytest.mark.parametrize('zone', [DEFENSIVE, MIDDLE, OFFENSIVE])
@pytest.mark.parametrize('edge', [1, -1])
@pytest.mark.parametrize('off_goal, wanted', [(0.0, 'head'), (29.9, 'head'), (30.0, 'upenn'),
                                              (80.0, 'upenn'), (80.1, 'head'), (170.0, 'head')])
def test_at_an_edge_a_ball_is_struck_if_the_goal_is_30_to_80_deg_off_else_swiped(zone, edge,
                                                                               off_goal, wanted):
    """To the side of the goal: it is to the left of a way with a negative difference."""
    for side, name in ((-1.0, '_left'), (1.0, '_right')):
        found = leaf(zone, side_edge=edge, edge=edge, off_goal=side * off_goal)
        assert found == wanted + name or off_goal == 0.0 and found == 'head_left'


@pytest.mark.parametrize('zone, grab', [(DEFENSIVE, KICK), (MIDDLE, CARRY), (OFFENSIVE, CARRY)])
@pytest.mark.parametrize('across, grabs', [(19.9, True), (20.0, False), (160.0, False),
                                           (160.1, True), (270.0, True)])
def test_at_an_edge_a_ball_that_is_not_20_to_160_deg_up_field_is_grabbed(zone, grab, across, grabs):
    found = leaf(zone, side_edge=1, edge=1, across=across)
    assert found == (grab if grabs else 'head_left')


# Algorithms 5.3 and 5.6, contests

@pytest.mark.parametrize('zone, grab', [(MIDDLE, CARRY), (OFFENSIVE, CARRY)])
@pytest.mark.parametrize('up, strikes', [(34.9, False), (35.0, True), (69.9, True), (70.0, False)])
def test_a_contested_ball_is_struck_at_35_to_70_deg_and_else_grabbed(zone, grab, up, strikes):
    for side, wanted in ((1.0, tree.UPENN_LEFT), (-1.0, tree.UPENN_RIGHT)):
        assert leaf(zone, contested=True, up=side * up) == (wanted if strikes else grab)
        assert leaf(zone, contested=True, up=side * up, side_edge=1, edge=1) == (
            wanted if strikes else grab)


@pytest.mark.parametrize('changes, wanted', [
    ({}, 'dribble'), ({'up': 34.0}, 'dribble'), ({'up': 36.0}, tree.UPENN_LEFT),
    ({'up': -36.0}, tree.UPENN_RIGHT), ({'up': 71.0}, 'dribble'),
    ({'about_to_grab': True}, KICK), ({'about_to_grab': True, 'up': 50.0}, tree.UPENN_LEFT),
    ({'edge': 1, 'up': 29.0}, KICK), ({'edge': -1, 'up': -29.0}, KICK),
    ({'edge': 1, 'up': 31.0}, 'dribble'), ({'edge': 1, 'up': -31.0}, 'dribble'),
    ({'own_goal_ahead': True}, KICK),
    ({'own_goal_ahead': True, 'rules': rulebook.Thesis}, 'avoid_own_goal'),
    ({'edge': 1, 'own_goal_ahead': True, 'rules': rulebook.Thesis}, KICK)])
def test_in_the_own_third_a_contested_ball_is_driven_on_unless_it_can_be_grabbed(changes, wanted):
    assert leaf(DEFENSIVE, contested=True, **changes) == wanted


# Leaves with a grab

@pytest.mark.parametrize('side, facing, wanted', [
    (-1, 90.0, tree.GRAB_UPENN_RIGHT), (1, -90.0, tree.GRAB_UPENN_LEFT), (-1, -90.0, CARRY),
    (1, 90.0, CARRY), (-1, 60.0, tree.GRAB_UPENN_RIGHT), (-1, 59.0, CARRY),
    (-1, 120.0, tree.GRAB_UPENN_RIGHT), (-1, 121.0, CARRY), (0, 90.0, CARRY)])
def test_a_ball_at_an_edge_is_struck_back_in_by_who_looks_out_60_to_120_deg(side, facing, wanted):
    assert leaf(MIDDLE, strike_side=side, facing=facing) == wanted
    assert leaf(MIDDLE, strike_side=side, facing=facing, by_kick_map=True) == CARRY


@pytest.mark.parametrize('line_distance, near_centre, wanted', [
    (29.0, False, STOP), (31.0, False, SHOOT), (29.0, True, SHOOT)])
def test_beside_the_goal_a_ball_is_carried_back(line_distance, near_centre, wanted):
    """Within 30 cm of its line; contested, since a free ball there is driven on."""
    assert leaf(OFFENSIVE, contested=True, line_distance=line_distance, near_centre=near_centre,
                goal_distance=100.0) == wanted


# What the tree is asked about

def seen(ball, robot=None, heading=90.0):
    made = world(*(robot or (ball[0], ball[1] - 30.0)), heading, ball)
    return Situation(made, False, False)


@pytest.mark.parametrize('y, zone', [(215.0, 0), (217.0, 1), (323.0, 1), (325.0, 2)])
def test_the_zones_end_at_40_and_60_percent_of_the_length(y, zone):
    assert zones.zone(FIELD, y) == zone == seen((180.0, y)).zone


@pytest.mark.parametrize('x, side', [(49.0, -1), (51.0, 0), (309.0, 0), (311.0, 1)])
@pytest.mark.parametrize('y', [100.0, 270.0, 400.0])
def test_a_ball_within_50_cm_of_a_side_line_is_at_that_edge(x, side, y):
    found = seen((x, y))
    assert (found.side_edge, found.edge, found.corner) == (side, side, 0)


@pytest.mark.parametrize('x, y, corner, edge', [
    (40.0, 481.0, -1, -1), (40.0, 479.0, 0, -1), (60.0, 501.0, -1, 0), (320.0, 481.0, 1, 1),
    (300.0, 501.0, 1, 0), (300.0, 499.0, 0, 0)])
def test_a_corner_is_a_triangle_with_legs_of_100_cm(x, y, corner, edge):
    found = seen((x, y))
    assert (found.corner, found.edge) == (corner, edge)
    assert found.side_edge == (0 if corner else edge)


@pytest.mark.parametrize('x, near', [(119.0, False), (121.0, True), (239.0, True), (241.0, False)])
def test_near_the_middle_is_within_60_cm(x, near):
    assert seen((x, 400.0)).near_centre is near


def test_bearings_of_a_ball_to_the_upper_right_of_the_middle():
    """Ball (260, 420), robot 40 cm to its left, looking 30 deg right of up-field."""
    found = seen((260.0, 420.0), (220.0, 420.0), 60.0)
    assert found.facing == pytest.approx(-30.0) and found.ball_bearing == pytest.approx(-60.0)
    assert found.up == pytest.approx(56.31 - 60.0, abs=0.01)           # to (260, 480)
    assert found.to_goal == pytest.approx(108.43 - 60.0, abs=0.01)     # to (180, 540)
    assert found.ball_to_goal == pytest.approx(33.69, abs=0.01)
    assert found.off_goal == pytest.approx(-123.69, abs=0.01)
    assert found.crossing == pytest.approx(-90.0 - 38.66, abs=0.01)    # to (180, 520)
    assert found.goal_distance == pytest.approx(144.22, abs=0.01)
    assert found.line_distance == pytest.approx(120.0)
    assert found.across == pytest.approx(0.0, abs=1e-6) and not found.own_goal_ahead


@pytest.mark.parametrize('heading, ahead', [(-1.0, True), (1.0, False), (179.0, False),
                                            (-179.0, True), (-90.0, True)])
def test_the_own_goal_is_ahead_where_the_way_to_the_ball_leads_down_field(heading, ahead):
    found = seen((180.0, 270.0), (180.0, 270.0), heading)
    found.ball_bearing = 0.0
    assert found.own_goal_ahead is ahead


# The tree's word and the kick map's

def by_map(grab, free, played=None, leaf_='dribble', contested=False):
    """What the map plays for these utilities of a grab and of its two free kicks."""
    made = world(180.0, 240.0, 90.0, (180.0, 270.0))
    choice = LeafByMap()
    made.frame = 1
    choice.utilities = {'grab': grab, 'upenn_left': free, 'head_right': -1.0}
    return choice.choose(made, Situation(made, contested, False), leaf_, played)[0]


@pytest.mark.parametrize('grab, free, played, wanted', [
    (0.50, 0.51, None, 'upenn_left'), (0.51, 0.50, None, CARRY),
    (0.50, 0.53, CARRY, CARRY), (0.50, 0.55, CARRY, 'upenn_left'),
    (0.53, 0.50, 'upenn_left', 'upenn_left'), (0.55, 0.50, 'upenn_left', CARRY),
    (0.53, 0.50, 'head_right', CARRY)])
def test_what_is_played_goes_on_unless_another_is_worth_0_04_more(grab, free, played, wanted):
    assert by_map(grab, free, played) == wanted


def test_a_grab_is_the_trees_own_and_a_contested_ball_is_always_grabbed():
    assert by_map(0.6, 0.5, leaf_=SHOOT) == SHOOT
    assert by_map(0.1, 0.9, contested=True) == CARRY


def test_a_degree_with_the_ball_costs_0_01_s_and_a_second_0_02_of_utility():
    made = world(180.0, 240.0, 90.0, (180.0, 270.0))
    found = Situation(made, False, False)
    straight = grab_utility(made, found, 90.0)
    for way in (140.0, 40.0):
        assert straight - grab_utility(made, found, way) == pytest.approx(0.02 * 0.01 * 50.0)


def test_time_makes_a_grab_0_026_and_a_free_kick_0_012_worse(monkeypatch):
    monkeypatch.setattr(leaf_by_map, 'utility_of_way', lambda *asked: 0.5)
    made = world(180.0, 240.0, 90.0, (180.0, 270.0))
    found = Situation(made, False, False)
    assert grab_utility(made, found, 90.0) == pytest.approx(0.5 - 0.026)
    assert free_utility(made, found, 'upenn_left', 90.0) == pytest.approx(0.5 - 0.012)


def test_all_ways_are_valued_at_first_then_one_in_every_second_frame():
    made, choice = world(180.0, 240.0, 90.0, (180.0, 270.0)), LeafByMap()
    found = Situation(made, False, False)
    made.frame = 3
    choice.update(made, found)
    ways = list(choice.utilities)
    assert ways[0] == 'grab' and len(ways) > 2
    renewed = []
    for made.frame in range(4, 4 + 2 * len(ways)):
        choice.utilities = dict.fromkeys(ways, 9.0)
        choice.update(made, found)
        renewed += [way for way in ways if choice.utilities[way] != 9.0]
    assert sorted(renewed) == sorted(ways)


@pytest.mark.parametrize('bearing', [30.0, -40.0])
def test_a_free_kick_is_valued_for_the_way_to_the_ball(monkeypatch, bearing):
    ways = []
    monkeypatch.setattr(leaf_by_map, 'utility_of_way',
                        lambda one, ball, way, outcome: ways.append(way) or 0.5)
    made = world(180.0, 240.0, 70.0, (180.0, 270.0))
    found = Situation(made, False, False)
    found.ball_bearing = bearing
    LeafByMap().update(made, found)
    assert ways.count(pytest.approx(70.0 + bearing)) == len(leaf_by_map.FREE)
