# SPDX-License-Identifier: Apache-2.0
"""Players and skills in 100 000 frames of random worlds: nothing raises, every Command is one that
the host takes, and nobody is stuck in what cannot be interrupted."""
import copy

import kelpie
import pytest
from decisions import tree
from decisions.held_choice import HeldChoice
from players.challenger import Challenger
from players.ellipse_goalie import EllipseGoalie
from players.forward import Forward
from players.goalie import Goalie
from players.single import SKILLS, OneSkill
from random_world import FRAME_S, RandomWorld, check
from situation.contested import Contested
from situation.goal import OpponentGoal
from situation.memory import Memory
from skills.ball.dodge import Dodge
from skills.ball.dribble import Dribble
from skills.ball.find_ball import FindBall
from skills.ball.grab import Grab
from skills.ball.grab_dribble import GrabDribble
from skills.ball.kick_ball import KickBall
from skills.ball.line_up_kick import LineUpKick
from skills.head.active_localise import ActiveLocalise
from skills.walk.avoid_own_box import AvoidOwnBox
from skills.walk.go_to_point import GoToPoint
from skills.walk.look_round import LookRound
from skills.walk.paw_stuck import PawStuck
from skills.walk.roam import Roam

FRAMES = 2500   # of a world

# Players: how many worlds each, and the states (module and branch of the trace) that it must have
# been in, so that the attack reaches what it attacks.
PLAYERS = {
    'forward': (Forward, 15, {
        'attacker': {'find', 'play', 'back_off', 'avoid_box', 'watch'},
        'grab_dribble': {'grab', 'settle', 'turn', 'steady', 'kick', 'overdue'},
        'kick_ball': {'walk_up', 'kick'}, 'dribble': {'run'}, 'line_up_kick': {'approach'},
        'forward': {'plays', 'waits', 'gets_up', 'takes_place', 'attacker', 'striker', 'defender'},
        'striker': {'bird_of_prey', 'go_home', 'get_out_of_way', 'receive'},
        'defender': {'avoid_ball', 'avoid_attacker'}, 'find_together': {'follow', 'go'},
        'take_place': {'walk_there', 'set'}}),
    'forward_by_the_theses': (Forward, 5, {
        'grab_dribble': {'grab', 'settle', 'turn', 'kick', 'overdue', 'off_edge'},
        'kick_ball': {'walk_up', 'kick'}, 'dribble': {'run'}}),
    'goalie': (Goalie, 6, {'goalie': {'turn', 'clear', 'attack', 'guard', 'adjust'}}),
    'goalie_2004': (EllipseGoalie, 3, {'ellipse_goalie': {'guard', 'attack', 'clear'}}),
    'goalie_2004_paw': (lambda: EllipseGoalie(True), 1, {'ellipse_goalie': {'guard', 'attack'}}),
    'challenger': (Challenger, 2, {'challenger': {'find_out', 'go_to_stand', 'waits'}}),
    'one_skill': (OneSkill, 2, {})}

FREE_KICKS = [kick for kick, reported in kelpie.KICKS.items() if reported.leaf]


def rules_of(name):
    return kelpie.RULES_OF_THESIS if 'theses' in name else kelpie.RULES_OF_KELPIE


def grab_dribble(random, memory):
    choose = HeldChoice(memory, Contested()).choose
    return GrabDribble(memory, choose, random.pick(tree.WITH_GRAB))


def any_kick(random, memory):
    return KickBall(memory, random.pick(list(FREE_KICKS)))


def any_dribble(random, memory):
    return Dribble(memory, lambda world: random.between(-180.0, 180.0))


def any_line_up(random, memory):
    return LineUpKick(memory, random.goal)


# Skills that end by themselves or can be interrupted: how many worlds each, the states that it must
# have been in, and the seconds after which it is not committed any more while the world stands.
ENDING = {
    'grab_dribble': (grab_dribble, 2, {'grab', 'settle', 'turn', 'steady', 'kick', 'overdue',
                                       'off_edge', 'ended'}, 8.5),
    'grab_dribble_by_the_theses': (grab_dribble, 2, {
        'grab', 'settle', 'turn', 'kick', 'overdue', 'off_edge', 'ended'}, 8.5),
    'grab': (lambda random, memory: Grab(memory), 1, {'approach', 'grab', 'finished'}, 2.1),
    'kick_ball': (any_kick, 1, {'walk_up', 'kick', 'ended'}, 5.1),
    'dribble': (any_dribble, 1, {'run', 'ended'}, 0.1),
    'line_up_kick': (any_line_up, 2, {'approach', 'line_up', 'look_for_goal', 'regain',
                                      'strike'}, 13.2)}

