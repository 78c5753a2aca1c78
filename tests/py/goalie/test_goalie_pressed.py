# SPDX-License-Identifier: Apache-2.0
import cmath
import math

import kelpie
import pytest
from goalie_world import blind_after, reported, scene
from players.goalie import Goalie
from situation.opponents import has_ball
from skills.motion.kick import Kick


def opponent(x, y, seen=0.0):
    return kelpie.OpponentEstimate(position=kelpie.Point2(x=x, y=y), seconds_since_seen=seen)


@pytest.mark.parametrize('ahead, left, stands', [(18, 0, True), (18, 10, True), (-8, 10, True),
                                                 (30, 0, False), (8, 20, False)])
def test_a_goalie_holds_position_at_a_ball_that_an_opponent_presses(ahead, left, stands):
    """Past who walks or turns it slips; into the way of one that is beside it, it goes."""
    at, facing = 166 + 30j, cmath.rect(1.0, math.radians(75.0))
    ball = at + (ahead + 1j * left) * facing
    scenery, player = scene(ball, at=at, facing=facing), Goalie()
    scenery.world.opponents = [opponent(ball.real, ball.imag + 10.0)]
    for _ in range(4):
        scenery.see()
        walk = player.step(scenery.world).walk
    assert player.state == player.guard
    assert (walk.forward == walk.left == walk.turn_deg == 0.0) == stands
    scenery.see()
    scenery.world.ball.seconds_since_seen = 0.8
    for place, goes in ((ball, not stands), (240 + 40j, True)):
        reported(scenery.world, place, 0.1)
        walk = player.step(scenery.world).walk
        assert (walk.left < -5.0 or walk.forward != 0.0 or walk.left > 5.0) == goes


def pressed(away=15.0, believed=188 + 21j):
    """A goalie's scene, and what it does in the next frame: mates see the ball at its flank, an
    opponent stands so far from it. `believed`: where the goalie saw it last, or None."""
    ball = 188 + 21j
    scenery, player = scene(ball, at=180 + 25j), Goalie()
    player.now.moved_s = -10.0

    def stands():
        world = scenery.world
        scenery.see()
        world.ball.present, world.ball.seconds_since_seen = believed is not None, 0.5
        if believed is not None:
            world.ball.position.x, world.ball.position.y = believed.real, believed.imag
        reported(world, ball, 0.01)
        world.opponents = [opponent(ball.real, ball.imag + away)]
        walk = player.step(world).walk
        return walk.forward == walk.left == walk.turn_deg == 0.0

    return scenery, player, stands


@pytest.mark.parametrize('away, believed, holds', [
    (15.0, 188 + 21j, True), (40.0, 188 + 21j, False), (15.0, 240 + 60j, True), (15.0, None, True)])
def test_a_goalie_holds_position_at_a_ball_that_its_mates_see_at_its_flank(away, believed, holds):
    _, player, stands = pressed(away, believed)
    for _ in range(5):
        still = stands()
    assert player.state == player.guard and player.now.reported is not None
    assert still == holds


def test_a_goalie_holds_position_for_four_seconds_and_after_a_kick_for_four_more():
    """It kicked at a ball pressed for 4 s, then its legs pushed it in (balls put before the goals,
    81 s)."""
    scenery, player, stands = pressed()
    frames = [stands() for _ in range(130)]
    assert all(frames[:118]) and not any(frames[122:])
    player.enter(scenery.world, player.clear, Kick(scenery.world))
    player.skill.start_s, player.expected = -10.0, (188.0, 21.0)
    assert all(stands() for _ in range(80))


@pytest.mark.parametrize('away, seen, turns', [(40, 0.5, False), (40, 1.5, True), (60, 0.0, True)])
def test_a_blind_goalie_does_not_turn_to_search_with_an_opponent_at_hand(away, seen, turns):
    """It swept in a ball that an attacker had pushed to its flank (seed 151001, 450 s)."""
    scenery = scene(180 + 60j, at=180 + 20j)
    scenery.world.opponents = [opponent(180, 20 + away, seen)]
    assert (blind_after(scenery, Goalie(), False, 0.5) != (0.0, 0.0, 0.0)) == turns


@pytest.mark.parametrize('away, seconds, turns', [(40, 12, False), (40, 17, True), (60, 9, True)])
def test_with_an_opponent_at_hand_a_goalie_waits_longer_for_a_landmark(away, seconds, turns):
    """It turned well round and took the ball at its feet along (seed 151001, 376 s)."""
    scenery, player = scene(180 + 60j, at=180 + 20j), Goalie()
    scenery.world.opponents = [opponent(180, 20 + away)]
    states = []
    for _ in range(30 * seconds):
        scenery.see()
        player.step(scenery.world)
        states.append(player.state)
    assert (player.turn in states) == turns


def test_nobody_has_a_ball_that_is_not_there():
    world = scene().world
    world.opponents = [opponent(10.0, 10.0)]
    world.ball.position.x = world.ball.position.y = 0.0
    for present in (True, False):
        world.ball.present = present
        assert has_ball(world) == present
