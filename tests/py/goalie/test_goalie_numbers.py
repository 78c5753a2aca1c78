# SPDX-License-Identifier: Apache-2.0
"""The goalies' rules and their walks to the ball, in numbers. The box of 2006 is 130 cm wide and 65
deep, the mouth 80 cm wide about x = 180."""
import math
from types import SimpleNamespace

import kelpie
import pytest
from decisions import goalie_rules
from goalie_world import scene, world_at
from players.ellipse_goalie import EllipseGoalie, attack_due, attack_failed
from players.ellipse_goalie import attacks as attacks_2004
from players.goalie import Goalie
from players.halted import Halted
from situation.memory import Memory
from skills.ball.attack_ball import AttackBall
from skills.motion.get_up import GetUp


# A ball that comes

@pytest.mark.parametrize('x, stops_y, speed, y, comes', [
    (180.0, 0.0, 11.0, 22.0, True), (180.0, 0.0, 9.0, 22.0, False), (234.0, 0.0, 20.0, 22.0, True),
    (236.0, 0.0, 20.0, 22.0, False), (126.0, 0.0, 20.0, 22.0, True),
    (124.0, 0.0, 20.0, 22.0, False), (180.0, 24.0, 20.0, 22.0, True),
    (180.0, 26.0, 20.0, 22.0, False), (180.0, 0.0, 100.0, 120.0, True)])
def test_a_ball_of_10_cm_a_second_within_15_of_the_mouth_that_stops_25_short_at_most_is_met(
        x, stops_y, speed, y, comes):
    made = scene(complex(x, y), at=180 + 20j).world
    made.ball.velocity = kelpie.Point2(x=0.0, y=-speed)
    made.ball.stopping_point = kelpie.Point2(x=x, y=stops_y)
    now = SimpleNamespace(world=made, sees=lambda: True, seen_since_motion=True)
    assert (goalie_rules.ball_comes(now, 'guard') is not None) is comes
    for name, value in (('sees', lambda: False), ('seen_since_motion', False)):
        blind = SimpleNamespace(**{**vars(now), name: value})
        assert goalie_rules.ball_comes(blind, 'guard') is None


@pytest.mark.parametrize('seconds, comes', [(3.9, True), (4.1, False)])
def test_a_ball_that_takes_4_s_does_not_come_yet(monkeypatch, seconds, comes):
    shot = SimpleNamespace(seconds=seconds, speed=20.0, lateral=5.0)
    monkeypatch.setattr(goalie_rules, 'coming', lambda *asked: shot)
    now = SimpleNamespace(world=None, sees=lambda: True, seen_since_motion=True)
    assert (goalie_rules.ball_comes(now, 'guard') is not None) is comes


@pytest.mark.parametrize('motion, word', [
    (kelpie.BLOCK, True), (kelpie.BLOCK_LEFT, True), (kelpie.BLOCK_RIGHT, True),
    (kelpie.NO_MOTION, False)])
def test_only_a_shot_that_has_a_block_is_blocked(motion, word):
    shots = SimpleNamespace(block=lambda: motion,
                            shot=SimpleNamespace(speed=1.0, lateral=2.0, seconds=0.5))
    reason = goalie_rules.shot_comes(SimpleNamespace(shots=shots), 'guard')
    assert (reason is not None) is word
    assert not word or reason[1:] == (1.0, 2.0, 0.5)


# A walk to the ball for a kick. The stand is on the field, and the ball 12 cm ahead of it.

class Stand:
    def __init__(self, x=180.0, y=40.0, heading=90.0):
        self.x, self.y, self.heading, self.direction = x, y, heading, heading

    def back(self, ball, off):
        angle = math.radians(self.heading)
        return self.x - off * math.cos(angle), self.y - off * math.sin(angle)


def attacking(dx, dy, off_deg=0.0):
    """The walk of a goalie whose stand is so far to its right and ahead and so many deg aside."""
    made = world_at(180.0, 30.0, 90.0)
    walk = AttackBall().step(made, Stand(180.0 + dx, 30.0 + dy, 90.0 + off_deg))
    return walk.forward, walk.left, walk.turn_deg


@pytest.mark.parametrize('dx, dy, forward, left', [
    (0.0, 5.0, 15.0, 0.0), (0.0, -5.0, -15.0, 0.0), (0.0, 12.0, 34.0, 0.0), (3.0, 4.0, 12.0, -9.0),
    (-3.0, 4.0, 12.0, 9.0), (3.9, 8.0, 24.0, -11.7), (4.1, 8.0, 12.0, -12.3),
    (-4.1, 8.0, 12.0, 12.3), (4.1, 3.0, 0.0, -12.3), (4.1, -3.0, -9.0, -12.3)])
