# SPDX-License-Identifier: Apache-2.0
"""Short looks at landmarks: when the head leaves the ball for one, at which, and for how long."""
import kelpie
import pytest
from situation.memory import Memory
from situations import world
from skills.head.active_localise import ActiveLocalise, attacker_may_look, due, interval
from skills.head.glance import Glance


def scene(**changes):
    """A robot that sees a resting ball 150 cm ahead, with a sure pose and no look for 71 frames."""
    made, memory = world(180.0, 200.0, 90.0, (180.0, 350.0)), Memory(ball_lost=0)
    memory.ball_run, memory.localised_lost = 8, 71
    for name, value in changes.items():
        if hasattr(memory, name):
            setattr(memory, name, value)
        elif name == 'distance':
            made.ball.distance = value
        elif name in ('vx', 'vy'):
            setattr(made.ball.velocity, name[1], value)
        else:
            setattr(made, name, value)
    return made, memory


@pytest.mark.parametrize('changes, due_now', [
    ({}, True), ({'localised_lost': 70}, False),
    ({'localised_lost': 70, 'position_sd': 20.5}, True),
    ({'localised_lost': 70, 'position_sd': 19.5}, False),
    ({'localised_lost': 70, 'heading_sd_deg': 9.5}, True),
    ({'localised_lost': 70, 'heading_sd_deg': 8.5}, False),
    ({'localised_lost': 23, 'position_sd': 30.0}, True),
    ({'localised_lost': 22, 'position_sd': 30.0}, False),
    ({'distance': 45.5}, True), ({'distance': 44.5}, False),
    ({'ball_run': 7}, False),
    ({'vx': 14.5}, True), ({'vx': 15.5}, False), ({'vy': -15.5}, False),
    ({'vx': 11.0, 'vy': 11.0}, False)])
def test_a_glance_is_due_every_70_frames_every_22_with_a_bad_pose_if_the_ball_can_be_left(changes,
                                                                                          due_now):
    made, memory = scene(**changes)
    glance = Glance(memory)
    assert glance.due(made) is due_now
    assert glance.takes_head(made, True) is due_now and glance.looking is due_now


def test_a_skill_that_needs_the_head_keeps_it_and_ends_a_glance():
    made, memory = scene()
    glance = Glance(memory)
    assert not glance.takes_head(made, False) and not glance.looking
    assert glance.takes_head(made, True)
    assert not glance.takes_head(made, False) and not glance.looking


def test_a_glance_takes_11_frames_of_which_the_memory_knows():
    made, memory = scene()
    glance, frames = Glance(memory), 0
    while glance.takes_head(made, True):
        glance.step(made)
        frames += 1
        assert memory.localised_lost == 0
    assert frames == 11
    memory.localised_lost = 71
    assert glance.takes_head(made, True)


def test_a_glance_that_has_begun_goes_on_whatever_the_ball_does():
    made, memory = scene()
    glance = Glance(memory)
    glance.takes_head(made, True)
    made.ball.distance = 30.0
    assert glance.takes_head(made, True)


@pytest.mark.parametrize('place', [(-15.0, 405.0), (375.0, 405.0), (180.0, 540.0)])
@pytest.mark.parametrize('never', [False, True])
def test_the_landmark_that_was_seen_longest_ago_is_looked_at(place, never):
    made, memory = scene()
    memory.marks = {mark.kind: 500 for mark in made.field.landmarks}
    kind = next(mark.kind for mark in made.field.landmarks
                if (mark.position.x, mark.position.y) == place)
    if never:
        del memory.marks[kind]
    else:
        memory.marks[kind] = 499
    glance = Glance(memory)
    glance.takes_head(made, True)
    assert glance.state == glance.look and glance.mark.kind == kind
    target = glance.step(made).target
    assert (target.x, target.y) == pytest.approx((place[0] - 180.0, place[1] - 200.0))


def test_with_a_bad_pose_it_sweeps_60_deg_to_the_right_then_to_the_left():
    made, memory = scene(position_sd=30.0)
    glance, pans = Glance(memory), []
    for _ in range(3):
        memory.localised_lost = 23
        while glance.takes_head(made, True):
            request = glance.step(made)
        pans.append(request.head_pan_deg)
        assert 14.25 - request.neck_tilt_deg - request.head_nod_deg == pytest.approx(4.0)
    assert pans == [-60.0, 60.0, -60.0]


