# SPDX-License-Identifier: Apache-2.0
"""The team's numbers: what a way, an obstacle, a paw and a lost ball cost in seconds, the order of
algorithm 4.4, when roles change hands, and when somebody wants a place for itself."""
import math
from types import SimpleNamespace

import kelpie
import pytest
from decisions.roles import Own, RoleChoice, goes_forward, should_attack, should_defend, sees
from roles.supporter import Supporter
from situation import keep_off, time_to
from situation.keep_off import Lane
from situation.memory import Memory
from situations import put_ball, world
from test_roles import A, S, Me, mate

D, K = kelpie.DEFENDER, kelpie.KEEPER


# Seconds (thesis 2006 section 4.4.1; checklist U04)

@pytest.mark.parametrize('distance, off_deg, obstacles, stuck, seconds', [
    (30.0, 0.0, 0.0, False, 1.0), (0.0, 120.0, 0.0, False, 1.0), (0.0, -60.0, 0.0, False, 0.5),
    (0.0, 0.0, 4.9, False, 0.0), (0.0, 0.0, 5.0, False, 0.05), (0.0, 0.0, 50.0, False, 0.5),
    (0.0, 0.0, 99.0, False, 0.99), (0.0, 0.0, 101.0, False, 1.0), (0.0, 0.0, 0.0, True, 2.0),
    (60.0, 60.0, 50.0, True, 5.0)])
def test_30_cm_120_deg_or_100_counts_on_the_way_take_a_second_and_who_is_stuck_two(
        distance, off_deg, obstacles, stuck, seconds):
    assert time_to.seconds(distance, off_deg, obstacles, stuck) == pytest.approx(seconds)


@pytest.mark.parametrize('feeling, more', [
    ({}, 0.0), ({'stuck': True}, 2.0), ({'paw_blocked': [True, False]}, 2.0),
    ({'paw_blocked': [False, True]}, 2.0)])
def test_a_stuck_robot_or_a_blocked_paw_costs_two_seconds_of_the_way_to_the_ball(feeling, more):
    made = world(180.0, 200.0, 90.0, (180.0, 350.0))
    for name, value in feeling.items():
        setattr(made.motion.feeling, name, value)
    assert time_to.to_point(made, (180.0, 350.0)) == pytest.approx(5.0 + more)
    assert time_to.to_ball(made, 0, False, False) == pytest.approx(5.0 + more + 2.7)


def test_what_stands_on_the_way_makes_the_ball_take_longer():
    made = world(180.0, 200.0, 90.0, (180.0, 350.0))
    made.obstacles = [kelpie.ObstacleCell(position=kelpie.Point2(x=180.0, y=270.0), own=30.0,
                                          heard=30.0)]
    assert time_to.to_point(made, (180.0, 350.0)) == pytest.approx(5.6)


@pytest.mark.parametrize('frames, seconds', [(0, 0.0), (15, 0.0), (25, 0.2), (45, 1.8),
                                             (65, 5.0), (69, 5.832), (70, 6.0), (500, 6.0)])
def test_a_lost_ball_costs_0_002_s_for_the_square_of_the_frames_beyond_15_up_to_6_s(frames,
                                                                                   seconds):
    assert time_to.unsure(frames) == pytest.approx(seconds)


@pytest.mark.parametrize('at, heading, seconds', [
    ((180.0, 100.0), 90.0, 1.0), ((180.0, 100.0), 30.0, 1.5), ((210.0, 130.0), 180.0, 1.0),
    ((210.0, 130.0), -170.0, 1.0 + 10.0 / 120.0), ((180.0, 160.0), 90.0, 2.5)])
def test_a_pose_needs_the_turn_and_the_way(at, heading, seconds):
    pose = kelpie.Pose2(position=kelpie.Point2(x=at[0], y=at[1]), heading_deg=heading)
    assert time_to.of_pose(pose, (180.0, 130.0)) == pytest.approx(seconds)


@pytest.mark.parametrize('grab_lost, approach_lost, away, held, wanted', [
    (1, 99, 20.0, True, kelpie.HOLDS), (1, 99, 20.0, False, kelpie.GRABS_SOON),
    (2, 99, 20.0, True, kelpie.GRABS_NOT), (2, 1, 39.0, False, kelpie.GRABS_SOON),
    (2, 1, 41.0, False, kelpie.GRABS_NOT), (2, 2, 39.0, False, kelpie.GRABS_NOT)])
def test_the_team_hears_of_a_grab_that_has_begun_or_is_within_40_cm(grab_lost, approach_lost, away,
                                                                  held, wanted):
    made, memory = world(180.0, 200.0, 90.0, (180.0, 200.0 + away)), Memory()
    memory.grab_lost, memory.approach_lost = grab_lost, approach_lost
    made.motion.feeling.ball_held = held
    assert time_to.grabs_now(made, memory) == wanted


