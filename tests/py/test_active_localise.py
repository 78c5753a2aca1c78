# SPDX-License-Identifier: Apache-2.0
import kelpie
import pytest
from situation.memory import Memory
from situations import world
from skills.head.active_localise import (BACK_FRAMES, LOOK_FRAMES, ActiveLocalise,
                                         attacker_may_look, due, interval)
from skills.head.watch_play import WatchPlay

EAST = kelpie.BEACON_PINK_ON_BLUE
WEST = kelpie.BEACON_BLUE_ON_PINK


def begins(skill, world):
    """Whether a look is needed in this frame, which then begins."""
    needed = skill.needed(world)
    if needed:
        skill.start(world)
    return needed


def scene():
    """An attacker that has just spun and found the ball, far and straight ahead."""
    world = kelpie.WorldFrame(field=kelpie.FIELDS['2006'])
    world.pose.position.x, world.pose.position.y, world.pose.heading_deg = 180.0, 250.0, 90.0
    world.covariance = [50.0, 40.0, 0.0, 40.0, 50.0, 0.0, 0.0, 0.0, 0.01]
    world.ball.present, world.ball.distance, world.ball.relative.y = True, 150.0, 150.0
    world.percepts.ball.distance = 150.0
    memory = Memory()
    memory.spin_lost, memory.ball_run, memory.ball_lost = 20, 5, 0
    return world, memory


def test_all_conditions_together_allow_a_look():
    assert attacker_may_look(*scene())


@pytest.mark.parametrize('name, value', [
    ('spin_lost', 61), ('ball_run', 4), ('close_lost', 60), ('approach_lost', 60),
    ('localised_lost', 60)])
def test_each_condition_of_the_memory_blocks_it_alone(name, value):
    world, memory = scene()
    setattr(memory, name, value)
    assert not attacker_may_look(world, memory)
    assert not ActiveLocalise(memory).needed(world)


@pytest.mark.parametrize('name, value', [('distance', 100.0), ('heading_deg', 10.0),
                                         ('heading_deg', -10.0)])
def test_each_condition_of_the_ball_blocks_it_alone(name, value):
    world, memory = scene()
    setattr(world.ball, name, value)
    assert not attacker_may_look(world, memory)


def test_without_a_landmark_in_reach_there_is_no_look():
    world, memory = scene()
    assert ActiveLocalise(memory, 70.0).needed(world)
    world.pose.position.y, world.pose.heading_deg = 530.0, 90.0
    assert not ActiveLocalise(memory, 70.0).needed(world)


@pytest.mark.parametrize('xy, kind', [(40.0, EAST), (-40.0, WEST)])
def test_the_beacon_along_the_widest_axis_is_looked_at(xy, kind):
    world, memory = scene()
    world.covariance[1] = world.covariance[3] = xy
    skill = ActiveLocalise(memory)
    assert begins(skill, world) and skill.mark.kind == kind
    assert (skill.step(world).target.x > 0.0) is (kind == EAST)


def look(skill, world, memory, sees):
    """Frames of the look and of the way back to the ball; the ball is out of sight meanwhile."""
    looks = backs = 0
    while not skill.done:
        world.percepts.ball.present = backs > 3
        memory.update(world)
        world.percepts.landmarks = [kelpie.LandmarkPercept(kind=EAST)] if sees and looks > 4 else []
        skill.step(world)
        looks, backs = looks + (skill.state == skill.look), backs + (skill.state == skill.back)
        assert looks + backs < 100
    return looks, backs


@pytest.mark.parametrize('sees, looks', [(True, 6), (False, LOOK_FRAMES)])
def test_a_look_ends_with_two_sightings_or_soon_and_returns_to_the_ball(sees, looks):
    world, memory = scene()
    skill = ActiveLocalise(memory)
    assert begins(skill, world)
    assert look(skill, world, memory, sees)[0] == looks
    assert memory.ball_lost == 0 and memory.localised_lost <= BACK_FRAMES


def test_it_is_not_repeated_before_60_frames():
    world, memory = scene()
    skill = ActiveLocalise(memory)
    begins(skill, world)
    look(skill, world, memory, True)
    waited, world.percepts.ball.present = memory.localised_lost, True
    while not begins(skill, world):
        memory.spun(1.0)
        memory.update(world)
        waited += 1
        assert waited < 100
    assert waited == 61


def test_a_ball_that_comes_near_ends_the_look():
    world, memory = scene()
    skill = ActiveLocalise(memory)
    begins(skill, world)
    skill.step(world)
    world.ball.relative.y = 49.0
    skill.step(world)
    assert skill.state == skill.back and skill.why == 'the ball is near'


def test_who_waits_looks_the_sooner_the_less_sure_its_pose_is():
    frames = [interval(sd) for sd in range(0, 100, 5)]
    assert frames == sorted(frames, reverse=True) and (frames[0], frames[-1]) == (120, 45)


@pytest.mark.parametrize('since, sd, heading_sd, is_due', [
    (45, 60.0, 0.0, False), (46, 60.0, 0.0, True), (46, 0.0, 26.0, True), (46, 5.0, 5.0, False),
    (120, 5.0, 5.0, False), (121, 5.0, 5.0, True)])
def test_looks_of_who_waits_are_45_to_120_frames_apart(since, sd, heading_sd, is_due):
    world, memory = scene()
    memory.localised_lost = since
    world.position_sd, world.heading_sd_deg = sd, heading_sd
    assert due(world, memory) is is_due


def test_the_rule_of_who_waits_can_be_given():
    world, memory = scene()
    memory.spin_lost = 1000
    assert not ActiveLocalise(memory).needed(world)
    assert ActiveLocalise(memory, 80.0, due).needed(world)


def test_it_says_why():
    world, memory = scene()
    world.position_sd = 12.0
    skill, trace = ActiveLocalise(memory), []
    begins(skill, world)
    skill.explain(trace)
    assert trace[0][:4] == (kelpie.LAYER_SKILL, 'active_localise', 'look',
                            'the pose is sure to {} cm; a landmark at {} deg')
    assert trace[0][4:] == (12.0, pytest.approx(-51.5, abs=0.1))


def test_who_waits_with_a_sure_pose_looks_at_a_landmark_every_four_seconds_for_a_third_of_one():
    made, memory, looks = world(), Memory(), []
    made.position_sd = memory.localised_lost = 0
    watch = WatchPlay(memory)
    for _ in range(300):
        memory.update(made)
        watch.step(made, None)
        looks.append(watch.looking)
        trace = []
        watch.explain(trace)
        assert bool(trace) is watch.looking
    begun = [i for i in range(1, 300) if looks[i] and not looks[i - 1]]
    assert not looks[0] and begun[0] == 120 and 120 < begun[1] - begun[0] < 140
    assert 10 <= looks[:200].count(True) <= 12
