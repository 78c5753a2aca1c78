# SPDX-License-Identifier: Apache-2.0
# Behaviours for `kelpie calibrate body`: stands and looks round in stops of 0.3 s, from side to
# side and back, each way at other places and heights and with the neck bent otherwise.
import math

import kelpie

STOP = 0.3   # s
STOPS = 11   # of a way from side to side
STEP = 17.5  # deg of pan
# Of each way: its first pan, neck tilt and how far the camera looks below the horizontal, deg.
WAYS = [(-92.0, 0.0, 2.0), (-84.0, -18.0, 10.0), (-88.0, -8.0, 16.0), (-90.0, -26.0, 5.0),
        (-86.0, -4.0, 0.0), (-89.0, -14.0, 6.0)]


def decide(world):
    way, place = divmod(int(world.time_s / STOP), STOPS)
    first, neck, down = WAYS[way % len(WAYS)]
    pan = first + STEP * (place if way % 2 == 0 else STOPS - 1 - place)
    lean = world.stance.body_tilt_deg - neck  # of the pan's axis, forward
    nod = lean * math.cos(math.radians(pan)) - down
    return kelpie.Command(head=kelpie.HeadRequest(neck_tilt_deg=neck, head_pan_deg=pan,
                                                  head_nod_deg=nod))