def test_a_stand_is_walked_to_by_3_of_the_way_a_second_sideways_first_4_cm_short(dx, dy, forward,
                                                                               left):
    found = attacking(dx, dy)
    assert found == pytest.approx((forward, left, 0.0), abs=1e-6)


@pytest.mark.parametrize('off_deg, turn', [(20.0, 60.0), (-20.0, -60.0), (49.0, 147.0),
                                           (60.0, 150.0), (-60.0, -150.0)])
def test_it_turns_to_the_kicks_heading_by_3_of_the_angle_and_at_150_at_most(off_deg, turn):
    assert attacking(0.0, 0.0, off_deg)[2] == pytest.approx(turn)


@pytest.mark.parametrize('off_deg, forward', [(24.0, 18.0), (26.0, 18.0 - 12.0 * math.cos(
    math.radians(26.0))), (-26.0, 18.0 - 12.0 * math.cos(math.radians(26.0)))])
def test_25_deg_aside_it_stays_4_cm_short_of_the_stand(off_deg, forward):
    assert attacking(0.0, 6.0, off_deg)[0] == pytest.approx(forward)


def test_it_tells_where_the_ball_shall_go():
    skill, trace = AttackBall(), []
    skill.explain(trace)
    assert not trace
    skill.step(world_at(180.0, 30.0, 90.0), Stand(190.0, 40.0, 70.0))
    skill.explain(trace)
    assert trace[0][4:] == (70.0, 190.0, 40.0)


# The goalie of 2006 as it goes from state to state

def playing(ball=180 + 200j, at=180 + 20j):
    made = scene(ball, at=at).world
    made.game.state, made.time_s = kelpie.PLAYING, 10.0
    goalie = Goalie()
    goalie.step(made)
    return made, goalie


@pytest.mark.parametrize('seconds, state', [(7.9, 'attack'), (8.1, 'guard')])
def test_an_attack_takes_8_s_at_most_and_then_rests_for_2(seconds, state):
    made, goalie = playing()
    goalie.enter(made, goalie.attack, AttackBall())
    goalie.now.stands, goalie.now.asked = None, {'stand': Stand()}
    made.time_s += seconds
    goalie.now.world = made
    goalie.attack(made)
    assert goalie.state.__name__ == state
    assert goalie.now.rest_s == pytest.approx(made.time_s + 2.0 if state == 'guard' else 0.0)


@pytest.mark.parametrize('lateral, side', [(-5.0, 1.0), (5.0, -1.0)])
def test_after_a_block_the_ball_is_looked_for_on_the_side_of_the_shot(lateral, side):
    made, goalie = playing()
    looked = []
    goalie.eyes.look_near = lambda one, where: looked.append(where)
    goalie.shot = SimpleNamespace(lateral=lateral)
    goalie.enter(made, goalie.block, SimpleNamespace(step=lambda one: kelpie.NO_MOTION, done=True))
    goalie.block(made)
    assert looked == [side] and goalie.state == goalie.guard
    assert goalie.now.moved_s == made.time_s and not goalie.now.kicked


def test_after_a_clearance_the_ball_is_expected_80_cm_on_and_where_it_lay_against_an_opponent():
    made, goalie = playing()
    best = SimpleNamespace(kick=kelpie.UPENN_LEFT, ball=(170.0, 50.0),
                           after=lambda way: (170.0, 50.0 + way))
    goalie.now.asked = {'clearance': best}
    goalie.skill_of('clear', goalie.now)
    assert goalie.expected == (170.0, 130.0)
    for away, expected in ((29.0, (170.0, 50.0)), (31.0, (170.0, 130.0))):
        made.opponents = [kelpie.OpponentEstimate(
            position=kelpie.Point2(x=170.0, y=50.0 + away), seconds_since_seen=0.0)]
        goalie.now.world = made
        goalie.skill_of('clear', goalie.now)
        assert goalie.expected == expected


def test_a_kick_and_a_block_are_told_apart():
    for name, kicked in (('clear', True), ('block', False)):
        made, goalie = playing()
        goalie.enter(made, getattr(goalie, name),
                     SimpleNamespace(step=lambda one: kelpie.NO_MOTION, done=True))
        assert goalie.perform(made) is None and goalie.now.kicked is kicked


@pytest.mark.parametrize('name, lazy', [('adjust', 2.0), ('guard', 8.0)])
def test_a_ball_that_comes_is_met_without_laziness(name, lazy):
    _, goalie = playing()
    assert goalie.skill_of(name, goalie.now).laziness.lazy == lazy


