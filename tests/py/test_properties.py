# SPDX-License-Identifier: Apache-2.0
"""What holds for all places and numbers, tried on those that hypothesis thinks of: right is treated
as left is, every question has an answer, and more is never less. Places are drawn off the round
numbers at which rules change, where a mirrored number may fall on the other side."""
import math

import kelpie
from decisions import kick_choice, kick_map_choice, tree
from decisions.held_choice import HeldChoice
from decisions.kick_choice import Hold
from decisions.leaf_by_map import LeafByMap
from hypothesis import assume, given, settings, strategies as st
from lib import goalie_places, intercept, zones
from lib.geom import clamp, heading, moved, polar, wrap
from lib.steer import towards
from pytest import approx
from situation import aim
from situation.at_ball import Situation
from situation.contested import Contested
from situation.memory import Memory
from situation.shot import Shot
from situation.shot_watch import block_for
from situations import world
from skills.ball import lost_ball
from skills.ball.dribble import Dribble
from skills.ball.go_to_ball import GoToBall
from skills.ball.grab import Grab, can_grab
from skills.ball.grab_dribble import GrabDribble
from skills.ball.hold import Hold as Held
from skills.ball.kick_ball import KickBall
from skills.ball.strike import StepToKick
from skills.walk.guard_goal import OF_2006, GuardGoal

FIELD = kelpie.FIELDS['2006']
settings.register_profile('kelpie', max_examples=120, derandomize=True, deadline=None,
                          database=None)
settings.load_profile('kelpie')

FREE_KICKS = [kick for kick, reported in kelpie.KICKS.items() if reported.leaf]


def numbers(low, high):
    """Between two numbers, in steps of 0.37 from 0.0123 on: none is round."""
    return st.integers(math.ceil(low / 0.37), math.floor(high / 0.37) - 1).map(
        lambda i: 0.37 * i + 0.0123)


degrees = numbers(-180, 180)
on_field = st.tuples(numbers(1, 358), numbers(1, 538))
near = st.tuples(numbers(-30, 30), numbers(-10, 40))   # in the robot frame
gaps = st.none() | st.tuples(numbers(-60, 60), numbers(1, 30)).map(
    lambda gap: (gap[0] + gap[1], gap[0] - gap[1]))


@st.composite
def places(draw):
    """A robot, and a ball near or far, as the arguments of situations.world()."""
    x, y = draw(on_field)
    turned = draw(degrees)
    right, ahead = draw(near) if draw(st.booleans()) else draw(st.tuples(numbers(-200, 200),
                                                                         numbers(-200, 200)))
    angle = math.radians(turned)
    ball = (x + right * math.sin(angle) + ahead * math.cos(angle),
            y - right * math.cos(angle) + ahead * math.sin(angle))
    return x, y, turned, ball


def both(place):
    """The world and its mirror image."""
    x, y, turned, ball = place
    return world(*place), world(FIELD.width - x, y, wrap(180.0 - turned),
                                (FIELD.width - ball[0], ball[1]))


def other(name):
    """Of a leaf or pass: that of the other side."""
    if name.endswith('left'):
        return name[:-4] + 'right'
    return name[:-5] + 'left' if name.endswith('right') else name


SIDES = {kelpie.HEAD_SWIPE_LEFT: kelpie.HEAD_SWIPE_RIGHT, kelpie.UPENN_LEFT: kelpie.UPENN_RIGHT,
         kelpie.BLOCK_LEFT: kelpie.BLOCK_RIGHT}
SIDES |= {right: left for left, right in SIDES.items()}


def other_kick(kick):
    return other(kick) if isinstance(kick, str) else SIDES.get(kick, kick)


def mirrored_gap(gap):
    return None if gap is None else (-gap[1], -gap[0])


def same_walk(one, mirrored):
    assert (one.forward, one.left, one.turn_deg, one.kind) == approx(
        (mirrored.forward, -mirrored.left, -mirrored.turn_deg, mirrored.kind), abs=1e-6)


