# SPDX-License-Identifier: Apache-2.0
# Whether the goalie faces the wrong way, and the turn on the spot that ends it (thesis 2006 section
# 4.3.1): a goalie that was pushed round may believe that it faces up-field. So besides the pose it
# goes by the own goal, seen ahead, and by seeing neither ball nor landmark. Keeps how often the own
# goal was seen, since when nothing was, and the side of the turn. A goalie with its head in a scrum
# may see nothing, too, and then turns for nothing.
import kelpie
from lib.geom import wrap
from lib.goalie_places import UP_FIELD
from lib.landmarks import GOALS
from lib.memory import target_goal
from lib.tune_goalie import Facing


def own_goal_ahead(world) -> bool:
    target = target_goal(world)
    return any(mark.kind in GOALS and mark.kind != target and
               abs(mark.heading_deg) < Facing.OWN_GOAL for mark in world.percepts.landmarks)


class FaceUpField:
    NAME = 'face_up_field'

    def __init__(self):
        self.own_goal = 0       # frames that saw it ahead, less those that did not
        self.something_s = None  # when ball or landmark was last seen
        self.side = 0.0         # of the turn; 0 while there is none
        self.left_deg = 0.0     # of a turn against the pose, by odometry
        self.began_s = self.rest_s = 0.0

    def update(self, world):
        """To be called in every frame."""
        step = 1 if own_goal_ahead(world) else -1
        self.left_deg -= abs(world.odometry.turn_deg)
        self.own_goal = max(0, min(2 * Facing.OWN_FRAMES, self.own_goal + step))
        if (self.something_s is None or world.percepts.landmarks or world.percepts.ball.present or
                world.motion.running != kelpie.NO_MOTION):
            self.something_s = world.time_s

    def aside(self, world) -> float:
        """Degrees from the robot's heading to up-field, as the pose says."""
        return wrap(UP_FIELD - world.pose.heading_deg)

    def wrong(self, world) -> tuple | None:
        """Why the goalie faces the wrong way, with a number; None if it does not."""
        aside = self.aside(world)
        if self.side != 0.0 and world.time_s - self.began_s > Facing.TIME:
            self.rest_s = world.time_s + Facing.TIME  # somebody holds the robot, or it is lost
        if world.time_s < self.rest_s:
            return None
        if self.side != 0.0:    # the turn goes on until all is well
            going = abs(aside) > Facing.RIGHT or self.own_goal > 0 or self.left_deg > 0.0
            return ('turning on, up-field is {} deg to the left', aside) if going else None
        if abs(aside) > Facing.WRONG:
            return 'up-field is {} deg to the left', aside
        if self.own_goal >= Facing.OWN_FRAMES:
            return 'the own goal is ahead, seen {} times', self.own_goal
        unseen = world.time_s - self.something_s
        if unseen > Facing.NOTHING:
            return 'neither ball nor landmark for {} s', unseen
        return None

    def begin(self, world):
        """Against a pose that says that all is well, the turn goes well round: on the way the
        landmarks put the pose right, or else it would turn back."""
        aside = self.aside(world)
        self.side = 1.0 if aside >= 0.0 else -1.0
        self.left_deg = Facing.AGAINST_POSE if abs(aside) <= Facing.WRONG else 0.0
        self.began_s = self.something_s = world.time_s

    def end(self):
        self.side = 0.0
        self.own_goal = 0

    def walk(self, world) -> kelpie.WalkRequest:
        return kelpie.WalkRequest(turn_deg=self.side * Facing.TURN)

    def explain(self, trace) -> None:
        branch = 'left' if self.side > 0.0 else 'right'
        trace.append((kelpie.LAYER_SKILL, self.NAME, branch,
                      'the own goal was seen ahead {} times', self.own_goal))
