# SPDX-License-Identifier: Apache-2.0
"""Roles, places and backing off by the theses' rules alone (thesis 2006 sections 4.3.3, 4.4 and
4.5.2), and by Kelpie's where those differ."""
import kelpie
import pytest
from books import both, by
from decisions.home import Home
from decisions.roles import RoleChoice, goes_forward
from roles.attacker import Attacker
from roles.supporter import Supporter
from situation import keep_off
from situation.memory import Memory
from situations import put_ball, world
from skills.walk.bird_of_prey import BirdOfPrey
from skills.walk.paw_stuck import PawStuck
from test_roles import A, S, mate

D, FRAME_S = kelpie.DEFENDER, 1.0 / 30.0


def roles(made, frames, choice=None):
    """The role of each third frame."""
    choice, memory, found = choice or RoleChoice(), Memory(), []
    for _ in range(frames):
        made.time_s += FRAME_S
        memory.update(made)
        found.append(choice.update(made, memory))
    return found


# Algorithm 4.6

@both('', [(True, False)])
def test_who_needs_least_attacks_from_the_next_choice_on(book, answer):
    """Player 2 attacks and needs 9 s; this robot stands 20 cm from the ball."""
    made = by(world(180.0, 380.0, ball=(180.0, 400.0)), book)
    made.teammates = [mate(2, A, 9.0, at=(180, 100))]
    choice = RoleChoice()
    choice.role = S
    assert (roles(made, 1, choice)[0] == A) is answer


@both('', [(False, True)])
def test_who_needs_more_gives_the_ball_up_at_once(book, answer):
    """Whether the quicker one attacks yet or not."""
    made = by(world(180.0, 200.0, ball=(180.0, 400.0)), book)
    made.teammates = [mate(2, S, 1.0, at=(180, 380))]
    assert (roles(made, 1)[0] == A) is answer


@both('', [(True, False)])
def test_without_an_attacker_everybody_is_one(book, answer):
    """Also right after another gave the ball up, and by far the slowest."""
    made = by(world(180.0, 200.0, ball=(180.0, 400.0)), book)
    made.teammates = [mate(2, A, 1.0, at=(180, 380))]
    choice = RoleChoice()
    choice.role = S
    roles(made, 3, choice)
    made.teammates[0].note.role = S
    assert (A in roles(made, 6, choice)) is answer


# Section 4.4.2

@both('', [(D, kelpie.SUPPORTER)])
def test_of_two_forwards_the_other_defends_wherever_the_ball_is(book, answer):
    made = by(world(180.0, 200.0, ball=(180.0, 400.0)), book)
    made.teammates = [mate(2, A, 1.0, at=(180, 380))]
    assert roles(made, 1)[0] == answer


def home_race(book, ahead_cm=0.0, was=S, obstacle=None, stuck=False):
    """The role of one that needs as long home as player 4 does, which is `ahead_cm` nearer. The
    defender's home for that ball is (180, 100)."""
    made = by(world(120.0, 220.0, -90.0, (180.0, 220.0)), book)
    made.game.player = 3
    made.teammates = [mate(2, A, 0.5, at=(180, 200)),
                      mate(4, S, 6.0, at=(240.0, 220.0 - ahead_cm), heading=-90.0)]
    if obstacle is not None:
        cell = kelpie.ObstacleCell(own=100.0)
        cell.position.x, cell.position.y = obstacle
        made.obstacles = [cell]
    made.motion.feeling.stuck = stuck
    choice = RoleChoice()
    choice.role = was
    return roles(made, 1, choice)[0]


@both('scene', [
    (dict(ahead_cm=-5.0), D, D), (dict(ahead_cm=5.0), S, S),
    # What stands in the way counts, the own being stuck too; a defender has no bonus.
    (dict(obstacle=(150.0, 160.0)), S, D), (dict(obstacle=(210.0, 160.0), ahead_cm=5.0), D, S),
    (dict(stuck=True), S, D), (dict(was=D, ahead_cm=15.0), S, D)])
def test_the_sooner_home_of_two_defends_by_the_same_time_as_to_the_ball(scene, book, answer):
    assert home_race(book, **scene) == answer


# Section 4.5.2

@both('', [(300.0, 60.0)])
def test_a_place_follows_the_ball_without_a_string(book, answer):
    """Algorithm 4.7: on the other side than the ball, from the first cm beyond the middle."""
    made, home = by(world(), book), Home()
    home.update(made, S, (190.0, 200.0), [])
    assert home.update(made, S, (175.0, 200.0), [])[0] == answer


@both('role, ball, attacker', [
    (S, (300.0, 300.0), (299.0, 240.0), (60.0, 270.0), (60.0, 270.0)),
    (D, (180.0, 240.0), (180.0, 60.0), (180.0, 120.0), None)])
def test_a_place_is_the_trees_whoever_needs_the_way(role, ball, attacker, book, answer):
    """A striker's for a ball at y 300: 300 - 0.65 * 80 = 248, but not behind the middle; a
    defender's 120 cm behind the ball."""
    made = by(world(300.0, 300.0, ball=ball), book)
    made.teammates = [mate(2, A, 2.0, at=attacker)]
    place = Home().update(made, role, ball, keep_off.lanes(made, ball))
    assert place == pytest.approx(answer) if answer else abs(place[0] - 180.0) > 30.0


