# SPDX-License-Identifier: Apache-2.0
# Behaviours of `kelpie evaluate stationary-views`: stands and looks from side to side, four seconds
# there and back, once lower and once higher.
import math

import kelpie

PAN = 70.0           # deg to either side
PERIOD = 4.0         # s
DOWN = (12.0, 26.0)  # deg below the horizontal: 110 and 45 cm ahead


def decide(world):
    turn = 2.0 * math.pi * world.time_s / PERIOD
    down = DOWN[int(world.time_s / PERIOD) % 2]
    pitch = world.stance.body_tilt_deg - down
    nod = max(-5.0, pitch) if pitch < 0.0 else pitch
    head = kelpie.HeadRequest(neck_tilt_deg=min(0.0, pitch - nod), head_nod_deg=nod,
                              head_pan_deg=PAN * math.sin(turn))
    return kelpie.Command(head=head)