# Left and right

@given(places(), st.booleans(), st.booleans())
def test_the_tree_names_the_mirrored_leaf_in_the_mirrored_world(place, contested, about):
    one, mirrored = (tree.decide(Situation(made, contested, about))[0] for made in both(place))
    assert mirrored == other(one)


@given(places())
def test_the_map_names_the_mirrored_leaf_in_the_mirrored_world(place):
    named, utilities = [], []
    for made in both(place):
        situation, choice = Situation(made, False, False), LeafByMap()
        named.append(choice.choose(made, situation, tree.decide(situation)[0])[0])
        utilities.append(choice.utilities)
    for way, utility in utilities[0].items():
        assert utility == approx(utilities[1][other(way)], abs=1e-6)
    best = sorted(utilities[0].values())[-2:]
    if not utilities[0] or best[1] - best[0] > 1e-6:
        assert named[1] == other(named[0])


@st.composite
def holds(draw):
    """What is known of a hold, and its mirror image."""
    x, y = draw(on_field)
    gap, aimed, contested = draw(gaps), draw(st.booleans()), draw(st.booleans())
    lost, own_lost = draw(st.integers(0, 40)), draw(st.integers(0, 10))
    goal, spun, side = draw(degrees), draw(st.integers(0, 60)), draw(st.sampled_from((-1.0, 1.0)))
    made = []
    for sign in (1.0, -1.0):
        memory = Memory()
        memory.goal_lost, memory.own_goal_lost, memory.goal_heading = lost, own_lost, sign * goal
        at = world(x if sign > 0.0 else FIELD.width - x, y)
        made.append(Hold(at, memory, contested, gap if sign > 0.0 else mirrored_gap(gap), aimed,
                         spun, sign * side))
    return made


@given(holds())
def test_the_kick_by_rules_is_mirrored_with_what_is_known(pair):
    for rule in (kick_choice.by_rules, kick_choice.out_of_time, kick_choice.goal_not_seen):
        one, mirrored = (rule(hold)[0] for hold in pair)
        assert mirrored == other_kick(one)


@given(places(), gaps, degrees)
def test_a_kick_of_the_map_has_the_same_utility_mirrored(place, gap, turn):
    one, mirrored = both(place)
    for kick in (kelpie.HARD_FORWARD, kelpie.HEAD_SWIPE_LEFT, kelpie.UPENN_RIGHT):
        assert kick_map_choice.utility_of(one, kick, gap, turn) == approx(
            kick_map_choice.utility_of(mirrored, other_kick(kick), mirrored_gap(gap), -turn),
            abs=1e-6)


@given(places(), st.sampled_from(list(FREE_KICKS)))
def test_skills_walk_mirrored_ways_to_mirrored_balls(place, kick):
    one, mirrored = both(place)
    same_walk(Grab(Memory()).step(one).walk, Grab(Memory()).step(mirrored).walk)
    same_walk(KickBall(Memory(), kick).step(one).walk,
              KickBall(Memory(), other_kick(kick)).step(mirrored).walk)
    same_walk(Dribble(Memory(), lambda _: 40.0).step(one).walk,
              Dribble(Memory(), lambda _: -40.0).step(mirrored).walk)


@given(places(), near)
def test_walks_to_a_ball_before_a_goal_are_mirrored_with_the_goal(place, goal):
    one, mirrored = both(place)
    goal = goal[0], 100.0 + goal[1]
    for skill in (GoToBall(), StepToKick()):
        same_walk(skill.step(one, goal), skill.step(mirrored, (-goal[0], goal[1])))


