# SPDX-License-Identifier: Apache-2.0
# The numbers of the behaviours that one would tune, by who uses them. In cm, degrees and seconds,
# speeds in cm/s and deg/s, gains in those per cm or degree. Tuned in the simulator, where no source
# is given.


class Approach:
    SLOW_DOWN = 45.0         # distance from which the speed falls
    SPEED = 34.0
    MIN_SPEED = 10.0
    TURN_GAIN = 1.8          # deg/s per deg
    TURN_SPEED = 70.0
    TURN_FIRST = 50.0        # a ball farther aside: turn on the spot
    NEAR = 28.0              # distance at which lining up begins
    BEHIND = 22.0            # aim at this far behind the ball, seen from the goal
    TIME = 25.0


class LineUp:
    RADIUS = 20.0            # distance kept while circling the ball
    SIDE_SPEED = 15.0
    SIDE_GAIN = 0.4          # cm/s per deg
    FORWARD_GAIN = 1.2       # cm/s per cm
    FORWARD_SPEED = 10.0
    TURN_GAIN = 2.0
    TURN_SPEED = 70.0
    AIMED = 10.0             # deg between ball and goal direction
    FACED = 15.0             # deg between body and ball
    LEFT_BEHIND = 38.0       # a ball farther than this has to be walked to again
    TIME = 15.0


class Strike:
    # The ball's place in the robot frame from which the kick hits it.
    KICK_AHEAD = 14.0        # actuator/data/motions/kick_forward.toml
    KICK_NEAR = 12.4
    KICK_FAR = 15.4          # 190 ms pass until the kick begins: 1.5 cm at MIN_SPEED
    KICK_SIDE = 1.8
    KICK_AIM = 14.0          # deg between the robot's and the goal's direction
    FORWARD_GAIN = 1.5
    FORWARD_SPEED = 26.0
    GONE = 45.0              # the ball has rolled away: walk to it again
    MIN_SPEED = 8.0
    SIDE_GAIN = 1.5
    SIDE_SPEED = 7.0
    SIDE_FIRST = 3.0         # the ball farther aside: do not go closer than STAND_OFF
    STAND_OFF = 18.0
    TURN_GAIN = 1.2
    TURN_SPEED = 30.0
    LOST_AIM = 28.0          # line up again
    LOST_SIDE = 9.0
    UNSEEN = 1.5             # the chin hides a near ball; odometry carries it that long
    TIME = 8.0


class Kick:
    START_TIME = 1.5         # for the motion to begin
    TIME = 5.0
    LOOK_DOWN = 20.0         # pitch of the view below the horizontal while kicking
    LOOK_AHEAD = 12.0        # and after it


class Watch:
    FRESH = 0.4              # an estimate that old is still looked at
    SCAN_PAN = 75.0
    SCAN_PERIOD = 2.4        # one sweep there and back
    SCAN_LOW = -32.0         # pitch of the view, sweeps alternate between the two
    SCAN_HIGH = -12.0
    GLANCE_EVERY = 2.5
    GLANCE_TIME = 0.7
    # Only while the ball is farther than this: around it, too. Blind until the kick, 6 s, the
    # robot lost its heading: 1.31 deg on the mean of 16 matches, 1.20 with these glances.
    GLANCE_FAR = 16.0
    GLANCE_PITCH = -6.0
    GLANCE_PAN = 60.0        # aside, when nobody knows where the goal is
    BALL_HEIGHT = 5.0


class Goal:
    FRESH = 6.0              # seconds for which a seen goal is carried along by odometry
    POSE_HEADING_SD = 20.0   # poses worse than this say nothing about the goal
    POSE_FRESH = 15.0        # neither do those without a landmark for so long
    SWEEP = 2.6              # look for it that long before playing without
    REGAIN = 1.0             # then look for the ball again that long


class Look:
    PAN = 86.0
    PAN_SPEED = 75.0         # deg/s; line points need less than 156
    DOWN = (4.0, 18.0)       # deg of the view below the horizon, in turn
    SETTLE = 0.35            # s until the head has come to a row's beginning
    TURN = 115.0             # deg of the body between two rounds
    TURN_SPEED = 60.0


class Features:
    """What the challenger's head looks at, of the field's features (lib/features.py)."""
    REACH = 80.0             # to either side
    NEAREST, FARTHEST = 15.0, 200.0
    CHOICE = 3               # so many of the best are looked at in turn
    TIME = 1.0               # a look; thesis 2004 section 4.1.6 has 1.3 s
    WALL_PAN = 40.0


class Challenge:
    STAND_OFF_CENTRE = 65.0  # the map is made from here, behind and beyond the middle
    STAND_NEAR = 12.0
    STAND_TIME = 12.0        # s; then map from where it is
    MAP_ROUNDS = 3
    MIN_STAGE = 10.0         # s; play halted earlier is the start
    SURE_SD = 15.0           # cm
    SURE_HEADING_SD = 6.0    # deg
    SURE_WEIGHT = 0.6        # weight of the best mode
    LOST_SD = 40.0           # cm
    NEAR = 3.0               # cm from a point that count as there
    SETTLE = 0.8             # s that it stands before it announces the point
    ANNOUNCE_TIME = 0.8
    SPEED = 32.0
    SLOW = 7.0
    SLOW_DOWN = 1.3          # cm/s per cm
    FACE_FIRST = 6.0         # deg; turning on the spot ends
    FACE_AGAIN = 22.0        # deg; turning on the spot begins again
    FACE_NEAR = 170.0        # deg cm: 3 cm aside
    STEP_BACK = 15.0         # a point nearer than this and behind is backed to
    TURN_GAIN = 2.0
    TURN_SPEED = 80.0
