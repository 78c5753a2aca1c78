# SPDX-License-Identifier: Apache-2.0
"""Who plays which role: the branches of algorithms 4.5 and 4.6, the time to the ball and its
bonuses, and what three forwards that hear each other late come to."""
import math
import random

import kelpie
import pytest
from decisions import positions
from decisions.roles import (CHALLENGE_S, HAND_OVER_S, Own, RoleChoice, forwards, should_attack,
                             should_defend)
from lib import rulebook
from situation import time_to
from situation.memory import Memory
from situations import put_ball, world

HOME = (180.0, 85.0)


class Me(Own):
    """What algorithm 4.6 asks of oneself, for tables."""
    world, rules = None, rulebook.Kelpie

    def __init__(self, seconds=4.0, player=3, attacked=False, sees=True, started=False,
                 distance=100.0, at=(180.0, 200.0), defended=False):
        self.seconds, self.player, self.attacked, self.sees = seconds, player, attacked, sees
        self.started, self.distance, self.defended = started, distance, defended
        self.ball = (at[0], at[1] + distance)
        self.pose = kelpie.Pose2(position=kelpie.Point2(x=at[0], y=at[1]), heading_deg=90.0)


def mate(player=2, role=kelpie.STRIKER, seconds=5.0, ball_s=0.0, at=(60.0, 60.0), heard_s=0.1,
         grabs=kelpie.GRABS_NOT, heading=90.0):
    note = kelpie.TeamNote(role=role, time_to_ball=seconds, grabs=grabs)
    pose = kelpie.Pose2(position=kelpie.Point2(x=at[0], y=at[1]), heading_deg=heading)
    return kelpie.TeammateEstimate(player=player, note=note, pose=pose, seconds_since_ball=ball_s,
                                   seconds_since_heard=heard_s)


A, S = kelpie.ATTACKER, kelpie.STRIKER

# What the branch is, oneself, the mates, whether one attacks.
BRANCHES = [
    ('without an attacker', Me(seconds=9.0), [mate(2), mate(4)], True),
    ('the attacker is blind, I see the ball and am closest', Me(seconds=9.0),
     [mate(2, A, 1.0, ball_s=2.0), mate(4)], True),
    ('the attacker is blind but another is closer', Me(seconds=9.0),
     [mate(2, A, 1.0, ball_s=2.0), mate(4, S, 5.0, at=(180.0, 290.0))], False),
    ('the attacker is blind and so am I', Me(seconds=9.0, sees=False),
     [mate(2, A, 1.0, ball_s=2.0)], False),
    ('the attacker sees the ball: closest alone is not enough (G17)', Me(seconds=9.0),
     [mate(2, A, 1.0)], False),
    ('an attacker that holds the ball need not see it', Me(seconds=9.0),
     [mate(2, A, 1.0, ball_s=2.0, grabs=kelpie.HOLDS)], False),
    ('I hold the ball or have started to grab', Me(seconds=9.0, started=True), [mate(2, A, 1.0)],
     True),
    ('another needs less', Me(seconds=4.0), [mate(2, A, 5.0), mate(4, S, 3.0)], False),
    ('I need least', Me(seconds=4.0), [mate(2, A, 5.0), mate(4, S, 6.0)], True),
    ('a tie with a larger number', Me(seconds=4.0, player=3), [mate(4, A, 4.0)], True),
    ('a tie with a smaller number', Me(seconds=4.0, player=3), [mate(2, A, 4.0)], False),
    ('I attack already and a mate needs less', Me(seconds=4.0, attacked=True),
     [mate(2, S, 3.0)], False),
    ('I attack already and need least', Me(seconds=4.0, attacked=True), [mate(2, S, 5.0)], True)]


@pytest.mark.parametrize('me, mates, yes', [row[1:] for row in BRANCHES],
                         ids=[row[0] for row in BRANCHES])
def test_an_attacker_is_chosen_by_algorithm_4_6(me, mates, yes):
    answer, reason, *reported = should_attack(me, mates)
    assert answer == yes
    assert len(reason) <= 80 and reason.count('{}') == len(reported) <= 3


