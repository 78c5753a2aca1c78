# SPDX-License-Identifier: Apache-2.0
# Whether the goalie faces the wrong way, and the turn on the spot that ends it (thesis 2006 section
# 4.3.1): a goalie that was pushed round may believe that it faces up-field. So besides the pose it
# goes by the own goal, seen ahead; by landmarks, of which it sees none for long; and by a pose far
# off the box, which it does not leave. Keeps how often the own goal was seen, the last landmark and
# the turn. In a long scrum it sees no landmark either, and then turns for nothing.
import math

import kelpie
from arbiter.skill import Skill
from lib.geom import wrap
from lib.goalie_places import UP_FIELD, beyond_box
from lib.head import view
from lib.landmarks import GOALS
from lib.tune_goalie import Facing, Guard
from lib.ways import point_of
from situation.memory import target_goal
from situation.obstacles import opponent_within


def own_goal_ahead(world) -> bool:
    target = target_goal(world)
    return any(mark.kind in GOALS and mark.kind != target and
               abs(mark.heading_deg) < Facing.OWN_GOAL for mark in world.percepts.landmarks)


def off_box(world) -> float:
    """cm from the pose to the goal box."""
    return beyond_box(world.field, (world.pose.position.x, world.pose.position.y))


def crowded(world) -> bool:
    """Whether an opponent is at hand: the ball is likely between the two."""
    return opponent_within(world, point_of(world.pose), Guard.CROWDED, Guard.CROWDED_SEEN)


class FaceUpField(Skill):
    NAME = 'face_up_field'

    def __init__(self):
        self.own_goal = 0       # frames that saw it ahead, less those that did not
        self.landmark_s = None  # when a landmark was last seen
        self.near_box_s = None  # when the pose was last near the box
        self.was_home = False   # in the box, since the last turn
        self.side = 0.0         # of the turn; 0 while there is none
        self.left_deg = 0.0     # of a turn against the pose, by odometry
        self.began_s = self.rest_s = -math.inf

    def update(self, world):
        """To be called in every frame."""
        self.left_deg -= abs(world.odometry.turn_deg)
        step = 1 if own_goal_ahead(world) else -1
        self.own_goal = max(0, min(2 * Facing.OWN_FRAMES, self.own_goal + step))
        if self.landmark_s is None or world.percepts.landmarks:
            self.landmark_s = world.time_s
        away = off_box(world)
        self.was_home = self.was_home or away == 0.0
        if away < Facing.OFF_BOX or self.near_box_s is None:
            self.near_box_s = world.time_s

    def aside(self, world) -> float:
        """Degrees from the robot's heading to up-field, as the pose says."""
        return wrap(UP_FIELD - world.pose.heading_deg)

    def wrong(self, world) -> tuple | None:
        """Why the goalie faces the wrong way, with a number; None if it does not."""
        if self.side != 0.0 and world.time_s - self.began_s > Facing.TIME:
            self.rest_s = world.time_s + Facing.TIME  # somebody holds the robot, or it is lost
        if world.time_s < self.rest_s:
            return None
        aside = self.aside(world)
        if self.side != 0.0:    # the turn goes on until all is well
            going = abs(aside) > Facing.RIGHT or self.own_goal > 0 or self.left_deg > 0.0
            return ('turning on, up-field is {} deg to the left', aside) if going else None
        if abs(aside) > Facing.WRONG:
            return 'up-field is {} deg to the left', aside
        return self.pose_is_wrong(world)

    def pose_is_wrong(self, world):
        """What speaks against a pose that says that all is well."""
        if self.own_goal >= Facing.OWN_FRAMES:
            return 'the own goal is ahead, seen {} times', self.own_goal
        unseen = world.time_s - self.landmark_s
        if unseen > (Facing.NOTHING_CROWDED if crowded(world) else Facing.NOTHING):
            return 'no landmark for {} s', unseen
        if self.was_home and world.time_s - self.near_box_s > Facing.OFF_TIME:
            return 'the pose is {} cm off the box', off_box(world)
        return None

    def begin(self, world):
        """Against a pose that says that all is well, the turn goes well round: on the way the
        landmarks put the pose right, or else it would turn back."""
        aside = self.aside(world)
        self.side = 1.0 if aside >= 0.0 else -1.0
        self.left_deg = Facing.AGAINST_POSE if self.pose_is_wrong(world) is not None else 0.0
        self.began_s = self.landmark_s = world.time_s
        self.was_home = False

    def end(self):
        self.side = 0.0
        self.own_goal = 0

    def step(self, world) -> kelpie.Command:
        """Well round, if it has to; then the shorter way to up-field. The head looks ahead of the
        turn, at the height of landmarks."""
        if self.left_deg <= 0.0:
            self.side = 1.0 if self.aside(world) >= 0.0 else -1.0
        return kelpie.Command(walk=kelpie.WalkRequest(turn_deg=self.side * Facing.TURN),
                              head=view(self.side * Facing.PAN, Facing.DOWN, world.stance))

    def explain(self, trace) -> None:
        branch = 'left' if self.side > 0.0 else 'right'
        trace.append((kelpie.LAYER_SKILL, self.NAME, branch,
                      'the own goal was seen ahead {} times', self.own_goal))
