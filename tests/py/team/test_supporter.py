# SPDX-License-Identifier: Apache-2.0
"""Who does not play the ball: the order of algorithm 4.4, the ways left free to the attacker, the
curved way home, the place before a kick-off and the search of the whole team."""
import itertools
import math

import kelpie
import pytest
from decisions.roles import goes_forward
from lib import kick_off_places, paths, search_places
from lib.geom import wrap
from players.ellipse_goalie import EllipseGoalie
from players.forward import Forward
from players.goalie import Goalie
from roles.supporter import Supporter
from situation import keep_off
from situation.memory import Memory
from situation.time_to import heard_of
from situations import put_ball, world
from skills.ball.find_together import FindTogether
from skills.walk.bird_of_prey import BirdOfPrey
from skills.walk.take_place import TakePlace
from test_roles import A, S, mate

FIELD = kelpie.FIELDS['2006']
FRAME_S = 1.0 / 30.0
GOAL = (180.0, 540.0)


def striker(made, frames=1, role=S, lost=0):
    memory = Memory()
    skill = Supporter(memory, role)
    for _ in range(frames):
        memory.update(made)
        memory.ball_lost += lost
        command = skill.step(made)
    return skill, command


def doing(made, role=S, lost=0):
    return striker(made, 1, role, lost)[0].state.__name__


# Algorithm 4.4: each rule goes before those below it. Home of a striker for this ball: (300, 350).

def scene(at=(300.0, 350.0), ball=(100.0, 200.0), attacker=(100.0, 150.0),
          grabs=kelpie.GRABS_NOT):
    made = world(*at, 90.0, ball)
    made.teammates = [mate(2, A, 2.0, at=attacker, grabs=grabs)]
    return made


def test_at_home_it_stands_and_faces_the_ball():
    made = scene()
    made.pose.heading_deg = math.degrees(math.atan2(-150.0, -200.0))
    put_ball(made, 100.0, 200.0)
    skill, command = striker(made, 3)
    assert skill.state == skill.go_home
    assert command.walk.forward == command.walk.left == command.walk.turn_deg == 0.0


@pytest.mark.parametrize('made, state', [
    (scene(at=(250.0, 330.0)), 'go_home'),
    (scene(at=(300.0, 100.0)), 'bird_of_prey'),
    (scene(at=(110.0, 120.0), attacker=(100.0, 50.0)), 'avoid_attacker'),
    (scene(at=(130.0, 300.0), attacker=(100.0, 175.0)), 'avoid_ball'),
    (scene(at=(130.0, 300.0), grabs=kelpie.GRABS_SOON), 'avoid_ball'),
    (scene(at=(130.0, 300.0), grabs=kelpie.HOLDS), 'get_out_of_way'),
    (scene(at=(130.0, 300.0)), 'bird_of_prey')])
def test_the_first_rule_that_holds_says_what_it_does(made, state):
    assert doing(made) == state


def test_a_blocked_paw_goes_before_a_mate_that_holds_the_ball():
    made = scene(at=(130.0, 300.0), grabs=kelpie.HOLDS)
    made.motion.feeling.paw_blocked = [True, True]
    skill, command = striker(made)
    assert skill.state == skill.back_off and command.walk.forward < 0.0


def test_a_ball_lost_near_home_is_looked_for_and_far_from_home_is_not_yet():
    near, far = scene(), scene(at=(300.0, 100.0))
    for made in (near, far):
        made.percepts.ball.present = made.ball.present = False
    assert doing(near, lost=50) == 'find_ball'
    far.pose.position.y = 20.0
    assert doing(far, lost=50) == 'bird_of_prey'


def test_a_ball_that_a_mate_sees_is_not_lost():
    made = scene()
    made.percepts.ball.present = made.ball.present = False
    made.team_ball = kelpie.TeamBall(present=True, position=kelpie.Point2(x=100.0, y=200.0))
    assert doing(made, lost=50) == 'go_home'


def test_bird_of_prey_goes_on_within_100_cm_until_it_is_home():
    made = scene(at=(300.0, 240.0))
    memory = Memory()
    skill = Supporter(memory, S)
    states = []
    for y in (240.0, 270.0, 315.0, 325.0):
        made.pose.position.y = y
        memory.update(made)
        skill.step(made)
        states.append(skill.state.__name__)
    assert states == ['bird_of_prey'] * 3 + ['go_home']


