# SPDX-License-Identifier: Apache-2.0
"""Which team has the ball, who says so, and what the defender does when it is theirs."""
import math

import kelpie
import pytest
from players.forward import Forward
from players.goalie import Goalie
from roles.supporter import Supporter
from situation.memory import Memory
from situation.possession import BESIDE, CHANGES_S, HAS, RUNS, Possession, who_has
from situations import opponent, put_ball, world
from skills.ball.challenge import (FROM, LEAST, LEFT, Challenge, course, meeting, off_course,
                                   within_reach)
from test_by_the_play import D, by_play
from test_roles import A, S, mate

BALL = 180.0, 260.0
LOOSE, OURS, THEIRS = kelpie.LOOSE, kelpie.OURS, kelpie.THEIRS


def above(cm):
    return [(BALL[0], BALL[1] + cm)]


def below(cm):
    return [(BALL[0], BALL[1] - cm)]


@pytest.mark.parametrize('speed_up, ours, theirs, has', [
    (0.0, [], [], LOOSE), (0.0, below(20.0), [], OURS), (0.0, [], above(20.0), THEIRS),
    (0.0, below(HAS + 1.0), above(HAS + 1.0), LOOSE), (0.0, below(20.0), above(25.0), OURS),
    (0.0, below(25.0), above(20.0), THEIRS), (RUNS + 1.0, below(25.0), above(20.0), THEIRS),
    (-RUNS - 1.0, below(20.0), above(BESIDE - 1.0), THEIRS),
    (-RUNS - 1.0, below(20.0), above(BESIDE + 1.0), OURS),
    (-RUNS + 1.0, below(20.0), above(BESIDE - 1.0), OURS)])
def test_who_is_nearest_has_it_but_for_a_ball_that_they_run_at_the_own_goal_with(speed_up, ours,
                                                                                  theirs, has):
    assert who_has(BALL, speed_up, ours, theirs) == has


def judging(made, frames=1, before=None):
    """Frames from an odd one on: in even ones nothing is judged."""
    possession = before or Possession(Memory())
    possession.memory.ball_lost = 0
    for _ in range(frames):
        made.frame += 1
        made.time_s += 1.0 / 30.0
        possession.update(made)
    return possession


def theirs_seen(**robot):
    made = by_play(world(**robot))
    made.frame = 0
    made.opponents = [opponent(BALL[0], BALL[1] + 15.0)]
    return made


def test_the_own_judgement_changes_after_a_while_and_says_since_when():
    made = theirs_seen()
    possession = judging(made, 3)
    assert possession.now == possession.own == LOOSE
    judging(made, math.ceil(CHANGES_S * 30.0) + 2, possession)
    assert possession.now == possession.own == THEIRS
    since = possession.since_s
    judging(made, 30, possession)
    assert possession.since_s == since > 0.0


def test_one_odd_frame_changes_nothing():
    made = theirs_seen()
    possession = judging(made, 20)
    made.opponents = []
    judging(made, 2, possession)
    made.opponents = [opponent(BALL[0], BALL[1] + 15.0)]
    judging(made, 20, possession)
    assert possession.own == THEIRS


def says(player, what, at, saw_s=0.1, heard_s=0.1):
    one = mate(player, A, 2.0, at=at)
    one.note.possession, one.seconds_since_ball, one.seconds_since_heard = what, saw_s, heard_s
    return one


@pytest.mark.parametrize('mates, player, has', [
    ([], 1, LOOSE), ([says(2, THEIRS, (180.0, 240.0))], 2, THEIRS),
    ([says(2, THEIRS, (180.0, 100.0))], 1, LOOSE),
    ([says(2, THEIRS, (180.0, 240.0), saw_s=0.6)], 1, LOOSE),
    ([says(2, THEIRS, (180.0, 240.0), heard_s=2.0)], 1, LOOSE),
    ([says(2, OURS, (180.0, 230.0)), says(3, THEIRS, (180.0, 240.0))], 3, THEIRS)])
def test_the_word_of_who_is_nearest_to_the_ball_and_sees_it_counts(mates, player, has):
    made = by_play(world())
    made.game.player, made.frame, made.teammates = 1, 0, mates
    possession = judging(made)
    assert (possession.player, possession.now) == (player, has)
    assert possession.own == LOOSE


