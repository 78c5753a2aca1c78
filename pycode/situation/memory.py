# SPDX-License-Identifier: Apache-2.0
# What one player remembers of the frames before, for all of its skills: since when ball and goals
# are unseen, whose feet were seen, spins, what the infrared reads, and what skills said (hints,
# last close ball). Counted in camera frames, as the theses do; a dropped image does not count.
# update() comes first in every frame. Everything else is a skill's own. What is not update()'s is
# written by one named method, and that is called by one module (WRITERS, held by
# tests/py/test_structure.py).
import math

import kelpie
from lib import rulebook
from lib.geom import to_field

# Who calls which method, and with it is the writer of what that changes.
WRITERS = {'spun': 'skills/ball/spin_for_ball', 'saw_close': 'skills/head/track_ball',
           'looked_for_landmarks': 'skills/head/active_localise', 'approached': 'roles/attacker',
           'grabbed': 'roles/attacker', 'set_hint': 'roles/attacker'}

NEVER = 10000           # frames
NEAR = 40.0             # cm to the ball
IR_RANGE = 50.0         # cm that the near sensor of the head reads at most
IR_SHARE = 0.3          # of a new reading in the filter
OWN_GOAL_KEPT = 15      # frames for which an own goal that was seen is carried along by the turn
OWN_GOAL_SPARED = 15.0  # deg beside its posts: kicks of the map go 7 to 10 deg off their way
FEET_KEPT = 45          # frames: a head that looks down at the ball sees nobody meanwhile
FEET_FROM, FEET_TO = 14.0, 150.0    # cm: nearer are the own feet, farther a pixel is 10 cm and more
BIG_TURN_DEG = 40.0     # deg/s asked for; thesis 2006 Alg 6.3 counts frames since a large turn


class Memory:
    def __init__(self, ball_lost=NEVER):
        self.frame = 0              # camera frames since the start
        self.ball_lost = ball_lost  # frames since vision saw the ball
        self.ball_run = 0           # frames in which it saw it without a break
        self.goal_lost = NEVER      # frames since the opponents' goal was seen
        self.own_goal_lost = NEVER
        self.own_goal = 0.0, 0.0    # deg, its posts as seen last: left, right
        self.goal_heading = 0.0     # deg, of the opponents' goal when it was seen last
        self.spin_side = 0.0        # of the last spin: +1 left, -1 right, 0 none yet
        self.spin_lost = NEVER      # frames since a spin for the ball
        self.spin_run = 0           # frames of this spin so far
        self.turn_lost = NEVER      # frames since a large turn was asked for
        self.ir = IR_RANGE          # cm, low-passed near distance of the head
        self.chest = IR_RANGE       # cm, low-passed distance of the chest: the carpet before it
        self.close_lost = NEVER     # frames since the ball was close (find_ball)
        self.approach_lost = NEVER  # frames since a grab was approached,
        self.approach_near_lost = NEVER  # and since that was near the ball
        self.near = False           # the ball is near in this frame
        self.grab_lost = NEVER      # frames since a grab was begun or the ball held
        self.localised_lost = NEVER  # frames since the head last looked for landmarks
        self.marks = {}             # of each kind of landmark: the frame in which it was seen last
        self.feet = []              # (x, y, frame) on the field: whose images showed, oldest first
        self.hint = None            # (distance cm, heading deg, frame): where to look for the ball

    def update(self, world) -> None:
        self.frame += 1
        self.spin_lost += 1
        self.turn_lost += 1
        self.close_lost += 1
        self.approach_lost += 1
        self.approach_near_lost += 1
        self.near = world.ball.present and world.ball.distance < NEAR
        self.grab_lost += 1
        self.localised_lost += 1
        self._see(world)
        if rulebook.runs(world):    # nobody else asks for them
            self._see_feet(world)
        self.chest += IR_SHARE * (world.sensors.chest_distance - self.chest)
        self.ir += IR_SHARE * (world.sensors.head_near_distance - self.ir)
        if abs(world.last_command.walk.turn_deg) > BIG_TURN_DEG:
            self.turn_lost = 0
        if self.spin_lost > 1:
            self.spin_run = 0

    def _see(self, world):
        seen = world.percepts.ball.present
        self.ball_lost = 0 if seen else self.ball_lost + 1
        self.ball_run = self.ball_run + 1 if seen else 0
        self.goal_lost += 1
        self.own_goal_lost += 1
        turn = world.odometry.turn_deg
        self.own_goal = self.own_goal[0] - turn, self.own_goal[1] - turn
        target = target_goal(world)
        for mark in world.percepts.landmarks:
            self.marks[mark.kind] = self.frame
            if mark.kind == target:
                self.goal_lost, self.goal_heading = 0, mark.heading_deg
            elif mark.kind in (kelpie.GOAL_BLUE, kelpie.GOAL_YELLOW):
                self.own_goal_lost = 0
                self.own_goal = (max(mark.left_edge_deg, mark.heading_deg),
                                 min(mark.right_edge_deg, mark.heading_deg))

    def _see_feet(self, world):
        while self.feet and self.feet[0][2] <= self.frame - FEET_KEPT:
            del self.feet[0]
        for foot in world.percepts.obstacles:
            x, y = foot.position.x, foot.position.y
            if FEET_FROM < math.hypot(x, y) < FEET_TO:
                self.feet.append((*to_field(world.pose, x, y), self.frame))

    def spun(self, side) -> None:
        """A skill turns on the spot for the ball in this frame: +1 to the left."""
        self.spin_side, self.spin_lost = side, 0
        self.spin_run += 1

    def saw_close(self) -> None:
        """The head is on a ball that vision sees close."""
        self.close_lost = 0

    def looked_for_landmarks(self) -> None:
        self.localised_lost = 0

    def approached(self) -> None:
        """A grab is approached in this frame."""
        self.approach_lost = 0
        if self.near:
            self.approach_near_lost = 0

    def grabbed(self) -> None:
        """A grab runs or the ball is held in this frame."""
        self.grab_lost = 0

    def set_hint(self, distance, heading_deg) -> None:
        """Where a skill thinks that the ball will come out (thesis 2006 table 6.1)."""
        self.hint = (distance, heading_deg, self.frame)


def own_goal_at(memory, direction) -> bool:
    """Whether a ball that goes so many deg to the left goes at the own goal, by sight, whatever the
    pose says."""
    left, right = memory.own_goal
    return (memory.own_goal_lost < OWN_GOAL_KEPT and
            right - OWN_GOAL_SPARED < direction < left + OWN_GOAL_SPARED)


def target_goal(world) -> int:
    """The opponents' goal; red defends the yellow one."""
    return kelpie.GOAL_BLUE if world.game.team == kelpie.RED else kelpie.GOAL_YELLOW
