# SPDX-License-Identifier: Apache-2.0
"""The goalies by the theses' rules alone (thesis 2006 section 4.3.1, thesis 2004 section 4.2), and
by Kelpie's where those differ."""
import math

import kelpie
import pytest
from books import both, by
from goalie_world import GoalieWorld, guards, place_of, reported, run, scene
from lib import goalie_places as places
from players.ellipse_goalie import EllipseGoalie
from players.goalie import Goalie
from situation.clearance import clearing_kick
from situation.shot import Shot
from situation.shot_watch import FRAMES, SEEN_FRAMES, block_for
from skills.ball.paw_kick import PawKick
from skills.head.point_scan import PointScan

UPENN = kelpie.UPENN_LEFT, kelpie.UPENN_RIGHT


def played(book, scenery, frames=SEEN_FRAMES + FRAMES, player=None):
    """The goalie after so many frames, the ball then where the scene has it."""
    player = player or Goalie()
    player.now.moved_s = -10.0
    by(scenery.world, book)
    scenery.ball -= scenery.velocity * frames / 30.0
    for _ in range(frames):
        scenery.ball += scenery.velocity / 30.0
        scenery.see()
        player.step(scenery.world)
    return player


# Algorithm 4.1

@pytest.mark.parametrize('branch, ball, velocity, at, facing', [
    ('turn', 180 + 200j, 0j, 180 + 20j, -1j), ('block', 180 + 90j, -170j, 180 + 20j, 1j),
    ('adjust', 180 + 85j, -75j, 180 + 20j, 1j), ('clear', 186 + 42j, 0j, 180 + 30j, 1j),
    ('attack', 180 + 62j, 0j, 180 + 20j, 1j), ('guard', 180 + 200j, 0j, 180 + 20j, 1j)])
def test_each_of_six_scenes_selects_its_branch(branch, ball, velocity, at, facing):
    assert played('thesis', scene(ball, velocity, at, facing)).state.__name__ == branch


def crowded(ball=180 + 60j, opponent=None, mate=None):
    """Somebody else at the ball."""
    made = scene(ball)
    if opponent is not None:
        made.world.opponents = [kelpie.OpponentEstimate(
            position=kelpie.Point2(x=opponent.real, y=opponent.imag), seconds_since_seen=0.1)]
    if mate is not None:
        made.world.teammates = [kelpie.TeammateEstimate(
            player=2, note=kelpie.TeamNote(grabs=kelpie.HOLDS),
            pose=kelpie.Pose2(position=kelpie.Point2(x=mate.real, y=mate.imag)))]
    return made


@both('made', [
    (crowded(opponent=180 + 85j), 'attack', 'guard'), (crowded(mate=180 + 80j), 'attack', 'guard')])
def test_who_else_has_the_ball_is_no_question(made, book, answer):
    assert played(book, made).state.__name__ == answer


@both('', [('guard', 'step_back')])
def test_a_ball_between_its_paws_is_no_reason_to_step_back(book, answer):
    scenery = scene(180 + 28j)
    scenery.world.sensors.chest_distance = 10.0
    player = played(book, scenery, 45)
    assert (player.state == player.step_back) is (answer == 'step_back')


# Blocks: of 2005 a ball of 0.4 cm a frame that arrives within 3 to 27 frames and 30 cm aside

@both('speed, seconds, lateral', [
    (100.0, 0.5, 4.0, kelpie.BLOCK, kelpie.NO_MOTION),
    (200.0, 0.5, 4.0, kelpie.BLOCK, kelpie.BLOCK),
    (100.0, 0.5, -12.0, kelpie.BLOCK_LEFT, kelpie.BLOCK_LEFT),
    (100.0, 0.5, 29.0, kelpie.BLOCK_RIGHT, kelpie.BLOCK_RIGHT),
    (100.0, 0.5, 31.0, kelpie.NO_MOTION, kelpie.BLOCK_RIGHT),
    (100.0, 0.95, 4.0, kelpie.NO_MOTION, kelpie.NO_MOTION)])
def test_a_fast_ball_is_blocked_though_legs_would_stop_it(speed, seconds, lateral, book, answer):
    assert block_for(Shot(lateral, seconds, 180.0, speed), book == 'kelpie') == answer


@both('speed', [(30.0, 'block', 'adjust'), (60.0, 'block', 'adjust')])
def test_a_ball_of_12_cm_a_second_is_blocked(speed, book, answer):
    """It is at the goalie within 0.6 s and would roll in."""
    scenery = scene(180 + (12 + 0.4 * speed) * 1j, -speed * 1j, 180 + 12j)
    assert played(book, scenery).state.__name__ == answer


