# SPDX-License-Identifier: Apache-2.0
# Where at the body a ball lies that the camera sees badly or not at all, as three regions of the
# robot frame, and for how long it lies between the own paws, where a referee takes it for held
# (docs/physical-body.md). Known by the infrared of the chest, which reads nearer than the carpet
# before it or, of a ball that touches it, farther; by the own belief; and by where mates see the
# ball. Of the goalies' frames with a ball there for 0.8 to 2.5 s (twenty matches) the infrared
# tells 75 %, belief or mates 84 %, any of the three 94 %; of those with it elsewhere 0.5, 0.4 and
# 0.8 %. Somebody else's leg there is taken for a ball. A motion begins it anew: it moves the ball,
# and the chest of who lies reads the carpet nearer.
import math

import kelpie
from arbiter.lasting import Lasting
from lib.geom import from_field
from lib.goalie_places import TRUNK

GAP = 0.25           # s without a sign of it that count as no break
SEEN = 3.0           # s that a belief counts
CHEST_NEAR = 12.5    # cm of the chest's infrared, which reads the carpet between this
CHEST_FAR = 17.0     # cm and this,
NOTHING = 60.0       # cm and so far when there is nothing at all


class Region:
    """A rectangle of the robot frame, in cm: `lateral` to either side, from `behind` to `ahead`."""

    def __init__(self, lateral, behind, ahead):
        self.lateral, self.behind, self.ahead = lateral, behind, ahead

    def holds(self, x, y) -> bool:
        return abs(x) < self.lateral and self.behind < y < self.ahead


PAWS = Region(6.0, 0.0, 13.0)        # between the paws; by the rules 4 to the side, 11 ahead
CHIN = Region(16.0, 0.0, 16.0)       # before the chest and not beside it
BODY = Region(16.0, -TRUNK, 22.0)    # at the body: past who stands there it hardly gets


def under_chin(world) -> bool:
    """Whether the ball is believed before the chest."""
    ball = world.ball
    return ball.present and CHIN.holds(ball.relative.x, ball.relative.y)


class BallBetweenPaws:
    def __init__(self):
        self.lies = Lasting(GAP, math.inf)
        self.moved_s = -math.inf   # when a motion ran last
        self.for_s = 0.0           # s for which it has been there

    def update(self, world, reported) -> None:
        """One frame; `reported`: where mates see a ball that the robot has lost, (x, y) on the
        field, or None."""
        if world.motion.running != kelpie.NO_MOTION:
            self.moved_s = world.time_s
            return self.end()
        self.lies.update(world.time_s, self.there(world, reported))
        lies = world.time_s - self.lies.last_s < GAP
        self.for_s = world.time_s - self.lies.from_s if lies else 0.0

    def there(self, world, reported) -> bool:
        chest = world.sensors.chest_distance
        if chest < CHEST_NEAR or CHEST_FAR < chest < NOTHING:
            return True
        if reported is not None and PAWS.holds(*from_field(world.pose, *reported)):
            return True
        ball = world.ball
        recent = min(SEEN, world.time_s - self.moved_s)
        return (ball.present and ball.seconds_since_seen < recent and
                PAWS.holds(ball.relative.x, ball.relative.y))

    def end(self) -> None:
        """Ball and robot have parted: it begins anew."""
        self.lies.end()
        self.for_s = 0.0