def test_who_has_lost_the_ball_goes_by_its_mates():
    made = by_play(world())
    made.game.player, made.frame = 1, 0
    put_ball(made, *BALL, seen=False)
    made.teammates = [says(2, THEIRS, (180.0, 100.0))]
    assert judging(made).player == 2


# The defender

def runs_at(made, vx=0.0, vy=-30.0):
    made.ball.velocity.x, made.ball.velocity.y = vx, vy
    return made


def test_a_rolling_ball_goes_where_it_rolls_and_a_slow_one_to_the_own_goal():
    made = runs_at(world(), 30.0, -30.0)
    assert course(made, BALL) == pytest.approx((math.sqrt(0.5), -math.sqrt(0.5)))
    for vx, vy in ((0.0, -10.0), (30.0, 30.0)):
        assert course(runs_at(made, vx, vy), (180.0, 260.0)) == pytest.approx((0.0, -1.0))


def test_it_steps_into_the_way_where_the_ball_will_be_when_it_is_there():
    here = (220.0, 160.0)
    assert off_course(BALL, (0.0, -1.0), here) == pytest.approx((100.0, 40.0))
    assert meeting(BALL, (0.0, -1.0), here) == pytest.approx((180.0, 230.0))
    assert meeting(BALL, (0.0, -1.0), (180.0, 160.0)) == pytest.approx((180.0, 260.0 - LEAST))


@pytest.mark.parametrize('here, reaches, goes_on', [
    ((180.0, 260.0 - FROM + 1.0), True, True), ((180.0, 260.0 - FROM - 1.0), False, True),
    ((180.0, 260.0 - LEFT - 1.0), False, False), ((180.0, 300.0), False, False),
    ((310.0, 170.0), False, False), ((250.0, 170.0), True, True)])
def test_it_reaches_the_way_of_a_ball_that_comes_and_is_not_past(here, reaches, goes_on):
    made = runs_at(world(*here))
    assert (within_reach(made), within_reach(made, challenges=True)) == (reaches, goes_on)


def test_without_a_ball_nobody_is_challenged():
    made = runs_at(world(180.0, 160.0))
    made.ball.present = False
    assert not within_reach(made)


def test_it_walks_into_the_way_and_from_near_runs_through_the_ball():
    made, skill = runs_at(by_play(world(240.0, 140.0, heading=120.0))), Challenge(Memory())
    walk = skill.step(made).walk
    assert skill.branch == 'steps_in' and walk.forward > 30.0 and walk.kind == kelpie.WALK_FAST
    made = runs_at(by_play(world(180.0, 220.0, heading=90.0)))
    assert skill.step(made).walk.forward > 30.0 and skill.branch == 'runs_through'


@pytest.mark.parametrize('role, possession, plays, state', [
    (D, THEIRS, True, 'challenge'), (D, LOOSE, True, 'run_along'), (D, OURS, True, 'run_along'),
    (S, THEIRS, True, 'run_along'), (D, THEIRS, False, 'go_home')])
def test_the_defender_takes_the_ball_when_it_is_theirs(role, possession, plays, state):
    made, memory = runs_at(world(200.0, 140.0)), Memory()
    if plays:
        by_play(made)
    memory.update(made)
    has = Possession(memory)
    has.now = possession
    player = Supporter(memory, role, has)
    player.step(made)
    assert player.playing == state


@pytest.mark.parametrize('player', [Forward, Goalie])
@pytest.mark.parametrize('plays, told', [(True, THEIRS), (False, LOOSE)])
def test_every_player_tells_the_team_and_its_trace_says_so(player, plays, told):
    made = theirs_seen(y=240.0) if plays else world(y=240.0)
    made.opponents = [opponent(BALL[0], BALL[1] + 5.0)]
    made.game.state, made.game.player, made.frame = kelpie.PLAYING, 2, 0
    made.teammates = [mate(3, S, 5.0, at=(100.0, 400.0))]
    one = player()
    for _ in range(16):
        made.frame += 1
        made.time_s += 1.0 / 30.0
        command = one.step(made)
    assert command.team.possession == told
    said = [step for step in command.trace if step[1] == 'possession']
    assert [step[2] for step in said] == (['theirs'] if plays else [])