# Clearances

def best(book, x, y, facing=1j, opponent=None):
    """The kick of a ball that far right and ahead of a goalie at (180, 30)."""
    scenery = scene(180 + 30j + complex(x, y) * (facing / 1j), 0j, 180 + 30j, facing)
    if opponent is not None:
        scenery.world.opponents = [kelpie.OpponentEstimate(
            position=kelpie.Point2(x=opponent.real, y=opponent.imag), seconds_since_seen=0.1)]
    found = clearing_kick(by(scenery.world, book))
    return found and found.kick


def test_the_thesis_clears_by_a_forelegs_swipe_alone():
    """Wherever the ball lies; Kelpie's goalie has every kick of the map."""
    found = {book: {best(book, x, y) for x in range(-9, 10) for y in range(6, 17)} - {None}
             for book in ('kelpie', 'thesis')}
    assert found['thesis'] == set(UPENN) and found['kelpie'] - found['thesis']


@pytest.mark.parametrize('degrees', range(-180, 180, 15))
def test_no_swipe_sends_the_ball_at_the_own_goal(degrees):
    """It goes some 40 to 90 deg to a side: what may go in is left alone."""
    facing = complex(math.cos(math.radians(degrees)), math.sin(math.radians(degrees)))
    for x in range(-9, 10, 3):
        for y in range(6, 17, 2):
            scenery = scene(180 + 30j + complex(x, y) * (facing / 1j), 0j, 180 + 30j, facing)
            found = clearing_kick(by(scenery.world, 'thesis'))
            assert found is None or found.off_goal > 25.0


def test_who_stands_in_the_way_of_a_swipe_is_no_question():
    places_of_ball = [(x, y) for x in range(-9, 10) for y in range(6, 17)]
    alone = [best('thesis', x, y) for x, y in places_of_ball]
    assert alone == [best('thesis', x, y, opponent=180 + 70j) for x, y in places_of_ball]


@pytest.mark.parametrize('ball', [150 + 55j, 180 + 60j, 215 + 50j])
def test_it_walks_to_a_ball_near_the_goal_and_clears_it(ball):
    scenery, player = GoalieWorld(), Goalie()
    scenery.ball = ball
    run(scenery, lambda made: player.step(by(made, 'thesis')), 8.0)
    assert scenery.kicks > 0 and not scenery.conceded and scenery.outside == 0
    assert places.beyond_box(scenery.field, (scenery.ball.real, scenery.ball.imag)) > 15.0


@both('', [('attack', 'guard')])
def test_a_fast_ball_in_the_box_is_attacked_too(book, answer):
    assert played(book, scene(180 + 55j, 40j)).state.__name__ == answer


# Positioning

def stands(book, ball, seconds=4.0):
    scenery, player = GoalieWorld(), Goalie()
    scenery.ball = ball
    run(scenery, lambda made: player.step(by(made, book)), seconds)
    return scenery.at


@both('ball', [((180.0, 300.0), 20.0, 20.0), ((260.0, 150.0), 20.0, 20.0),
               ((300.0, 30.0), 20.0, 15.0), ((60.0, 24.0), 20.0, 12.0)])
def test_its_place_is_20_cm_from_the_line_wherever_the_ball_is(ball, book, answer):
    rule = places.fixed_bisector_place if book == 'thesis' else places.bisector_place
    field = kelpie.FIELDS['2006']
    x, y, _ = rule(field, ball)
    assert y == pytest.approx(answer)
    if y < ball[1] and abs(x - 180.0) < 35.0:
        angles = [places.direction(ball, there) for there in (*places.posts(field), (x, y))]
        assert angles[2] - angles[0] == pytest.approx(angles[1] - angles[2], abs=1e-6)


@both('', [(20.0, 14.0)])
def test_it_goes_there_in_play(book, answer):
    assert stands(book, 300 + 28j).imag == pytest.approx(answer, abs=4.0)


# What is Kelpie's alone: the pose, the mates, the own goal

@both('', [('guard', 'turn')])
def test_a_pose_far_off_the_box_is_no_reason_to_turn(book, answer):
    scenery, player = scene(180 + 200j), Goalie()
    for frame in range(280):
        scenery.see()
        scenery.world.percepts.landmarks = [kelpie.LandmarkPercept(kind=kelpie.GOAL_BLUE)]
        if frame > 10:
            scenery.world.pose.position.y = 160.0
            scenery.world.position_sd = 20.0
        player.step(by(scenery.world, book))
    assert player.state.__name__ == answer


