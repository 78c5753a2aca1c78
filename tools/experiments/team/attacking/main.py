# SPDX-License-Identifier: Apache-2.0
# A mate of `kelpie evaluate bird-of-prey`: stands before the ball and tells its team that it
# attacks, so that the other one defends. Its head moves, for landmarks, but never off the ball: an
# attacker that does not see it is relieved.
import math

import kelpie

PAN = 22.0           # deg to either side
PERIOD = 3.0         # s
DOWN = (20.0, 10.0)  # deg below the horizontal, in turn; the ball is 45 cm ahead


def decide(world):
    turn = 2.0 * math.pi * world.time_s / PERIOD
    pitch = world.stance.body_tilt_deg - DOWN[int(world.time_s / PERIOD) % 2]
    nod = max(-5.0, pitch) if pitch < 0.0 else pitch
    head = kelpie.HeadRequest(neck_tilt_deg=min(0.0, pitch - nod), head_nod_deg=nod,
                              head_pan_deg=PAN * math.sin(turn))
    note = kelpie.TeamNote(role=kelpie.ATTACKER, time_to_ball=0.0)
    return kelpie.Command(head=head, team=note)
