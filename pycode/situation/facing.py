# SPDX-License-Identifier: Apache-2.0
# Whether a goalie faces the wrong way (thesis 2006 section 4.3.1): one that was pushed round may
# believe that it faces up-field. So besides the pose it goes by the own goal, seen ahead; by
# landmarks, of which it sees none for long; and by a pose far off the box, which it does not leave.
# Keeps how often the own goal was seen, the last landmark, and the turn that is to end it. In a
# long scrum it sees no landmark either, and is then called wrong for nothing.
import math

from lib import rulebook
from lib.geom import wrap
from lib.goalie_places import UP_FIELD, beyond_box
from lib.landmarks import GOALS
from lib.paths import point_of
from situation import opponents
from situation.memory import target_goal

WRONG = 120.0            # deg from up-field
RIGHT = 50.0             # deg; up to here a turn goes on
OWN_GOAL = 35.0          # deg; the own goal seen that near to straight ahead ...
OWN_FRAMES = 5           # ... so often says that the pose is wrong
AGAINST_POSE = 270.0     # deg of a turn while the pose says that all is well
NOTHING = 8.0            # s without a landmark; a scrum in which none was seen for 15 s pushed the
                         # goalie round, and a pose sure to 7 cm was 200 cm off
NOTHING_CROWDED = 16.0   # s, with an opponent at hand: of 13 turns after 8 s none was of a pose
                         # that was wrong, and one took the ball at its feet in
OFF_BOX = 50.0           # cm
OFF_TIME = 2.0           # s; jumps of the pose that end by themselves are shorter
TIME = 5.0               # s of turning, and then of not turning


def own_goal_ahead(world) -> bool:
    target = target_goal(world)
    return any(mark.kind in GOALS and mark.kind != target and
               abs(mark.heading_deg) < OWN_GOAL for mark in world.percepts.landmarks)


def off_box(world) -> float:
    """cm from the pose to the goal box."""
    return beyond_box(world.field, point_of(world.pose))


class Facing:
    def __init__(self):
        self.wrong = None       # (why, number) if the goalie faces the wrong way in this frame
        self.up_deg = 0.0      # deg from the robot's heading to up-field, as the pose says
        self.own_goal = 0       # frames that saw it ahead, less those that did not
        self.landmark_s = None  # when a landmark was last seen
        self.near_box_s = None  # when the pose was last near the box
        self.was_home = False   # in the box, since the last turn
        self.side = 0.0         # of the turn, +1 left; 0 while there is none
        self.left_deg = 0.0     # of a turn against the pose, by odometry
        self.began_s = self.rest_s = -math.inf

    def update(self, world) -> None:
        """To be called in every frame."""
        self.left_deg -= abs(world.odometry.turn_deg)
        self.up_deg = wrap(UP_FIELD - world.pose.heading_deg)
        step = 1 if own_goal_ahead(world) else -1
        self.own_goal = max(0, min(2 * OWN_FRAMES, self.own_goal + step))
        if self.landmark_s is None or world.percepts.landmarks:
            self.landmark_s = world.time_s
        away = off_box(world)
        self.was_home = self.was_home or away == 0.0
        if away < OFF_BOX or self.near_box_s is None:
            self.near_box_s = world.time_s
        if self.side != 0.0 and world.time_s - self.began_s > TIME:
            self.rest_s = world.time_s + TIME  # somebody holds the robot, or it is lost
        self.wrong = self.why_wrong(world) if world.time_s >= self.rest_s else None

    def why_wrong(self, world) -> tuple | None:
        if self.side != 0.0:    # the turn goes on until all is well
            going = abs(self.up_deg) > RIGHT or self.own_goal > 0 or self.left_deg > 0.0
            return ('turning on, up-field is {} deg to the left', self.up_deg) if going else None
        if abs(self.up_deg) > WRONG:
            return 'up-field is {} deg to the left', self.up_deg
        return self.pose_is_wrong(world)

    def pose_is_wrong(self, world) -> tuple | None:
        """What speaks against a pose that says that all is well."""
        if self.own_goal >= OWN_FRAMES:
            return 'the own goal is ahead, seen {} times', self.own_goal
        unseen = world.time_s - self.landmark_s
        ours = rulebook.of(world).WATCHES_POSE
        if unseen > NOTHING and unseen > (
                NOTHING_CROWDED if ours and opponents.at_hand(world) else NOTHING):
            return 'no landmark for {} s', unseen
        if ours and self.was_home and world.time_s - self.near_box_s > OFF_TIME:
            return 'the pose is {} cm off the box', off_box(world)
        return None

    def begin_turn(self, world) -> None:
        """Against a pose that says that all is well, the turn goes well round: on the way the
        landmarks put the pose right, or else it would turn back."""
        self.side = self.shorter_side()
        self.left_deg = AGAINST_POSE if self.pose_is_wrong(world) is not None else 0.0
        self.began_s = self.landmark_s = world.time_s
        self.was_home = False

    def turn_on(self) -> float:
        """The side of the turn in this frame: well round, if it has to; then the shorter way."""
        if self.left_deg <= 0.0:
            self.side = self.shorter_side()
        return self.side

    def shorter_side(self) -> float:
        return 1.0 if self.up_deg >= 0.0 else -1.0

    def end_turn(self) -> None:
        self.side = 0.0
        self.own_goal = 0