@pytest.mark.parametrize('lateral, left', [(10.0, -25.0), (-10.0, 25.0)])
def test_it_steps_into_the_way_of_a_ball_to_where_that_passes(lateral, left):
    """A ball from (180, 120) that passes the goalie at (180, 20) so far to the right of it."""
    made, goalie = playing(180 + 120j)
    made.ball.velocity = kelpie.Point2(x=0.3 * lateral, y=-30.0)
    made.ball.stopping_point = kelpie.Point2(x=180.0 + 1.2 * lateral, y=0.0)
    made.ball.seconds_since_seen = 0.0
    goalie.now.world = made
    goalie.enter(made, goalie.adjust, goalie.skill_of('adjust', goalie.now))
    assert goalie.adjust(made).walk.left == pytest.approx(left, abs=3.0)


def test_what_it_is_told_by_mates_and_a_jump_of_the_pose_are_in_its_trace():
    made, goalie = playing()
    goalie.now.reported = (100.0, 90.0)
    trace = []
    goalie.explain(trace)
    assert [step[1] for step in trace].count('team_ball') == 1
    goalie.enter(made, goalie.attack, AttackBall())
    trace.clear()
    goalie.explain(trace)
    assert 'team_ball' not in [step[1] for step in trace]
    assert 'pose_watch' not in [step[1] for step in trace]
    goalie.now.pose.since_s = made.time_s
    goalie.explain(trace)
    assert 'pose_watch' in [step[1] for step in trace]


@pytest.mark.parametrize('penalised, role', [(False, kelpie.KEEPER), (True, kelpie.NO_ROLE)])
@pytest.mark.parametrize('kind', [Goalie, EllipseGoalie])
def test_a_penalised_goalie_has_no_role(kind, penalised, role):
    made = scene(180 + 200j, at=180 + 20j).world
    made.game.state, made.game.penalised = kelpie.PLAYING, penalised
    assert kind().step(made).team.role == role


# While play is halted

@pytest.mark.parametrize('state, penalised, walks', [
    (kelpie.READY, False, True), (kelpie.SET, False, True), (kelpie.READY, True, False),
    (kelpie.INITIAL, False, False), (kelpie.FINISHED, False, False)])
def test_only_before_a_kick_off_a_halted_goalie_takes_its_place(state, penalised, walks):
    made = world_at(300.0, 200.0)
    made.game.state, made.game.penalised = state, penalised
    halted = Halted(Memory(), GetUp())
    halted.step(made)
    assert (halted.place is not None) is walks


@pytest.mark.parametrize('state, gets_up', [(kelpie.READY, True), (kelpie.INITIAL, False)])
def test_who_has_fallen_gets_up_before_a_kick_off(state, gets_up):
    made = world_at()
    made.game.state, made.motion.feeling.fallen = state, kelpie.ON_BACK
    motion = Halted(Memory(), GetUp()).step(made).motion
    assert motion == (kelpie.GET_UP_BACK if gets_up else kelpie.NO_MOTION)


# The goalie of 2004 (thesis 2004 section 4.2.2)

@pytest.mark.parametrize('y, seen_away, due', [(64.9, 99.0, True), (65.1, 99.0, False),
                                               (65.1, 14.9, True), (65.1, 15.1, False)])
def test_a_ball_in_the_box_or_seen_within_15_cm_is_attacked(y, seen_away, due):
    made = scene(complex(180.0, y)).world
    made.percepts.ball.present, made.percepts.ball.distance = True, seen_away
    assert attack_due(made) is due
    made.ball.present = False
    assert not attack_due(made)


@pytest.mark.parametrize('y, bearing, unseen, failed', [
    (79.9, 0.0, 0.0, False), (80.1, 0.0, 0.0, True), (60.0, 39.0, 0.0, False),
    (60.0, 41.0, 0.0, True), (60.0, -41.0, 0.0, True), (60.0, 0.0, 0.9, False),
    (60.0, 0.0, 1.1, True)])
def test_an_attack_ends_15_cm_beyond_the_box_40_deg_aside_or_unseen_for_a_second(y, bearing, unseen,
                                                                               failed):
    made = scene(complex(180.0, y)).world
    made.percepts.ball.present, made.percepts.ball.heading_deg = True, bearing
    made.ball.seconds_since_seen = unseen
    assert (attack_failed(made) is not None) is failed