@pytest.mark.parametrize('lost, present, team_s, ball', [
    (15, True, 0.1, 'own'), (16, True, 0.1, 'team'), (16, True, 0.99, 'team'),
    (16, True, 1.01, 'own'), (0, False, 0.1, 'team'), (0, False, 1.01, None)])
def test_a_ball_lost_for_15_frames_is_the_teams_if_that_is_not_a_second_old(lost, present, team_s,
                                                                          ball):
    made = world(180.0, 200.0, 90.0, (180.0, 350.0))
    made.ball.present = present
    made.team_ball = kelpie.TeamBall(present=True, position=kelpie.Point2(x=90.0, y=80.0),
                                     seconds_since_seen=team_s)
    wanted = {'own': (180.0, 350.0), 'team': (90.0, 80.0), None: None}[ball]
    assert time_to.ball_of(made, lost) == wanted


# Who attacks

def test_who_grabs_or_holds_the_ball_attacks_though_a_mate_is_quicker():
    me = Me(seconds=9.0, started=True)
    assert should_attack(me, [mate(2, A, 1.0)])[0]


@pytest.mark.parametrize('distance, attacks', [(99.0, True), (101.0, False)])
def test_of_those_who_see_a_ball_that_the_attacker_does_not_the_closest_attacks(distance, attacks):
    """Mates stand 100 cm from the ball at (180, 300)."""
    me = Me(seconds=9.0, distance=100.0)
    me.distance = distance
    mates = [mate(2, A, 1.0, ball_s=2.0, at=(180.0, 400.0)), mate(4, S, 5.0, at=(80.0, 300.0))]
    assert should_attack(me, mates)[0] is attacks


@pytest.mark.parametrize('ball_s, grabs, seen', [
    (0.49, kelpie.GRABS_NOT, True), (0.51, kelpie.GRABS_NOT, False), (9.0, kelpie.HOLDS, True),
    (9.0, kelpie.GRABS_SOON, False)])
def test_who_holds_the_ball_counts_as_seeing_it(ball_s, grabs, seen):
    assert sees(mate(2, A, ball_s=ball_s, grabs=grabs)) is seen


def test_an_own_situation_is_of_the_last_role_and_of_this_frame():
    made, memory = world(180.0, 200.0, 90.0, (180.0, 350.0)), Memory(ball_lost=0)
    for last in (A, D, S):
        own = Own(made, memory, last)
        assert (own.attacked, own.defended) == (last == A, last == D)
        assert own.seconds == pytest.approx(5.0 + (2.0 if last == A else 2.7))
        assert (own.distance, own.ball, own.sees) == (150.0, (180.0, 350.0), True)
    made.ball.present = False
    assert not Own(made, memory, S).sees


@pytest.mark.parametrize('seconds, defends', [(2.0, True), (3.0, True), (4.0, False)])
def test_of_two_who_attack_the_slower_or_the_larger_number_may_be_sooner_home(seconds, defends):
    """Player 2, near home, attacks as quickly as that; player 4, far up-field, in 3 s."""
    mates = [mate(2, A, seconds, at=(180.0, 90.0)), mate(4, A, 3.0, at=(180.0, 400.0))]
    assert should_defend(Me(at=(180.0, 200.0)), mates, (180.0, 85.0))[0] is defends


def chosen(times, last=S, mates=(), ball=(180.0, 400.0), at=(180.0, 200.0)):
    """The role after choices at these times (s), mates the same all the time or one list each."""
    made, memory, choice = world(*at, 90.0, ball), Memory(ball_lost=0), RoleChoice()
    choice.role = last
    lists = mates if mates and isinstance(mates[0], list) else [list(mates)] * len(times)
    for made.time_s, made.teammates in zip(times, lists):
        choice.frames = 0
        choice.update(made, memory)
    return choice


@pytest.mark.parametrize('after_s, attacks', [(0.1, False), (0.49, False), (0.51, True)])
def test_a_slower_robot_waits_half_a_second_for_the_mate_that_takes_over(after_s, attacks):
    """Player 2 gives the ball up; player 4 is quicker and has not said yet that it attacks."""
    before = [mate(2, A, 3.0, at=(180, 380)), mate(4, S, 1.0, at=(200, 400))]
    after = [mate(2, S, 3.0, at=(180, 380)), mate(4, S, 1.0, at=(200, 400))]
    assert (chosen((10.0, 10.0 + after_s), S, [before, after]).role == A) is attacks