@given(places())
def test_a_goalie_guards_mirrored_places(place):
    one, mirrored = both(place)
    assume(one.ball.position.y > goalie_places.STAND_Y)  # nearer, straight behind is a tie
    for rule in (goalie_places.bisector_place, goalie_places.fixed_bisector_place,
                 goalie_places.ellipse_place):
        walks = [GuardGoal(OF_2006).step(made, rule(FIELD, (made.ball.position.x,
                                                          made.ball.position.y)))
                 for made in (one, mirrored)]
        same_walk(*walks)


@given(numbers(-60, 60), numbers(0, 1.6), numbers(10, 300))
def test_a_block_is_mirrored_with_the_shot_and_there_is_none_for_what_it_cannot_reach(
        lateral, seconds, speed):
    one, mirrored = (block_for(Shot(sign * lateral, seconds, 180.0, speed)) for sign in (1, -1))
    assert mirrored == other_kick(one)
    if abs(lateral) > 40.0 or seconds > 1.0:
        assert one == kelpie.NO_MOTION


# Every question has an answer

anywhere = st.floats(-1e4, 1e4)


@given(anywhere, anywhere, anywhere, st.tuples(anywhere, anywhere), st.booleans(), st.booleans())
def test_the_tree_has_a_leaf_for_any_numbers(x, y, turned, ball, contested, about):
    made = world(x, y, turned, ball)
    leaf, place, reason, *reported = tree.decide(Situation(made, contested, about))
    assert leaf in tree.LEAVES and reason.count('{}') == len(reported) and len(reason) <= 80
    assert all(math.isfinite(number) for number in reported)


@given(anywhere, anywhere)
def test_zones_cover_everything(x, y):
    number = zones.sub_zone(FIELD, (x, y))
    assert 1 <= number <= 12 and zones.zone(FIELD, y) in (0, 1, 2)


@given(on_field)
def test_the_zones_of_the_field_are_mirrored(point):
    number = zones.sub_zone(FIELD, point)
    swapped = {1: 3, 4: 5, 8: 9, 10: 11}
    swapped |= {right: left for left, right in swapped.items()}
    mirrored = zones.sub_zone(FIELD, (FIELD.width - point[0], point[1]))
    assert mirrored == swapped.get(number, number)


@given(places(), gaps, st.sampled_from(tree.WITH_GRAB), st.sampled_from((0, 1)),
       st.integers(0, 100), st.floats(0.0, 180.0))
def test_who_is_out_of_time_always_has_a_kick_or_lets_go(place, gap, plan, kicks, lost, sd):
    made, memory = world(*place), Memory()
    made.task.kicks, made.heading_sd_deg = kicks, sd
    memory.goal_lost = memory.own_goal_lost = lost
    choice = HeldChoice(memory, Contested())
    skill = GrabDribble(memory, choice.choose, plan)
    skill.hold, skill.aim.gap = Held(made, made.time_s), gap
    kick, reason, *reported = choice.choose(made, skill, True)
    assert kick == kick_choice.RELEASE or kick in kelpie.KICKS
    assert reason.count('{}') == len(reported) <= 3 and len(reason) <= 80


# More is never less

@given(numbers(0.5, 40), degrees, numbers(0.05, 1), st.integers(0, 30))
def test_a_nearer_ball_can_be_grabbed_where_a_farther_one_can(away, lateral, share, turn_lost):
    if can_grab(polar(away, lateral), (0.0, 0.0), turn_lost):
        assert can_grab(polar(share * away, lateral), (0.0, 0.0), turn_lost)
        assert can_grab(polar(away, lateral), (0.0, 0.0), turn_lost + 100)
        assert away < 13.5 and abs(lateral) < 90.0


@given(gaps, gaps)
def test_the_best_side_is_one_that_is_there_and_no_narrower_than_the_other(left, right):
    side = aim.best_side(left, right)
    chosen, rest = (left, right) if side == aim.LEFT else (right, left)
    if left is not None or right is not None:
        assert chosen is not None
        assert rest is None or aim.size(chosen) >= aim.size(rest) - 1e-9


