# SPDX-License-Identifier: Apache-2.0
"""The challenger by its thesis' rules alone (thesis 2004 sections 4.1.5 and 4.1.6), and by Kelpie's
where those differ."""
import math

import kelpie
import pytest
from books import both, by
from lib import features
from situations import world
from skills.head.watch_field import WatchField
from test_challenger import POINTS, Challenge2004

FIELD = kelpie.FIELDS['2006']
CENTRE = (180.0, 270.0)


@pytest.mark.parametrize('point, feature', [
    ((180.0, 250.0), CENTRE), ((60.0, 60.0), (115.0, 65.0)), ((20.0, 20.0), (0.0, 0.0)),
    # A feature within 15 cm is too near; the next one is faced.
    ((180.0, 280.0), (245.0, 475.0))])
def test_near_a_point_the_closest_feature_beyond_15_cm_is_faced(point, feature):
    found = features.to_face(FIELD, point)
    away = {place: math.dist(place, point) for place in features.primary(FIELD)}
    assert away[found] == min(each for each in away.values() if each > 15.0)
    if point != (180.0, 280.0):
        assert math.dist(found, feature) < 2.0
    else:
        assert math.dist(found, CENTRE) > 15.0


@pytest.mark.parametrize('point', POINTS)
def test_the_way_goes_to_a_place_behind_the_point_in_line_with_its_feature(point):
    feature, place = features.to_face(FIELD, point), features.behind(FIELD, point)
    assert math.dist(place, feature) == pytest.approx(
        math.dist(place, point) + math.dist(point, feature))
    assert 10.0 < math.dist(place, point) < 30.0


def announced(book):
    """Each point that is announced, with the bearing of its feature then."""
    run, found = Challenge2004(3), []
    by(run.world, book)
    run.world.position_sd, run.world.heading_sd_deg = 3.0, 1.0
    run.run(60)
    run.world.game.state = kelpie.SET
    run.run(2)
    run.ideal.at = 90 + 120j
    run.world.game.state = kelpie.PLAYING
    while len(found) < len(POINTS) and run.world.time_s < 200.0:
        before = len(run.said)
        run.run(0.1)
        if len(run.said) > before:
            at = run.said[-1]
            point = min(POINTS, key=lambda place: math.dist(place, at))
            x, y = run.ideal.robot_frame(complex(*features.to_face(FIELD, point)))
            found.append((point, math.dist(point, at), abs(math.degrees(math.atan2(x, y)))))
    return found


def test_at_each_point_the_challenger_faces_its_feature():
    found = announced('thesis')
    assert {point for point, _, _ in found} == {tuple(point) for point in POINTS}
    assert all(off < 6.0 for _, off, _ in found)
    assert all(bearing < 15.0 for _, _, bearing in found)
    assert max(bearing for _, _, bearing in announced('kelpie')) > 60.0


@both('', [(40, 30)])
def test_the_head_goes_to_the_next_feature_after_so_many_frames(book, answer):
    made, skill, targets = by(world(180.0, 150.0), book), WatchField(), []
    for frame in range(90):
        made.time_s = frame / 30.0
        skill.step(made)
        targets.append(skill.target)
    changes = [i for i in range(1, 90) if targets[i] != targets[i - 1]]
    assert changes[0] == pytest.approx(answer, abs=1)


@both('', [(True, False)])
def test_all_features_in_view_are_looked_at(book, answer):
    made, skill, targets = by(world(180.0, 150.0), book), WatchField(), set()
    for second in range(0, 90, 2):
        made.time_s = float(second)
        skill.step(made)
        targets.add(skill.target)
    assert (len(targets - {None}) > 2) is answer