@pytest.mark.parametrize('mates, defends', [
    ([mate(2, A), mate(4, S, at=(180.0, 400.0))], True),
    ([mate(2, A), mate(4, S, at=(180.0, 120.0))], False),
    ([mate(2, A, at=(180.0, 120.0)), mate(4, S, at=(180.0, 400.0))], True),
    ([mate(2, A)], True),
    ([mate(2, S, 1.0, at=(180.0, 90.0)), mate(4, S, at=(180.0, 400.0))], True),
    ([mate(2, A, 1.0, at=(180.0, 400.0)), mate(4, A, at=(180.0, 90.0))], False)])
def test_the_sooner_home_defends_of_those_who_do_not_attack(mates, defends):
    assert should_defend(Me(at=(180.0, 200.0)), mates, HOME)[0] == defends


@pytest.mark.parametrize('seconds, player, attacks', [
    (3.95, 4, True), (3.93, 4, False), (3.95, 2, False), (4.05, 2, False), (4.07, 2, True)])
def test_times_within_60_ms_are_a_tie_that_the_smaller_number_wins(seconds, player, attacks):
    assert should_attack(Me(seconds=4.0), [mate(player, A, seconds)])[0] is attacks


@pytest.mark.parametrize('ball_s, attacks', [(0.49, False), (0.51, True)])
def test_an_attacker_that_has_not_seen_the_ball_for_half_a_second_is_blind(ball_s, attacks):
    assert should_attack(Me(seconds=9.0), [mate(2, A, 1.0, ball_s=ball_s)])[0] is attacks


@pytest.mark.parametrize('sooner_cm, role, stays', [
    (31.0, S, True), (33.0, S, False), (1.0, kelpie.DEFENDER, True), (3.0, kelpie.DEFENDER, False)])
def test_a_defender_stays_one_until_a_mate_is_home_a_second_sooner(sooner_cm, role, stays):
    """At 30 cm/s, and by the 60 ms of a tie more."""
    me = Me(at=(180.0, 200.0), defended=True)
    other = mate(4, role, at=(180.0, 200.0 - sooner_cm))
    assert should_defend(me, [mate(2, A), other], HOME)[0] is stays


@pytest.mark.parametrize('sooner_cm, number, defends', [
    (1.5, 4, True), (2.1, 4, False), (1.5, 2, False), (-1.5, 2, False), (-2.1, 2, True)])
def test_who_are_home_within_60_ms_leave_it_to_the_smaller_number(sooner_cm, number, defends):
    mates = [mate(5, A), mate(number, S, at=(180.0, 200.0 - sooner_cm))]
    assert should_defend(Me(at=(180.0, 200.0)), mates, HOME)[0] is defends


@pytest.mark.parametrize('lost, grab_lost, sees, started', [
    (15, 1, True, True), (16, 2, False, False)])
def test_who_saw_the_ball_within_15_frames_sees_it_and_a_grab_is_of_this_frame(lost, grab_lost,
                                                                              sees, started):
    memory = Memory()
    memory.ball_lost, memory.grab_lost = lost, grab_lost
    own = Own(world(), memory, S)
    assert (own.sees, own.started) == (sees, started)


def test_a_defender_stays_one_against_a_mate_that_is_a_little_sooner_home():
    near = [mate(2, A), mate(4, S, at=(180.0, 180.0))]
    assert not should_defend(Me(), near, HOME)[0]
    assert should_defend(Me(defended=True), near, HOME)[0]


def test_goalies_and_who_was_silent_for_long_do_not_count():
    made = world()
    made.teammates = [mate(1, kelpie.KEEPER, 0.1), mate(2, heard_s=1.6), mate(4)]
    assert [other.player for other in forwards(made)] == [4]


# The time to the ball

def test_one_metre_straight_ahead_takes_100_cm_at_30_cm_a_second():
    assert time_to.seconds(100.0) == pytest.approx(100.0 / 30.0)
    assert time_to.seconds(0.0, off_deg=-120.0) == pytest.approx(1.0)


@pytest.mark.parametrize('more', [dict(distance=120.0), dict(off_deg=60.0), dict(obstacles=40.0),
                                  dict(stuck=True)])
def test_each_term_more_takes_longer(more):
    base = dict(distance=100.0, off_deg=10.0, obstacles=6.0, stuck=False)
    assert time_to.seconds(**{**base, **more}) > time_to.seconds(**base)