def test_the_quickest_takes_a_ball_that_was_given_up_at_once():
    before = [mate(2, A, 30.0, at=(180, 380)), mate(4, S, 40.0, at=(200, 400))]
    after = [mate(2, S, 30.0, at=(180, 380)), mate(4, S, 40.0, at=(200, 400))]
    assert chosen((10.0, 10.1), S, [before, after]).role == A


@pytest.mark.parametrize('claimed_s, attacks', [(1.0, False), (8.7, False), (8.8, True)])
def test_an_attacker_gives_the_ball_up_to_a_mate_that_attacks_and_is_as_quick(claimed_s, attacks):
    """Itself 200 cm away: 6.67 s, and 2 for no grab; a third is quicker and does not attack."""
    mates = [mate(2, A, claimed_s, at=(180, 380)), mate(4, S, 1.0, at=(60, 60))]
    assert (chosen((10.0,), A, mates).role == A) is attacks


@pytest.mark.parametrize('ball_y, role', [(269.0, D), (271.0, kelpie.SUPPORTER)])
def test_the_only_other_forward_supports_with_the_ball_in_their_half(ball_y, role):
    mates = [mate(2, A, 0.5, at=(180.0, ball_y))]
    assert chosen((10.0,), S, mates, (180.0, ball_y), (180.0, 100.0)).role == role


@pytest.mark.parametrize('own, theirs, aware, player, forward', [
    (0, 4, True, kelpie.GOALIE, True), (0, 3, True, kelpie.GOALIE, False),
    (1, 5, True, kelpie.GOALIE_2004, True), (4, 0, True, kelpie.GOALIE, False),
    (0, 4, False, kelpie.GOALIE, False), (0, 4, True, kelpie.FORWARD, False)])
def test_a_goalie_goes_forward_when_its_team_is_behind_by_more_than_three_goals(
        own, theirs, aware, player, forward):
    made = world()
    made.game.own_score, made.game.opponent_score = own, theirs
    made.task.score_aware, made.task.player = aware, player
    assert goes_forward(made) is forward


# The order of algorithm 4.4. A striker's home for this ball is (300, 350).

def states(places, attacker=(100.0, 150.0), ball=(100.0, 200.0), **changes):
    """What a striker does at these places, one after the other."""
    memory, found = Memory(), []
    skill = Supporter(memory, S)
    for place in places:
        made = world(*place, 90.0, ball)
        made.teammates = [mate(2, A, 2.0, at=attacker, **changes)]
        memory.update(made)
        skill.step(made)
        found.append(skill.state.__name__)
    return found


def test_who_flies_home_is_not_turned_aside_by_the_attackers_way_to_the_ball():
    """Both rules hold at the last place; who stands there leaves the attacker's way."""
    in_way = (140.0, 140.0)
    assert states([(140.0, 20.0), in_way], (180.0, 80.0)) == ['bird_of_prey'] * 2
    assert states([in_way], (180.0, 80.0)) == ['avoid_attacker']


def test_who_flies_home_leaves_the_line_of_a_mate_that_has_the_ball():
    assert states([(300.0, 20.0), (110.0, 300.0)], (100.0, 180.0)) == ['bird_of_prey', 'avoid_ball']


@pytest.mark.parametrize('away, state', [(99.0, 'go_home'), (101.0, 'bird_of_prey')])
def test_bird_of_prey_begins_100_cm_from_home(away, state):
    assert states([(300.0, 350.0 - away)]) == [state]


@pytest.mark.parametrize('away, state', [(29.0, 'go_home'), (31.0, 'bird_of_prey')])
def test_bird_of_prey_ends_30_cm_from_home(away, state):
    assert states([(300.0, 200.0), (300.0, 350.0 - away)])[1] == state


@pytest.mark.parametrize('lost, reported, state', [(40, False, 'go_home'), (41, False, 'find_ball'),
                                                   (60, True, 'go_home')])
def test_at_home_a_ball_is_looked_for_after_40_frames_unless_mates_see_it(lost, reported, state):
    made, memory = world(300.0, 350.0, 90.0, (100.0, 200.0)), Memory(ball_lost=lost - 1)
    made.percepts.ball.present, made.ball.seconds_since_seen = False, lost / 30.0
    made.teammates = [mate(2, A, 2.0, at=(100.0, 150.0))]
    made.team_ball = kelpie.TeamBall(present=reported, position=kelpie.Point2(x=100.0, y=200.0))
    memory.update(made)
    skill = Supporter(memory, S)
    skill.step(made)
    assert skill.state.__name__ == state


def test_a_mate_that_passes_to_another_is_not_waited_for():
    made, memory = world(180.0, 400.0, -90.0, (180.0, 260.0)), Memory()
    made.game.player = 4
    holder = mate(2, A, 0.5, at=(180.0, 250.0), grabs=kelpie.HOLDS)
    made.teammates = [holder]
    memory.update(made)
    for to, state in ((3, 'get_out_of_way'), (4, 'receive'), (0, 'get_out_of_way')):
        holder.note.pass_to = to
        skill = Supporter(memory, S)
        command = skill.step(made)
        assert skill.state.__name__ == state
    assert math.hypot(command.walk.forward, command.walk.left) > 0.0


