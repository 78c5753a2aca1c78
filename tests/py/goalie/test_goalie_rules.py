# SPDX-License-Identifier: Apache-2.0
"""The bounds of the goalie's rules and of where it guards, each as a table of situations."""
from types import SimpleNamespace

import kelpie
import pytest
from decisions import goalie_rules
from decisions.guard_place import guard_place
from goalie_world import scene
from lib.goalie_places import central_place


@pytest.mark.parametrize('seconds, over', [(1.1, False), (1.3, True)])
def test_a_ball_may_lie_between_the_paws_for_1_2_s(seconds, over):
    now = SimpleNamespace(world=kelpie.WorldFrame(), paws=SimpleNamespace(for_s=seconds))
    assert (goalie_rules.stands_over_ball(now, 'guard') is not None) is over


@pytest.mark.parametrize('stood_s, clears', [(0.34, False), (0.36, True)])
def test_a_goalie_stands_for_0_35_s_before_it_clears(stood_s, clears):
    best = SimpleNamespace(utility=1.0, direction=0.0, off_goal=90.0)
    now = SimpleNamespace(world=kelpie.WorldFrame(time_s=10.0), moved_s=10.0 - stood_s,
                          clearance=best)
    assert (goalie_rules.can_clear(now, 'guard') is not None) is clears
    now.clearance = None
    assert goalie_rules.can_clear(now, 'guard') is None


def at_ball(y=60.0, speed=0.0, **facts):
    world = scene(complex(180.0, y), at=180 + 20j).world
    world.ball.velocity = kelpie.Point2(x=0.0, y=speed)
    world.time_s = 10.0
    known = dict(world=world, ball=(180.0, y), sees=lambda: True, seen_since_motion=True,
                 rest_s=9.0, pose_lost=False, kick_stand=lambda attacks: 'a stand')
    return SimpleNamespace(**{**known, **facts})


@pytest.mark.parametrize('playing, beyond, attacks', [
    ('guard', 7.9, True), ('guard', 8.1, False), ('attack', 14.9, True), ('attack', 15.1, False)])
def test_a_ball_is_attacked_up_to_8_cm_beyond_the_box_and_followed_up_to_15(playing, beyond,
                                                                           attacks):
    now = at_ball(at_ball().world.field.box_depth + beyond)
    assert (goalie_rules.can_attack(now, playing) is not None) is attacks


@pytest.mark.parametrize('facts, attacks', [
    (dict(), True), (dict(speed=29.0), True), (dict(speed=31.0), False), (dict(rest_s=11.0), False),
    (dict(sees=lambda: False), False), (dict(seen_since_motion=False), False),
    (dict(pose_lost=True), False), (dict(kick_stand=lambda attacks: None), False)])
def test_only_a_slow_ball_in_sight_with_a_place_to_kick_from_is_attacked(facts, attacks):
    assert (goalie_rules.can_attack(at_ball(**facts), 'guard') is not None) is attacks


def guarded(lost_for, surveyed_ago=100.0, near=False, settled=True, sees=False, surveys=False):
    now = at_ball(200.0, reported=None, lost_for=lost_for, pose_settled=settled,
                  sees=lambda: sees)
    eyes = SimpleNamespace(searches_near=lambda world: near, surveyed_s=10.0 - surveyed_ago,
                           surveys=surveys)
    return guard_place(now, eyes, lambda field, ball: 'by the ball'), now.world.field


@pytest.mark.parametrize('facts, middle', [
    (dict(lost_for=1.5), False), (dict(lost_for=1.7), True),
    (dict(lost_for=5.0, surveyed_ago=1.5), False), (dict(lost_for=5.0, surveyed_ago=1.7), True),
    (dict(lost_for=5.0, near=True), False), (dict(lost_for=5.0, settled=False), False)])
def test_a_goalie_goes_to_the_middle_when_the_ball_is_unseen_for_1_6_s(facts, middle):
    place, field = guarded(**facts)
    assert place == (central_place(field) if middle else None)


@pytest.mark.parametrize('lost_for, on_line', [(5.9, False), (6.1, True)])
def test_a_goalie_goes_to_its_line_when_the_ball_is_unseen_for_6_s(lost_for, on_line):
    place, field = guarded(lost_for)
    assert (place[1] < central_place(field)[1]) is on_line


@pytest.mark.parametrize('speed, comes', [(9.0, False), (11.0, True)])
def test_a_ball_that_rolls_at_10_cm_a_second_to_the_mouth_is_gone_into_the_way_of(speed, comes):
    now = at_ball(21.0, -speed)
    now.world.ball.stopping_point.y = 0.0
    assert (goalie_rules.ball_comes(now, 'guard') is not None) is comes


def running(y, **facts):
    now = at_ball(y, **facts)
    now.world.task.run = True
    return now


@pytest.mark.parametrize('beyond, runs', [(-10.0, True), (31.0, True), (33.0, False)])
def test_who_runs_with_the_ball_runs_through_one_at_its_box(beyond, runs):
    now = running(at_ball().world.field.box_depth + beyond)
    assert (goalie_rules.can_run(now, 'guard') is not None) is runs
    now.world.task.run = False
    assert goalie_rules.can_run(now, 'guard') is None


@pytest.mark.parametrize('y, runs', [(60.0, True), (90.0, False)])
def test_beside_the_box_the_ball_is_a_nearer_mates_but_in_it_the_goalies(y, runs):
    now = running(y)
    there = kelpie.Pose2(position=kelpie.Point2(x=180.0, y=y + 10.0))
    now.world.teammates = [kelpie.TeammateEstimate(player=2, pose=there)]
    assert (goalie_rules.can_run(now, 'guard') is not None) is runs


def test_a_goalie_without_a_pose_or_a_ball_runs_nowhere():
    assert goalie_rules.can_run(running(40.0, pose_lost=True), 'guard') is None
    assert goalie_rules.can_run(running(40.0, sees=lambda: False), 'guard') is None
