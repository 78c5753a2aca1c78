# SPDX-License-Identifier: Apache-2.0
# Running with the ball: where it shall go, and the walk of who runs.
import math

import kelpie
import pytest
from lib import kick_table
from lib.geom import heading
from lib.goalie_places import beyond_box
from lib.paths import point_of
from lib.steer import FULL, any_way
from roles.attacker import Attacker, in_mouth
from situation.about_ball import seen
from situation.memory import Memory
from situation.open_shot import KEEPS, SHOT, open_shot
from situation.run_way import FREED, PRESSED, in_way, leaves, near_ball, pressed, run_way
from situations import opponent, world
from skills.ball.run_ball import BEHIND, ROUND, RunBall, aside, led

FIELD = kelpie.FIELDS['2006']
MIDDLE = 0.5 * FIELD.width


def run(made):
    return RunBall(Memory()).step(made).walk


def presses(made, runs):
    return pressed(FIELD, point_of(made.ball), seen(made), runs)


def test_a_free_ball_goes_straight_to_the_goal():
    assert run_way(FIELD, (MIDDLE, 200.0), []) == pytest.approx(90.0)


@pytest.mark.parametrize('x, side', [(MIDDLE - 10.0, -1.0), (MIDDLE + 10.0, 1.0)])
def test_the_ball_goes_past_an_opponent_on_the_side_that_it_leaves_free(x, side):
    way = run_way(FIELD, (MIDDLE, 200.0), [(x, 260.0)])
    assert side * (way - 90.0) >= 15.0


def test_an_opponent_behind_the_ball_or_far_ahead_is_not_in_the_way():
    near = near_ball([(MIDDLE, 150.0), (MIDDLE, 320.0)], (MIDDLE, 200.0))
    assert len(near) == 1 and in_way(near, 90.0) == 0.0


def test_at_the_side_line_the_ball_is_kept_on_the_field():
    ball = (30.0, 250.0)
    assert leaves(FIELD, ball, 115.0) and not leaves(FIELD, ball, 85.0)
    way = run_way(FIELD, ball, [(60.0, 330.0)])
    assert not leaves(FIELD, ball, way)


def test_near_the_goal_the_side_is_run_at_that_the_goalie_leaves_free():
    ball = (MIDDLE, FIELD.length - 90.0)
    left = run_way(FIELD, ball, [(MIDDLE + 25.0, FIELD.length - 10.0)])
    right = run_way(FIELD, ball, [(MIDDLE - 25.0, FIELD.length - 10.0)])
    assert left > 90.0 > right


def test_beside_the_mouth_a_way_over_the_goal_line_leaves_the_field():
    ball = (MIDDLE, FIELD.length - 60.0)
    assert not leaves(FIELD, ball, 90.0)
    assert leaves(FIELD, ball, 40.0)


def test_a_ball_ahead_on_its_line_is_run_through_at_full_speed():
    asked = run(world(x=MIDDLE, y=200.0, heading=90.0, ball=(MIDDLE, 240.0)))
    assert asked.forward == pytest.approx(FULL, abs=1.0) and asked.kind == kelpie.WALK_FAST
    assert asked.turn_deg == pytest.approx(0.0, abs=1e-6)


def test_a_ball_behind_is_turned_to_before_it_is_run_at():
    asked = run(world(x=MIDDLE, y=200.0, heading=-90.0, ball=(MIDDLE, 330.0)))
    assert math.hypot(asked.forward, asked.left) < 11.0 and abs(asked.turn_deg) > 100.0


def test_who_comes_from_up_field_goes_round_the_ball_and_not_through_it():
    made = world(x=MIDDLE, y=260.0, heading=-90.0, ball=(MIDDLE + 5.0, 230.0))
    skill = RunBall(Memory())
    asked = skill.step(made).walk
    way = math.radians(heading(-asked.left, asked.forward) - made.ball.heading_deg)
    assert skill.branch == 'round'
    assert abs(math.sin(way)) * made.ball.distance == pytest.approx(ROUND, abs=0.5)


@pytest.mark.parametrize('off', (20.0, 60.0, 120.0, 179.0))
def test_both_sides_are_alike(off):
    assert aside(60.0, -off) == -aside(60.0, off)


def test_the_way_leads_no_farther_aside_than_the_tangent_of_the_circle_round_the_ball():
    assert aside(100.0, 179.0) == pytest.approx(math.degrees(math.asin(ROUND / 100.0)))
    assert aside(ROUND, 179.0) == pytest.approx(90.0)
    assert aside(ROUND - 5.0, 179.0) > 90.0


def test_on_its_line_the_ball_is_hit_on_the_side_from_which_it_turns_to_the_line():
    assert 0.0 < aside(60.0, 0.5 * BEHIND) < 0.5 * BEHIND


def test_a_rolling_ball_is_met_where_it_will_be_unless_it_was_not_seen():
    made = world(ball=(180.0, 260.0))
    made.ball.velocity.x = 40.0
    assert led(made.ball) == pytest.approx((190.0, 260.0))
    made.ball.seconds_since_seen = 0.5
    assert led(made.ball) == pytest.approx((180.0, 260.0))


def test_the_legs_strafe_only_slowly():
    asked = any_way(90.0, 0.0, FULL)
    assert asked.left == pytest.approx(35.0) and asked.kind != kelpie.WALK_FAST


