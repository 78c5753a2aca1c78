# SPDX-License-Identifier: Apache-2.0
"""The search for the ball, the head on it and looks at landmarks by the theses' rules alone (thesis
2006 sections 6.2.1, 6.2.2 and 4.3.2), and by Kelpie's where those differ."""
import math

import kelpie
import pytest
from books import both, by
from ideal_world import IdealWorld
from lib import hints
from players.forward import Forward
from roles.attacker import Attacker
from situation.memory import Memory
from situations import world
from skills.ball.find_ball import FindBall
from skills.ball.find_together import FindTogether
from skills.ball.kick_ball import KickBall
from skills.head.active_localise import ActiveLocalise
from skills.head.glance import Glance
from skills.head.track_ball import TrackBall
from test_active_localise import scene

FRAME_S = 1.0 / 30.0
UNKNOWN = None


class Search:
    """A robot that stands at (180, 100) and has lost a ball ahead; it is believed `away` cm
    ahead, or nobody knows where. The legs turn and back as they are told."""

    def __init__(self, book, away=150.0, nod=45.0, lost=1):
        made = world(180.0, 100.0, 90.0, (180.0, 100.0 + (away or 150.0)))
        self.world = by(made, book)
        self.world.head.head_nod_deg = nod
        self.world.ball.present = away is not None
        self.memory = Memory()
        self.memory.update(self.world)
        self.skill = FindBall(self.world, self.memory)
        self.world.percepts.ball.present = False
        for _ in range(lost - 1):
            self.memory.update(self.world)

    def next(self, frames=1):
        made = self.world
        for _ in range(frames):
            made.time_s += FRAME_S
            self.memory.update(made)
            command = self.skill.step(made)
            made.last_command = command
            made.odometry.turn_deg = command.walk.turn_deg * FRAME_S
        return command

    def steps(self, frames):
        """The steps of the chain in so many frames, each once where it follows itself."""
        found = []
        for _ in range(frames):
            self.next()
            name = self.skill.state.__name__
            if not found or found[-1] != name:
                found.append(name)
        return found


# Figure 6.2

@both('away, nod, frames', [
    # Nobody knows where: the scan of one second, then the spin, which has no end.
    (UNKNOWN, 45.0, 700, ['last_seen', 'scan', 'spin'], ['last_seen', 'scan', 'spin', 'roam']),
    # Four frames at the last place, where gps has it up to the 25th, a second of scan.
    (150.0, 45.0, 100, ['last_seen', 'belief', 'scan', 'spin'],
     ['last_seen', 'belief', 'scan', 'spin']),
    # Nearer than 40 cm it steps back before it scans.
    (35.0, 45.0, 60, ['last_seen', 'belief', 'back_off'], ['last_seen', 'belief', 'back_off']),
    # As long as the ball is believed so near.
    (35.0, 45.0, 120, ['last_seen', 'belief', 'back_off'],
     ['last_seen', 'belief', 'back_off', 'scan', 'spin']),
    # Images that show the place and no ball say nothing.
    (100.0, 0.0, 20, ['last_seen', 'belief'], ['last_seen', 'scan'])])
def test_the_eight_steps_follow_each_other(away, nod, frames, book, answer):
    assert Search(book, away, nod).steps(frames) == answer


@both('', [('back_off', 'scan')])
def test_from_a_ball_that_was_kicked_away_it_backs_off_too(book, answer):
    search = Search(book, 35.0, lost=27)
    search.memory.hint = (50.0, 30.0, search.memory.frame - 20)
    search.next()
    assert search.skill.state.__name__ == answer


@both('', [('hint', 'belief')])
def test_a_hint_holds_whatever_images_show(book, answer):
    search = Search(book, 300.0, nod=-10.0, lost=6)
    search.memory.set_hint(*hints.GRAB)
    search.next(12)
    assert search.skill.state.__name__ == answer


# Algorithm 6.2

