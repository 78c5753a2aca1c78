# SPDX-License-Identifier: Apache-2.0
# Where the host starts: decide(world) -> Command, once per camera frame. What a robot remembers
# lives in the player made here; an edited file makes a new one.
import kelpie
from players.challenger import Challenger
from players.striker import Striker

players = {kelpie.FORWARD: Striker(), kelpie.CHALLENGER: Challenger()}


def decide(world) -> kelpie.Command:
    return players[world.task.player].command(world)