@pytest.mark.parametrize('playing_now, y, can, yes', [
    ('guard', 60.0, True, True), ('guard', 70.0, True, False), ('attack', 70.0, True, True),
    ('guard', 60.0, False, False), ('attack', 85.0, True, False)])
def test_an_attack_goes_on_up_to_15_cm_beyond_the_box_with_a_place_to_kick_from(playing_now, y, can,
                                                                              yes):
    made = scene(complex(180.0, y)).world
    made.percepts.ball.present, made.percepts.ball.distance = True, 30.0
    made.percepts.ball.heading_deg, made.ball.seconds_since_seen = 0.0, 0.0
    asked = []
    now = SimpleNamespace(world=made, can_attack=lambda one, on: asked.append(on) or can)
    assert (attacks_2004(now, playing_now) is not None) is yes
    assert asked in ([], [playing_now == 'attack'])


@pytest.mark.parametrize('unseen, middle', [(3.9, False), (4.1, True)])
def test_a_ball_unseen_for_4_s_is_guarded_against_from_the_middle(unseen, middle):
    made = scene(260 + 150j).world
    made.ball.seconds_since_seen = unseen
    place = EllipseGoalie().place(made)
    assert (place[0] == 180.0) is middle and (place[0] > 185.0) is not middle


@pytest.mark.parametrize('paw', [True, False])
def test_the_first_version_runs_at_the_ball_with_a_paw_and_needs_no_stand(paw):
    made = scene(180 + 300j).world
    goalie = EllipseGoalie(paw)
    goalie.world = made
    assert goalie.can_attack(made, False) is paw
    assert type(goalie.skill_of('attack', goalie)).__name__ == ('PawKick' if paw else 'AttackBall')
    assert goalie.skill_of('guard', goalie).laziness.lazy == 15.0


@pytest.mark.parametrize('goes_on', [True, False])
def test_the_stand_of_an_attack_that_goes_on_is_kept(goes_on):
    made = scene(180 + 60j, at=180 + 20j).world
    goalie = EllipseGoalie()
    goalie.world = made
    goalie.can_attack(made, False)
    before = goalie.stands
    made.time_s += 0.1
    goalie.can_attack(made, goes_on)
    assert (goalie.stands is before) is goes_on


@pytest.mark.parametrize('state, free', [('guard', True), ('attack', False)])
def test_only_who_guards_lets_the_head_off_the_ball(state, free):
    made, goalie = playing()
    asked = []
    goalie.eyes.step = lambda one, may: asked.append(may) or kelpie.HeadRequest()
    goalie.now.world = made
    goalie.now.asked = {'stand': Stand()}
    goalie.enter(made, getattr(goalie, state),
                 AttackBall() if state == 'attack' else goalie.skill_of('guard', goalie.now))
    getattr(goalie, state)(made)
    assert asked == [free]


def test_without_a_ball_that_comes_it_stays_where_it_is():
    made, goalie = playing(180 + 120j)
    made.ball.velocity = kelpie.Point2(x=0.0, y=0.0)
    goalie.now.world = made
    goalie.enter(made, goalie.adjust, goalie.skill_of('adjust', goalie.now))
    walk = goalie.adjust(made).walk
    assert (walk.forward, walk.left) == (0.0, 0.0) and goalie.skill.off == pytest.approx(0.0)


@pytest.mark.parametrize('over, expected', [(True, [(170.0, 130.0)]), (False, [])])
def test_where_the_ball_is_expected_is_looked_at_once_the_clearance_is_over(over, expected):
    made, goalie = playing()
    looked = []
    goalie.eyes.expect = lambda one, point: looked.append(point)
    goalie.expected = (170.0, 130.0)
    goalie.enter(made, goalie.clear, SimpleNamespace(step=lambda one: kelpie.NO_MOTION, done=over))
    goalie.clear(made)
    assert looked == expected


@pytest.mark.parametrize('rules, y', [(kelpie.RULES_OF_KELPIE, 15.0),
                                      (kelpie.RULES_OF_THESIS, 20.0)])
def test_before_a_near_ball_it_drops_back_and_by_the_theses_it_does_not(rules, y):
    """A ball 30 cm from the line is guarded against from half as far."""
    made, goalie = playing(180 + 30j)
    made.task.rules, made.ball.seconds_since_seen = rules, 0.0
    places = []
    goalie.now.world, goalie.now.reported = made, (180.0, 30.0)
    goalie.enter(made, goalie.guard, SimpleNamespace(
        step=lambda one, place: places.append(place) or kelpie.WalkRequest()))
    goalie.guard(made)
    assert places[0][1] == pytest.approx(y)
