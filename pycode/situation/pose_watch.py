# SPDX-License-Identifier: Apache-2.0
# Whether the pose has jumped, and the world as odometry says it is then. A goalie that stands in
# its box, sure of its pose to a centimetre, cannot be 190 cm off in the next frame; but the
# localiser believes that, for 0.2 to 2 s, when somebody hides half of the only beacon in view, or
# after a block: 1.5 % of a goalie's frames. Keeps the pose carried by odometry and since when the
# other one is doubted. A jump that lasts is believed in the end, right or wrong. Says also when the
# pose is lost: who was pushed about beside a ball went astray by 130 cm and stayed sure to 5 cm,
# before the filter felt the pushes.
import math

from lib.geom import wrap

JUMP_CM = 35.0     # cm in a frame that are a jump,
JUMP_DEG = 35.0    # deg
BACK_CM = 20.0     # cm; so near to the carried pose it is right again
BACK_DEG = 20.0    # deg
SURE_CM = 8.0      # cm of sd; from a pose less sure than that a jump may be the truth
SURE_DEG = 6.0     # deg of sd
LONGEST = 2.5                    # s
SETTLES = 0.7                    # s
BLIND = 2.0                      # s without a landmark; where the pose is sure,
BLIND_SURE = 5.0                 # since of 8430 such frames of goalies 94 were 20 cm off
LIKELY = 0.6                     # weight of a mode that needs no second opinion


class PoseWatch:
    def __init__(self):
        self.carried = None     # x, y, heading in deg
        self.sure = False       # of the pose before the jump
        self.gave_in = False    # in this frame, to a jump that lasted
        self.ended_s = -math.inf  # the last doubt
        self.since_s = None     # when the doubt began; None without one
        self.landmark_s = None  # when a landmark was last seen

    def update(self, world):
        """To be called in every frame."""
        if self.carried is None:
            self.carried = pose_of(world)
        if self.landmark_s is None or world.percepts.landmarks:
            self.landmark_s = world.time_s
        self.carried = moved(self.carried, world.odometry)
        away, turned = apart(self.carried, pose_of(world))
        if self.since_s is None and self.sure and (away > JUMP_CM or turned > JUMP_DEG):
            self.since_s = world.time_s
        self.gave_in = False
        right = away < BACK_CM and turned < BACK_DEG
        if self.since_s is not None and (right or world.time_s - self.since_s > LONGEST):
            self.since_s, self.gave_in = None, not right
            self.ended_s = world.time_s
        if self.since_s is None:
            self.carried = pose_of(world)
            self.sure = is_sure(world)

    @property
    def doubtful(self) -> bool:
        return self.since_s is not None

    def lost(self, world) -> bool:
        """Whether to look at landmarks before anything else that depends on the pose."""
        maximum = BLIND_SURE if is_sure(world) else BLIND
        return world.time_s - self.landmark_s > maximum or torn(world)

    def settled(self, world) -> bool:
        """Whether the pose is good enough to walk by: one jump is often followed by others."""
        return not self.doubtful and world.time_s - self.ended_s > SETTLES

    def believed(self, world):
        """The world, or in doubt the one of the carried pose."""
        return CarriedWorld(world, self.carried) if self.doubtful else world


class Place:
    def __init__(self, x, y):
        self.x, self.y = x, y


class CarriedPose:
    def __init__(self, x, y, heading_deg):
        self.position, self.heading_deg = Place(x, y), heading_deg


class CarriedBall:
    """A ball of one pose's field as that of another."""

    def __init__(self, ball, was, pose):
        self.ball = ball
        angle = math.radians(pose[2] - was[2])
        cos, sin = math.cos(angle), math.sin(angle)

        def turned(x, y, at):
            return Place(at[0] + x * cos - y * sin, at[1] + x * sin + y * cos)
        self.position = turned(ball.position.x - was[0], ball.position.y - was[1], pose)
        self.stopping_point = turned(ball.stopping_point.x - was[0],
                                     ball.stopping_point.y - was[1], pose)
        self.velocity = turned(ball.velocity.x, ball.velocity.y, (0.0, 0.0))

    def __getattr__(self, name):
        return getattr(self.ball, name)


class CarriedWorld:
    """A world whose pose and ball are those of the carried pose, and all else as it is."""

    def __init__(self, world, pose):
        self.world = world
        self.pose = CarriedPose(*pose)
        self.ball = CarriedBall(world.ball, pose_of(world), pose)

    def __getattr__(self, name):
        return getattr(self.world, name)


def is_sure(world, position_sd=SURE_CM, heading_sd_deg=SURE_DEG) -> bool:
    """Whether both standard deviations of the pose are below these."""
    return world.position_sd < position_sd and world.heading_sd_deg < heading_sd_deg


def torn(world) -> bool:
    """Whether two modes that are far from each other are both likely."""
    if len(world.modes) < 2 or world.modes[0].weight > LIKELY:
        return False
    away, turned = apart(pose_of(world.modes[0]), pose_of(world.modes[1]))
    return away > BACK_CM or turned > BACK_DEG


def pose_of(world) -> tuple[float, float, float]:
    """The pose of a world, or of a mode."""
    pose = world.pose
    return pose.position.x, pose.position.y, pose.heading_deg


def moved(pose, odometry) -> tuple[float, float, float]:
    """A pose after one frame's odometry, the step taken along half the turn."""
    angle = math.radians(pose[2] + 0.5 * odometry.turn_deg)
    forward, left = odometry.forward, odometry.left
    return (pose[0] + forward * math.cos(angle) - left * math.sin(angle),
            pose[1] + forward * math.sin(angle) + left * math.cos(angle),
            pose[2] + odometry.turn_deg)


def apart(a, b) -> tuple[float, float]:
    """How far two poses are from each other, cm and deg."""
    return math.hypot(a[0] - b[0], a[1] - b[1]), abs(wrap(a[2] - b[2]))