@both('away', [(300.0, 55.0, 110.0), (20.0, 60.5, 121.0), (70.0, 57.75, 115.5)])
def test_a_spin_is_as_fast_as_algorithm_6_2_has_it(away, book, answer):
    search = Search(book, away, lost=30)
    search.skill.backed = 45
    search.skill.scanned = 30
    walk = search.skill.spin(search.world).walk
    assert walk.turn_deg == pytest.approx(answer) and walk.forward == walk.left == 0.0


@pytest.mark.parametrize('away, pan, down', [(300.0, 45.0, 10.0), (100.0, 30.0, 20.0)])
def test_the_head_is_locked_ahead_of_the_spin(away, pan, down):
    """Kelpie's goes on to the next direction that no image showed."""
    search = Search('thesis', away, lost=30)
    head = search.skill.spin(search.world).head
    assert head.head_pan_deg == pan and head.neck_tilt_deg + head.head_nod_deg == -down


@both('', [(False, True)])
def test_a_scan_moves_the_head_alone(book, answer):
    search = Search(book, UNKNOWN, lost=5)
    turns = []
    for _ in range(30):
        pan = search.next().head.head_pan_deg
        search.world.head.head_pan_deg += max(-12.0, min(12.0, pan -
                                                         search.world.head.head_pan_deg))
        turns.append(search.world.last_command.walk.turn_deg != 0.0 and
                     search.skill.state == search.skill.scan)
    assert answer or not any(turns)


def test_a_scan_has_the_cranes_of_the_thesis_and_all_pans_without_a_belief():
    search = Search('thesis', UNKNOWN, lost=5)
    head = search.next().head
    assert abs(head.head_pan_deg) == 88.0 and head.neck_tilt_deg + head.head_nod_deg == -10.0


# Use force

def kicked(book, which):
    made = by(world(ball=(180.0, 240.0)), book)
    memory = Memory()
    memory.update(made)
    player = Attacker(memory)
    player.skill = KickBall(memory, which)
    memory.set_hint(*(kelpie.KICKS[which].hint or (50.0, 0.0)))
    search = player.after_skill(made)
    made.percepts.ball.present = False
    memory.update(made)
    return search, search.step(made)


@both('which, direction', [
    (kelpie.UPENN_LEFT, 30.0, 'forced', 'hint'), (kelpie.UPENN_RIGHT, -30.0, 'forced', 'hint'),
    (kelpie.HEAD_SWIPE_LEFT, 30.0, 'forced', 'hint')])
def test_after_a_kick_the_robot_is_forced_to_look_where_the_ball_goes(which, direction, book,
                                                                      answer):
    search, command = kicked(book, which)
    target = command.head.target
    assert search.state.__name__ == answer
    assert math.degrees(math.atan2(-target.x, target.y)) == pytest.approx(direction, abs=0.1)


def test_a_forced_look_ends_with_its_timer():
    search, _ = kicked('thesis', kelpie.UPENN_LEFT)
    made, memory = world(), search.memory
    made.task.rules = kelpie.RULES_OF_THESIS
    made.percepts.ball.present, steps = False, []
    for _ in range(20):
        memory.update(made)
        search.step(made)
        steps.append(search.state.__name__)
    assert steps[10] == 'forced' and steps[11] != 'forced'


# Distributed find ball, section 6.2.2.1

def mate(player, role, x):
    return kelpie.TeammateEstimate(
        player=player, note=kelpie.TeamNote(role=role, time_to_ball=5.0),
        pose=kelpie.Pose2(position=kelpie.Point2(x=x, y=350.0), heading_deg=90.0))


def searching(book, y=162.0):
    made = by(world(180.0, y), book)
    made.game.player = 2
    made.ball.present = made.percepts.ball.present = False
    made.teammates = [mate(3, kelpie.ATTACKER, 100.0), mate(4, kelpie.STRIKER, 300.0)]
    memory = Memory()
    memory.ball_lost = 200
    return FindTogether(memory, False), made


@both('', [(55.0, 110.0)])
def test_at_its_place_of_the_teams_search_it_spins(book, answer):
    skill, made = searching(book)
    skill.step(made)
    assert skill.step(made).walk.turn_deg == pytest.approx(answer)


