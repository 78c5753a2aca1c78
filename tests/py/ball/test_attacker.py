# SPDX-License-Identifier: Apache-2.0
"""The role that plays the ball: when a ball counts as lost, how long a leaf and a look after a
kick last, and what it does about a ball in the own box."""
from types import SimpleNamespace

import kelpie
import pytest
from decisions import tree
from roles.attacker import (Attacker, AttackerSituation, ball_is_lost, looks_on, skill_has_ended)
from situation.memory import Memory
from situations import facing_up_point, put_ball, world
from skills.ball.find_ball import FindBall


def attacker(lost=0):
    memory = Memory()
    memory.ball_lost = lost
    return Attacker(memory)


@pytest.mark.parametrize('away, frames, lost', [
    (60.0, 15, False), (60.0, 16, True), (21.0, 16, True), (19.0, 16, False), (19.0, 40, False),
    (19.0, 41, True)])
def test_a_ball_is_lost_after_15_frames_and_after_40_where_the_chin_hides_it(away, frames, lost):
    made = world(ball=(180.0, 200.0 + away))
    assert AttackerSituation(made, attacker(frames).memory).lost is lost
    made.ball.present = False
    assert AttackerSituation(made, attacker(0).memory).lost


@pytest.mark.parametrize('playing, unseen_s, in_box, looks', [
    ('play', 0.3, False, False), ('find', 0.09, False, False), ('find', 0.11, False, True),
    ('watch', 0.11, False, True), ('localise', 0.09, False, False), ('avoid_box', 0.3, True, False),
    ('avoid_box', 0.3, False, True), ('find', 0.3, True, True)])
def test_who_looked_elsewhere_must_see_the_ball_again_before_it_plays(playing, unseen_s, in_box,
                                                                      looks):
    made = world()
    made.ball.seconds_since_seen = unseen_s
    now = AttackerSituation(made, attacker(3).memory)
    now.box_in_the_way = in_box
    assert (ball_is_lost(now, playing) is not None) is looks


def test_a_lost_ball_is_looked_for_whatever_it_does():
    for playing in ('play', 'find', 'watch', 'localise', 'avoid_box'):
        now = AttackerSituation(world(), attacker(50).memory)
        now.box_in_the_way = True
        assert ball_is_lost(now, playing) is not None


@pytest.mark.parametrize('playing, ended, watches', [
    ('play', 'dribble', True), ('watch', '', True), ('play', '', False), ('find', '', False)])
def test_where_the_ball_goes_is_watched_when_a_skill_has_ended(playing, ended, watches):
    assert (skill_has_ended(SimpleNamespace(ended=ended), playing) is not None) is watches


@pytest.mark.parametrize('playing, done, lost, on', [
    ('localise', False, False, True), ('localise', True, False, False),
    ('localise', False, True, False), ('play', False, False, False)])
def test_a_look_at_a_landmark_goes_on_until_it_is_over_or_the_ball_is_lost(playing, done, lost, on):
    now = SimpleNamespace(landmarks=SimpleNamespace(done=done), lost=lost)
    assert (looks_on(now, playing) is not None) is on


@pytest.mark.parametrize('hint, ago, wanted', [
    (None, 0, (100.0, 0.0)), ((50.0, 30.0), 2, (50.0, 30.0)), ((50.0, 30.0), 3, (100.0, 0.0))])
def test_after_a_skill_that_said_nothing_of_it_the_ball_is_looked_for_a_metre_ahead(hint, ago,
                                                                                   wanted):
    made, player = world(), attacker()
    if hint is not None:
        player.memory.set_hint(*hint)
    for _ in range(ago):
        player.memory.update(made)
    player.after_skill(made)
    assert player.memory.hint[:2] == wanted


@pytest.mark.parametrize('hint, forward', [
    ((100.0, 14.0), 40.0), ((100.0, -14.0), 40.0), ((100.0, 16.0), 0.0), ((30.0, 0.0), 40.0),
    ((29.0, 0.0), 0.0)])
def test_a_ball_that_went_ahead_by_30_cm_at_least_is_followed(hint, forward):
    made, player = world(ball=(180.0, 220.0)), attacker()
    made.ball.present = made.percepts.ball.present = False
    player.memory.set_hint(*hint)
    player.enter(made, player.watch, FindBall(made, player.memory))
    assert player.watch(made).walk.forward == forward


@pytest.mark.parametrize('seconds, state', [(0.39, 'watch'), (0.41, 'find')])
def test_a_kicked_ball_is_watched_for_0_4_s(seconds, state):
    made, player = world(), attacker()
    player.memory.set_hint(100.0, 0.0)
    player.enter(made, player.watch, FindBall(made, player.memory))
    made.time_s += seconds
    player.watch(made)
    assert player.state.__name__ == state


@pytest.mark.parametrize('away, frames, kept', [(34.0, 11, True), (34.0, 12, False),
                                                (36.0, 1, False)])
def test_within_35_cm_of_the_ball_a_leaf_is_kept_for_12_frames(away, frames, kept):
    player = attacker()
    for degrees in (50.0, -50.0):
        made = facing_up_point(degrees, (180.0, 270.0), away)
        made.task.kicks = kelpie.KICKS_BY_RULES
        player.choose_leaf(made)
        player.memory.frame += frames
    assert player.leaf == (tree.UPENN_LEFT if kept else tree.UPENN_RIGHT)


@pytest.mark.parametrize('ago, grabs', [(2, True), (3, False)])
def test_who_came_near_for_a_grab_within_3_frames_grabs_a_contested_ball(ago, grabs):
    made, player = facing_up_point(0.0, (180.0, 150.0)), attacker()
    made.task.kicks = kelpie.KICKS_BY_RULES
    player.contested, player.memory.approach_lost = SimpleNamespace(now=True), ago
    player.choose_leaf(made)
    assert (player.leaf in tree.WITH_GRAB) is grabs


@pytest.mark.parametrize('waited, goalie, stays_out', [
    (90, False, True), (91, False, False), (91, True, True)])
def test_without_a_goalie_a_ball_in_the_own_box_is_fetched_after_90_frames(waited, goalie,
                                                                         stays_out):
    made, player = world(180.0, 120.0, -90.0, (180.0, 40.0)), attacker()
    note = kelpie.TeamNote(role=kelpie.KEEPER if goalie else kelpie.STRIKER)
    made.teammates = [kelpie.TeammateEstimate(player=1, note=note)]
    player.box_frames = waited
    assert player.box_in_the_way(made) is stays_out


@pytest.mark.parametrize('y, waits_anew', [(129.0, False), (131.0, True)])
def test_a_ball_beyond_130_cm_has_left_the_own_box(y, waits_anew):
    made, player = world(180.0, 200.0, -90.0, (180.0, y)), attacker()
    player.box_frames = 50
    player.box_in_the_way(made)
    assert player.box_frames == (0 if waits_anew else 50)
    put_ball(made, 180.0, 40.0)
    made.ball.present = False
    player.box_frames = 50
    player.box_in_the_way(made)
    assert player.box_frames == 50
