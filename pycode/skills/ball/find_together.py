# SPDX-License-Identifier: Apache-2.0
# Looks for a lost ball with the team. A mate that sees it ends the search: who must play it walks
# to where the team has it. When the whole team has lost it each forward goes to its own place of
# the field and spins there (distributed find ball, thesis 2006 section 6.2.2, figure 6.1). Keeps
# the place and the way there. It has nothing to say (None) in the first seconds, when the own
# search finds most balls, and without mates.
import math

import kelpie
from arbiter.machine import Machine
from lib import rulebook, search_places
from lib.geom import from_field
from lib.paths import SILENT_S
from lib.steer import aim_at, towards
from situation.time_to import FRESH_S, heard_of
from skills.ball.spin_for_ball import SpinForBall
from skills.head.watch import Scan
from skills.walk.bird_of_prey import BirdOfPrey

LOST_FRAMES = 66      # after which the team is asked (facts-2005 section 7.2),
LOST_ATTACKER = 166   # by an attacker
NEAR = 60.0           # cm; a nearer ball is the own search's, which looks under the chin
ARRIVED = 20.0        # cm from its place,
LEFT = 50.0           # cm from which it goes there again
AGAIN_S = 1.0         # between two looks at who is where
# Ours: a ball that none of three places shows is searched for by each alone for a while. Of 8 balls
# that are seen from 90 cm only, two were never found by spinning on.
SPIN_S = 7.0    # s at the place,
REST_S = 12.0   # s alone


class FindTogether(Machine):
    NAME = 'find_together'

    def __init__(self, memory, attacks):
        super().__init__(self.alone)
        self.memory = memory
        self.lost_frames = LOST_ATTACKER if attacks else LOST_FRAMES
        self.place = None
        self.placed_s = 0.0
        self.rest_until_s = -math.inf
        self.bird = BirdOfPrey()
        self.spinning = SpinForBall(memory, 1.0)

    @property
    def active(self) -> bool:
        return self.state != self.alone

    def step(self, world) -> kelpie.Command:
        """A Command, or None: the own search goes on."""
        reported = heard_of(world) if rulebook.of(world).HEARS_OF_BALL else None
        if reported is not None and math.hypot(*from_field(world.pose, *reported)) > NEAR:
            if self.state != self.follow:
                self.enter(world, self.follow, None, 'seen by a mate {} s ago',
                           world.team_ball.seconds_since_seen)
        elif self.together(world):
            if self.state not in (self.go, self.spin):
                self.choose_place(world)
                self.enter(world, self.go, self.bird, 'the team has lost the ball for {} frames',
                           float(self.memory.ball_lost))
        elif self.active:
            self.enter(world, self.alone, None, 'the own search')
        return super().step(world) if self.active else None

    def together(self, world) -> bool:
        team = world.team_ball
        return (rulebook.finds_together(world) and self.memory.ball_lost > self.lost_frames and
                world.time_s > self.rest_until_s and
                not (team.present and team.seconds_since_seen < FRESH_S))

    def choose_place(self, world):
        """Again every second: the mates' places change, and all must come to the same answer."""
        self.placed_s = world.time_s
        robots = [(mate.player, mate.pose.position.x, mate.pose.position.y)
                  for mate in world.teammates
                  if mate.note.role != kelpie.KEEPER and mate.seconds_since_heard < SILENT_S and
                  mate.player != world.game.player]
        here = world.pose.position
        robots.append((world.game.player, here.x, here.y))
        self.place = search_places.assigned(world.field, robots)[world.game.player]

    # States

    def alone(self, world):
        return kelpie.Command()

    def follow(self, world):
        point = from_field(world.pose, world.team_ball.position.x, world.team_ball.position.y)
        return kelpie.Command(walk=towards(point, NEAR / 2.0), head=aim_at(*point))

    def go(self, world):
        if world.time_s - self.placed_s > AGAIN_S:
            self.choose_place(world)
        if math.hypot(*from_field(world.pose, *self.place)) < ARRIVED:
            side = 1.0 if self.memory.spin_side >= 0.0 else -1.0
            self.spinning = SpinForBall(self.memory, side, rulebook.of(world).SPIN_TIMES)
            return self.enter(world, self.spin, None, 'at its place ({}, {})', *self.place)
        return kelpie.Command(walk=self.bird.step(world, self.place),
                              head=Scan().step(world, world.time_s))

    def spin(self, world):
        if math.hypot(*from_field(world.pose, *self.place)) > LEFT:
            return self.enter(world, self.go, self.bird, 'pushed off its place')
        if rulebook.of(world).SEARCH_RESTS and self.timed_out(world, SPIN_S):
            self.rest_until_s = world.time_s + REST_S
        return self.spinning.step(world)
