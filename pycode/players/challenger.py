# SPDX-License-Identifier: Apache-2.0
# The 2004 localisation challenge (thesis 2004 section 4.1). Stage 1: from two places near the
# middle, map the pink patches on the outer wall. While play is halted somebody hides the landmarks
# and carries the robot away. Stage 2: look round until the pose is known, then visit the five
# points of world.task by the shortest way and say so at each (open mouth).
import kelpie
from lib.route import points_of, shortest
from lib.tune import Challenge
from skills.go_to_point import GoToPoint
from skills.look_round import LookRound


class Challenger:
    def __init__(self):
        self.state = self.find_out
        self.since_s = None
        self.skill = LookRound()
        self.stands = list(Challenge.STANDS)
        self.mapped = False
        self.points = []

    def tick(self, world):
        if self.since_s is None:
            self.since_s = world.time_s
        if world.game.state != kelpie.PLAYING or world.game.penalised:
            return self.halted(world)
        if not self.stage2 and self.mapped:
            return self.begin_stage2(world)
        return self.state(world)

    @property
    def stage2(self):
        return self.state in (self.reorient, self.walk, self.announce, self.rest)

    def enter(self, state, skill, world):
        self.state, self.skill, self.since_s = state, skill, world.time_s

    def halted(self, world):
        """Whatever was mapped by now is the map; the next play is the second stage."""
        self.mapped = world.time_s > Challenge.LEAST_STAGE
        return kelpie.Command(pinks=kelpie.PINKS_LOCALISE)

    # Stage 1

    def find_out(self, world):
        if self.knows_place(world) and self.skill.rows > 0:
            self.enter(self.go_to_stand, self.to_stand(), world)
        return self.skill.tick(world)

    def to_stand(self):
        return GoToPoint(self.stands[0], Challenge.STAND_NEAR)

    def go_to_stand(self, world):
        if self.skill.arrived(world) or world.time_s - self.since_s > Challenge.STAND_TIME:
            self.stands.append(self.stands.pop(0))
            self.enter(self.map_pinks, LookRound(), world)
        return self.skill.tick(world)

    def map_pinks(self, world):
        if self.skill.rounds >= Challenge.MAP_ROUNDS:
            self.enter(self.go_to_stand, self.to_stand(), world)
        command = self.skill.tick(world)
        if not self.skill.turning:
            command.pinks = kelpie.PINKS_MAP
        return command

    # Stage 2

    def begin_stage2(self, world):
        self.points = points_of(world.task)
        self.enter(self.reorient, LookRound(), world)
        return self.reorient(world)

    def reorient(self, world):
        command = self.skill.tick(world)
        command.pinks = kelpie.PINKS_LOCALISE
        if self.knows_place(world):
            self.points = shortest(world.pose.position, self.points)
            self.next_point(world)
        return command

    def next_point(self, world):
        if self.points:
            self.enter(self.walk, GoToPoint(self.points[0], Challenge.NEAR), world)
        else:
            self.enter(self.rest, None, world)

    def walk(self, world):
        if world.position_sd > Challenge.LOST_SD:
            self.enter(self.reorient, LookRound(), world)
        elif self.skill.arrived(world):
            self.enter(self.announce, self.skill, world)
        return self.localising(self.skill.tick(world))

    def announce(self, world):
        command = self.localising(kelpie.Command(head=self.skill.watch.tick(world)))
        command.mouth_open = True
        if world.time_s - self.since_s > Challenge.ANNOUNCE_TIME:
            self.points.pop(0)
            self.next_point(world)
        return command

    def rest(self, world):
        return self.localising(kelpie.Command())

    def localising(self, command):
        command.pinks = kelpie.PINKS_LOCALISE
        return command

    def knows_place(self, world):
        return (world.position_sd < Challenge.SURE_SD and
                world.heading_sd_deg < Challenge.SURE_HEADING_SD and
                world.modes[0].weight > Challenge.SURE_WEIGHT)
