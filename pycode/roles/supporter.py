# SPDX-License-Identifier: Apache-2.0
# Who does not play the ball: striker, supporter or defender (thesis 2006 sections 4.3.3 and 4.3.4,
# algorithm 4.4). In every frame the first rule that holds says what it does; roles differ in their
# home alone. Keeps the state, its skills, the home and where the team has the ball. It never
# interrupts anybody: what it does may end in any frame.
import math

import kelpie
from arbiter.machine import Machine
from decisions.home import Home
from decisions.roles import NAMES
from lib.geom import from_field
from lib.steer import facing
from lib.ways import aside_of
from situation import keep_off, time_to
from skills.ball.find_ball import FindBall
from skills.ball.find_together import FindTogether, heard_of
from skills.head.watch_play import WatchPlay
from skills.walk.avoid_attacker import AvoidAttacker
from skills.walk.avoid_own_box import clear_of, held_off
from skills.walk.bird_of_prey import BirdOfPrey
from skills.walk.get_out_of_way import GetOutOfWay
from skills.walk.paw_stuck import PawStuck

LOST_FRAMES = 40           # facts-2005 section 7.1: "anywhere"
FAR = 100.0                # cm from home: Bird of Prey, which ends within
BIRD_END = 30.0            # (facts-2005 section 7.2)
ARRIVED, LEFT = 15.0, 30.0     # cm; circles of the same section
TURN_FROM, TURN_UNTIL = 25.0, 8.0   # deg from the ball, who stands
BOX_MARGIN = 10.0          # cm that the neck base stays away from the own box,
BOX_NEAR = 45.0            # minded from so near, what the fast walk goes in a second