def test_the_trace_says_where_the_ball_shall_go():
    skill, trace = RunBall(Memory()), []
    skill.step(world(x=MIDDLE, y=200.0, heading=90.0, ball=(MIDDLE, 240.0)))
    skill.explain(trace)
    assert trace[0][1:3] == ('run_ball', 'push') and trace[0][4] == pytest.approx(90.0)


def shooter(y, offs=0.0):
    return world(x=MIDDLE, y=y, heading=90.0 + offs, ball=(MIDDLE, y + 40.0))


def test_from_near_a_free_ball_ahead_is_shot_at_an_open_goal():
    kick, chance = open_shot(shooter(FIELD.length - 130.0), [])
    assert kelpie.KICKS[kick].leaf == 'kick_ahead' and SHOT < chance <= 1.0


def test_one_at_the_side_is_swiped_in():
    made = world(x=110.0, y=FIELD.length - 90.0, heading=90.0, ball=(110.0, FIELD.length - 60.0))
    kick, _ = open_shot(made, seen(made))
    assert kick in kick_table.LEFT_OF    # to the right


@pytest.mark.parametrize('made', [
    shooter(200.0), world(x=MIDDLE, y=300.0, heading=90.0, ball=(MIDDLE, FIELD.length - 80.0))],
    ids=['a goal far away', 'a ball far away'])
def test_from_far_nothing_is_shot(made):
    assert open_shot(made, seen(made)) is None


@pytest.mark.parametrize('x, y', [(MIDDLE + 5.0, -60.0), (MIDDLE + 30.0, -90.0)])
def test_at_a_goalie_or_with_somebody_at_the_ball_it_is_run_on(x, y):
    made = shooter(FIELD.length - 130.0)
    made.opponents = [opponent(x, FIELD.length + y)]
    assert open_shot(made, seen(made)) is None


def test_a_goalie_in_the_corner_leaves_enough():
    made = shooter(FIELD.length - 130.0)
    made.opponents = [opponent(MIDDLE + 60.0, FIELD.length - 10.0)]
    assert open_shot(made, seen(made)) is not None


def test_the_kick_that_is_played_goes_on_with_less():
    made = shooter(FIELD.length - 130.0)
    kick, chance = open_shot(made, seen(made))
    assert open_shot(made, seen(made), kick)[1] == pytest.approx(chance + KEEPS)


@pytest.mark.parametrize('away, leaf', [(80.0, 'run'), (150.0, 'grab_dribble_goal')])
def test_the_attacker_runs_when_it_is_pressed_and_else_plays_by_map_and_tree(away, leaf):
    made = shooter(200.0)
    made.task.run = True
    made.opponents = [opponent(MIDDLE + away, 240.0)]
    assert attacker(made).leaf == leaf


def test_pressed_it_kicks_where_a_shot_is_open():
    made = shooter(FIELD.length - 130.0)
    made.task.run = True
    made.opponents = [opponent(MIDDLE + 80.0, FIELD.length - 90.0)]
    assert attacker(made).leaf == 'kick_ahead'


def attacker(made):
    memory = Memory()
    memory.update(made)
    player = Attacker(memory)
    player.step(made)
    return player


def test_who_runs_goes_on_until_the_ball_is_free_by_some_more():
    made = shooter(200.0)
    made.opponents = [opponent(MIDDLE + PRESSED + 0.5 * FREED, 240.0)]
    assert presses(made, True) and not presses(made, False)
    made.opponents = [opponent(MIDDLE + PRESSED - 5.0, 240.0, 2.5)]
    assert not presses(made, True)


@pytest.mark.parametrize('pressed_by, lost, state', [(80.0, 25, 'play'), (80.0, 35, 'find'),
                                                     (200.0, 25, 'find')])
def test_who_runs_with_the_ball_looks_for_it_later(pressed_by, lost, state):
    made = shooter(200.0)
    made.task.run = True
    made.opponents = [opponent(MIDDLE + pressed_by, 240.0)]
    player = attacker(made)
    player.memory.ball_lost = lost
    player.step(made)
    assert player.playing == state


@pytest.mark.parametrize('away, near', [(60.0, False), (40.0, True)])
def test_a_goalie_in_its_box_presses_from_near_by_only(away, near):
    made = shooter(FIELD.length - 150.0)
    made.opponents = [opponent(MIDDLE, FIELD.length - 110.0 + away)]
    assert made.opponents[0].position.y > FIELD.length - FIELD.box_depth or near
    assert presses(made, False) is near


def at_mouth(x, y, from_x, from_y):
    made = world(x=from_x, y=from_y, heading=90.0, ball=(x, y))
    made.task.run = True
    return made


@pytest.mark.parametrize('from_x, leaf', [(MIDDLE, 'dribble'), (MIDDLE - 70.0, 'run')])
def test_a_ball_in_the_mouth_is_pushed_in_and_from_aside_gone_round_first(from_x, leaf):
    made = at_mouth(MIDDLE + 10.0, FIELD.length - 12.0, from_x, FIELD.length - 45.0)
    assert attacker(made).leaf == leaf


@pytest.mark.parametrize('x, y', [(0.5 * FIELD.goal_width + 2.0, -10.0), (0.0, -30.0)])
def test_beside_the_mouth_or_farther_out_it_is_not(x, y):
    assert in_mouth(FIELD, (MIDDLE, FIELD.length - 10.0))
    assert not in_mouth(FIELD, (MIDDLE + x, FIELD.length + y))
