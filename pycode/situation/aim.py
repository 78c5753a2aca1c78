# SPDX-License-Identifier: Apache-2.0
# Where to shoot: the goal's free gaps as vision sees them (thesis 2006 section 6.4.2), one of them
# locked until the shot, carried along by odometry while it is out of sight; else the mouth as the
# pose has it, by the theses' rules in the own half alone. Keeps the locked side, the gap's
# headings, since when it was not seen, and how many frames were aimed. By the pose alone it is as
# wrong as the pose.
import kelpie
from lib import rulebook
from lib.geom import from_field, heading, wrap
from situation.goal import sure
from situation.memory import target_goal

PADDING = 0.25         # of the gap's width, to each side of its middle (U06)
MIN_PADDING = 2.5      # deg: narrower cannot be turned to
MAX_PADDING = 8.0      # deg: a near goal is wide, but its middle is safest
AIMED_FRAMES = 4       # accumulated, Alg 6.6 (G44)
CARRIED_FRAMES = 15    # for which a gap that is out of sight is still aimed at
LEFT = 'left'
RIGHT = 'right'


def gaps_of(world) -> tuple:
    """((left, right) of the left gap or None, of the right gap or None), in deg of the robot frame.
    A goal that is free from post to post has a right gap alone."""
    target = target_goal(world)
    seen = sorted(((gap.left_deg, gap.right_deg) for gap in world.percepts.gaps
                   if gap.goal == target), key=sum, reverse=True)
    if not seen:
        return None, None
    return (seen[0] if len(seen) > 1 else None), seen[-1]


def size(gap) -> float:
    return abs(gap[0] - gap[1])


def best_side(left, right):
    """Alg 6.5 without its lock: the one that is there, else the wider one, ties to the right."""
    if left is None or right is None:
        return RIGHT if left is None else LEFT
    return LEFT if size(left) > size(right) else RIGHT


def mouth(world):
    """(left, right) heading of the posts by the pose, or None when that is not sure."""
    if not sure(world):
        return None
    field = world.field
    half = 0.5 * field.goal_width
    left = heading(*from_field(world.pose, 0.5 * field.width - half, field.length))
    right = heading(*from_field(world.pose, 0.5 * field.width + half, field.length))
    return left, left + wrap(right - left)


def mouth_by_pose(world):
    """The mouth where the pose may tell where to aim, or None."""
    in_front = world.pose.position.y > 0.5 * world.field.length
    if in_front and not rulebook.of(world).AIMS_BY_POSE_IN_FRONT:
        return None
    return mouth(world)


class Aim:
    def __init__(self):
        self.side = None       # of the locked gap; None: not locked
        self.gap = None        # (left, right) deg as of this frame; None: nobody knows
        self.lost = CARRIED_FRAMES
        self.aimed_frames = 0
        self.by_sight = False

    def update(self, world) -> None:
        """One frame: looks for the gap, then counts whether the robot points into it."""
        self.lost += 1
        seen = gaps_of(world) if rulebook.aims_by_sight(world) else (None, None)
        if seen != (None, None):
            if not self.by_sight and rulebook.of(world).SIGHT_COUNTS_ALONE:
                self.aimed_frames = 0
            self._lock(*seen)
        elif self.gap is not None and self.lost <= CARRIED_FRAMES and self.by_sight:
            turn = world.odometry.turn_deg
            self.gap = self.gap[0] - turn, self.gap[1] - turn
        else:
            self.gap, self.by_sight = mouth_by_pose(world), False
        if self.points_into_gap:
            self.aimed_frames += 1

    def explain(self, trace) -> None:
        """Appends what it aims at to a list for Command.trace."""
        branch = 'by_sight' if self.by_sight else 'by_pose'
        trace.append((kelpie.LAYER_SKILL, 'aim', 'search', 'no goal in sight, and no sure pose')
                     if self.gap is None else
                     (kelpie.LAYER_SKILL, 'aim', branch, 'gap from {} to {} deg, {} frames aimed',
                      *self.gap, self.aimed_frames))

    def _lock(self, left, right):
        if self.side is None:
            self.side = best_side(left, right)
        gap = left if self.side == LEFT else right
        self.gap = gap if gap is not None else (right if left is None else left)
        self.lost, self.by_sight = 0, True

    @property
    def middle(self) -> float:
        """deg to turn until the robot points into the middle of the gap."""
        return wrap(0.5 * (self.gap[0] + self.gap[1]))

    @property
    def points_into_gap(self) -> bool:
        return self.gap is not None and abs(self.middle) < self.padding

    @property
    def padding(self) -> float:
        return min(MAX_PADDING, max(MIN_PADDING, PADDING * size(self.gap)))

    @property
    def aimed(self) -> bool:
        return self.aimed_frames >= AIMED_FRAMES
