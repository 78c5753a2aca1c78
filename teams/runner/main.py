# SPDX-License-Identifier: Apache-2.0
# The runner: a team that plays the pattern of the released team of 2005 as ../shared/data/rival
# shows it. Its nearest robot wins the ball and runs with it, pushed 15 to 35 cm ahead; nobody
# stands. decide(world) -> Command, once per camera frame; all that is kept lives in the Player.
import kelpie
from eyes import Eyes, off_ahead, sweep
from keeper import keep
from places import Roles, defence, go, moving, out_of_box, ready, support
from plane import walk, wrap, xy
from run import run

UP = {kelpie.ON_FRONT: kelpie.GET_UP_FRONT, kelpie.ON_BACK: kelpie.GET_UP_BACK,
      kelpie.ON_LEFT: kelpie.GET_UP_LEFT, kelpie.ON_RIGHT: kelpie.GET_UP_RIGHT}
HELD_S = 1.2         # s for which it pushes on at what holds it,
LOOSE_S = 0.7        # s that it then steps back and aside
ARRIVED = 9.0        # cm from its place before a kick-off within which it stands still


class Player:
    def __init__(self):
        self.eyes, self.roles = Eyes(), Roles()
        self.asked = False      # for getting up, in the last frame
        self.free_s = self.loose_s = 0.0   # when nothing held it last, until when it gets loose

    def step(self, world) -> kelpie.Command:
        game = world.game
        if game.penalised or game.state in (kelpie.INITIAL, kelpie.FINISHED):
            return kelpie.Command(head=sweep(world))
        fell = world.motion.feeling.fallen in UP or world.motion.running in UP.values()
        if fell and game.state != kelpie.SET:
            return kelpie.Command(motion=self.get_up(world))
        ball = self.eyes.ball(world)
        command = kelpie.Command(head=self.eyes.look(world, ball))
        if game.state == kelpie.READY:
            command.head, command.walk = sweep(world), self.take_place(world)
        elif game.state == kelpie.PLAYING:
            command.walk = self.play(world, ball)
        self.tell(world, ball, command)
        return command

    def get_up(self, world) -> int:
        """A motion begins once for each time that it is asked, so one frame asks, the next not."""
        wanted = UP.get(world.motion.feeling.fallen, kelpie.NO_MOTION)
        if self.asked or world.motion.running != kelpie.NO_MOTION:
            wanted = kelpie.NO_MOTION
        self.asked = wanted != kelpie.NO_MOTION
        return wanted

    def take_place(self, world) -> kelpie.WalkRequest:
        place, (x, y) = ready(world), xy(world.pose)
        off = abs(wrap(world.pose.heading_deg - 90.0))
        if abs(x - place[0]) + abs(y - place[1]) < ARRIVED and off < 20.0:
            return kelpie.WalkRequest()
        return go(world, place, (x, world.field.length), 1.5)

    def play(self, world, ball) -> kelpie.WalkRequest:
        keeper, role = world.game.player == 1, self.roles.choose(world, ball)
        if self.held(world):
            return walk(120.0 if world.game.player % 2 else -120.0, 0.0, 30.0)
        if keeper:
            return keep(world, ball)
        if ball is None:
            return self.eyes.search(world)
        if role != kelpie.ATTACKER:
            place = support if role == kelpie.SUPPORTER else defence
            return go(world, moving(world, place(world, ball), ball), ball)
        boxed = out_of_box(world.field, ball, 0.0)
        return run(world, ball) if boxed == ball else go(world, moving(world, boxed, ball), ball)

    def held(self, world) -> bool:
        """Whether it gets loose in this frame: something has held it for a while."""
        if not world.motion.feeling.stuck:
            self.free_s = world.time_s
        if world.time_s - self.free_s > HELD_S:
            self.free_s, self.loose_s = world.time_s, world.time_s + LOOSE_S
        return world.time_s < self.loose_s

    def tell(self, world, ball, command):
        """To the mates who it is and how soon it has the ball; to who asks, why."""
        role = kelpie.KEEPER if world.game.player == 1 else self.roles.role
        command.team.role, command.team.time_to_ball = role, self.roles.seconds
        why = ('nobody knows of the ball',) if ball is None else (
            'the ball is at ({}, {}), {} deg off', *ball, off_ahead(world, ball))
        command.trace.append((kelpie.LAYER_PLAYER, 'runner', kelpie.ROLE_NAMES[role], *why))


decide = Player().step
