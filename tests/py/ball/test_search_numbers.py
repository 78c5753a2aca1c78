# SPDX-License-Identifier: Apache-2.0
"""The numbers of a search: alone, on the spot, and with the team. A search is set up so that the
step in question is the one that is played."""
import math

import kelpie
import pytest
from situation.memory import Memory
from situations import put_ball, world
from skills.ball.find_ball import FindBall, remembered, side_of, taken
from skills.ball.find_together import FindTogether
from skills.ball.lost_ball import Situation, first_step
from skills.ball.spin_for_ball import SpinForBall


def search(ball=(180.0, 400.0), lost=0, **memory):
    """A FindBall of a robot at (180, 250) that looks up-field; the head looks over the ball."""
    made, known = world(180.0, 250.0, 90.0, ball), Memory(ball_lost=lost)
    made.percepts.ball.present, made.head.head_nod_deg = False, 45.0
    made.ball.seconds_since_seen = lost / 30.0
    for name, value in memory.items():
        setattr(known, name, value)
    return made, FindBall(made, known)


def turned(bearing, away):
    angle = math.radians(bearing)
    return 180.0 - away * math.sin(angle), 250.0 + away * math.cos(angle)


# Alone

@pytest.mark.parametrize('away, forward', [(100.0, 34.0), (45.0, 24.0), (26.0, 1.2), (24.0, 0.0)])
def test_a_ball_is_gone_to_until_25_cm_before_where_it_is_believed(away, forward):
    made, skill = search((180.0, 250.0 + away))
    for step in (skill.belief, skill.last_seen):
        assert step(made).walk.forward == pytest.approx(forward)
    skill.hint_point = (0.0, away)
    assert skill.hint(made).walk.forward == pytest.approx(forward)


@pytest.mark.parametrize('bearing, turn', [(44.0, 0.0), (46.0, 82.8), (-44.0, 0.0), (-46.0, -82.8)])
def test_a_forced_look_turns_the_body_from_45_deg_on_and_is_aimed_120_cm_off(bearing, turn):
    made, skill = search()
    skill.force(bearing, 99)
    command = skill.forced(made)
    assert command.walk.turn_deg == pytest.approx(turn) and command.walk.forward == 0.0
    target = command.head.target
    assert math.hypot(target.x, target.y) == pytest.approx(120.0)
    assert math.degrees(math.atan2(-target.x, target.y)) == pytest.approx(bearing)


@pytest.mark.parametrize('spun, side, pan, looks', [
    (14, 1.0, 10.0, -20.0), (14, -1.0, 10.0, 40.0), (15, 1.0, 10.0, 10.0), (14, 1.0, -70.0, -88.0),
    (14, -1.0, 70.0, 88.0)])
def test_the_head_looks_30_deg_back_against_a_spin_of_the_last_15_frames(spun, side, pan, looks):
    made, skill = search(lost=3, spin_lost=spun, spin_side=side)
    made.head.head_pan_deg, made.head.neck_tilt_deg, made.head.head_nod_deg = pan, -12.0, 7.0
    head = skill.last_seen(made).head
    assert (head.head_pan_deg, head.neck_tilt_deg, head.head_nod_deg) == (looks, -12.0, 7.0)


@pytest.mark.parametrize('bearing, before, side', [
    (8.5, -1.0, 1.0), (7.5, -1.0, -1.0), (-8.5, 1.0, -1.0), (-7.5, 1.0, 1.0)])
def test_a_ball_8_deg_aside_is_looked_for_on_that_side(bearing, before, side):
    made, _ = search(turned(bearing, 100.0))
    assert side_of(made, before) == side
    made.ball.present = False
    assert side_of(made, before) == before


@pytest.mark.parametrize('seconds, is_taken', [(0.09, True), (0.11, False)])
def test_a_sighting_counts_that_gps_takes_within_0_1_s(seconds, is_taken):
    made, _ = search()
    made.ball.seconds_since_seen = seconds
    assert taken(made) is is_taken
    made.ball.present = False
    assert not taken(made)


@pytest.mark.parametrize('seconds, frames', [(0.0, 0), (1.0, 30), (2.5, 75), (900.0, 10000)])
def test_who_has_no_memory_lost_the_ball_when_gps_saw_it_last(seconds, frames):
    made, _ = search()
    made.ball.seconds_since_seen = seconds
    assert remembered(made).ball_lost == frames
    made.ball.present = False
    assert remembered(made).ball_lost == 10000


def test_it_looks_down_30_deg_and_walks_to_the_ball_when_infrared_reads_something():
    made, skill = search((180.0, 270.0))
    command = skill.infrared(made)
    assert command.head.neck_tilt_deg + command.head.head_nod_deg == -30.0
    assert command.walk.forward == pytest.approx(24.0)


@pytest.mark.parametrize('sd, heading_sd, away, half', [
    (0.0, 15.0, 100.0, 30.0), (10.0, 0.0, 57.3, 20.0), (20.0, 0.0, 57.3, 38.5),
    (20.0, 10.0, 57.3, 58.5), (0.0, 1.0, 100.0, 20.0), (200.0, 0.0, 57.3, 90.0)])
