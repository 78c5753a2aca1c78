# SPDX-License-Identifier: Apache-2.0
# How a held ball is carried: head, jaw and walk that keep it between chin, chest and forelegs
# (docs/physical-body.md, Holding the ball), and what the rules allow meanwhile (3 s, 50 cm). A Hold
# keeps since when and how far the robot has had the ball, by odometry. It fails when the ball slips
# out and nothing is felt of it for a while.
import math

import kelpie

NECK = -52.0  # deg,
NOD = 45.0  # deg
TURN_SPEED = 130.0         # deg/s; 20 of 20 balls were kept at up to 134 (physics.md section 10)
FORWARD_SPEED = 20.0       # cm/s; the dribble walk goes 23
SIDE_SPEED = 14.0  # cm/s
FEEL_S = 0.45              # after the grab until the feeling must say that the ball is there
SLIPPED_FRAMES = 9         # without any feeling of the ball: it is gone


def carry(forward=0.0, left=0.0, turn=0.0) -> kelpie.Command:
    """A Command that holds on to the ball while it walks."""
    walk = kelpie.WalkRequest(forward=forward, left=left, turn_deg=turn, kind=kelpie.WALK_DRIBBLE)
    head = kelpie.HeadRequest(neck_tilt_deg=NECK, head_nod_deg=NOD)
    return kelpie.Command(walk=walk, head=head, mouth_open=True)


class Hold:
    def __init__(self, world, begun_s):
        self.begun_s = begun_s      # when the rules' clock started: as the grab began, or before
        self.since_s = world.time_s
        self.x = self.y = 0.0       # of the robot since then, in its frame of then
        self.turned = 0.0           # deg
        self.unfelt = 0             # frames without any feeling of the ball

    def update(self, world) -> None:
        """Once per frame while the ball is held."""
        step, angle = world.odometry, math.radians(self.turned)
        self.x += step.forward * math.cos(angle) - step.left * math.sin(angle)
        self.y += step.forward * math.sin(angle) + step.left * math.cos(angle)
        self.turned += step.turn_deg
        felt = world.motion.feeling.ball_held or world.time_s - self.since_s < FEEL_S
        self.unfelt = 0 if felt else self.unfelt + 1

    def seconds(self, world) -> float:
        return world.time_s - self.begun_s

    @property
    def way(self) -> float:
        """cm from where the ball was grabbed."""
        return math.hypot(self.x, self.y)

    @property
    def slipped(self) -> bool:
        return self.unfelt > SLIPPED_FRAMES