def test_without_a_landmark_in_reach_it_sweeps_too():
    made, memory = scene()
    made.pose.position.y = 535.0
    glance = Glance(memory)
    assert glance.takes_head(made, True) and glance.state == glance.sweep


def test_while_it_does_not_look_its_request_is_ahead():
    made, memory = scene()
    request = Glance(memory).none(made)
    assert request.head_pan_deg == 0.0
    assert 14.25 - request.neck_tilt_deg - request.head_nod_deg == pytest.approx(4.0)


# Active localisation (thesis 2006 section 4.3.2)

@pytest.mark.parametrize('distance, bearing', [(101.0, 9.5), (101.0, -9.5), (400.0, 0.0)])
def test_an_attacker_may_look_60_frames_after_a_spin_at_a_ball_100_cm_off_and_10_deg_ahead(
        distance, bearing):
    made, memory = scene(spin_lost=60, ball_run=5, close_lost=61, approach_lost=61,
                         localised_lost=61)
    made.ball.distance, made.ball.heading_deg = distance, bearing
    assert attacker_may_look(made, memory)


@pytest.mark.parametrize('sd, frames', [(0.0, 120.0), (5.0, 120.0), (17.5, 101.25), (30.0, 82.5),
                                        (42.5, 63.75), (55.0, 45.0), (500.0, 45.0)])
def test_looks_of_who_waits_come_sooner_in_proportion_from_5_to_55_cm(sd, frames):
    assert interval(sd) == pytest.approx(frames)


@pytest.mark.parametrize('since, sd, heading_sd, is_due', [
    (46, 0.0, 25.0, True), (46, 0.0, 24.9, False), (46, 55.0, 0.0, True), (46, 53.0, 0.0, False),
    (45, 55.0, 25.0, False), (83, 30.0, 0.0, True), (82, 30.0, 0.0, False)])
def test_a_pose_bad_by_55_cm_or_25_deg_is_looked_after_at_the_soonest(since, sd, heading_sd,
                                                                     is_due):
    made, memory = scene(localised_lost=since, position_sd=sd, heading_sd_deg=heading_sd)
    assert due(made, memory) is is_due


def looking(distance=150.0, sightings=0):
    """An attacker's look at a landmark that has begun; `sightings` frames have shown it."""
    made, memory = scene(spin_lost=20, distance=distance)
    made.ball.relative.y = distance
    skill = ActiveLocalise(memory)
    skill.start(made)
    for _ in range(sightings):
        made.percepts.landmarks = [kelpie.LandmarkPercept(kind=skill.mark.kind)]
        skill.step(made)
    made.percepts.landmarks = []
    return made, memory, skill


@pytest.mark.parametrize('sightings, over', [(1, False), (2, True)])
def test_a_look_is_over_with_two_sightings_of_its_landmark(sightings, over):
    made, _, skill = looking(sightings=sightings)
    skill.step(made)
    assert (skill.state == skill.back) is over


def test_another_landmark_is_no_sighting():
    made, _, skill = looking()
    others = [mark.kind for mark in made.field.landmarks if mark.kind != skill.mark.kind]
    made.percepts.landmarks = [kelpie.LandmarkPercept(kind=kind) for kind in others]
    skill.step(made)
    assert skill.sightings == 0


@pytest.mark.parametrize('distance, present, over', [(49.0, True, True), (51.0, True, False),
                                                     (49.0, False, False)])
def test_a_look_ends_when_the_ball_is_believed_within_50_cm(distance, present, over):
    made, _, skill = looking(distance)
    made.ball.present = present
    skill.step(made)
    assert (skill.state == skill.back) is over


def test_a_look_that_finds_nothing_lasts_10_frames_and_the_way_back_10():
    made, memory, skill = looking()
    memory.ball_lost = 1
    frames = 0
    while skill.state == skill.look:
        skill.step(made)
        frames += 1
    assert frames == 11 and not skill.done
    for frame in range(2, 11):
        skill.step(made)
        assert skill.done is (frame >= 10)


def test_who_sees_the_ball_again_is_done():
    made, memory, skill = looking(sightings=2)
    memory.ball_lost = 1
    skill.step(made)
    assert not skill.done
    memory.ball_lost = 0
    assert skill.done
