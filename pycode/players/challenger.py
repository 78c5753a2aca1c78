# SPDX-License-Identifier: Apache-2.0
# The 2004 localisation challenge (thesis 2004 section 4.1). Stage 1: from two places near the
# middle, map the pink patches on the outer wall. While play is halted somebody hides the landmarks
# and carries the robot away. Stage 2: look round until the pose is known, then visit the five
# points of world.task by the shortest way and say so at each (open mouth). Keeps the state, whether
# there is a map and which points are left. Fails when the pose is sure and wrong: it then announces
# the wrong places.
import kelpie
from arbiter.machine import Machine
from lib import features, rulebook
from lib.route import points_of, shortest
from situation.pose_watch import is_sure
from skills.walk.go_to_point import Challenge, GoToPoint
from skills.walk.look_round import LookRound


class Challenger(Machine):
    LAYER = kelpie.LAYER_PLAYER
    NAME = 'challenger'

    def __init__(self):
        super().__init__(self.find_out, LookRound())
        self.beyond = False  # the middle: where the map is made next
        self.mapped = False
        self.points = []

    def step(self, world) -> kelpie.Command:
        if world.game.state != kelpie.PLAYING or world.game.penalised:
            # Whatever was mapped by now is the map; the next play is the second stage.
            self.mapped = world.time_s > Challenge.MIN_STAGE
            command = self.idle(world)
            command.trace.append((self.LAYER, self.NAME, 'waits', 'play is halted'))
            return command
        if self.mapped and not self.stage2:
            self.points = points_of(world.task)
            self.reset(world, 'carried away', self.reorient, LookRound())
        command = super().step(world)
        self.explain(command.trace)
        return command

    def idle(self, world) -> kelpie.Command:
        return self.localising(kelpie.Command())

    @property
    def stage2(self) -> bool:
        return self.state in (self.reorient, self.visit, self.announce, self.finish)

    # Stage 1

    def find_out(self, world):
        if self.knows_place(world) and self.skill.rows > 0:
            return self.enter(world, self.go_to_stand, self.to_stand(world.field),
                              'the pose is sure to {} cm', world.position_sd)
        return self.skill.step(world)

    def to_stand(self, field) -> GoToPoint:
        off = Challenge.STAND_OFF_CENTRE if self.beyond else -Challenge.STAND_OFF_CENTRE
        return GoToPoint((0.5 * field.width, 0.5 * field.length + off), Challenge.STAND_NEAR)

    def go_to_stand(self, world):
        command = self.skill.step(world)
        if self.skill.done or self.timed_out(world, Challenge.STAND_TIME):
            self.beyond = not self.beyond
            # The map begins with the next frame: what this one saw, it may have seen while walking.
            self.enter(world, self.map_pinks, LookRound(), 'at the place to map from')
            return self.skill.step(world)
        return command

    def map_pinks(self, world):
        if self.skill.rounds >= Challenge.MAP_ROUNDS:
            return self.enter(world, self.go_to_stand, self.to_stand(world.field),
                              'mapped in {} rounds', self.skill.rounds)
        command = self.skill.step(world)
        if not self.skill.turning:
            command.pinks = kelpie.PINKS_MAP
        return command

    # Stage 2

    def reorient(self, world):
        command = self.localising(self.skill.step(world))
        if self.knows_place(world):
            self.points = shortest(world.pose.position, self.points)
            self.next_point(world)
        return command

    def next_point(self, world):
        """The way to the next point, or the end, begins with the next frame."""
        if self.points:
            first = None
            if rulebook.of(world).AIMS_BEHIND:
                first = features.behind(world.field, self.points[0])
            self.enter(world, self.visit, GoToPoint(self.points[0], Challenge.NEAR, first),
                       '{} points are left', len(self.points))
        else:
            self.enter(world, self.finish, None, 'no point is left')

    def visit(self, world):
        if world.position_sd > Challenge.LOST_SD:
            return self.reset(world, 'the pose is lost', self.reorient, LookRound())
        command = self.localising(self.skill.step(world))
        if self.skill.done:
            self.enter(world, self.announce, self.skill, 'stands at the point')
        return command

    def announce(self, world):
        command = self.localising(kelpie.Command(head=self.skill.watch.step(world)))
        command.mouth_open = True
        if self.timed_out(world, Challenge.ANNOUNCE_TIME):
            self.points.pop(0)
            self.next_point(world)
        return command

    def finish(self, world):
        return self.idle(world)

    def localising(self, command) -> kelpie.Command:
        command.pinks = kelpie.PINKS_LOCALISE
        return command

    def knows_place(self, world) -> bool:
        return (is_sure(world, Challenge.SURE_SD, Challenge.SURE_HEADING_SD) and
                bool(world.modes) and world.modes[0].weight > Challenge.SURE_WEIGHT)
