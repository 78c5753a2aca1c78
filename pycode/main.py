# SPDX-License-Identifier: Apache-2.0
# Where the host starts: decide(world) -> Command, once per camera frame. What a robot remembers
# lives in the one player made here; an edited file makes a new one.
from players.striker import Striker

decide = Striker().tick