class Supporter(Machine):
    LAYER = kelpie.LAYER_ROLE
    committed = False
    pass_to = 0

    def __init__(self, memory, role):
        super().__init__(self.go_home)
        self.NAME, self.role = NAMES[role], role
        self.memory = memory
        self.stuck = PawStuck()
        self.watch = WatchPlay(memory)
        self.home_of = Home()
        self.bird, self.avoid = BirdOfPrey(), AvoidAttacker()
        self.out_of_way = GetOutOfWay(role)
        self.team_search = FindTogether(memory, False)
        self.ball, self.home, self.lane = None, None, None
        self.away = 0.0                 # cm from home
        self.moving, self.turning = True, False

    def step(self, world) -> kelpie.Command:
        told = heard_of(world)
        self.ball = told if told is not None else time_to.ball_of(world, self.memory.ball_lost)
        lanes = keep_off.lanes(world, self.ball)
        self.home = self.home_of.update(world, self.role, self.ball, lanes)
        self.away = math.hypot(*from_field(world.pose, *self.home))
        self.choose(world, lanes)
        command = super().step(world)
        if self.state != self.back_off:
            kept_out_of_box(world, command.walk)
        return command

    def wanted(self, world):
        """Where it goes on the field: home."""
        return self.home

    # Algorithm 4.4: the first rule that holds

    def choose(self, world, lanes):
        if self.stuck.needed(world):
            return self.take(world, self.back_off, self.stuck, 'a front paw pushes at something')
        for rule in (self.mate_passes, self.mate_holds, self.mate_has_ball, self.bird_flies,
                     self.mate_comes, self.is_far, self.has_lost):
            if rule(world, lanes):
                return None
        return self.take(world, self.go_home, None, 'home is {} cm away', self.away)

    def take(self, world, state, skill, why, *numbers) -> bool:
        if self.state != state:
            self.enter(world, state, skill, why, *numbers)
        return True

    def mate_passes(self, world, lanes) -> bool:
        """Who is to get the ball waits for it: it is in the way on purpose."""
        player = world.game.player
        return (any(mate.note.pass_to == player for mate in world.teammates) and
                self.take(world, self.receive, None, 'a mate plays the ball to it'))

    def mate_holds(self, world, lanes) -> bool:
        lane = self.out_of_way.lane_of(world, lanes, self.state == self.get_out_of_way)
        return lane is not None and self.leave(world, self.get_out_of_way, self.out_of_way, lane,
                                               'a mate holds the ball')

    def mate_has_ball(self, world, lanes) -> bool:
        lane = self.avoid.lane(world, lanes, keep_off.HAS_BALL, self.state == self.avoid_ball)
        return lane is not None and self.leave(world, self.avoid_ball, self.avoid, lane,
                                               'the attacker has the ball')

    def bird_flies(self, world, lanes) -> bool:
        return self.state == self.bird_of_prey and self.away > BIRD_END

    def mate_comes(self, world, lanes) -> bool:
        lane = self.avoid.lane(world, lanes, keep_off.ON_WAY, self.state == self.avoid_attacker)
        return lane is not None and self.leave(world, self.avoid_attacker, self.avoid, lane,
                                               'in the attacker\'s way to the ball')

    def leave(self, world, state, skill, lane, why) -> bool:
        self.lane = lane
        return self.take(world, state, skill, why)

    def is_far(self, world, lanes) -> bool:
        return self.away > FAR and self.take(world, self.bird_of_prey, self.bird,
                                             'home is {} cm away', self.away)

    def has_lost(self, world, lanes) -> bool:
        if self.memory.ball_lost <= LOST_FRAMES or heard_of(world) is not None:
            return False
        if self.state != self.find_ball:
            self.team_search = FindTogether(self.memory, False)
            self.enter(world, self.find_ball, FindBall(world, self.memory),
                       'ball unseen for {} frames', float(self.memory.ball_lost))
        return True

    # States

    def back_off(self, world) -> kelpie.Command:
        return self.stuck.step(world)

    def receive(self, world) -> kelpie.Command:
        return self.walking(world, facing((0.0, 0.0), aside_of(world, self.ball)))

    def get_out_of_way(self, world) -> kelpie.Command:
        return self.walking(world, self.out_of_way.step(world, (self.lane, self.ball)))

    def avoid_ball(self, world) -> kelpie.Command:
        return self.walking(world, self.avoid.step(world, (self.lane, self.ball)))

    def avoid_attacker(self, world) -> kelpie.Command:
        return self.walking(world, self.avoid.step(world, (self.lane, self.ball)))

    def bird_of_prey(self, world) -> kelpie.Command:
        return self.walking(world, self.bird.step(world, self.home))

    def find_ball(self, world) -> kelpie.Command:
        together = self.team_search.step(world) if len(world.teammates) > 0 else None
        return together if together is not None else self.skill.step(world)

    def go_home(self, world) -> kelpie.Command:
        """The last steps in any direction with the ball in view; then stands and faces it."""
        self.moving = self.away > (ARRIVED if self.moving else LEFT)
        aside = self.home_of.aside(world, self.ball)
        if self.moving:
            return self.walking(world, facing(from_field(world.pose, *self.home), aside))
        self.turning = abs(aside) > (TURN_UNTIL if self.turning else TURN_FROM)
        return self.walking(world, facing((0.0, 0.0), aside if self.turning else 0.0))

    def walking(self, world, walk) -> kelpie.Command:
        return kelpie.Command(walk=walk, head=self.watch.step(world, self.ball))

    def explain(self, trace) -> None:
        trace.append((self.LAYER, self.NAME, self.state.__name__, self.why, *self.numbers))
        if self.state == self.find_ball and self.team_search.active:
            self.team_search.explain(trace)
        elif self.skill is not None:
            self.skill.explain(trace)
        if self.state not in (self.find_ball, self.back_off):
            self.watch.explain(trace)


def kept_out_of_box(world, walk) -> None:
    """Takes from a walk what would lead into the own box within a second: only one may defend
    there, the goalie. Who is inside already walks on as it is."""
    place = world.pose.position
    left, right, top = clear_of(world.field, BOX_MARGIN)
    inside = left < place.x < right and place.y < top
    if place.y > top + BOX_NEAR or inside:
        return
    angle = math.radians(world.pose.heading_deg)
    sine, cosine = math.sin(angle), math.cos(angle)
    vx = walk.forward * cosine - walk.left * sine
    vy = walk.forward * sine + walk.left * cosine
    vx, vy = held_off(left, right, top, place.x, place.y, vx, vy)
    walk.forward, walk.left = vx * cosine + vy * sine, vy * cosine - vx * sine
