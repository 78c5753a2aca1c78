# SPDX-License-Identifier: Apache-2.0
# For how long the ball lies between the own paws, where a referee takes it for held (docs/body.md,
# Holding the ball) and the camera does not see it. Told by the infrared of the chest, which reads
# nearer than the carpet before it or, of a ball that touches it, farther; by the own belief; and by
# where mates see the ball. Of the goalies' frames with a ball there for 0.8 to 2.5 s (twenty
# matches) the infrared tells 75 %, belief or mates 84 %, any of the three 94 %; of those with it
# elsewhere 0.5, 0.4 and 0.8 %. Somebody else's leg there is taken for a ball. A motion begins it
# anew: it moves the ball, and the chest of who lies reads the carpet nearer.
import math

import kelpie
from arbiter.lasting import Lasting
from lib.geom import from_field
from lib.tune_goalie import Paws


def between(x, y) -> bool:
    """A place of the robot frame, cm."""
    return abs(x) < Paws.ASIDE and 0.0 < y < Paws.AHEAD


class Underfoot:
    def __init__(self):
        self.lies = Lasting(Paws.GAP, math.inf)
        self.moved_s = -math.inf   # when a motion ran last

    def update(self, world, told) -> None:
        """One frame; `told`: where mates see a ball that the robot has lost, (x, y) on the field,
        or None."""
        if world.motion.running != kelpie.NO_MOTION:
            self.moved_s = world.time_s
            return self.end()
        self.lies.update(world.time_s, self.there(world, told))

    def there(self, world, told) -> bool:
        chest = world.sensors.chest_distance
        if chest < Paws.TOO_NEAR or Paws.TOO_FAR < chest < Paws.NOTHING:
            return True
        if told is not None and between(*from_field(world.pose, *told)):
            return True
        ball = world.ball
        recent = min(Paws.SEEN, world.time_s - self.moved_s)
        return (ball.present and ball.seconds_since_seen < recent and
                between(ball.relative.x, ball.relative.y))

    def seconds(self, world) -> float:
        """For which it has been there."""
        lies = world.time_s - self.lies.last_s < Paws.GAP
        return world.time_s - self.lies.from_s if lies else 0.0

    def end(self) -> None:
        """Ball and robot have parted: it begins anew."""
        self.lies.end()
