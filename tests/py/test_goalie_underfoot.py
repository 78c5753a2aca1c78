# SPDX-License-Identifier: Apache-2.0
"""A ball between the goalie's paws, where it sees none: by the rules it holds it."""
import kelpie
import pytest
from goalie_world import scene, told
from lib.tune_goalie import Guard, Paws
from lib.underfoot import Underfoot
from players.goalie import Goalie

FRAME_S = 1.0 / 30.0
CARPET, BALL = 14.5, 10.5   # cm, what the infrared of the chest reads


def believes(place, unseen=1.0):
    """A goalie's scene; it sees no ball, and its mates none either."""
    scenery = scene(place, at=180 + 26j)
    scenery.world.ball.seconds_since_seen = unseen
    scenery.world.sensors.chest_distance = CARPET
    return scenery


@pytest.mark.parametrize('chest, there', [
    (Paws.TOO_NEAR - 0.1, True), (Paws.TOO_NEAR + 0.1, False), (Paws.TOO_FAR - 0.1, False),
    (Paws.TOO_FAR + 0.1, True), (Paws.NOTHING + 1.0, False)])
def test_the_infrared_tells_a_ball_from_the_carpet(chest, there):
    scenery = believes(180 + 150j)
    scenery.world.sensors.chest_distance = chest
    assert Underfoot().there(scenery.world, None) is there


@pytest.mark.parametrize('ball, there', [
    (180 + 34j, True), (180 + 41j, False), (188 + 34j, False), (180 + 22j, False)])
def test_own_belief_and_mates_tell_it_too(ball, there):
    assert Underfoot().there(believes(ball).world, None) is there
    assert Underfoot().there(believes(ball, Paws.SEEN + 0.1).world, None) is False
    assert Underfoot().there(believes(180 + 150j).world, (ball.real, ball.imag)) is there


def stood(gap_s):
    """Seconds that a ball counts as there which is felt for 1 s but for a gap in the middle."""
    scenery, under = believes(180 + 150j), Underfoot()
    for frame in range(31):
        scenery.world.time_s = frame * FRAME_S
        away = abs(scenery.world.time_s - 0.5) < 0.5 * gap_s
        scenery.world.sensors.chest_distance = CARPET if away else BALL
        under.update(scenery.world, None)
    return under.seconds(scenery.world)


def test_short_gaps_in_what_is_felt_do_not_end_it():
    assert stood(Paws.GAP - 0.1) == pytest.approx(1.0)
    assert stood(Paws.GAP + 0.1) < 0.6


def walks_of(player, scenery, seconds):
    walks = []
    for _ in range(round(seconds / FRAME_S)):
        scenery.world.time_s += FRAME_S
        walks.append((player.state.__name__, player.command(scenery.world).walk))
    return walks


def test_it_steps_back_from_it_in_time_even_with_an_opponent_at_hand():
    scenery, player = believes(180 + 34j), Goalie()
    scenery.world.sensors.chest_distance = BALL
    scenery.world.opponents = [kelpie.OpponentEstimate(position=kelpie.Point2(x=180.0, y=45.0))]
    back = [walk.forward < -20.0 and walk.left == 0.0 and walk.turn_deg == 0.0
            for _, walk in walks_of(player, scenery, 2.5)]
    assert not any(back[:round(Paws.LONGEST / FRAME_S) - 1])
    assert 10 <= sum(back) <= 14   # one step


@pytest.mark.parametrize('y', [3.0, 12.0, 26.0, 50.0])
def test_but_not_over_its_goal_line(y):
    scenery, player = believes(complex(180, y + 8.0)), Goalie()
    scenery.at = complex(180, y)
    scenery.see()
    scenery.world.sensors.chest_distance = BALL
    world, at = scenery.world, y
    for _ in range(120):
        world.time_s += FRAME_S
        walk = player.command(world).walk
        world.odometry.forward = walk.forward * FRAME_S if player.state == player.step_back else 0.0
        at += world.odometry.forward
        world.pose.position.y = at
    assert 0.0 <= at < y


def test_a_ball_at_its_feet_that_is_felt_elsewhere_moves_nobody():
    scenery, player = believes(180 + 150j, Guard.LOST), Goalie()
    assert all(state != 'step_back' for state, _ in walks_of(player, scenery, 4.0))
