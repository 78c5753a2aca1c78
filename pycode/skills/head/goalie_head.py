# SPDX-License-Identifier: Apache-2.0
# The goalie's head (thesis 2006 section 4.3.1): always on the ball; back to it at once when it is
# lost, by where it is believed, then by a point scan; now and then a glance at the landmark seen
# longest ago, and a survey of all when there is none. Keeps the state and when it last glanced. It
# looks away only when it is allowed to and the ball is far and does not come, so a goalie in
# a long scrum does not localise.
import math

import kelpie
from arbiter.machine import Machine
from lib import rulebook
from lib.geom import from_field
from lib.head import look_at, view
from lib.landmarks import GOALIE_PAN, in_reach, look_at_landmark
from situation.goalie import seen
from situation.pose_watch import is_sure
from skills.head.point_scan import Looks, PointScan
from skills.head.watch import Watch


class Look:
    """Glances at landmarks; facts-2005 section 7.2: every 50 to 95 frames, for 9."""
    EVERY_LOST = 1.7         # s between glances,
    EVERY_SURE = 3.2         # s while the pose is sure: to
    SURE_SD = 6.0            # cm and
    SURE_HEADING_SD = 4.0    # deg
    TIME = 0.3  # s
    SURVEY = 75.0, 25.0, -25.0, -75.0  # deg of pan, in turn
    SURVEY_TIME = 0.26       # s at each
    SURVEY_DOWN = 6.0        # deg below the horizontal
    AGAIN = 2.0              # s between two surveys of a lost pose
    STEADY = 0.7             # s of tracking before a glance
    FAR = 60.0               # cm to the ball; nearer it is not left alone,
    FAR_SURE = 120.0         # nor here while the pose is sure: from 100 cm the attacker shoots
    FAR_ELLIPSE = 25.0       # thesis 2004 section 4.2.3
    STILL = 15.0             # cm/s of the ball towards the goal
    FRONT = 45.0             # deg of pan in every second glance; the near beacons are at 60
    RETURN = 0.25            # s at the angle of before, then at where gps has the ball
    BELIEVED = 0.4  # s
    LOST = 0.25              # s unseen while it is looked at
    REPORTED = 0.5           # s,
    REPORTED_EVERY = 2.0     # s of looking to where mates see it, out of so many


def side_of(x) -> float:
    """Of a point so far to the right of the robot: +1 left, -1 right."""
    return -1.0 if x > 0.0 else 1.0


class Hints:
    """What a goalie's head knows of the pose, and of the ball by mates: nothing."""
    reported = None        # where mates see a ball that the goalie has lost
    pose_lost = False      # a survey now, unless a ball comes
    gave_in_s = -math.inf  # when a jump of the pose was believed: a survey once the ball is far


