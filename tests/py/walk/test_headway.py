# SPDX-License-Identifier: Apache-2.0
import kelpie
import pytest
from situation.headway import AWAY, MAX_FRAMES, NEAR, NEARER, SEEN_S, Headway
from skills.walk.paw_stuck import PawStuck


def world_with(distance, forward=30.0, unseen_s=0.0, present=True):
    world = kelpie.WorldFrame()
    world.ball.present, world.ball.distance = present, distance
    world.ball.seconds_since_seen = unseen_s
    world.last_command.walk.forward = forward
    return world


def after(frames, watch=None, **situation) -> Headway:
    watch = watch or Headway()
    for _ in range(frames):
        watch.update(world_with(**situation))
    return watch


def test_a_ball_that_comes_no_nearer_for_46_frames_of_walking_is_no_headway():
    assert not after(MAX_FRAMES + 1, distance=40.0).none
    assert after(MAX_FRAMES + 2, distance=40.0).none


@pytest.mark.parametrize('situation', [
    {'distance': NEAR - 0.1}, {'distance': 40.0, 'forward': 0.0},
    {'distance': 40.0, 'forward': -24.0}, {'distance': 40.0, 'unseen_s': SEEN_S + 0.01},
    {'distance': 40.0, 'present': False}])
def test_a_ball_near_unseen_or_not_walked_at_says_nothing(situation):
    assert not after(300, **situation).none


def test_a_ball_that_comes_nearer_or_rolls_away_begins_anew():
    for distance in (40.0 - NEARER, 40.0 + AWAY):
        watch = after(MAX_FRAMES, distance=40.0)
        assert not after(2, watch, distance=distance).none


def test_a_free_walk_to_a_ball_always_makes_headway():
    watch = Headway()
    for frame in range(300):
        watch.update(world_with(distance=300.0 - frame))
        assert not watch.none


def test_a_robot_without_headway_backs_off_once():
    skill, backs = PawStuck(), []
    for frame in range(3 * MAX_FRAMES):
        world = world_with(distance=40.0)
        world.time_s = frame / 30.0
        skill.update(world)
        backs.append(skill.needed(world))
    assert not any(backs[:MAX_FRAMES + 1]) and any(backs)
    began = backs.index(True)
    assert began == MAX_FRAMES + 1 and not all(backs[began:began + 30])