# Algorithm 4.4

def doing(made, lost=0):
    memory = Memory()
    player = Supporter(memory, S)
    memory.update(made)
    memory.ball_lost += lost
    player.step(made)
    return player.state.__name__


@both('', [('find_ball', 'go_home')])
def test_who_has_lost_the_ball_near_home_looks_for_it_though_a_mate_sees_it(book, answer):
    made = by(world(300.0, 350.0, 90.0, (100.0, 200.0)), book)
    made.teammates = [mate(2, A, 2.0, at=(100.0, 150.0))]
    made.percepts.ball.present = made.ball.present = False
    made.team_ball = kelpie.TeamBall(present=True, position=kelpie.Point2(x=100.0, y=200.0))
    assert doing(made, lost=50) == answer


@pytest.mark.parametrize('at, state', [
    ((300.0, 350.0), 'go_home'), ((110.0, 120.0), 'avoid_attacker'), ((300.0, 100.0),
                                                                      'bird_of_prey')])
def test_the_order_of_algorithm_4_4_is_the_same_in_both_books(at, state):
    for book in ('kelpie', 'thesis'):
        made = by(world(*at, 90.0, (100.0, 200.0)), book)
        made.teammates = [mate(2, A, 2.0, at=(100.0, 50.0))]
        assert doing(made) == state


@both('', [('avoid_ball', 'receive')])
def test_nobody_waits_in_the_way_for_a_pass(book, answer):
    made = by(world(130.0, 300.0, 90.0, (100.0, 200.0)), book)
    made.teammates = [mate(2, A, 2.0, at=(100.0, 175.0))]
    made.teammates[0].note.pass_to = made.game.player = 3
    assert doing(made) == answer


@pytest.mark.parametrize('role', [S, D])
def test_places_by_examples_stay_a_choice_of_the_thesis(role):
    """Section 4.5.3."""
    made = by(world(ball=(90.0, 400.0)), 'thesis')
    trees = Home().update(made, role, (90.0, 400.0), [])
    made.task.positions = kelpie.POSITIONS_BY_REGRESSION
    assert Home().update(made, role, (90.0, 400.0), []) != trees


def test_bird_of_prey_is_the_theses_own_whatever_the_switch():
    made = by(world(180.0, 400.0, -90.0, (30.0, 500.0)), 'thesis')
    made.task.bird_of_prey = False
    made.teammates = [mate(2, A, 2.0, at=(180.0, 250.0))]
    bird = BirdOfPrey()
    bird.step(made, (180.0, 110.0))
    assert bird.bend != 0.0


# Stuck detection, section 4.3.3

def felt(book, paws=(False, False), stuck=False):
    made = by(world(ball=(180.0, 500.0)), book)
    made.last_command.walk.forward = 30.0
    made.motion.feeling.paw_blocked, made.motion.feeling.stuck = list(paws), stuck
    return made


@both('paws, stuck', [
    ((True, True), False, 'back', 'back'), ((True, False), False, 'back_right', 'back_right'),
    ((False, True), False, 'back_left', 'back_left'), ((False, False), True, 'free', 'back')])
def test_paws_alone_make_a_robot_back_off(paws, stuck, book, answer):
    skill = PawStuck()
    assert skill.needed(felt(book, paws, stuck)) is (answer != 'free')
    assert skill.state.__name__ == answer


@both('', [(False, True)])
def test_a_ball_that_comes_no_nearer_is_no_reason_to_back_off(book, answer):
    skill, made = PawStuck(), felt(book)
    put_ball(made, 180.0, 260.0)
    for _ in range(60):
        skill.update(made)
    assert skill.needed(made) is answer


@both('', [('back', 'back_right')])
def test_who_meets_somebody_again_backs_straight_again(book, answer):
    skill, made = PawStuck(), felt(book, (True, True))
    assert skill.needed(made)
    made.time_s = 2.0
    assert skill.needed(made) and skill.state.__name__ == answer


@both('', [(True, False)])
def test_a_paw_is_felt_as_soon_as_it_has_backed(book, answer):
    skill, made = PawStuck(), felt(book, (True, False))
    assert skill.needed(made)
    made.time_s = 0.9
    assert skill.needed(made) is answer


@both('', [('find', 'back_off')])
def test_an_attacker_does_not_back_off(book, answer):
    """Section 4.3.3: a robot that is not the attacker does."""
    made = felt(book, (True, True))
    memory = Memory()
    memory.update(made)
    player = Attacker(memory)
    player.step(made)
    assert (player.state.__name__ == 'back_off') is (answer == 'back_off')


# What is to come, sections 5.2 and 8.2

@both('', [(False, True)])
def test_a_goalie_does_not_mind_the_score(book, answer):
    made = by(world(), book)
    made.task.player, made.task.score_aware = kelpie.GOALIE, True
    made.game.opponent_score = 4
    assert goes_forward(made) is answer