def test_few_points_on_the_way_are_noise_and_very_many_are_as_bad_as_100():
    assert time_to.seconds(1.0, obstacles=4.9) == time_to.seconds(1.0)
    assert time_to.seconds(1.0, obstacles=900.0) == time_to.seconds(1.0, obstacles=100.0)


def cell(x, y, count=20.0):
    return kelpie.ObstacleCell(position=kelpie.Point2(x=x, y=y), own=count)


def test_what_stands_on_the_way_counts_and_what_stands_beside_or_at_the_ball_does_not():
    way = (180.0, 100.0), (180.0, 300.0)
    assert time_to.on_way([cell(180, 200), cell(190, 200)], *way) == 40.0
    assert time_to.on_way([cell(200, 200), cell(180, 290), cell(180, 105), cell(180, 50)],
                          *way) == 0.0


@pytest.mark.parametrize('end', [(300.0, 300.0), (60.0, 220.0), (40.0, 60.0), (320.0, 180.0)])
def test_a_way_in_any_direction_is_blocked_across_a_corridor_of_30_cm(end):
    start = (180.0, 180.0)
    dx, dy = end[0] - start[0], end[1] - start[1]
    length = math.hypot(dx, dy)
    for lateral, counted in ((-16, 0), (-14, 20), (0, 20), (14, 20), (16, 0)):
        there = cell(start[0] + 0.5 * dx + lateral * dy / length,
                     start[1] + 0.5 * dy - lateral * dx / length)
        assert time_to.on_way([there], start, end) == counted, lateral


def test_a_ball_unseen_for_longer_costs_more_and_never_more_than_a_little():
    costs = [time_to.unsure(frames) for frames in range(0, 300, 5)]
    assert costs == sorted(costs) and costs[3] == 0.0 and costs[-1] == time_to.LOST_MAX_S
    assert time_to.unsure(45) == pytest.approx(0.002 * 30 * 30)


def test_the_attacker_of_the_last_frame_and_a_grab_have_their_bonus():
    made = world()
    plain = time_to.to_ball(made, 0, False, False)
    assert plain - time_to.to_ball(made, 0, True, False) == pytest.approx(0.7)
    assert plain - time_to.to_ball(made, 0, False, True) == pytest.approx(2.0)
    assert time_to.to_ball(made, 0, True, True) >= 0.0


def test_who_lost_the_ball_goes_by_its_teams_and_without_one_never_arrives():
    made = world(ball=(180.0, 260.0))
    made.team_ball = kelpie.TeamBall(present=True, position=kelpie.Point2(x=90.0, y=90.0))
    assert time_to.ball_of(made, 0) == (180.0, 260.0)
    assert time_to.ball_of(made, 60) == (90.0, 90.0)
    made.ball.present = made.team_ball.present = False
    assert time_to.to_ball(made, 60, False, False) == time_to.NEVER_S


# Role by role, in frames

def choice_in(made, frames=1, choice=None, memory=None):
    choice = choice or RoleChoice()
    memory = memory or Memory()
    for _ in range(frames):
        made.time_s += 1.0 / 30.0
        memory.update(made)
        choice.update(made, memory)
    return choice


def test_whoever_is_alone_attacks():
    made = world()
    assert choice_in(made, 10).role == kelpie.ATTACKER
    made.teammates = [mate(1, kelpie.KEEPER)]
    assert choice_in(made, 10).role == kelpie.ATTACKER


def test_of_three_one_attacks_one_defends_and_the_last_is_striker():
    made = world(180.0, 200.0, ball=(180.0, 400.0))
    made.teammates = [mate(2, A, 1.0, at=(180, 380)), mate(4, S, 6.0, at=(60, 400))]
    assert choice_in(made).role == kelpie.DEFENDER
    made.pose.position.y, made.teammates[1].pose.position.y = 420.0, 200.0
    assert choice_in(made).role == kelpie.STRIKER


def test_the_only_other_supports_in_their_half_and_defends_in_the_own():
    made = world(180.0, 200.0, ball=(180.0, 400.0))
    made.teammates = [mate(2, A, 1.0, at=(180, 380))]
    assert choice_in(made).role == kelpie.SUPPORTER
    put_ball(made, 180.0, 120.0)
    assert choice_in(made).role == kelpie.DEFENDER


