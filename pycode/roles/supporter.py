# SPDX-License-Identifier: Apache-2.0
# Who does not play the ball: striker, supporter or defender (thesis 2006 sections 4.3.3 and 4.3.4,
# algorithm 4.4). In every frame the first rule that holds says what it does; roles differ in their
# home alone. Keeps the state, its skills, the home and where the team has the ball. It never
# interrupts anybody: what it does may end in any frame.
import math

import kelpie
from arbiter.rules import RuleMachine
from decisions.home import Home
from decisions.roles import NAMES
from lib import rulebook
from lib.geom import from_field
from lib.paths import bearing_of
from lib.steer import facing, filtered
from safety.own_box import outside_box
from situation import keep_off, time_to
from situation.time_to import heard_of
from situation.possession import Possession
from skills.ball import challenge
from skills.ball.challenge import Challenge
from skills.ball.find_ball import FindBall
from skills.ball.find_together import FindTogether
from skills.head.watch_play import WatchPlay
from skills.walk.avoid_attacker import AvoidAttacker
from skills.walk.bird_of_prey import BirdOfPrey
from skills.walk.get_out_of_way import GetOutOfWay
from skills.walk.paw_stuck import PawStuck, paw_pushes
from skills.walk.run_to import RunTo

LOST_FRAMES = 40           # facts-2005 section 7.1: "anywhere"
FAR = 100.0                # cm from home: Bird of Prey, which ends within
BIRD_END = 30.0            # (facts-2005 section 7.2)
ARRIVED = 15.0  # cm,
LEFT = 30.0  # cm; circles of the same section
TURN_FROM = 25.0  # deg,
TURN_UNTIL = 8.0  # deg from the ball, who stands


class SupporterSituation:
    """What a supporter decides by in one frame, in cm and places of the field."""

    def __init__(self, world, memory, role, possession):
        self.world, self.memory = world, memory
        self.role, self.possession = role, possession.now
        reported = heard_of(world)
        self.ball = reported or time_to.ball_of(world, memory.ball_lost)
        # The team has the ball that this robot has lost: it need not look for it.
        self.reported = reported is not None and rulebook.of(world).HEARS_OF_BALL
        # By the play nobody's place lies in the attacker's way, and nobody leaves it for another.
        self.by_play = rulebook.follows_play(world)
        self.lanes = [] if self.by_play else keep_off.lanes(world, self.ball)
        self.home, self.away = None, 0.0   # the place, and how far it is
        self.paw_pushes = False
        self.held = None                   # GetOutOfWay, which knows who holds the ball

    def lane(self, kind, leaves):
        """The attacker's lane of a kind that it stands in, or None. `leaves`: it leaves it."""
        return AvoidAttacker.lane(self.world, self.lanes, kind, leaves)


def mate_passes(now, playing):
    """Who is to get the ball waits for it: it is in the way on purpose."""
    player, receives = now.world.game.player, rulebook.of(now.world).RECEIVES
    passes = any(mate.note.pass_to == player for mate in now.world.teammates)
    return ('a mate plays the ball to it',) if receives and passes else None


def mate_holds(now, playing):
    lane = now.held.lane_to_leave(now.world, playing == 'get_out_of_way')
    return ('a mate holds the ball',) if lane is not None else None


def mate_has_ball(now, playing):
    lane = now.lane(keep_off.HAS_BALL, playing == 'avoid_ball')
    return ('the attacker has the ball',) if lane is not None else None


def bird_flies(now, playing):
    flies = playing == 'bird_of_prey' and now.away > BIRD_END
    return ('home is {} cm away', now.away) if flies else None


def mate_comes(now, playing):
    lane = now.lane(keep_off.ON_WAY, playing == 'avoid_attacker')
    return ('in the attacker\'s way to the ball',) if lane is not None else None


def takes_ball(now, playing):
    """Of the defender alone: who attacks runs after it, and the third comes back behind it."""
    defends = now.role == kelpie.DEFENDER and rulebook.of(now.world).CHALLENGES
    theirs = defends and now.by_play and now.possession == kelpie.THEIRS
    steps_in = theirs and challenge.within_reach(now.world, playing == 'challenge')
    return ('they have the ball, {} cm away', now.world.ball.distance) if steps_in else None


def play_goes_on(now, playing):
    known = now.ball is not None and (now.reported or now.memory.ball_lost <= LOST_FRAMES)
    return ('its place is {} cm away', now.away) if now.by_play and known else None


def home_is_far(now, playing):
    return ('home is {} cm away', now.away) if now.away > FAR else None


def ball_is_lost(now, playing):
    lost = now.memory.ball_lost
    unknown = lost > LOST_FRAMES and not now.reported
    return ('ball unseen for {} frames', float(lost)) if unknown else None


def goes_home(now, playing):
    return 'home is {} cm away', now.away


