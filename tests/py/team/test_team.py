# SPDX-License-Identifier: Apache-2.0
"""Three forwards that play together on the plane: who attacks, who stays out of the way, and how
they get to their places before a kick-off."""
import math

import kelpie
import pytest
from lib import kick_off_places
from team_world import BODY, TeamWorld


@pytest.mark.parametrize('task', [{}, dict(positions=kelpie.POSITIONS_BY_REGRESSION),
                                  dict(passing=True)], ids=['tree', 'regression', 'passing'])
def test_there_is_exactly_one_attacker_in_95_of_100_frames(task):
    team, roles, switches = TeamWorld(1, **task), [], 0
    for frame in range(900):
        if frame % 300 == 299:
            team.ball = team.somewhere()
        now = [command.team.role for command in team.step()]
        if frame > 15:
            switches += sum(one != two for one, two in zip(now, roles[-1])) if roles else 0
            roles.append(now)
    assert sum(now.count(kelpie.ATTACKER) == 1 for now in roles) > 0.95 * len(roles)
    assert max(now.count(kelpie.DEFENDER) for now in roles) <= 2
    assert switches < 30
    assert team.touched_by_others <= 2 and team.nearest > 0.5 * BODY


def test_three_whose_ways_cross_are_at_their_places_within_45_s():
    places = [(60.0, 480.0, -90.0), (285.0, 120.0, 90.0), (100.0, 110.0, 0.0)]
    team = TeamWorld(2, places, kelpie.READY)
    team.ball = (180.0, 270.0)
    for _ in range(round(30 * kelpie.Rules().ready_time)):
        commands = team.step()
        if all(command.trace[1][2] == 'stand' for command in commands):
            break
    field = team.worlds[0].field
    for made in team.worlds:
        x, y = kick_off_places.forward(field, made.game.player, True, False)
        place = made.pose.position
        assert math.hypot(place.x - x, place.y - y) < 12.0
    assert team.nearest > BODY


def test_a_ball_that_one_sees_is_played_by_one_who_did_not():
    """The others look away from it; whoever sees it is far."""
    team = TeamWorld(3, [(180.0, 330.0, -90.0), (60.0, 100.0, -90.0), (300.0, 60.0, 90.0)])
    team.ball = (180.0, 420.0)
    for made in team.worlds:
        made.ball.present = made.percepts.ball.present = False
        made.ball.seconds_since_seen = 1000.0
        made.ball.position = kelpie.Point2(x=180.0, y=20.0)
    start = team.ball
    for _ in range(450):
        team.step()
        if team.ball != start:
            break
    assert team.ball != start


def test_a_mate_that_falls_silent_is_replaced():
    team = TeamWorld(4, [(180.0, 250.0, 90.0), (100.0, 150.0, 90.0), (260.0, 100.0, 90.0)])
    team.ball = (180.0, 300.0)
    for _ in range(60):
        commands = team.step()
    silent = [command.team.role for command in commands].index(kelpie.ATTACKER)
    del team.worlds[silent], team.players[silent]
    team.said = [said for number, said in enumerate(team.said) if number != silent]
    for _ in range(45):
        commands = team.step()
    assert [command.team.role for command in commands].count(kelpie.ATTACKER) == 1