def test_who_attacks_goes_on_until_a_quicker_mate_has_said_that_it_does():
    made = world(180.0, 200.0, ball=(180.0, 400.0))
    made.teammates = [mate(2, S, 1.0, at=(180, 380))]
    choice, memory = choice_in(made, 20), Memory()
    assert choice.role == kelpie.ATTACKER and 'no quicker mate' in choice.why[0]
    made.teammates[0].note.role = A
    assert choice_in(made, 1, choice, memory).role != kelpie.ATTACKER


def test_a_mate_takes_the_ball_over_when_it_has_been_quicker_for_a_while():
    made = world(180.0, 380.0, ball=(180.0, 400.0))
    made.teammates = [mate(2, A, 1.0, at=(180, 390))]
    choice, memory = choice_in(made, 3), Memory()
    assert choice.role != kelpie.ATTACKER
    made.teammates[0].note.time_to_ball = 9.0
    attacks = [choice_in(made, 1, choice, memory).role == kelpie.ATTACKER for _ in range(15)]
    assert attacks.index(True) >= 30.0 * CHALLENGE_S
    made.teammates[0].note.time_to_ball = 1.0
    assert choice_in(made, 3, choice, memory).role != kelpie.ATTACKER


def test_who_attacked_last_leaves_the_ball_to_a_quicker_mate_that_has_not_said_so_yet():
    made = world(180.0, 200.0, ball=(180.0, 400.0))
    made.teammates = [mate(2, A, 1.0, at=(180, 380))]
    choice, memory = choice_in(made), Memory()
    made.teammates[0].note.role = S
    attacks = [choice_in(made, 1, choice, memory).role == kelpie.ATTACKER for _ in range(20)]
    assert attacks.index(True) >= 30.0 * HAND_OVER_S - 1.0


def test_a_role_is_chosen_anew_in_every_third_frame_or_when_others_attack():
    made, memory = world(180.0, 200.0, ball=(180.0, 400.0)), Memory()
    made.teammates = [mate(2, A, 1.0, at=(180, 380)), mate(4, S, 6.0, at=(60, 400))]
    choice, roles = choice_in(made), []
    made.teammates[1].pose.position = kelpie.Point2(x=180.0, y=280.0)
    for _ in range(3):
        roles.append(choice_in(made, 1, choice, memory).role)
    assert roles == [kelpie.DEFENDER, kelpie.DEFENDER, S]
    made.teammates = [mate(4, A, 1.0, at=(60, 100)), mate(2, S, 3.0, at=(180, 380))]
    assert choice_in(made, 1, choice, memory).role == kelpie.DEFENDER


@pytest.mark.parametrize('seconds, attacks', [(0.12, False), (0.17, True)])
def test_a_quicker_robot_waits_0_15_s_before_it_takes_the_ball_over(seconds, attacks):
    made, memory = world(180.0, 380.0, ball=(180.0, 400.0)), Memory()
    memory.update(made)
    made.teammates = [mate(2, A, 9.0, at=(180, 390))]
    choice = RoleChoice()
    choice.role = S
    for at_s in (10.0, 10.0 + seconds):
        made.time_s, choice.frames = at_s, 0
        choice.update(made, memory)
    assert (choice.role == A) is attacks


@pytest.mark.parametrize('seconds, attacks', [(0.48, False), (0.52, True)])
def test_half_a_second_after_the_last_attacker_a_slower_one_takes_the_ball(seconds, attacks):
    made, memory = world(180.0, 200.0, ball=(180.0, 400.0)), Memory()
    memory.update(made)
    choice = RoleChoice()
    choice.role = S
    for at_s, role in ((10.0, A), (10.0 + seconds, S)):
        made.time_s, made.teammates = at_s, [mate(2, role, 1.0, at=(180, 380))]
        choice.update(made, memory)
    assert (choice.role == A) is attacks


def test_who_knows_of_no_ball_stays_what_it_is_and_an_attacker_becomes_a_striker():
    made, memory = world(), Memory()
    made.ball.present = made.percepts.ball.present = False
    made.teammates = [mate(2, A, 1.0), mate(4)]
    for before, after in ((A, S), (S, S), (kelpie.DEFENDER, kelpie.DEFENDER)):
        choice = RoleChoice()
        choice.role = before
        assert choice_in(made, 1, choice, memory).role == after