def test_who_came_within_15_cm_of_home_stands_until_it_is_30_cm_off():
    made, memory, walks = scene(at=(300.0, 325.0)), Memory(), []
    skill = Supporter(memory, S)
    for away in (31.0, 16.0, 14.0, 29.0, 31.0, 16.0):
        made.pose.position.y = 350.0 - away
        put_ball(made, 100.0, 200.0)
        memory.update(made)
        walk = skill.step(made).walk
        walks.append(math.hypot(walk.forward, walk.left) > 0.0)
    assert walks == [True, True, False, False, True, True]


def test_who_stands_at_home_turns_when_the_ball_is_25_degrees_aside_until_it_is_8():
    made, memory, turns = scene(), Memory(), []
    skill = Supporter(memory, S)
    for off in (24.0, 26.0, 9.0, 7.0, 24.0):
        made.pose.heading_deg = math.degrees(math.atan2(-150.0, -200.0)) - off
        put_ball(made, 100.0, 200.0)
        memory.update(made)
        turns.append(skill.step(made).walk.turn_deg > 0.0)
    assert turns == [False, True, True, False, False]


@pytest.mark.parametrize('role', [S, kelpie.SUPPORTER, kelpie.DEFENDER])
@pytest.mark.parametrize('positions', [kelpie.POSITIONS_BY_TREE, kelpie.POSITIONS_BY_REGRESSION])
def test_every_role_has_a_home_on_the_field_with_and_without_a_ball(role, positions):
    for seen in (True, False):
        made = scene()
        made.task.positions = positions
        made.ball.present = made.percepts.ball.present = seen
        home = striker(made, role=role)[0].home
        assert 0.0 < home[0] < 360.0 and FIELD.box_depth < home[1] < 540.0


@pytest.mark.parametrize('at, ball', [((180.0, 130.0), (180.0, 30.0)),
                                      ((60.0, 50.0), (160.0, 30.0)),
                                      ((300.0, 110.0), (200.0, 20.0))])
def test_nobody_but_the_goalie_walks_into_the_own_box(at, ball):
    made = world(*at, -90.0, ball)
    made.teammates = [mate(2, A, 5.0, at=(100.0, 500.0)), mate(1, kelpie.KEEPER, at=(180.0, 20.0))]
    memory = Memory()
    skill = Supporter(memory, kelpie.DEFENDER)
    for frame in range(300):
        made.percepts.ball.present = frame < 30
        made.ball.seconds_since_seen = max(0.0, (frame - 30) * FRAME_S)
        memory.update(made)
        walk_in(made, skill.step(made))
        x, y = paths.point_of(made.pose)
        assert not (y < FIELD.box_depth and abs(x - 180.0) < 0.5 * FIELD.box_width)


# The attacker's ways

def test_a_place_in_a_lane_is_moved_out_of_it_to_the_nearer_side():
    lane = keep_off.Lane(keep_off.HAS_BALL, (180.0, 300.0), (180.0, 540.0), 40.0)
    assert lane.way_off(FIELD, (190.0, 400.0)) == pytest.approx((230.0, 400.0))
    assert lane.way_off(FIELD, (170.0, 400.0)) == pytest.approx((130.0, 400.0))
    assert lane.gap((180.0, 250.0)) == 50.0


def test_a_lane_beside_the_line_is_left_to_the_inside():
    lane = keep_off.Lane(keep_off.ON_WAY, (40.0, 100.0), (40.0, 300.0), 40.0)
    assert lane.way_off(FIELD, (30.0, 200.0)) == pytest.approx((90.0, 200.0))


def walk_in(made, command):
    """Moves the robot of a world by what it asked for, at most as its legs do."""
    walk, pose = command.walk, made.pose
    ahead = max(-37.0, min(42.0, walk.forward)) * FRAME_S
    left = max(-35.0, min(35.0, walk.left)) * FRAME_S
    angle = math.radians(pose.heading_deg)
    pose.position.x += ahead * math.cos(angle) - left * math.sin(angle)
    pose.position.y += ahead * math.sin(angle) + left * math.cos(angle)
    pose.heading_deg += max(-200.0, min(200.0, walk.turn_deg)) * FRAME_S
    made.last_command = command
    made.time_s += FRAME_S
    put_ball(made, made.ball.position.x, made.ball.position.y)


