# SPDX-License-Identifier: Apache-2.0
# The goalie's clearing kicks (thesis 2006 section 4.3.1): which one hits the ball where it lies now
# and sends it where it cannot become an own goal. Keeps nothing but the table; a kick's place and
# direction are those of its file in actuator/data/motions. Fails where ball or heading are off by
# more than they were when the kicks were measured (docs/body.md): 12 mm.
import kelpie
from lib.goalie_places import off_own_goal
from lib.tune_goalie import Clear


class Kick:
    """Where the ball must lie (cm ahead and to the right of the neck base), the direction in which
    it goes (deg left) and by how much the robot gets ahead."""

    def __init__(self, name, motion, ahead, right, direction, forward):
        self.name, self.motion = name, motion
        self.ahead, self.right = ahead, right
        self.direction, self.forward = direction, forward

    def off(self, ball):
        """cm from the kick's place to a ball of the robot frame: ahead and aside."""
        return abs(ball.y - self.ahead), abs(ball.x - self.right)

    def hits(self, ball) -> bool:
        ahead, aside = self.off(ball)
        return ahead <= Clear.AHEAD and aside <= Clear.SIDE


KICKS = (Kick('kick_forward', kelpie.KICK_FORWARD, 14.0, 0.0, 0.0, -0.5),
         Kick('upenn_left', kelpie.UPENN_LEFT, 12.0, 6.0, 42.0, 5.5),
         Kick('upenn_right', kelpie.UPENN_RIGHT, 12.0, -6.0, -42.0, 5.5),
         Kick('head_swipe_left', kelpie.HEAD_SWIPE_LEFT, 13.0, 3.0, 37.0, 10.1),
         Kick('head_swipe_right', kelpie.HEAD_SWIPE_RIGHT, 13.0, -3.0, -37.0, 10.1))


def off_goal(world, kick) -> float:
    """Degrees between the own goal and where a kick would send the ball from here."""
    ball = (world.ball.position.x, world.ball.position.y)
    return off_own_goal(world.field, ball, world.pose.heading_deg + kick.direction)


def safe(world, kick) -> bool:
    """Whether a kick from here cannot become an own goal."""
    return off_goal(world, kick) > Clear.OFF_GOAL


def clearing_kick(world) -> Kick | None:
    """The safe kick whose place the ball is nearest to, if one hits it as it lies."""
    ball = world.ball
    if not ball.present or ball.seconds_since_seen > Clear.SEEN:
        return None
    hits = [kick for kick in KICKS if kick.hits(ball.relative) and safe(world, kick)]
    return min(hits, key=lambda kick: sum(kick.off(ball.relative)), default=None)
