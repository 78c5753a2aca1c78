# SPDX-License-Identifier: Apache-2.0
# Behaviours for `kelpie calibrate infrared`: stands on bare carpet as with a ball in its hold, then
# looks down at the carpet from near to far, each pose for 2 s, and begins again.
import kelpie

HOLD = 2.0  # s, of a pose
# Neck tilt and nod, deg, and whether the mouth is open. The first is that of a held ball.
POSES = [(-52.0, 45.0, True), (-30.0, 0.0, False), (-20.0, 0.0, False), (-15.0, 0.0, False),
         (-10.0, 0.0, False)]


def decide(world):
    neck, nod, mouth_open = POSES[int(world.time_s / HOLD) % len(POSES)]
    return kelpie.Command(walk=kelpie.WalkRequest(kind=kelpie.WALK_DRIBBLE), mouth_open=mouth_open,
                          head=kelpie.HeadRequest(neck_tilt_deg=neck, head_nod_deg=nod))
