# SPDX-License-Identifier: Apache-2.0
"""A ball between the goalie's paws, where it sees none: by the rules it holds it."""
import cmath
import math

import kelpie
import pytest
from decisions.goalie_rules import BETWEEN_PAWS
from goalie_world import scene
from players.goalie import Goalie
from situation import ball_at_body as at_body
from situation.ball_at_body import BallBetweenPaws
from skills.walk.step_back import StepBack

FRAME_S = 1.0 / 30.0
CARPET, BALL = 14.5, 10.5   # cm, what the infrared of the chest reads


def believes(place, unseen=1.0):
    """A goalie's scene; it sees no ball, and its mates none either."""
    scenery = scene(place, at=180 + 26j)
    scenery.world.ball.seconds_since_seen = unseen
    scenery.world.sensors.chest_distance = CARPET
    return scenery


def feels(place):
    """The same, and its chest tells of a ball between the paws."""
    scenery = believes(place)
    scenery.world.sensors.chest_distance = BALL
    return scenery


@pytest.mark.parametrize('chest, there', [
    (at_body.CHEST_NEAR - 0.1, True), (at_body.CHEST_NEAR + 0.1, False),
    (at_body.CHEST_FAR - 0.1, False),
    (at_body.CHEST_FAR + 0.1, True), (at_body.NOTHING + 1.0, False)])
def test_the_infrared_tells_a_ball_from_the_carpet(chest, there):
    scenery = believes(180 + 150j)
    scenery.world.sensors.chest_distance = chest
    assert BallBetweenPaws().there(scenery.world, None) is there


@pytest.mark.parametrize('ball, there', [
    (180 + 34j, True), (180 + 41j, False), (188 + 34j, False), (180 + 22j, False)])
def test_own_belief_and_mates_tell_it_too(ball, there):
    assert BallBetweenPaws().there(believes(ball).world, None) is there
    assert BallBetweenPaws().there(believes(ball, at_body.SEEN + 0.1).world, None) is False
    assert BallBetweenPaws().there(believes(180 + 150j).world, (ball.real, ball.imag)) is there


def stood(gap_s):
    """Seconds that a ball counts as there which is felt for 1 s but for a gap in the middle."""
    scenery, under = believes(180 + 150j), BallBetweenPaws()
    for frame in range(31):
        scenery.world.time_s = frame * FRAME_S
        away = abs(scenery.world.time_s - 0.5) < 0.5 * gap_s
        scenery.world.sensors.chest_distance = CARPET if away else BALL
        under.update(scenery.world, None)
    return under.for_s


def test_short_gaps_in_what_is_felt_do_not_end_it():
    assert stood(at_body.GAP - 0.1) == pytest.approx(1.0)
    assert stood(at_body.GAP + 0.1) < 0.6


def walks_of(player, scenery, seconds):
    walks = []
    for _ in range(round(seconds / FRAME_S)):
        scenery.world.time_s += FRAME_S
        walks.append((player.state.__name__, player.step(scenery.world).walk))
    return walks


def test_it_steps_back_from_it_in_time_even_with_an_opponent_at_hand():
    scenery, player = feels(180 + 34j), Goalie()
    scenery.world.opponents = [kelpie.OpponentEstimate(position=kelpie.Point2(x=180.0, y=45.0))]
    back = [walk.forward < -20.0 and walk.left == 0.0 and walk.turn_deg == 0.0
            for _, walk in walks_of(player, scenery, 2.5)]
    assert not any(back[:round(BETWEEN_PAWS / FRAME_S) - 1])
    assert 10 <= sum(back) <= 14   # one step


@pytest.mark.parametrize('y', [3.0, 12.0, 26.0, 50.0])
def test_but_not_over_its_goal_line(y):
    scenery, player = feels(complex(180, y + 8.0)), Goalie()
    scenery.at = complex(180, y)
    scenery.see()
    world, at = scenery.world, y
    for _ in range(120):
        world.time_s += FRAME_S
        walk = player.step(world).walk
        world.odometry.forward = walk.forward * FRAME_S if player.state == player.step_back else 0.0
        at += world.odometry.forward
        world.pose.position.y = at
    assert 0.0 <= at < y


@pytest.mark.parametrize('at, degrees', [(180 + 3j, 45.0), (118 + 20j, 20.0), (100 + 26j, 90.0),
                                         (180 - 5j, 90.0), (180 - 15j, 60.0), (180 + 30j, 110.0)])
def test_the_step_is_straight_back_or_none_wherever_it_believes_to_stand(at, degrees):
    """Sideways or ahead it would take the ball along."""
    scenery, player = believes(180 + 150j), Goalie()
    scenery.at, scenery.facing = at, cmath.rect(1.0, math.radians(degrees))
    scenery.see()
    player.enter(scenery.world, player.step_back, StepBack(scenery.world))
    walk = player.step(scenery.world).walk
    assert walk.forward <= 0.0 and walk.left == walk.turn_deg == 0.0


def test_what_the_chest_reads_of_the_carpet_in_a_block_does_not_count():
    scenery, player = feels(180 + 150j), Goalie()
    scenery.world.motion.running = kelpie.BLOCK
    walks_of(player, scenery, 1.5)
    scenery.world.motion.running = kelpie.NO_MOTION
    scenery.world.sensors.chest_distance = CARPET
    assert all(state != 'step_back' for state, _ in walks_of(player, scenery, 1.0))


def test_nor_does_a_belief_of_before_a_kick():
    scenery, under = believes(180 + 34j, 0.0), BallBetweenPaws()
    under.update(scenery.world, None)
    for running in [kelpie.UPENN_LEFT] * 20 + [kelpie.NO_MOTION] * 60:
        scenery.world.time_s += FRAME_S
        scenery.world.ball.seconds_since_seen += FRAME_S
        scenery.world.motion.running = running
        under.update(scenery.world, None)
        assert under.for_s == 0.0


def test_what_the_chest_read_before_play_does_not_count():
    scenery, player = feels(180 + 150j), Goalie()
    scenery.world.game.state = kelpie.SET
    walks_of(player, scenery, 2.0)
    scenery.world.game.state = kelpie.PLAYING
    states = [state for state, _ in walks_of(player, scenery, BETWEEN_PAWS)]
    assert 'step_back' not in states
