# SPDX-License-Identifier: Apache-2.0
# Which team has the ball: ours, theirs, or nobody (loose), since when, and who says so. Each player
# judges by itself: whoever is nearest to the ball has it, but a ball that runs at the own goal
# beside an opponent is theirs, whoever runs after it. Of what the team says the word of who is
# nearest to the ball and sees it counts: a robot farther off does not see who is there. Keeps the
# own judgement, which changes after CHANGES_S, and the team's. As wrong as what is known of
# opponents (situation/about_ball.py).
import math

import kelpie
from lib.paths import SILENT_S, point_of
from situation import time_to
from situation.about_ball import opponents

HAS = 38.0           # cm from the neck base to a ball that a robot has: paws and head reach 18 to
                     # 20, and who runs with a ball is up to 40 behind it (the runners of 2005)
RUNS = 15.0          # cm/s to the own goal line of a ball that somebody runs with,
BESIDE = 60.0        # cm from whom it is then
CHANGES_S = 0.25     # s that the own judgement is another before it changes
SEES_S = 0.5         # s since who is asked saw the ball
NAMES = {kelpie.LOOSE: 'loose', kelpie.OURS: 'ours', kelpie.THEIRS: 'theirs'}


def who_has(ball, speed_up, ours, theirs) -> int:
    """`speed_up`: of the ball up-field, cm/s; `ours`, `theirs`: places of either team, as the ball
    in cm on the field."""
    our = min((math.dist(ball, one) for one in ours), default=math.inf)
    their = min((math.dist(ball, one) for one in theirs), default=math.inf)
    if speed_up < -RUNS and their < BESIDE:
        return kelpie.THEIRS
    if min(our, their) > HAS:
        return kelpie.LOOSE
    return kelpie.OURS if our <= their else kelpie.THEIRS


class Possession:
    def __init__(self, memory):
        self.memory = memory
        self.own = kelpie.LOOSE       # as this robot judges, and tells the team
        self.other, self.other_s = kelpie.LOOSE, 0.0   # what it saw last, and since when
        self.now, self.since_s = kelpie.LOOSE, 0.0     # as the team has it
        self.player, self.now_s = 0, 0.0   # who says so, and when
        self.asked = False            # nobody asks by rules that know no possession

    def update(self, world) -> None:
        """In every second frame, as the robot can spend little."""
        if world.frame % 2 == 0:
            return
        self.asked = True
        ball = time_to.ball_of(world, self.memory.ball_lost)
        seen = self.judged(world, ball) if ball is not None else kelpie.LOOSE
        if seen != self.other:
            self.other, self.other_s = seen, world.time_s
        if world.time_s - self.other_s >= CHANGES_S:
            self.own = seen
        self.player, said = self.word(world, ball)
        self.now_s = world.time_s
        if said != self.now:
            self.now, self.since_s = said, world.time_s

    def judged(self, world, ball) -> int:
        ours = [point_of(world.pose)] + [point_of(mate.pose) for mate in heard(world)]
        speed_up = world.ball.velocity.y if world.ball.seconds_since_seen < SEES_S else 0.0
        return who_has(ball, speed_up, ours, opponents(world, self.memory))

    def word(self, world, ball) -> tuple:
        """(player, possession) of who is nearest to the ball and sees it; itself when nobody is."""
        said = world.game.player, self.own
        if ball is None:
            return said
        sees = world.ball.present and world.ball.seconds_since_seen < SEES_S
        nearest = math.dist(point_of(world.pose), ball) if sees else math.inf
        for mate in heard(world):
            away = math.dist(point_of(mate.pose), ball)
            if mate.seconds_since_ball < SEES_S and away < nearest:
                nearest, said = away, (mate.player, mate.note.possession)
        return said

    def explain(self, trace) -> None:
        if self.asked:
            trace.append((kelpie.LAYER_DECISION, 'possession', NAMES[self.now],
                          'for {} s, as player {} says', self.now_s - self.since_s,
                          float(self.player)))


def heard(world) -> list:
    """The mates that were heard of lately."""
    return [mate for mate in world.teammates if mate.seconds_since_heard < SILENT_S]
