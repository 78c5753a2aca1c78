# SPDX-License-Identifier: Apache-2.0
# Which kick a robot that holds the ball uses by the rules of thesis 2006 (Alg 6.8 to 6.11 and the
# text of section 6.4.7): the surer it is of the goal, the stronger. Pure functions of a Hold, what
# is known in that frame; each answers (choice, reason, numbers...). Keeps nothing. The map's choice
# is decisions/kick_map_choice.py.
import kelpie
from lib import zones

RELEASE = 'release'
SPIN_AWAY = 'spin_away'
PASS_LEFT = 'pass_left'
PASS_RIGHT = 'pass_right'

CORNER_AREA = 100.0     # cm around an upper corner
SMALL_GAP = 12.0        # deg: "the gap is small" (open; the goal is 38 deg wide from 115 cm)
FACING = 15.0           # deg, Alg 6.9
TOO_CLOSE = 30.0        # cm, Alg 6.9
LAST_CM = 50.0          # cm before the goal line, Alg 6.9 and 6.10
RECENT = 15             # frames, Alg 6.10
SPUN = 30               # frames, Alg 6.11
SPINNING_Y = 350.0      # cm, Alg 6.11 (G48)
OWN_GOAL_RECENT = 5     # frames since the own goal was seen that count as seeing it


class Hold:
    """What the rules ask. `gap`: (left, right) in deg or None; `aimed`: it was aimed at the gap
    for long enough, and is still; `spin_frames`, `spin_side`: of the turn in search of the goal, +1
    left."""

    def __init__(self, world, memory, contested, gap, aimed, spin_frames=0, spin_side=0.0):
        self.field = world.field
        self.x, self.y = world.pose.position.x, world.pose.position.y
        self.contested, self.gap, self.aimed = contested, gap, aimed
        self.goal_lost, self.goal_heading = memory.goal_lost, memory.goal_heading
        self.own_goal_seen = memory.own_goal_lost < OWN_GOAL_RECENT
        self.spin_frames, self.spin_side = spin_frames, spin_side
        dx, dy = self.x - 0.5 * self.field.width, self.y - self.field.length
        self.goal_distance = (dx * dx + dy * dy) ** 0.5

    @property
    def small_gap_in_corner(self) -> bool:
        if self.gap is None or abs(self.gap[0] - self.gap[1]) >= SMALL_GAP:
            return False
        lateral = min(self.x, self.field.width - self.x)
        below = self.field.length - self.y
        return (lateral * lateral + below * below) ** 0.5 < CORNER_AREA

    def pass_across(self):
        """Towards the middle: who looks up-field from the left corner passes to the right."""
        left = self.x < 0.5 * self.field.width
        return (PASS_RIGHT if left else PASS_LEFT, 'in a corner, the gap is small')


def by_rules(hold) -> tuple:
    """The kick for where the robot stands, once it has aimed or may not hold any longer."""
    region = zones.zone(hold.field, hold.y)
    if region == zones.DEFENSIVE:
        return defensive(hold)
    if region == zones.MIDDLE:
        return middle(hold)
    if hold.goal_lost == 0:
        return goal_seen(hold)
    return goal_seen_lately(hold) if hold.goal_lost < RECENT else goal_not_seen(hold)


def defensive(hold) -> tuple:
    """Alg 6.8."""
    if hold.own_goal_seen:
        return SPIN_AWAY, 'the own goal is in sight'
    return kelpie.HARD_FORWARD, 'own third, the own goal is not in sight'


def middle(hold) -> tuple:
    """As the defensive rule, but soft when contested (section 6.4.7)."""
    if hold.own_goal_seen:
        return SPIN_AWAY, 'the own goal is in sight'
    if hold.contested:
        return kelpie.WEDGE, 'midfield, contested'
    return kelpie.HARD_FORWARD, 'midfield'


def goal_seen(hold) -> tuple:
    """Alg 6.9, in the order of the listing (G47)."""
    if hold.small_gap_in_corner:
        return hold.pass_across()
    if hold.aimed and hold.gap is not None:
        return kelpie.HARD_FORWARD, 'aimed at the gap from {} to {} deg', *hold.gap
    if abs(hold.goal_heading) < FACING:
        return kelpie.HARD_FORWARD, 'the goal is {} deg aside', hold.goal_heading
    if hold.goal_distance < TOO_CLOSE:
        return RELEASE, 'the goal is {} cm away', hold.goal_distance
    if hold.y > hold.field.length - LAST_CM:
        return kelpie.HARD_FORWARD, '{} cm before the goal line', hold.field.length - hold.y
    return kelpie.WEDGE, 'the goal is in sight, {} deg aside', hold.goal_heading


def goal_seen_lately(hold) -> tuple:
    """Alg 6.10."""
    if hold.small_gap_in_corner:
        return hold.pass_across()
    if hold.y > hold.field.length - LAST_CM:
        return kelpie.HARD_FORWARD, 'the goal was seen {} frames ago', float(hold.goal_lost)
    return kelpie.WEDGE, 'the goal was seen {} frames ago', float(hold.goal_lost)


def goal_not_seen(hold) -> tuple:
    """Alg 6.11: who has turned long for the goal in its front third strikes on in that turn."""
    if hold.y > SPINNING_Y and not hold.own_goal_seen and hold.spin_frames >= SPUN:
        kick = kelpie.HEAD_SWIPE_LEFT if hold.spin_side > 0.0 else kelpie.HEAD_SWIPE_RIGHT
        return kick, 'turned {} frames and saw no goal', float(hold.spin_frames)
    if hold.y > 0.5 * hold.field.length:
        return kelpie.WEDGE, 'no goal in sight for {} frames', float(hold.goal_lost)
    return RELEASE, 'no goal in sight for {} frames, own half', float(hold.goal_lost)


def out_of_time(hold) -> tuple:
    """The kick that the holding rule forces (section 6.4.7): also without sight of the goal."""
    chosen = by_rules(hold)
    if chosen[0] in (SPIN_AWAY, RELEASE):
        return RELEASE, 'out of time: ' + chosen[1], *chosen[2:]
    return chosen
