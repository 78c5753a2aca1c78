# SPDX-License-Identifier: Apache-2.0
# The head of who does not play the ball: on the ball, from time to time at a landmark (active
# localisation of who waits, thesis 2006 section 4.3.2), and when the ball is unseen where the team
# has it and around in turn. Keeps whether it looks at a landmark. With a wrong pose the team's ball
# is looked for in the wrong place; the sweep in between finds it then.
import kelpie
from arbiter.skill import Skill
from lib import rulebook
from lib.geom import from_field
from lib.steer import aim_at
from situation.time_to import SURE_FRAMES
from skills.head.active_localise import ActiveLocalise, due
from skills.head.track_ball import TrackBall
from skills.head.watch import Scan

TURN_FRAMES = 45      # looks at the team's ball and sweeps take turns


class WatchPlay(Skill):
    NAME = 'watch_play'

    def __init__(self, memory):
        self.memory = memory
        self.mark = ActiveLocalise(memory, may_look=due)
        self.looking = False
        self.track = TrackBall(memory)

    def step(self, world, ball) -> kelpie.HeadRequest:
        """`ball`: where the team has it on the field, or None."""
        if self.looking:
            self.looking = not self.mark.done
        elif self.mark.needed(world):
            self.looking = True
            self.mark.start(world)
        if self.looking:
            return self.mark.step(world)
        if self.memory.ball_lost <= SURE_FRAMES and world.ball.present:
            return self.track.step(world)
        hears = rulebook.of(world).HEARS_OF_BALL
        if hears and ball is not None and self.memory.ball_lost // TURN_FRAMES % 2 == 0:
            return aim_at(*from_field(world.pose, *ball))
        return Scan().step(world, world.time_s)

    def explain(self, trace) -> None:
        if self.looking:
            self.mark.explain(trace)
