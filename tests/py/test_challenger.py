# SPDX-License-Identifier: Apache-2.0
import math

import kelpie
import pytest
from ideal_world import IdealWorld
from lib import features
from lib.route import orders, points_of, shortest, way
from players.challenger import Challenger
from skills.head.watch_field import in_reach
from skills.walk.go_to_point import Challenge

POINTS = [(60, 60), (300, 480), (60, 480), (300, 60), (180, 270)]


def test_task_holds_x_and_y_in_turn():
    task = kelpie.Task(points=[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0])
    assert points_of(task) == [(1, 2), (3, 4), (5, 6), (7, 8), (9, 10)]


def test_all_orders_are_tried_once():
    tried = [tuple(order) for order in orders(POINTS)]
    assert len(tried) == len(set(tried)) == 120


def test_shortest_goes_round_and_not_across():
    order = shortest(kelpie.Point2(x=50.0, y=50.0), POINTS)
    assert order[0] == (60, 60)
    assert way((50, 50), order) == min(way((50, 50), o) for o in orders(POINTS))
    assert way((50, 50), order) < way((50, 50), POINTS)


FIELD = kelpie.FIELDS['2006']
FEATURES = features.primary(FIELD), features.secondary(FIELD)


def pose(x, y, heading):
    return kelpie.Pose2(position=kelpie.Point2(x=x, y=y), heading_deg=heading)


def test_nearly_every_pose_has_a_feature_in_reach():
    poses = [pose(x, y, h) for x in range(40, 340, 40) for y in range(40, 520, 40)
             for h in range(0, 360, 30)]
    assert sum(bool(in_reach(p, *FEATURES)) for p in poses) > 0.95 * len(poses)


def test_features_in_reach_are_neither_near_nor_far_nor_behind():
    assert (180, 270) in in_reach(pose(180, 250, 90), *FEATURES)
    assert (180, 270) not in in_reach(pose(180, 260, 90), *FEATURES)  # 10 cm ahead
    for x, y in in_reach(pose(100, 200, 90), *FEATURES):
        assert y > 200 and 15 < math.hypot(x - 100, y - 200) < 200


class Challenge2004:
    """The challenger in an ideal world that knows its pose; run() plays it for some seconds."""

    def __init__(self, seed):
        self.ideal = IdealWorld(seed)
        self.world = self.ideal.world
        self.world.modes = [kelpie.PoseMode(weight=1.0)]
        self.world.task = kelpie.Task(player=kelpie.CHALLENGER,
                                      points=[float(c) for point in POINTS for c in point])
        self.world.game.state = kelpie.PLAYING
        self.player = Challenger()
        self.mapped = self.announced = 0
        self.said = []

    def run(self, seconds):
        end = self.world.time_s + seconds
        while self.world.time_s < end:
            self.ideal.see()
            self.world.pose.position.x = self.ideal.at.real
            self.world.pose.heading_deg = math.degrees(
                math.atan2(self.ideal.facing.imag, self.ideal.facing.real))
            command = self.player.step(self.world)
            self.mapped += command.pinks == kelpie.PINKS_MAP
            if command.mouth_open and not self.announced:
                self.said.append((self.ideal.at.real, self.ideal.at.imag))
            self.announced = command.mouth_open
            self.last = command
            self.ideal.move_head(command.head)
            self.ideal.walk(command.walk)


def test_the_whole_challenge_in_an_ideal_world():
    run = Challenge2004(3)
    run.world.position_sd, run.world.heading_sd_deg = 3.0, 1.0
    run.run(60)
    assert run.mapped > 20 * 30 and not run.said
    run.world.game.state = kelpie.SET
    run.run(2)
    assert run.last.pinks == kelpie.PINKS_LOCALISE and run.last.walk.forward == 0.0
    run.ideal.at, run.world.position_sd = 90 + 120j, 250.0
    run.world.game.state = kelpie.PLAYING
    run.run(12)
    assert not run.said and run.last.pinks == kelpie.PINKS_LOCALISE
    run.world.position_sd = 3.0
    run.run(80)
    assert len(run.said) == 5
    for x, y in POINTS:
        assert min(math.hypot(x - a, y - b) for a, b in run.said) < 2.0 * Challenge.NEAR


def test_a_halt_at_the_very_start_is_not_the_end_of_mapping():
    run = Challenge2004(4)
    run.world.position_sd, run.world.heading_sd_deg = 3.0, 1.0
    run.world.game.state = kelpie.SET
    run.run(1)
    run.world.game.state = kelpie.PLAYING
    run.run(30)
    assert run.mapped > 0 and not run.said


def test_the_map_is_made_from_65_cm_before_the_middle_and_from_as_far_beyond():
    player = Challenger()
    assert player.to_stand(FIELD).point == (180.0, 205.0)
    player.beyond = True
    assert player.to_stand(FIELD).point == (180.0, 335.0)


@pytest.mark.parametrize('sd, heading_sd, weight, known', [
    (14.0, 5.0, 0.61, True), (16.0, 5.0, 0.61, False), (14.0, 7.0, 0.61, False),
    (14.0, 5.0, 0.59, False), (14.0, 5.0, None, False)])
def test_a_place_is_known_to_15_cm_and_6_degrees_by_a_mode_of_0_6(sd, heading_sd, weight, known):
    world = kelpie.WorldFrame(field=FIELD, position_sd=sd, heading_sd_deg=heading_sd)
    world.modes = [] if weight is None else [kelpie.PoseMode(weight=weight)]
    assert Challenger().knows_place(world) is known
