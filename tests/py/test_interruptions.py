# SPDX-License-Identifier: Apache-2.0
"""After random worlds: no player stays for ever in a state that has an end, and whatever interrupts
it leaves nothing behind."""
import copy

import kelpie
import pytest
from players.ellipse_goalie import EllipseGoalie
from players.forward import Forward
from players.goalie import Goalie
from random_world import FRAME_S, RandomWorld


def longest_stays(player_of, machine_of, settle, seconds, seeds, **task):
    """The longest time (s) in each state of a machine, from random frames on, in worlds that stand
    still as `settle` leaves them."""
    longest = {}
    for seed in seeds:
        random, player = RandomWorld(seed, **task), player_of()
        command = kelpie.Command()
        for _ in range(400):
            command = player.step(random.next(command))
        world = random.world
        settle(world)
        for _ in range(int(seconds / FRAME_S)):
            world.time_s += FRAME_S
            world.ball.seconds_since_seen += FRAME_S
            player.step(world)
            machine = machine_of(player)
            name = machine.state.__name__
            longest[name] = max(longest.get(name, 0.0), machine.since(world))
    return longest


def alone(world):
    """Nothing runs, nobody is there, no ball is seen, believed or felt."""
    world.elapsed_s, world.odometry = FRAME_S, kelpie.Odometry()
    world.motion, world.game = kelpie.MotionStatus(), kelpie.GameState()
    world.percepts, world.ball = kelpie.Percepts(), kelpie.BallEstimate()
    world.opponents, world.obstacles, world.teammates = [], [], []
    world.team_ball = kelpie.TeamBall()


def test_without_a_ball_an_attacker_is_searching_again_after_its_time_outs():
    limits = {'play': 9.0, 'watch': 0.5, 'back_off': 0.9, 'localise': 0.5, 'avoid_box': 0.1}
    # With the mates its role as one of theirs goes, within three frames.
    limits |= dict.fromkeys(('bird_of_prey', 'get_out_of_way', 'go_home', 'avoid_ball',
                             'avoid_attacker', 'find_ball'), 0.1)
    longest = longest_stays(Forward, lambda player: player.role, alone, 10.0, range(40))
    assert set(longest) - {'find'} <= set(limits) and longest['find'] > 9.0
    for name in set(longest) - {'find'}:
        assert longest[name] <= limits[name] + 30.0 * 0.2, name


@pytest.mark.parametrize('make', [Goalie, EllipseGoalie])
def test_without_a_ball_a_goalie_guards_its_goal_again_after_its_time_outs(make):
    def settle(world):
        alone(world)
        world.pose.position.x, world.pose.position.y = 0.5 * world.field.width, 20.0
        world.pose.heading_deg = 90.0
        world.percepts.landmarks = [kelpie.LandmarkPercept(kind=kelpie.GOAL_BLUE)]
    longest = longest_stays(make, lambda player: player, settle, 14.0, range(20))
    assert longest.pop('guard') > 8.0
    assert all(seconds <= 6.0 for seconds in longest.values()), longest


# What a halt leaves behind

def answer(command):
    walk, head = command.walk, command.head
    return (walk.forward, walk.left, walk.turn_deg, walk.kind, head.neck_tilt_deg,
            head.head_pan_deg, head.head_nod_deg, head.aim, head.direction_deg, head.target.x,
            head.target.y, command.motion, command.mouth_open, command.trace)


@pytest.mark.parametrize('why', ['halted', 'fallen'])
def test_after_an_interruption_in_any_frame_a_forward_plays_like_a_new_one(why):
    """But for what its memory holds, which the new one gets, too."""
    interrupted_in = set()
    for seed in range(30):
        random, player = RandomWorld(seed), Forward()
        command = kelpie.Command()
        for _ in range(60 + 7 * seed):
            command = player.step(random.next(command))
        interrupted_in.add(player.role.state.__name__)
        world = random.world
        world.motion, world.game = kelpie.MotionStatus(), kelpie.GameState()
        if why == 'halted':
            world.game.penalised = True
        else:
            world.motion.feeling.fallen = kelpie.ON_LEFT
        stopped = player.step(world)
        assert stopped.walk.forward == stopped.walk.left == stopped.walk.turn_deg == 0.0
        new = Forward()
        new.memory.__dict__.update(copy.deepcopy(player.memory.__dict__))
        world.game.penalised, world.motion.feeling.fallen = False, kelpie.NOT_FALLEN
        for _ in range(40):
            random.next(command)
            world.motion, world.game = kelpie.MotionStatus(), kelpie.GameState()
            command = player.step(world)
            assert answer(command) == answer(new.step(world))
    assert {'find', 'play'} <= interrupted_in


def test_no_module_remembers_anything_from_one_player_to_the_next():
    def answers():
        random, player = RandomWorld(3), Forward()
        command, reported = kelpie.Command(), []
        for _ in range(300):
            command = player.step(random.next(command))
            reported.append(answer(command))
        return reported
    assert answers() == answers()