def test_a_scan_covers_two_standard_deviations_to_either_side_of_the_ball(sd, heading_sd, away,
                                                                        half):
    made, skill = search((180.0, 250.0 + away))
    made.ball.covariance = [sd * sd, 0.0, 0.0, sd * sd]
    made.heading_sd_deg = heading_sd
    assert skill.limits(made) == pytest.approx((max(-88.0, -half), min(88.0, half)), abs=0.2)


@pytest.mark.parametrize('side', [1.0, -1.0])
def test_without_a_belief_it_turns_at_twice_algorithm_6_2_while_the_head_goes_to_that_side(side):
    made, skill = search()
    made.ball.present = False
    skill.side = side
    command = skill.scan(made)
    assert skill.scanned == 1 and command.walk.turn_deg == 0.0
    assert skill.scan_head.side == -side
    skill.scan_head.side = side
    assert skill.scan(made).walk.turn_deg == pytest.approx(side * 110.0)
    skill.scan_head.rows = 2
    skill.scan(made)
    assert skill.scanned == 30


def test_a_scan_with_a_belief_begins_on_its_side_and_stands():
    for bearing, side in ((20.0, 1.0), (-20.0, -1.0)):
        made, skill = search(turned(bearing, 100.0), lost=30)
        skill.carry(made)
        command = skill.scan(made)
        assert skill.scan_head.side == side and command.walk.turn_deg == 0.0


@pytest.mark.parametrize('only, turn', [(False, 110.0), (True, 55.0)])
def test_a_spin_is_twice_as_fast_unless_nothing_else_is_done(only, turn):
    made, skill = search(lost=100)
    made.ball.present = False
    made.task.search = kelpie.SEARCH_BY_SPIN if only else kelpie.SEARCH_BY_CHAIN
    assert skill.spin(made).walk.turn_deg == pytest.approx(turn)


@pytest.mark.parametrize('only, pan', [(False, 60.0), (True, 45.0)])
def test_the_head_goes_on_to_what_was_not_looked_at_unless_nothing_but_a_spin_is_done(only, pan):
    made, skill = search(lost=100)
    made.ball.present = False
    made.task.search = kelpie.SEARCH_BY_SPIN if only else kelpie.SEARCH_BY_CHAIN
    skill.explored.next_unseen = lambda side: 60.0
    assert skill.spin(made).head.head_pan_deg == pytest.approx(pan)


def test_a_look_that_is_forced_to_no_place_is_none():
    for present, until in ((True, 99), (False, -1)):
        made, skill = search()
        made.ball.present = present
        skill.force(None, 99)
        assert skill.situation(made).force_until == until


def test_one_of_the_own_memory_counts_for_itself():
    made, _ = search()
    skill = FindBall(made)
    skill.step(made)
    assert skill.memory.frame == 1
    other = search(lost=10)[1]
    other.step(made)
    assert other.memory.frame == 0


@pytest.mark.parametrize('side', [1.0, -1.0])
def test_a_believed_ball_that_changes_its_side_changes_that_of_the_search(side):
    made, skill = search(turned(side * 40.0, 100.0), lost=10)
    assert skill.side == side
    put_ball(made, *turned(-side * 40.0, 100.0), seen=False)
    skill.carry(made)
    assert skill.side == -side


# On the spot

@pytest.mark.parametrize('side', [1.0, -1.0])
@pytest.mark.parametrize('distance, unseen, pan, turn', [
    (math.inf, 0.0, 45.0, 55.0), (math.inf, 60.0, 60.0, 55.0), (math.inf, 200.0, 88.0, 55.0),
    (60.0, 0.0, 30.0, 58.3)])
def test_a_spin_holds_the_head_ahead_or_goes_on_to_what_was_not_looked_at(side, distance, unseen,
                                                                        pan, turn):
    made = world()
    skill = SpinForBall(Memory(), side)
    made.odometry.turn_deg = 3.0 * side
    command = skill.step(made, (distance, unseen))
    assert command.head.head_pan_deg == pytest.approx(side * pan)
    assert command.walk.turn_deg == pytest.approx(side * turn) and skill.turned == 3.0
    assert (skill.memory.spin_side, skill.memory.spin_lost, skill.memory.spin_run) == (side, 0, 1)


def test_a_spin_that_is_asked_nothing_turns_as_without_a_belief():
    made = world()
    command = SpinForBall(Memory(), 1.0).step(made)
    assert command.head.head_pan_deg == 45.0 and command.walk.turn_deg == 55.0


# With the team

def together(lost=200, attacks=False, at=(180.0, 200.0)):
    """Player 2 of three, who all have lost the ball; its place is (180, 162)."""
    made = world(*at)
    made.game.player = 2
    made.ball.present = made.percepts.ball.present = False
    made.teammates = [mate(3, (100.0, 350.0)), mate(4, (300.0, 350.0))]
    return made, FindTogether(Memory(ball_lost=lost), attacks)


