# SPDX-License-Identifier: Apache-2.0
# What a goalie knows in a frame, worked out once and before anything is decided: the world as it
# believes it, the ball at its body, who is near, a shot, how it faces, where mates see a ball that
# it has lost, and what its last motion moved. Keeps what each of these remembers. Changed by
# update() and what it learns by motion_ended() and the like alone. It is as wrong as the pose.
import math

from arbiter.lasting import Lasting
from lib import rulebook
from lib.geom import from_field
from lib.paths import point_of
from situation import kick_stand, opponents
from situation.ball_at_body import BODY, BallBetweenPaws
from situation.clearance import clearing_kick
from situation.facing import Facing
from situation.pose_watch import PoseWatch
from situation.shot_watch import ShotWatch
from situation.time_to import heard_of

SEEN = 0.4           # s; a ball unseen for longer is not acted on
HAS_STILL = 0.4      # s for which an opponent has the ball, or presses, on; in all
HAS_LONGEST = 4.0    # s; the rules let it hold the ball for 3
REPORTED_SD = 5.0    # cm; of vaguer balls of the team one in ten is more than 25 cm off


def seen(world, seconds=SEEN) -> bool:
    """Whether the ball was seen so recently."""
    return world.ball.present and world.ball.seconds_since_seen < seconds


class GoalieSituation:
    def __init__(self, memory):
        self.memory = memory
        self.world = None            # the frame, with the pose that is believed
        self.pose = PoseWatch()
        self.gave_in_s = -math.inf   # when a jump of the pose was believed in the end
        self.shots = ShotWatch(memory)
        self.facing = Facing()
        self.paws = BallBetweenPaws()
        self.has = Lasting(HAS_STILL, HAS_LONGEST)
        self.presses = Lasting(HAS_STILL, HAS_LONGEST)
        self.moved_s = 0.0           # when the last motion ended, or the last fall
        self.kicked = False          # that motion was a kick
        self.pose_lost = False       # landmarks come before what depends on the pose
        self.reported = None         # (x, y) of the field: where mates see a ball that it has lost
        self.opponent_has_ball = self.pressed = False
        self.rest_s = 0.0            # no attack before, after one that came to nothing
        self.stands = None           # kick_stand.Choice
        self.asked = {}              # what is worked out only when it is asked for, of this frame

    def update(self, world) -> None:
        """Takes one frame; to be called first."""
        self.asked = {}
        rules = rulebook.of(world)
        self.world = world = self.watched(world) if rules.WATCHES_POSE else world
        self.shots.update(world)
        self.facing.update(world)
        self.reported = self.heard() if rules.HEARS_OF_BALL else None
        self.paws.update(world, self.reported)
        if rules.YIELDS:
            self.see_others(world)

    def watched(self, world):
        """The world with the pose that is believed."""
        self.pose.update(world)
        if self.pose.gave_in:
            self.gave_in_s = world.time_s
        self.pose_lost = self.pose.lost(world)
        return self.pose.believed(world)

    def see_others(self, world):
        self.opponent_has_ball = self.has.update(world.time_s, opponents.has_ball(world))
        pressed = self.is_pressed()
        self.pressed = self.presses.update(world.time_s, pressed) and pressed

    # What it tells of itself

    def motion_ended(self, kicked) -> None:
        self.moved_s, self.kicked = self.world.time_s, kicked
        self.leave_to_them()
        self.reported = None     # whoever saw the ball saw it before

    def fell(self) -> None:
        self.moved_s = self.world.time_s

    def left_ball(self) -> None:
        """Ball and paws have parted."""
        self.paws.end()
        self.leave_to_them()

    def leave_to_them(self) -> None:
        """It has done something about the ball: whoever has it now has it anew."""
        self.has.end()
        self.presses.end()

    def attack_failed(self, rest) -> None:
        """No other for so many seconds."""
        self.rest_s = self.world.time_s + rest

    def start_over(self) -> None:
        """Play is halted, or it gets up: what was counted of the ball is over."""
        self.facing.end_turn()
        self.paws.end()
        self.reported = None

    # What follows from the frame

    @property
    def ball(self) -> tuple:
        """The ball's place on the field."""
        return point_of(self.world.ball)

    def sees(self, seconds=SEEN) -> bool:
        return seen(self.world, seconds)

    @property
    def seen_since_motion(self) -> bool:
        """Whether the ball was seen after the last kick or block, which moved it."""
        return self.world.time_s - self.moved_s > self.world.ball.seconds_since_seen

    @property
    def pose_settled(self) -> bool:
        """Whether the pose is to be gone by."""
        return self.pose.settled(self.world) and not self.pose_lost

    @property
    def lost_for(self) -> float:
        """Seconds without the ball; a motion takes the head along."""
        since_motion = self.world.time_s - self.moved_s
        ball = self.world.ball
        return min(ball.seconds_since_seen, since_motion) if ball.present else since_motion

    @property
    def clearance(self):
        """The kick that clears the ball as it lies, or None; the dearest question of all."""
        if 'clearance' not in self.asked:
            self.asked['clearance'] = clearing_kick(self.world)
        return self.asked['clearance']

    def kick_stand(self, goes_on):
        """Where to kick the ball from, or None; `goes_on`: an attack that is played already, whose
        stand is kept."""
        if 'stand' not in self.asked:
            self.stands = kick_stand.choose(self.world, self.stands if goes_on else None)
            self.asked['stand'] = self.stands.stand
        return self.asked['stand']

    def heard(self):
        """Where mates see a ball that the goalie has lost, if they saw it after its last motion; or
        None. It sees none beside its body or behind. Of balls within 60 cm, unseen for 0.4 s, the
        team's was sure to 5 cm in 65 %, and then off by 4 cm (median), its own belief by 17."""
        world, reported = self.world, heard_of(self.world)
        team = world.team_ball
        if (reported is None or world.time_s - self.moved_s <= team.seconds_since_seen or
                not self.pose_settled):
            return None
        variance = 0.5 * (team.covariance[0] + team.covariance[3])
        return reported if math.sqrt(variance) < REPORTED_SD else None

    def is_pressed(self) -> bool:
        """Whether an opponent is at a ball at the body: past who stands there it hardly gets, past
        who walks or turns it slips."""
        if self.reported is None and not self.world.ball.present:
            return False
        place = self.reported or self.ball
        return (BODY.holds(*from_field(self.world.pose, *place)) and
                opponents.at_ball(self.world, place))