def test_a_far_robot_does_not_attack_while_a_mate_hands_the_ball_to_another():
    made = world(180.0, 60.0, ball=(180.0, 450.0))
    made.teammates = [mate(2, A, 3.0, at=(180, 380)), mate(4, S, 2.0, at=(200, 400))]
    choice, memory = choice_in(made), Memory()
    made.teammates[0].note.role = S
    for _ in range(round(25 * HAND_OVER_S)):
        assert choice_in(made, 1, choice, memory).role != kelpie.ATTACKER


class Team:
    """Three forwards on the plane that go for one ball and hear each other every fifth frame,
    three frames late."""

    def __init__(self, places, ball):
        self.worlds = [world(x, y, heading, ball) for x, y, heading in places]
        for number, made in enumerate(self.worlds):
            made.game.player = number + 2
        self.choices = [RoleChoice() for _ in places]
        self.memories = [Memory() for _ in places]
        self.said = [[] for _ in places]

    def step(self, frame):
        for made, choice, memory in zip(self.worlds, self.choices, self.memories):
            made.time_s = frame / 30.0
            memory.update(made)
            choice.update(made, memory)
        for number, made in enumerate(self.worlds):
            if (frame + number) % 5 == 0:
                place = made.pose.position
                self.said[number].append(
                    (frame + 3, mate(number + 2, self.choices[number].role,
                                     self.choices[number].seconds, at=(place.x, place.y),
                                     heading=made.pose.heading_deg)))
        for number, made in enumerate(self.worlds):
            heard = [[reported for at, reported in said if at <= frame] for said in self.said]
            made.teammates = [reported[-1] for other, reported in enumerate(heard)
                              if other != number and reported]

    def walk(self):
        """The attacker to the ball, the others to their places."""
        for made, choice in zip(self.worlds, self.choices):
            ball = (made.ball.position.x, made.ball.position.y)
            place = positions.PLACES[choice.role](made.field, ball) \
                if choice.role in positions.PLACES else ball
            x, y = made.pose.position.x, made.pose.position.y
            away = math.hypot(place[0] - x, place[1] - y)
            if away > 10.0:
                made.pose.position.x += (place[0] - x) / away
                made.pose.position.y += (place[1] - y) / away
            put_ball(made, *ball)


@pytest.mark.parametrize('ball', [(180.0, 270.0), (40.0, 500.0), (320.0, 60.0)])
def test_three_forwards_agree_within_half_a_second_and_stay_agreed(ball):
    team = Team([(100.0, 150.0, 90.0), (180.0, 230.0, 90.0), (260.0, 150.0, 0.0)], ball)
    roles = []
    for frame in range(300):
        team.step(frame)
        team.walk()
        roles.append(tuple(choice.role for choice in team.choices))
    for now in roles[15:]:
        assert now.count(kelpie.ATTACKER) == 1 and now.count(kelpie.DEFENDER) <= 1
    assert sum(now.count(kelpie.DEFENDER) == now.count(kelpie.STRIKER) == 1
               for now in roles[15:]) > 0.95 * len(roles[15:])
    assert sum(one != two for one, two in zip(roles[15:], roles[16:])) <= 4


def switches(hysteresis_s, monkeypatch):
    """Of roles in 20 s of two robots that are as near to a ball that each sees 4 cm (sd) off."""
    monkeypatch.setattr(time_to, 'ATTACKER_S', hysteresis_s)
    chance = random.Random(5)
    team = Team([(80.0, 200.0, 0.0), (280.0, 200.0, 180.0), (180.0, 60.0, 90.0)], (180.0, 200.0))
    before, count = None, 0
    for frame in range(600):
        for made in team.worlds:
            put_ball(made, 180.0 + chance.gauss(0.0, 4.0), 200.0 + chance.gauss(0.0, 4.0))
        team.step(frame)
        now = [choice.role == kelpie.ATTACKER for choice in team.choices]
        count += before is not None and now != before
        before = now
    return count


def test_with_the_attackers_bonus_roles_flap_less(monkeypatch):
    without, with_bonus = switches(0.0, monkeypatch), switches(0.7, monkeypatch)
    assert with_bonus < 0.2 * without, (with_bonus, without)