@pytest.mark.parametrize('role', [S, kelpie.SUPPORTER, kelpie.DEFENDER])
@pytest.mark.parametrize('at', [(185.0, 400.0), (160.0, 350.0), (150.0, 300.0)])
def test_the_line_from_ball_to_goal_is_free_within_2_s_and_stays_so(role, at):
    """Plan A, checklist U03."""
    made = world(*at, -90.0, (180.0, 270.0))
    made.teammates = [mate(2, A, 0.5, at=(180.0, 250.0))]
    memory = Memory()
    skill, gaps = Supporter(memory, role), []
    lane = keep_off.Lane(keep_off.HAS_BALL, (180.0, 270.0), GOAL, 40.0)
    for _ in range(240):
        memory.update(made)
        walk_in(made, skill.step(made))
        gaps.append(lane.gap(paths.point_of(made.pose)))
    assert min(gaps[60:]) > 40.0


def test_the_attackers_way_to_the_ball_is_left_free():
    """Plan B."""
    made = world(190.0, 200.0, 90.0, (180.0, 300.0))
    made.teammates = [mate(2, A, 3.0, at=(180.0, 80.0))]
    memory = Memory()
    skill = Supporter(memory, kelpie.SUPPORTER)
    for _ in range(120):
        memory.update(made)
        walk_in(made, skill.step(made))
    lane = keep_off.Lane(keep_off.ON_WAY, (180.0, 80.0), (180.0, 300.0), 40.0)
    assert lane.gap(paths.point_of(made.pose)) > 40.0


# The way home

def test_a_free_way_home_is_straight_and_a_blocked_one_bends_to_the_freer_side():
    start, end = (100.0, 120.0), (100.0, 420.0)
    assert paths.best_bend([], start, end, FIELD) == 0.0
    assert paths.best_bend([(100.0, 250.0)], start, end, FIELD) != 0.0
    assert paths.best_bend([(90.0, 250.0)], start, end, FIELD) < 0.0
    assert paths.best_bend([(110.0, 250.0)], start, end, FIELD) > 0.0


def test_no_way_home_leads_off_the_field():
    assert paths.best_bend([(45.0, 250.0)], (30.0, 120.0), (30.0, 420.0), FIELD) < 0.0


def home_after(bird_of_prey):
    """Seconds until it is home past two robots that stand in its way, each a disc of 24 cm that it
    slides along, as legs do that catch each other, at a fifth of its speed."""
    made = world(180.0, 480.0, -90.0, (60.0, 100.0))
    made.task.bird_of_prey = bird_of_prey
    blockers = [(180.0, 380.0), (190.0, 250.0)]
    made.opponents = [kelpie.OpponentEstimate(position=kelpie.Point2(x=x, y=y))
                      for x, y in blockers]
    bird, place, way = BirdOfPrey(), (180.0, 120.0), []
    for frame in range(900):
        before = paths.point_of(made.pose)
        if math.hypot(before[0] - place[0], before[1] - place[1]) < 15.0:
            return frame * FRAME_S, way
        walk_in(made, kelpie.Command(walk=bird.step(made, place)))
        here = made.pose.position
        for x, y in blockers:
            dx, dy = here.x - x, here.y - y
            away = math.hypot(dx, dy)
            if away < 24.0:
                here.x = before[0] + 0.2 * (here.x - before[0]) + 0.5 * dx / away
                here.y = before[1] + 0.2 * (here.y - before[1]) + 0.5 * dy / away
        way.append((here.x, here.y))
    return 30.0, way


def test_past_two_robots_a_curve_is_sooner_home_than_the_straight_line_and_touches_none():
    curved, way = home_after(True)
    straight, _ = home_after(False)
    assert curved < straight and curved < 12.0
    assert min(math.hypot(x - bx, y - by) for x, y in way
               for bx, by in ((180.0, 380.0), (190.0, 250.0))) > 24.0


# The place before a kick-off

@pytest.mark.parametrize('field', kelpie.FIELDS.values(), ids=kelpie.FIELDS)
@pytest.mark.parametrize('kicks_off', [True, False])
def test_all_places_are_in_the_own_half_out_of_circle_and_box_and_not_on_one_another(field,
                                                                                   kicks_off):
    found = [kick_off_places.forward(field, player, kicks_off, False) for player in (1, 2, 3, 4)]
    for x, y in found:
        assert 20.0 < x < field.width - 20.0 and y + 18.0 < 0.5 * field.length
        assert math.hypot(x - 0.5 * field.width, y - 0.5 * field.length) > \
            0.5 * field.circle_diameter + 18.0
        assert not (y < field.box_depth and abs(x - 0.5 * field.width) < 0.5 * field.box_width)
    for one, two in itertools.combinations(found, 2):
        assert math.hypot(one[0] - two[0], one[1] - two[1]) > 45.0
    x, y = kick_off_places.goalie(field)
    assert x == 0.5 * field.width and 0.0 < y < field.box_depth