# Skills without an end: the player leaves them.
ENDLESS = {
    'find_ball': (lambda random, memory: FindBall(random.world, memory), 2),
    'dodge': (lambda random, memory: Dodge(random.world, memory), 1),
    'avoid_own_box': (lambda random, memory: AvoidOwnBox(memory), 1),
    'look_round': (lambda random, memory: LookRound(), 1),
    'go_to_point': (lambda random, memory: GoToPoint((100.0, 100.0), 3.0), 1)}


def test_the_attack_has_100000_frames():
    worlds = sum(entry[1] for table in (PLAYERS, ENDING, ENDLESS) for entry in table.values())
    assert worlds * FRAMES >= 100000


@pytest.mark.parametrize('name', PLAYERS)
def test_no_world_stops_a_player(name):
    make, worlds, wanted = PLAYERS[name]
    met = {}
    for seed in range(worlds):
        random = RandomWorld(seed, 'goalie' in name, skill=seed, rules=rules_of(name))
        player = make()
        command = kelpie.Command()
        for _ in range(FRAMES):
            command = player.step(random.next(command))
            check(command)
            for _, module, branch, *_ in command.trace:
                met.setdefault(module, set()).add(branch)
    for module, branches in wanted.items():
        assert branches <= met[module], (module, branches - met[module])


class Driven:
    """A skill in a random world, begun anew when it has ended, or in the middle now and then."""

    def __init__(self, make, seed, name=''):
        self.random, self.memory = RandomWorld(seed, rules=rules_of(name)), Memory()
        self.random.goal = OpponentGoal()
        self.make, self.command = make, kelpie.Command()
        self.skill = make(self.random, self.memory)
        self.met = set()

    def step(self, world):
        self.memory.update(world)
        self.random.goal.update(world)
        self.command = self.skill.step(world)
        trace = []
        if hasattr(self.skill, 'state'):
            self.met.add(self.skill.state.__name__)
        self.skill.explain(trace)
        self.command.trace = trace
        check(self.command)

    def frame(self):
        world = self.random.next(self.command)
        if self.random.often(0.002) or getattr(self.skill, 'done', False) is True:
            self.skill = self.make(self.random, self.memory)
        self.step(world)


@pytest.mark.parametrize('name', ENDING)
def test_no_world_stops_a_skill_or_keeps_it_committed(name):
    """In a world that stands still (a ball or none, a motion that runs for ever or none) it can be
    interrupted after its time-outs at the latest."""
    make, worlds, wanted, limit_s = ENDING[name]
    met = set()
    for seed in range(worlds):
        driven = Driven(make, seed, name)
        for frame in range(FRAMES):
            driven.frame()
            if frame % 100 == 99 and getattr(driven.skill, 'committed', False):
                assert seconds_until_free(driven) <= limit_s
        met |= driven.met
    assert wanted <= met


def seconds_until_free(driven):
    """In a copy of the world and of the skill."""
    twin = copy.deepcopy(driven)
    world, begun_s = twin.random.world, twin.random.world.time_s
    world.elapsed_s, world.odometry = FRAME_S, kelpie.Odometry()
    while twin.skill.committed and world.time_s < begun_s + 60.0:
        world.time_s += FRAME_S
        world.ball.seconds_since_seen += FRAME_S
        twin.step(world)
    return world.time_s - begun_s


@pytest.mark.parametrize('name', ENDLESS)
def test_no_world_stops_a_skill_without_an_end(name):
    make, worlds = ENDLESS[name]
    for seed in range(worlds):
        driven = Driven(make, seed)
        for _ in range(FRAMES):
            driven.frame()


def test_no_world_stops_what_takes_head_or_legs_for_a_moment():
    random, memory, stuck = RandomWorld(6), Memory(), PawStuck()
    looks, roam, command = ActiveLocalise(memory), Roam(random.world), kelpie.Command()
    looked = backed = 0
    for _ in range(FRAMES):
        world = random.next(command)
        memory.update(world)
        if random.often(0.1):
            memory.spin_lost, memory.ball_run = 10, 9
        if looks.needed(world):
            looks.start(world)
            while not looks.done:
                command = kelpie.Command(head=looks.step(world))
                check(command)
                world = random.next(command)
                memory.update(world)
                looked += 1
        command = stuck.step(world) if stuck.needed(world) else roam.step(world)
        backed += stuck.state != stuck.free
        check(command)
    assert looked > 10 and backed > 10


def test_every_skill_that_can_be_drawn_is_attacked():
    """OneSkill asks them by number; the worlds above ask for the first two only."""
    for number in range(len(SKILLS) + 1):
        random, player = RandomWorld(number, skill=number), OneSkill()
        command = kelpie.Command()
        for _ in range(100):
            command = player.step(random.next(command))
            check(command)