def mate(player, at, role=kelpie.STRIKER, heard_s=0.1):
    pose = kelpie.Pose2(position=kelpie.Point2(x=at[0], y=at[1]), heading_deg=90.0)
    return kelpie.TeammateEstimate(player=player, note=kelpie.TeamNote(role=role), pose=pose,
                                   seconds_since_heard=heard_s)


@pytest.mark.parametrize('lost, attacks, helps', [(66, False, False), (67, False, True),
                                                  (166, True, False), (167, True, True)])
def test_the_team_is_asked_after_66_frames_and_by_an_attacker_after_166(lost, attacks, helps):
    made, skill = together(lost, attacks)
    assert (skill.step(made) is not None) is helps is skill.active


@pytest.mark.parametrize('off, state', [(21.0, 'go'), (19.0, 'spin')])
def test_it_is_at_its_place_within_20_cm(off, state):
    made, skill = together(at=(180.0 + off, 162.0))
    skill.step(made)
    assert skill.state.__name__ == state


@pytest.mark.parametrize('off, state', [(49.0, 'spin'), (51.0, 'go')])
def test_it_is_off_its_place_beyond_50_cm(off, state):
    made, skill = together(at=(180.0, 162.0))
    skill.step(made)
    made.pose.position.x += off
    skill.step(made)
    assert skill.state.__name__ == state


def test_at_its_place_it_spins_for_7_s_and_searches_alone_for_12():
    made, skill = together(at=(180.0, 162.0))
    found = {}
    for made.time_s in (0.0, 6.99, 7.01, 7.05, 18.9, 19.1):
        found[made.time_s] = skill.step(made) is not None
    assert found == {0.0: True, 6.99: True, 7.01: True, 7.05: False, 18.9: False, 19.1: True}


@pytest.mark.parametrize('side, turn', [(1.0, 110.0), (0.0, 110.0), (-1.0, -110.0)])
def test_it_spins_to_the_side_of_its_last_spin(side, turn):
    made, skill = together(at=(180.0, 162.0))
    skill.memory.spin_side = side
    assert skill.step(made).walk.turn_deg == pytest.approx(turn)


@pytest.mark.parametrize('seconds, place', [(0.9, (180.0, 162.0)), (1.1, (80.0, 378.0))])
def test_who_is_where_is_looked_at_again_after_a_second(seconds, place):
    """Meanwhile player 3 has come nearest to the first place."""
    made, skill = together()
    skill.step(made)
    made.teammates[0] = mate(3, (180.0, 165.0))
    made.time_s += seconds
    skill.step(made)
    assert skill.place == pytest.approx(place)


@pytest.mark.parametrize('other', [
    mate(3, (180.0, 165.0), kelpie.KEEPER), mate(3, (180.0, 165.0), heard_s=1.6),
    mate(2, (180.0, 165.0))])
def test_goalies_who_is_silent_and_itself_are_no_mates_in_the_search(other):
    made, skill = together()
    made.teammates = [other]
    skill.step(made)
    assert skill.place == pytest.approx((180.0, 162.0))


@pytest.mark.parametrize('away, follows', [(59.0, False), (61.0, True)])
def test_a_ball_that_mates_see_more_than_60_cm_off_is_followed_to_30_cm(away, follows):
    made, skill = together(0)
    made.team_ball = kelpie.TeamBall(present=True,
                                     position=kelpie.Point2(x=180.0, y=200.0 + away))
    command = skill.step(made)
    assert (skill.state == skill.follow) is follows is (command is not None)
    if follows:
        assert command.walk.forward == pytest.approx(34.0)
        made.pose.position.y = 200.0 + away - 40.0
        assert skill.follow(made).walk.forward == pytest.approx(12.0)


@pytest.mark.parametrize('seconds, helps', [(0.99, False), (1.01, True)])
def test_the_team_does_not_search_for_a_ball_that_it_saw_within_a_second(seconds, helps):
    """40 cm off, where the own search looks."""
    made, skill = together()
    made.team_ball = kelpie.TeamBall(present=True, position=kelpie.Point2(x=180.0, y=240.0),
                                     seconds_since_seen=seconds)
    assert (skill.step(made) is not None) is helps


def test_a_ball_that_is_seen_again_ends_the_search_of_the_team():
    made, skill = together()
    assert skill.step(made) is not None
    put_ball(made, 180.0, 300.0)
    skill.memory.ball_lost = 0
    assert skill.step(made) is None and not skill.active


# What is asked of nothing

def test_who_knows_nothing_but_that_the_ball_is_lost_scans():
    """No hint, no infrared, no belief: a reading alone is that of a ball only after a near one."""
    assert first_step(Situation())[0] == 'scan'
    assert first_step(Situation(ir=5.0))[0] == 'scan'
    assert first_step(Situation(ir=5.0, close_lost=0))[0] == 'infrared'
    assert first_step(Situation(frame=0, lost=0))[0] == 'last_seen'
    assert first_step(Situation(scanned=30))[0] == 'spin'
    assert first_step(Situation(scanned=30, unseen=0))[0] == 'roam'
    assert first_step(Situation(believed=True))[0] == 'scan'