def test_who_kicks_off_stands_behind_the_ball_and_alone_that_is_number_1():
    assert kick_off_places.forward(FIELD, 2, True, False) == (180.0, 225.0)
    assert kick_off_places.forward(FIELD, 1, True, True) == (180.0, 225.0)
    assert kick_off_places.forward(FIELD, 1, True, False) != (180.0, 225.0)


def ready_world(at, player=2, kick_off=True):
    made = world(*at, 0.0, (180.0, 270.0))
    made.game.state, made.game.player, made.game.kick_off = kelpie.READY, player, kick_off
    return made


@pytest.mark.parametrize('at', [(20.0, 500.0), (340.0, 30.0), (180.0, 400.0), (180.0, 230.0)])
@pytest.mark.parametrize('player', [1, 2, 3, 4])
def test_a_forward_is_at_its_place_looking_up_field_within_20_s(at, player):
    made, forward = ready_world(at, player), Forward()
    for _ in range(600):
        command = forward.step(made)
        assert command.team.role == kelpie.NO_ROLE
        walk_in(made, command)
    place = kick_off_places.forward(FIELD, player, True, True)
    assert math.hypot(made.pose.position.x - place[0], made.pose.position.y - place[1]) < 12.0
    assert abs(wrap(made.pose.heading_deg - 90.0)) < 20.0
    assert command.trace[0][2] == 'takes_place' and command.walk.forward == 0.0


def test_when_all_are_set_it_stands_and_looks_at_the_ball():
    made, skill = ready_world((20.0, 500.0)), TakePlace(Memory())
    made.game.state = kelpie.SET
    skill.memory.update(made)
    command = skill.step(made)
    assert command.walk.forward == command.walk.turn_deg == 0.0
    assert command.head.aim == kelpie.AIM_POINT


def test_the_team_hears_to_which_place_it_walks():
    made, skill = ready_world((20.0, 500.0)), TakePlace(Memory())
    note = skill.step(made).team
    assert note.wants and (note.wanted.x, note.wanted.y) == skill.place(made)


@pytest.mark.parametrize('paws, left', [((True, True), 0.0), ((True, False), -1.0),
                                        ((False, True), 1.0)])
def test_a_paw_that_meets_somebody_on_the_way_to_the_place_makes_it_back_off(paws, left):
    made, skill = ready_world((20.0, 500.0)), TakePlace(Memory())
    made.motion.feeling.paw_blocked = list(paws)
    command = skill.step(made)
    assert command.walk.forward < 0.0 and command.walk.left * left >= 0.0
    assert (command.walk.left == 0.0) == (left == 0.0)


def test_a_lone_forward_takes_its_place_too_and_then_plays():
    made, forward = ready_world((60.0, 60.0), 1), Forward()
    branches = []
    for state in (kelpie.INITIAL, kelpie.READY, kelpie.SET, kelpie.PLAYING):
        made.game.state = state
        branches.append(forward.step(made).trace[0][2])
    assert branches == ['waits', 'takes_place', 'waits', 'plays']


def test_who_comes_back_from_a_penalty_plays_on():
    made, forward = world(), Forward()
    made.game.penalised = True
    assert forward.step(made).team.role == kelpie.NO_ROLE
    made.game.penalised = False
    assert forward.step(made).team.role == kelpie.ATTACKER


# The search of the whole team

@pytest.mark.parametrize('order', itertools.permutations((2, 3, 4)))
def test_the_closest_takes_the_place_behind_and_the_next_the_left_one(order):
    near = [(180.0, 150.0), (90.0, 360.0), (200.0, 500.0)]
    robots = [(player, *place) for player, place in zip(order, near)]
    found = search_places.assigned(FIELD, robots)
    assert [found[player] for player in order] == [
        pytest.approx(place) for place in ((180.0, 162.0), (80.0, 378.0), (280.0, 378.0))]


def lost_world():
    made = world(180.0, 200.0)
    made.game.player = 2
    made.ball.present = made.percepts.ball.present = False
    made.teammates = [mate(3, A, at=(100.0, 350.0)), mate(4, at=(300.0, 350.0))]
    return made


def searching(made, lost=200):
    memory = Memory()
    memory.ball_lost = lost
    skill = FindTogether(memory, False)
    return skill, skill.step(made)