@given(places(), numbers(-150, 150), numbers(-150, 150))
def test_a_rolling_ball_is_met_on_its_way_and_never_behind_time(place, vx, vy):
    """At the place to go to the robot is not later than the ball, unless that lies there."""
    made = world(*place)
    speed, ball = math.hypot(vx, vy), made.ball
    assume(speed > intercept.SLOW)
    stop = intercept.rolled(speed, math.inf)
    ball.velocity.x, ball.velocity.y = vx, vy
    ball.stopping_point.x = ball.position.x + stop * vx / speed
    ball.stopping_point.y = ball.position.y + stop * vy / speed
    x, y = intercept.meeting(made)
    way = math.hypot(x - ball.relative.x, y - ball.relative.y)
    assert way <= stop + 1e-6
    seconds = intercept.needed(x, y)
    late = seconds > intercept.LONGEST_S or intercept.rolled(speed, seconds) > way + 1e-6
    last = intercept.rolled(speed, intercept.LONGEST_S - intercept.STEP_S)
    assert not late or way >= last - 1e-6


@given(st.floats(0, 500), st.floats(0, 600), st.floats(0, 180), st.floats(0, 50), degrees)
def test_a_scan_is_within_the_neck_and_no_narrower_for_a_worse_belief(sd, away, pose, more, at):
    half = lost_ball.scan_half_width(sd, away, pose)
    assert lost_ball.MIN_SCAN <= half <= lost_ball.MAX_SCAN
    assert lost_ball.scan_half_width(sd + more, away, pose + more) >= half
    low, high = lost_ball.scan_limits(at, half)
    assert -lost_ball.MAX_PAN <= low <= high <= lost_ball.MAX_PAN
    wider = lost_ball.scan_limits(at, half + more)
    assert wider[0] <= low and high <= wider[1]


@given(st.lists(st.tuples(numbers(-3, 3), numbers(-2, 2), numbers(-8, 8)), max_size=80))
def test_a_ball_is_never_carried_farther_than_the_way_walked(steps):
    made = world()
    hold, walked = Held(made, made.time_s), 0.0
    for forward, left, turn in steps:
        odometry = kelpie.Odometry(forward=forward, left=left, turn_deg=turn)
        made.odometry = odometry
        made.time_s += 1.0 / 30.0
        hold.update(made)
        walked += math.hypot(forward, left)
        assert hold.way <= walked + 1e-6


# Geometry that all of it stands on

@given(numbers(0.5, 500), degrees)
def test_polar_and_heading_are_inverse(away, lateral):
    assert heading(*polar(away, lateral)) == approx(lateral, abs=1e-6)


@given(st.floats(-1e6, 1e6))
def test_a_wrapped_angle_is_the_same_direction_within_a_turn(angle):
    wrapped = wrap(angle)
    assert -180.0 < wrapped <= 180.0 and wrap(wrapped) == wrapped
    assert math.cos(math.radians(wrapped)) == approx(math.cos(math.radians(angle)), abs=1e-5)


@given(near, numbers(-3, 3), numbers(-2, 2), numbers(-8, 8))
def test_a_step_and_the_step_back_leave_a_point_where_it_was(point, forward, left, turn):
    there = moved(*point, kelpie.Odometry(forward=forward, left=left, turn_deg=turn))
    back = moved(*there, kelpie.Odometry(forward=-forward, left=-left, turn_deg=-turn))
    assert back == approx(point, abs=1e-6)


@given(st.tuples(anywhere, anywhere), st.floats(0, 100), st.floats(1, 60))
def test_a_walk_to_a_point_is_within_the_speeds_and_stands_at_its_end(point, close, speed):
    walk = towards(point, close, speed)
    assert 0.0 <= walk.forward <= speed and abs(walk.turn_deg) <= 90.0
    if math.hypot(*point) <= close:
        assert walk.forward == 0.0
    assert clamp(walk.turn_deg, -1.0, 1.0) * heading(*point) >= 0.0