@both('', [(True, False)])
def test_it_spins_there_until_somebody_sees_the_ball(book, answer):
    skill, made = searching(book)
    for frame in range(300):
        made.time_s = frame * FRAME_S
        spins = skill.step(made) is not None
    assert spins is answer
    made.team_ball = kelpie.TeamBall(present=True, position=kelpie.Point2(x=180.0, y=162.0))
    assert skill.step(made) is None


@both('', [(None, 'follow')])
def test_a_ball_that_a_mate_sees_is_not_walked_to(book, answer):
    skill, made = searching(book)
    made.team_ball = kelpie.TeamBall(present=True, position=kelpie.Point2(x=180.0, y=400.0))
    command = skill.step(made)
    assert (command and skill.state.__name__) == answer


def test_the_teams_search_is_the_theses_own_whatever_the_switch():
    skill, made = searching('thesis')
    made.task.distributed_find = False
    assert skill.step(made) is not None and skill.place == pytest.approx((180.0, 162.0))


# The head on the ball, section 6.2.1

def tracked(book, off_deg):
    """deg between ball and view, of a robot in mid-field that has the ball so far aside."""
    x = 180.0 + 150.0 * math.tan(math.radians(off_deg))
    made = by(world(180.0, 250.0, 90.0, (x, 400.0)), book)
    made.percepts.ball.centre.y, made.percepts.ball.radius = 0.0, 1.0   # its top is out of view
    target = TrackBall().step(made).target
    return math.degrees(math.atan2(-target.x, target.y)) - made.ball.heading_deg


def test_the_head_looks_at_the_ball_and_not_beside_it():
    off = {book: max(abs(tracked(book, x)) for x in range(-40, 41, 4))
           for book in ('kelpie', 'thesis')}
    assert off['thesis'] < 1e-6 and off['kelpie'] > 1.0


@both('', [(0.0, -8.0)])
def test_the_head_looks_where_the_ball_was_seen(book, answer):
    """Turning 2 deg to the left a frame."""
    made = by(world(180.0, 250.0, 90.0, (180.0, 270.0)), book)
    made.percepts.ball.centre.y, made.percepts.ball.radius = 0.0, 1.0
    made.odometry.turn_deg = 2.0
    target = TrackBall().step(made).target
    assert math.degrees(math.atan2(-target.x, target.y)) == pytest.approx(answer, abs=0.1)


# Active localisation, section 4.3.2

@both('', [(False, True)])
def test_an_attacker_does_not_look_away_as_it_walks(book, answer):
    made = by(world(180.0, 250.0, ball=(180.0, 400.0)), book)
    memory = Memory()
    for _ in range(90):
        memory.update(made)
    assert Glance(memory).takes_head(made, True) is answer


@both('', [(True, False)])
def test_an_attacker_that_spun_for_a_far_ball_looks_at_a_landmark_then(book, answer):
    """Kelpie's has glanced at one as it saw the ball, and need not."""
    made, memory = scene()
    by(made, book)
    made.percepts.ball.present = True
    memory.ball_run, glance, looks = 9, Glance(memory), ActiveLocalise(memory)
    memory.localised_lost = 80
    if glance.takes_head(made, True):
        glance.step(made)
    memory.update(made)
    assert looks.needed(made) is answer


def played(book, frames=240):
    """The states of an attacker and whether it glances, with the ball 220 cm behind it."""
    ideal, player, states, glances = IdealWorld(3), Forward(), set(), 0
    ideal.at, ideal.ball, ideal.facing = complex(180, 120), complex(180, 340), -1j
    ideal.see()
    for _ in range(frames):
        ideal.step(player.step(by(ideal.world, book)))
        states.add(player.role.state.__name__)
        glances += player.role.glance.looking
    return states, glances


def test_in_play_an_attacker_of_the_thesis_looks_at_a_landmark_after_its_spin():
    states, glances = played('thesis')
    assert 'localise' in states and glances == 0
    states, glances = played('kelpie')
    assert 'localise' not in states and glances > 0
