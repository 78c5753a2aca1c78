# SPDX-License-Identifier: Apache-2.0
# Walks to its place before a kick-off (ready state, 45 s), round others and backing off from whom
# its paws meet (thesis 2006 section 4.3.3), turns up-field there, and in the set state stands and
# looks at the ball. Keeps the way, the paws and whether it stands. Looks at landmarks all the way;
# it arrives where its pose says.
import math

import kelpie
from arbiter.machine import Machine
from lib import kick_off_places
from lib.geom import from_field, wrap
from lib.steer import facing
from situation.goal import UP_FIELD_DEG
from situation.time_to import SURE_FRAMES
from skills.head.track_ball import TrackBall
from skills.head.watch import Scan, Sweep
from skills.walk.bird_of_prey import BirdOfPrey
from skills.walk.paw_stuck import PawStuck

IN = 7.0  # cm,
OUT = 12.0  # cm (facts-2005 section 7.2)
TURNED = 10.0  # deg,
TURN_AGAIN = 20.0  # deg
NEAR = 50.0                  # cm; from there on it turns up-field while it walks
SLOW = 20.0                  # cm/s, of the last steps


class TakePlace(Machine):
    NAME = 'take_place'

    def __init__(self, memory, goalie=False):
        super().__init__(self.walk_there)
        self.memory, self.goalie = memory, goalie
        self.bird, self.stuck = BirdOfPrey(), PawStuck()
        self.track = TrackBall(memory)

    def place(self, world):
        if self.goalie:
            return kick_off_places.goalie(world.field)
        return kick_off_places.forward(world.field, world.game.player, world.game.kick_off,
                                       len(world.teammates) == 0)

    def step(self, world) -> kelpie.Command:
        if world.game.state != kelpie.READY:
            if self.state != self.set:
                self.enter(world, self.set, None, 'waits for the kick-off')
        elif self.stuck.needed(world):
            if self.state != self.back_off:
                self.enter(world, self.back_off, self.stuck, 'a front paw pushes at something')
        elif self.state in (self.back_off, self.set):
            self.enter(world, self.walk_there, self.bird, 'the paws are free')
        command = super().step(world)
        note = command.team
        note.wants, (note.wanted.x, note.wanted.y) = True, self.place(world)
        return command

    # States

    def walk_there(self, world):
        place = self.place(world)
        point = from_field(world.pose, *place)
        away, off_deg = math.hypot(*point), wrap(UP_FIELD_DEG - world.pose.heading_deg)
        if away < IN and abs(off_deg) < TURNED:
            return self.enter(world, self.stand, None, 'at its place')
        if away < NEAR:
            walk = facing(point, off_deg, speed=SLOW)
        else:
            walk = self.bird.step(world, place)
        return kelpie.Command(walk=walk, head=Sweep().step(world, world.time_s))

    def stand(self, world):
        away = math.hypot(*from_field(world.pose, *self.place(world)))
        off_deg = wrap(UP_FIELD_DEG - world.pose.heading_deg)
        if away > OUT or abs(off_deg) > TURN_AGAIN:
            return self.enter(world, self.walk_there, self.bird, '{} cm off its place', away)
        return kelpie.Command(head=Sweep().step(world, world.time_s))

    def back_off(self, world):
        return self.stuck.step(world)

    def set(self, world):
        seen = self.memory.ball_lost <= SURE_FRAMES and world.ball.present
        return kelpie.Command(head=self.track.step(world) if seen else
                              Scan().step(world, world.time_s))
