# SPDX-License-Identifier: Apache-2.0
# The head of the goalie of 2004 (thesis 2004 section 4.2.3): after each glance at a beacon it goes
# back to the angles of before, then to where gps has the ball, then searches: from left to right
# with the horizon at the image's top, then quickly at the feet. Keeps the state and those angles. A
# sweep lasts 1.5 s and shows what is at the feet for 0.7 s.
import kelpie
from lib.head import view
from lib.landmarks import GOALIE_PAN, choose_landmark
from situation.goalie import seen
from skills.head.goalie_head import GoalieHead, Look


class Pan:
    """The full search of 2004: from left to right at the horizon's height, then quickly at the
    feet."""
    SIDE = 88.0  # deg
    SPEED = 120.0            # deg/s
    QUICK = 250.0  # deg/s
    DOWN = 18.0  # deg,
    FEET = 48.0  # deg below the horizontal; 22 is half an image


class EllipseHead(GoalieHead):
    NAME = 'ellipse_head'
    FAR = FAR_SURE = Look.FAR_ELLIPSE

    def __init__(self, memory):
        super().__init__(memory)
        self.state = self.horizon
        self.angles = None   # of the head when the ball was last looked at

    def track(self, world):
        self.angles = (world.head.neck_tilt_deg, world.head.head_pan_deg, world.head.head_nod_deg)
        return super().track(world)

    def next_landmark(self, world):
        """Along the axis in which the pose is least sure; far to the side, where the near beacons
        are, in every second glance only (thesis 2004 figure 4.7)."""
        limit = GOALIE_PAN if self.glances % 2 else Look.FRONT
        return choose_landmark(world, limit, world.head.head_pan_deg)

    def after_glance(self, world):
        return self.enter(world, self.last_angle, None, 'the glance is over')

    def last_angle(self, world):
        if seen(world, self.since(world)):
            return self.found(world)
        if self.timed_out(world, Look.RETURN):
            return self.regain_ball(world)
        neck, pan, nod = self.angles
        return kelpie.HeadRequest(neck_tilt_deg=neck, head_pan_deg=pan, head_nod_deg=nod)

    def regain_ball(self, world):
        if not world.ball.present:
            return self.enter(world, self.horizon, None, 'no ball is believed')
        return super().regain_ball(world)

    def believed(self, world):
        if seen(world, self.since(world)):
            return self.found(world)
        if not world.ball.present or self.timed_out(world, Look.BELIEVED):
            return self.enter(world, self.horizon, None, 'not where it is believed')
        return self.at_ball(world)

    def horizon(self, world):
        return self.pan(world, Pan.SPEED, Pan.DOWN, self.feet)

    def feet(self, world):
        return self.pan(world, Pan.QUICK, Pan.FEET, self.horizon)

    def pan(self, world, speed, down, after):
        if seen(world, Look.LOST):
            return self.found(world)
        way = speed * self.since(world)
        if way > 2.0 * Pan.SIDE:
            return self.enter(world, after, None, 'the sweep is over')
        return view(Pan.SIDE - way, down, world.stance)

    def found(self, world):
        return self.enter(world, self.track, None, 'the ball is {} cm away', world.ball.distance)