def test_who_waits_for_a_pass_turns_to_the_ball():
    for x, turns in ((280.0, -1.0), (80.0, 1.0)):
        made, memory = world(180.0, 400.0, 90.0, (x, 400.0)), Memory()
        made.game.player = 4
        made.teammates = [mate(2, A, 0.5, at=(x, 395.0), grabs=kelpie.HOLDS)]
        made.teammates[0].note.pass_to = 4
        memory.update(made)
        walk = Supporter(memory, S).step(made).walk
        assert walk.turn_deg * turns > 0.0 and walk.forward == walk.left == 0.0


def test_it_says_what_its_head_does_but_while_it_searches_or_backs_off():
    made, memory = world(300.0, 350.0, 90.0, (100.0, 200.0)), Memory()
    made.teammates = [mate(2, A, 2.0, at=(100.0, 150.0))]
    put_ball(made, 100.0, 200.0)
    memory.update(made)
    memory.localised_lost = 500
    skill, trace = Supporter(memory, S), []
    skill.step(made)
    skill.watch.looking = True
    skill.watch.mark.start(made)
    for state, tells in (('go_home', True), ('back_off', False), ('find_ball', False)):
        skill.enter(made, getattr(skill, state))
        trace.clear()
        skill.explain(trace)
        assert any(step[1] == 'active_localise' for step in trace) is tells


@pytest.mark.parametrize('gap, before, state', [
    (43.0, 'go_home', 'avoid_attacker'), (45.0, 'go_home', 'go_home'),
    (45.0, 'avoid_attacker', 'avoid_attacker'), (51.0, 'avoid_attacker', 'go_home')])
def test_the_attackers_way_is_left_from_44_cm_until_50(gap, before, state):
    """A striker at home beside the way of an attacker up the field to the ball."""
    made, memory = world(300.0, 350.0, 90.0, (100.0, 200.0)), Memory()
    made.teammates = [mate(2, A, 2.0, at=(300.0 - gap, 500.0))]
    memory.update(made)
    skill = Supporter(memory, S)
    skill.step(made)
    lane = Lane(keep_off.ON_WAY, (300.0 - gap, 250.0), (300.0 - gap, 450.0), 44.0)
    skill.enter(made, getattr(skill, before))
    skill.now.lanes, skill.now.paw_pushes = [lane], False
    skill.now.home, skill.now.away = (300.0, 350.0), 10.0
    skill.choose(made, skill.now)
    assert skill.state.__name__ == state


@pytest.mark.parametrize('paws, keeps_out', [([False, False], True), ([True, True], False)])
def test_the_own_box_is_kept_out_of_but_by_who_backs_off(paws, keeps_out):
    """A defender 15 cm above the box, 5 above where it turns, whose place is in it."""
    made, memory = world(180.0, 80.0, 90.0, (180.0, 300.0)), Memory()
    made.motion.feeling.paw_blocked = paws
    memory.update(made)
    skill = Supporter(memory, D)
    skill.home_of = SimpleNamespace(update=lambda *asked: (180.0, 20.0),
                                    turn_deg=lambda *asked: 0.0)
    walk = skill.step(made).walk
    assert walk.forward == pytest.approx(-5.0 if keeps_out else -24.0)


def test_the_search_of_the_team_is_told_only_while_it_is_played():
    made, memory = world(300.0, 350.0, 90.0, (100.0, 200.0)), Memory()
    memory.update(made)
    skill = Supporter(memory, S)
    skill.step(made)

    def teller(name):
        return SimpleNamespace(active=True, end=lambda: None,
                               explain=lambda trace: trace.append((0, name, '', '')))
    for state, active, told in (('find_ball', True, 'team'), ('find_ball', False, 'own'),
                                ('go_home', True, 'own')):
        skill.enter(made, getattr(skill, state), teller('own'))
        skill.team_search, trace = teller('team'), []
        skill.team_search.active = active
        skill.explain(trace)
        assert trace[1][1] == told


@pytest.mark.parametrize('bound', [True, False])
def test_who_may_not_be_interrupted_attacks_on_though_a_quicker_mate_says_that_it_does(bound):
    made, memory = world(180.0, 200.0, 90.0, (180.0, 400.0)), Memory(ball_lost=0)
    choice = RoleChoice()
    made.teammates = [mate(2, A, 0.1, at=(180, 390)), mate(4, S, 5.0, at=(180, 100))]
    assert (choice.update(made, memory, bound) == A) is bound