class GoalieHead(Machine):
    NAME = 'goalie_head'
    FAR = Look.FAR   # cm; a nearer ball is not left alone,
    FAR_SURE = Look.FAR_SURE   # nor one so near while the pose is sure

    def __init__(self, memory, hints=Hints()):
        super().__init__(self.search)
        self.memory = memory
        self.hints = hints
        self.free = False
        self.mates_saw = None  # where mates last saw a ball that the goalie has lost
        self.surveyed_s = -math.inf   # the last frame of a survey
        self.tracked = 0.0    # cm to the ball when it was last tracked
        self.glances = 0
        self.marked = False   # the landmark was seen in this glance
        self.glanced_s = 0.0

    def step(self, world, free) -> kelpie.HeadRequest:
        """`free`: whether the player can do without the ball for a moment."""
        self.free = free
        return super().step(world)

    @property
    def asked(self) -> bool:
        """For a survey, as soon as the ball can be left alone."""
        return self.hints.gave_in_s > self.surveyed_s

    def idle(self, world) -> kelpie.HeadRequest:
        return self.at_ball(world)

    def at_ball(self, world):
        ball = world.ball.relative
        return look_at(ball.x, ball.y, Watch.BALL_HEIGHT, world.stance)

    def track(self, world):
        self.mates_saw = None
        self.tracked = world.ball.distance
        if not seen(world, Look.LOST):
            return self.regain_ball(world)
        if self.asked and self.calm(world) or self.must_survey(world):
            why = 'the pose is lost' if self.hints.pose_lost else 'the pose has jumped'
            return self.enter(world, self.survey, None, why)
        mark = self.landmark(world)
        if mark is not None:
            self.glances += 1
            self.marked = False
            return self.enter(world, self.localise, mark, 'glance {}; the pose is sure to {} cm',
                              self.glances, world.position_sd)
        return self.at_ball(world)

    def regain_ball(self, world):
        """Which of the ways to find the ball comes first."""
        if not world.ball.present:
            return self.enter(world, self.search, self.scan(world), 'no ball is believed')
        return self.enter(world, self.believed, None, 'the ball is unseen for {} s',
                          world.ball.seconds_since_seen)

    def calm(self, world) -> bool:
        """Whether the ball can be left alone for a moment."""
        sure = is_sure(world, Look.SURE_SD, Look.SURE_HEADING_SD)
        far = self.FAR_SURE if sure and not self.asked else self.FAR
        return (self.free and world.ball.distance > far and
                world.ball.velocity.y > -Look.STILL and self.since(world) > Look.STEADY)

    def must_survey(self, world) -> bool:
        """Of a lost pose even with the ball at the feet, now and then."""
        return (self.hints.pose_lost and self.free and world.ball.velocity.y > -Look.STILL and
                world.time_s - self.surveyed_s > Look.AGAIN)

    def landmark(self, world):
        """The one to glance at now, or None."""
        sure = is_sure(world, Look.SURE_SD, Look.SURE_HEADING_SD)
        every = Look.EVERY_SURE if sure else Look.EVERY_LOST
        if world.time_s - self.glanced_s < every or not self.calm(world):
            return None
        return self.next_landmark(world)

    def next_landmark(self, world):
        """The one seen longest ago: with one alone, seen again and again, the pose goes astray on a
        circle about it."""
        marks = [mark for mark, _, _ in in_reach(world, GOALIE_PAN)]
        return min(marks, key=lambda mark: self.memory.marks.get(mark.kind, -1), default=None)

    def localise(self, world):
        self.glanced_s = world.time_s
        self.marked = self.marked or any(mark.kind == self.skill.kind
                                         for mark in world.percepts.landmarks)
        if not self.free or self.timed_out(world, Look.TIME):
            if self.free and not self.marked and rulebook.of(world).WATCHES_POSE:
                return self.enter(world, self.survey, None, 'no landmark where the pose says')
            return self.after_glance(world)
        return look_at_landmark(world, self.skill)

    def survey(self, world):
        """Once from left to right, at rest in four directions: what is seen mends the pose."""
        self.glanced_s = self.surveyed_s = world.time_s
        look = int(self.since(world) / Look.SURVEY_TIME)
        if not self.free or look >= len(Look.SURVEY):
            return self.after_glance(world)
        return view(Look.SURVEY[look], Look.SURVEY_DOWN, world.stance)

    def after_glance(self, world):
        return self.enter(world, self.believed, None, 'the glance is over')

    def believed(self, world):
        if seen(world, Look.LOST) and world.ball.seconds_since_seen < self.since(world):
            return self.enter(world, self.track, None, 'the ball is {} cm away',
                              world.ball.distance)
        if not world.ball.present or self.timed_out(world, Look.BELIEVED):
            return self.enter(world, self.search, self.scan(world), 'not where it is believed')
        return self.at_ball(world)

    def look_near(self, world, side):
        """After a block, which had the head: the ball lies close by, seldom where the filter
        believes it, which knows of no block. `side`: +1 left, -1 right."""
        if not seen(world, Look.LOST):
            self.enter(world, self.search, PointScan(world, side), 'a block has ended')

    def expect(self, world, point):
        """The ball was kicked and should be near that point of the field."""
        self.enter(world, self.expected, point, 'after a kick it should be near ({}, {})',
                   *point)

    def expected(self, world):
        if seen(world, Look.LOST) and world.ball.seconds_since_seen < self.since(world):
            return self.enter(world, self.track, None, 'the ball is {} cm away',
                              world.ball.distance)
        x, y = from_field(world.pose, *self.skill)
        if self.timed_out(world, Look.BELIEVED):
            return self.enter(world, self.search, PointScan(world, side_of(x)),
                              'not where it was kicked')
        return look_at(x, y, Watch.BALL_HEIGHT, world.stance)

    def search(self, world):
        if seen(world, Look.LOST):
            return self.enter(world, self.track, None, 'the ball is {} cm away',
                              world.ball.distance)
        if self.must_survey(world) and not self.searches_near(world):
            return self.enter(world, self.survey, None, 'the pose is lost')
        if self.skill is None:
            self.skill = self.scan(world)
        if self.hints.reported is not None:
            return self.look_where_mates_saw(world)
        if self.mates_saw is not None:   # from there on it is looked for again
            x, y = from_field(world.pose, *self.mates_saw)
            self.mates_saw = None
            self.skill = PointScan(world,
                                   side_of(x) if math.hypot(x, y) < Looks.NEAR else 0.0)
        return self.skill.step(world)

    def look_where_mates_saw(self, world):
        """There, and between two such looks on with the scan: a mate may be wrong."""
        self.mates_saw = self.hints.reported
        if math.fmod(self.since(world), Look.REPORTED_EVERY) > Look.REPORTED:
            return self.skill.step(world)
        x, y = from_field(world.pose, *self.hints.reported)
        return look_at(x, y, Watch.BALL_HEIGHT, world.stance)

    def turn_side(self, world) -> float:
        """To which side the body must turn for the search, +1 left; 0: to none."""
        return self.skill.turn_side(world) if isinstance(self.skill, PointScan) else 0.0

    @property
    def surveys(self) -> bool:
        return self.state == self.survey

    def searches_near(self, world) -> bool:
        """Whether the ball is still looked for where it was lost close by."""
        return isinstance(self.skill, PointScan) and self.skill.searches_near(world)

    def scan(self, world):
        """Low first on the side where the ball is believed, if it was lost close by."""
        if self.tracked > Looks.NEAR:
            return PointScan(world)
        return PointScan(world, 1.0 if world.ball.heading_deg >= 0.0 else -1.0)
