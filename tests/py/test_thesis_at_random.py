# SPDX-License-Identifier: Apache-2.0
"""No world stops a player of the theses' rules, and what it answers may always be done."""
import kelpie
import pytest
from players.challenger import Challenger
from players.ellipse_goalie import EllipseGoalie
from players.forward import Forward
from players.goalie import Goalie
from random_world import RandomWorld, check


@pytest.mark.parametrize('make, home', [(Forward, False), (Goalie, True), (EllipseGoalie, True),
                                        (Challenger, False)])
def test_every_answer_of_a_player_of_the_theses_may_be_done(make, home):
    for seed in range(6):
        made, player = RandomWorld(seed, home, rules=kelpie.RULES_OF_THESIS), make()
        command = kelpie.Command()
        for _ in range(500):
            made.next(command)
            command = player.step(made.world)
            check(command)