class Supporter(RuleMachine):
    LAYER = kelpie.LAYER_ROLE
    RULES = (
        (paw_pushes, 'back_off'),
        (mate_passes, 'receive'),
        (takes_ball, 'challenge'),
        (play_goes_on, 'run_along'),
        (mate_holds, 'get_out_of_way'),
        (mate_has_ball, 'avoid_ball'),
        (bird_flies, 'bird_of_prey'),
        (mate_comes, 'avoid_attacker'),
        (home_is_far, 'bird_of_prey'),
        (ball_is_lost, 'find_ball'),
        (goes_home, 'go_home'))
    WALKED = (outside_box,)   # what is left of a walk, but of backing off
    pass_to = 0

    def __init__(self, memory, role, possession=None):
        super().__init__(self.go_home)
        self.NAME, self.role = NAMES[role], role
        self.memory = memory
        self.possession = possession or Possession(memory)
        self.stuck = PawStuck()
        self.watch = WatchPlay(memory)
        self.home_of = Home()
        self.bird, self.avoid, self.run = BirdOfPrey(), AvoidAttacker(), RunTo()
        self.out_of_way = GetOutOfWay(role)
        self.team_search = FindTogether(memory, False)
        self.now = None                 # SupporterSituation of this frame
        self.moving, self.turning = True, False

    @property
    def home(self):
        return self.now.home

    def step(self, world) -> kelpie.Command:
        self.now = now = SupporterSituation(world, self.memory, self.role,
                                            self.possession)
        now.home = self.home_of.update(world, self.role, now.ball, now.lanes)
        now.away = math.hypot(*from_field(world.pose, *now.home))
        now.paw_pushes = self.stuck.needed(world)
        now.held = self.out_of_way
        self.out_of_way.update(now.lanes)
        self.choose(world, now)
        command = super().step(world)
        if self.state != self.back_off:
            command.walk = filtered(now, command.walk, self.WALKED)
        return command

    def skill_of(self, name, now):
        if name == 'find_ball':
            self.team_search = FindTogether(self.memory, False)
            return FindBall(now.world, self.memory)
        return {'back_off': self.stuck, 'get_out_of_way': self.out_of_way,
                'avoid_ball': self.avoid, 'avoid_attacker': self.avoid,
                'bird_of_prey': self.bird, 'challenge': Challenge(self.memory),
                'run_along': self.run}.get(name)

    def wanted(self, world):
        """Where it goes on the field: home."""
        return self.now.home

    # States

    def back_off(self, world) -> kelpie.Command:
        return self.stuck.step(world)

    def receive(self, world) -> kelpie.Command:
        return self.walking(world, facing((0.0, 0.0), bearing_of(world, self.now.ball)))

    def get_out_of_way(self, world) -> kelpie.Command:
        return self.walking(world, self.out_of_way.step(
            world, (self.out_of_way.lane_to_leave(world, True), self.now.ball)))

    def avoid_ball(self, world) -> kelpie.Command:
        return self.leave(world, keep_off.HAS_BALL)

    def avoid_attacker(self, world) -> kelpie.Command:
        return self.leave(world, keep_off.ON_WAY)

    def leave(self, world, kind) -> kelpie.Command:
        lane = self.now.lane(kind, True)
        return self.walking(world, self.avoid.step(world, (lane, self.now.ball)))

    def bird_of_prey(self, world) -> kelpie.Command:
        return self.walking(world, self.bird.step(world, self.now.home))

    def run_along(self, world) -> kelpie.Command:
        return self.walking(world, self.run.step(world, (self.now.home, self.now.ball)))

    def challenge(self, world) -> kelpie.Command:
        return self.skill.step(world)

    def find_ball(self, world) -> kelpie.Command:
        together = self.team_search.step(world) if len(world.teammates) > 0 else None
        return together if together is not None else self.skill.step(world)

    def go_home(self, world) -> kelpie.Command:
        """The last steps in any direction with the ball in view; then stands and faces it."""
        self.moving = self.now.away > (ARRIVED if self.moving else LEFT)
        turn_deg = self.home_of.turn_deg(world, self.now.ball)
        if self.moving:
            return self.walking(world, facing(from_field(world.pose, *self.now.home), turn_deg))
        self.turning = abs(turn_deg) > (TURN_UNTIL if self.turning else TURN_FROM)
        return self.walking(world, facing((0.0, 0.0), turn_deg if self.turning else 0.0))

    def walking(self, world, walk) -> kelpie.Command:
        return kelpie.Command(walk=walk, head=self.watch.step(world, self.now.ball))

    def explain(self, trace) -> None:
        trace.append((self.LAYER, self.NAME, self.state.__name__, self.why, *self.numbers))
        if self.state == self.find_ball and self.team_search.active:
            self.team_search.explain(trace)
        elif self.skill is not None:
            self.skill.explain(trace)
        if self.state not in (self.find_ball, self.back_off):
            self.watch.explain(trace)