def test_the_whole_team_searches_after_66_frames_and_each_goes_to_its_place():
    assert searching(lost_world(), 60)[1] is None
    skill, command = searching(lost_world())
    assert skill.state == skill.go and skill.place == pytest.approx((180.0, 162.0))
    assert command is not None


def test_at_its_place_it_spins():
    made = lost_world()
    made.pose.position.y = 162.0
    skill, _ = searching(made)
    assert skill.step(made).walk.turn_deg != 0.0 and skill.state == skill.spin


def test_a_place_that_shows_no_ball_is_left_to_the_own_search_for_a_while():
    made = lost_world()
    made.pose.position.y = 162.0
    skill, _ = searching(made)
    answers = []
    for frame in range(900):
        made.time_s = frame * FRAME_S
        answers.append(skill.step(made) is not None)
    assert answers[0] and not answers[300] and answers[600] and 300 < answers.count(True) < 600


def test_a_mate_that_sees_the_ball_ends_the_search_and_is_believed():
    made = lost_world()
    made.team_ball = kelpie.TeamBall(present=True, position=kelpie.Point2(x=180.0, y=400.0))
    skill, command = searching(made)
    assert skill.state == skill.follow and command.walk.forward > 0.0
    assert heard_of(made) == (180.0, 400.0)
    made.team_ball.position.y = -38.0   # behind the goal
    assert heard_of(made) is None


def test_the_search_of_the_team_can_be_switched_off_and_needs_mates():
    made = lost_world()
    made.task.distributed_find = False
    assert searching(made)[1] is None
    made.teammates = []
    made.team_ball.present = True
    assert heard_of(made) is None


# What the team hears

def test_a_forward_tells_its_role_its_time_and_where_it_goes():
    made, forward = scene(at=(300.0, 100.0)), Forward()
    note = forward.step(made).team
    assert note.role == kelpie.SUPPORTER or note.role == kelpie.DEFENDER
    assert 0.0 < note.time_to_ball < 100.0 and note.wants
    made.teammates = []
    for _ in range(4):
        note = forward.step(made).team
    assert note.role == kelpie.ATTACKER and note.wanted.x == 100.0


def test_a_grab_is_reported_before_and_while_the_ball_is_held():
    made, forward = world(180.0, 200.0, ball=(180.0, 230.0)), Forward()
    forward.memory.approach_lost = 0
    assert forward.step(made).team.grabs == kelpie.GRABS_SOON
    forward.memory.grab_lost, made.motion.feeling.ball_held = 0, True
    assert forward.step(made).team.grabs == kelpie.HOLDS


def test_the_role_and_why_are_in_the_trace():
    made, forward = scene(), Forward()
    layer, module, branch, why, *_ = forward.step(made).trace[0]
    assert (layer, module) == (kelpie.LAYER_PLAYER, 'forward') and branch != 'plays' and why


# The goalie's part

@pytest.mark.parametrize('make', [Goalie, EllipseGoalie])
def test_a_goalie_takes_its_place_and_tells_that_it_is_one(make):
    made, goalie = ready_world((300.0, 200.0), 1), make()
    for _ in range(600):
        command = goalie.step(made)
        walk_in(made, command)
    assert math.hypot(made.pose.position.x - 180.0, made.pose.position.y - 20.0) < 12.0
    assert command.team.role == kelpie.KEEPER
    assert [step[1] for step in command.trace].count('take_place') == 1
    made.game.penalised = True
    assert goalie.step(made).team.role == kelpie.NO_ROLE


@pytest.mark.parametrize('aware, kind, own, theirs, goes', [
    (True, kelpie.GOALIE, 0, 4, True), (True, kelpie.GOALIE, 0, 3, False),
    (True, kelpie.GOALIE, 2, 5, False), (True, kelpie.GOALIE_2004, 1, 6, True),
    (False, kelpie.GOALIE, 0, 9, False), (True, kelpie.CHALLENGER, 0, 9, False)])
def test_a_goalie_goes_forward_when_its_team_is_behind_by_more_than_three(aware, kind, own, theirs,
                                                                         goes):
    made = world()
    made.task.score_aware, made.task.player = aware, kind
    made.game.own_score, made.game.opponent_score = own, theirs
    assert goes_forward(made) == goes


def test_who_attacks_is_agreed_before_the_whistle():
    made, forward = ready_world((180.0, 225.0), 2), Forward()
    made.game.state = kelpie.SET
    made.teammates = [mate(3, S, 9.0), mate(4, S, 8.0)]
    note = forward.step(made).team
    assert note.role == kelpie.ATTACKER and note.time_to_ball < 9.0
