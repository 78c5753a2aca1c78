# SPDX-License-Identifier: Apache-2.0
# The numbers of the behaviours that one would tune, by who uses them. In cm, degrees and seconds.


class Field:
    WIDTH = 360.0
    LENGTH = 540.0


class Search:
    BACK_OFF_NEAR = 35.0     # a ball lost nearer than this is at the feet: step back first
    BACK_OFF_SPEED = -12.0
    BACK_OFF_TIME = 1.2
    SCAN_TIME = 2.0          # with the head only; then turn on the spot
    TURN_SPEED = 50.0
    TURN_TIME = 7.5          # once round
    ROAM_SPEED = 22.0
    ROAM_TIME = 9.0
    ROAM_NEAR = 30.0


class Approach:
    SLOW_DOWN = 45.0         # distance from which the speed falls
    SPEED = 34.0
    LEAST_SPEED = 10.0
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
    KICK_NEAR = 6.0          # chest against the ball
    KICK_FAR = 9.6           # 190 ms pass until the push begins: 1.5 cm at LEAST_SPEED
    KICK_SIDE = 2.5          # the chest is flat, the paws are 18 cm apart
    KICK_AIM = 14.0          # deg between the robot's and the goal's direction
    FORWARD_GAIN = 1.5
    FORWARD_SPEED = 26.0
    GONE = 45.0              # the ball has rolled away: walk to it again
    LEAST_SPEED = 8.0
    SIDE_GAIN = 1.5
    SIDE_SPEED = 7.0
    SIDE_FIRST = 3.0         # the ball farther aside: do not go closer than STAND_OFF
    STAND_OFF = 13.0
    TURN_GAIN = 1.2
    TURN_SPEED = 30.0
    LOST_AIM = 28.0          # line up again
    LOST_SIDE = 9.0
    UNSEEN = 1.5             # the chin hides a near ball; odometry carries it that long
    TIME = 8.0


class Kick:
    START_TIME = 1.5         # for the motion to begin
    TIME = 5.0


class Watch:
    FRESH = 0.4              # an estimate that old is still looked at
    SCAN_PAN = 75.0
    SCAN_PERIOD = 2.4        # of one sweep there and back
    SCAN_LOW = -32.0         # pitch of the view, sweeps alternate between the two
    SCAN_HIGH = -12.0
    SPIN_PAN = 15.0          # a small sweep, ahead of the turn, while turning on the spot
    GLANCE_EVERY = 2.5
    GLANCE_TIME = 0.7
    GLANCE_FAR = 55.0        # only while the ball is farther than this
    GLANCE_PITCH = -6.0
    GLANCE_PAN = 60.0        # aside, when nobody knows where the goal is
    BALL_HEIGHT = 5.0


class Goal:
    FRESH = 6.0              # seconds for which a seen goal is carried along by odometry
    POSE_HEADING_SD = 20.0   # poses worse than this say nothing about the goal
    POSE_FRESH = 15.0        # nor those without a landmark for so long
    SWEEP = 2.6              # look for it that long before playing without


class Stuck:
    STEP_BACK = 1.0          # after a skill ran out of time
    SPEED = -12.0