@both('', [(160.0, 20.0)])
def test_a_pose_that_jumps_is_believed(book, answer):
    scenery, player = scene(180 + 300j), Goalie()
    for frame in range(12):
        scenery.see()
        if frame > 9:
            scenery.world.pose.position.y = 160.0
        player.step(by(scenery.world, book))
    assert player.now.world.pose.position.y == pytest.approx(answer)


@both('', [(None, (150.0, 50.0))])
def test_a_ball_that_mates_see_is_not_guarded_against(book, answer):
    scenery, player = scene(180 + 60j), Goalie()
    scenery.world.ball.seconds_since_seen = 2.0
    scenery.world.time_s = 100.0
    scenery.world.percepts.ball.present = False
    reported(scenery.world, 150 + 50j, 0.1)
    player.step(by(scenery.world, book))
    assert player.now.reported == answer


@both('', [(True, False)])
def test_it_walks_to_its_place_whatever_it_pushes(book, answer):
    """The ball lies between it and the goal: Kelpie's goes round it."""
    scenery, player = scene(180 + 36j, at=180 + 50j), Goalie()
    player.now.moved_s = -10.0
    walk = guards(player, by(scenery.world, book))
    assert (walk.forward < -10.0 and abs(walk.left) < 1.0) is answer


@both('seconds', [(0.5, 20.0, None), (3.0, 20.0, None), (8.0, 20.0, 10.0)])
def test_a_ball_lost_close_by_is_waited_for_at_y_20(seconds, book, answer):
    """Kelpie's stands and looks about at first, and goes to its line in the end."""
    scenery, player = scene(180 + 45j), Goalie()
    scenery.world.time_s = 100.0
    player.now.moved_s = 0.0
    player.now.update(by(scenery.world, book))
    player.eyes.tracked = 30.0
    scenery.world.ball.seconds_since_seen, scenery.world.percepts.ball.present = seconds, False
    player.eyes.enter(scenery.world, player.eyes.search, player.eyes.scan(scenery.world))
    scenery.world.time_s += min(seconds, 3.0)
    place = place_of(player, scenery.world)
    assert (place and place[1]) == (pytest.approx(answer) if answer else None)


def test_a_lost_ball_is_scanned_for_at_four_beacons_and_one_low_point():
    made = by(scene().world, 'thesis')
    scan, looks = PointScan(made, 1.0), set()
    begin = made.time_s
    for frame in range(60):
        made.time_s = begin + frame / 30.0
        scan.step(made)
        looks.add((scan.branch, scan.at))
    assert looks == {('beacon', 0), ('beacon', 1), ('beacon', 2), ('beacon', 3), ('low', 0)}
    assert scan.period() < 1.5 < PointScan(by(made, 'kelpie')).period()


# The goalie of 2004

@both('', [(PawKick, None)])
def test_the_goalie_of_2004_attacks_by_the_paw_kick(book, answer):
    scenery, player = scene(170 + 55j), EllipseGoalie()
    player.step(by(scenery.world, book))
    assert player.state == player.attack
    assert isinstance(player.skill, PawKick) is (answer is PawKick)


def test_its_paw_kick_meets_a_ball_ahead_and_no_motion_is_asked_for():
    scenery, player = scene(180 + 60j), EllipseGoalie()
    motions = set()
    for _ in range(90):
        command = player.step(by(scenery.world, 'thesis'))
        motions.add(command.motion)
        scenery.step(command)
    left, ahead = scenery.in_robot(180 + 60j)
    assert motions == {kelpie.NO_MOTION} and ahead < 20.0 and abs(left) < 9.0


@both('', [('attack', 'guard')])
def test_an_attack_of_2004_is_broken_off_by_place_and_angle_alone(book, answer):
    scenery, player = scene(170 + 55j), EllipseGoalie()
    player.step(by(scenery.world, book))
    scenery.world.ball.seconds_since_seen, scenery.world.percepts.ball.present = 1.5, False
    player.step(scenery.world)
    assert player.state.__name__ == answer


@pytest.mark.parametrize('seed', range(20))
def test_neither_goalie_leaves_its_box(seed):
    for make in (Goalie, EllipseGoalie):
        scenery, player = GoalieWorld(seed, noise=1.0), make()
        scenery.ball = complex(120 + 6 * seed, 25 + 2 * seed)
        run(scenery, lambda made, player=player: player.step(by(made, 'thesis')), 5.0)
        assert scenery.outside == 0
