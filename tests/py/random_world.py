# SPDX-License-Identifier: Apache-2.0
# Worlds that no field ever shows, to attack the behaviours with: all that a frame tells changes at
# random, most of it seldom, so that skills get into all of their states. Every number is finite but
# parts contradict one another: a ball in the arms that gps has on the other side, a motion that
# nobody asked for, a clock that stands still or jumps. Mates come and go, all alone is one world in
# three. What a Command may be is at the end.
import math
import random

import kelpie

FRAME_S = 1.0 / 30.0
FAR = 700.0          # cm
LOOKS = [(present, seen) for present in (True, True, False) for seen in (True, True, False)]
FALLEN = (kelpie.ON_FRONT, kelpie.ON_BACK, kelpie.ON_LEFT, kelpie.ON_RIGHT)


class RandomWorld:
    """`home`: the robot is near its own goal mostly. Some worlds change often, some seldom."""

    def __init__(self, seed, home=False, **task):
        self.chance, self.home = random.Random(seed), home
        pace = self.pick((0.15, 0.5, 1.0, 2.0))
        self.changes = [(change, pace * share) for change, share in CHANGES]
        self.world = kelpie.WorldFrame(field=kelpie.FIELDS[self.pick(list(kelpie.FIELDS))])
        self.world.task = kelpie.Task(
            grab=self.often(0.8), kicks=self.pick((0, 1)), aiming=self.pick((0, 1)),
            search=self.pick((0, 0, 1)), dodge=self.often(0.7), intercept=self.often(0.7),
            points=[self.between(0.0, FAR) for _ in range(10)], **task)
        self.world.game.team = self.pick((kelpie.RED, kelpie.BLUE))
        self.world.modes = [kelpie.PoseMode(weight=1.0)]
        self.place_robot()
        self.place_ball()
        self.team_chance = random.Random(seed + 7919)
        self.chance, kept = self.team_chance, self.chance
        self.mates = self.pick((0.0, 0.3, 1.0))
        self.world.game.player = self.pick((1, 2, 3, 4))
        task = self.world.task
        task.positions, task.passing = self.pick((0, 1)), self.often(0.5)
        task.distributed_find, task.bird_of_prey = self.often(0.7), self.often(0.7)
        self.chance = kept

    def pick(self, values):
        return values[int(len(values) * self.chance.random())]

    def often(self, share):
        return self.chance.random() < share

    def between(self, low, high):
        return low + (high - low) * self.chance.random()

    def next(self, command):
        """The next frame after that answer."""
        world = self.world
        world.last_command = command
        world.frame += self.pick((1, 1, 1, 1, 3))
        world.elapsed_s = FRAME_S if self.often(0.8) else self.between(0.0, 0.2)
        world.time_s += world.elapsed_s
        if self.often(0.002):
            world.time_s += self.between(0.0, 60.0)
        self.move()
        self.run(command.motion)
        for change, share in self.changes:
            if self.chance.random() < share:
                change(self)
        self.team()
        return world

    def move(self):
        odometry, head = self.world.odometry, self.world.head
        odometry.forward, odometry.left = self.between(-3.0, 3.0), self.between(-2.0, 2.0)
        odometry.turn_deg = self.between(-8.0, 8.0)
        head.head_pan_deg = max(-90.0, min(90.0, head.head_pan_deg + self.between(-15.0, 15.0)))
        ball = self.world.ball
        ball.seconds_since_seen += self.world.elapsed_s
        if self.world.percepts.ball.present and self.often(0.9):
            ball.seconds_since_seen = 0.0

    def run(self, wanted):
        """A motion begins when it is asked for, or not, and ends some time."""
        status = self.world.motion
        if status.running == kelpie.NO_MOTION:
            if wanted != kelpie.NO_MOTION and self.often(0.3):
                status.running = wanted
        elif self.often(0.1):
            if status.running in (kelpie.GRAB, kelpie.GRAB_QUICK, kelpie.GRAB_LIFT):
                status.feeling.ball_held = self.often(0.8)
            status.running = kelpie.NO_MOTION
        status.seconds_left = self.between(0.0, 2.0)

    # What changes now and then

    def stand_still(self):
        self.world.odometry = kelpie.Odometry()

    def place_robot(self):
        pose, field = self.world.pose, self.world.field
        pose.position.x = self.between(-60.0, field.width + 60.0)
        pose.position.y = self.between(-60.0, field.length + 60.0)
        if self.home and self.often(0.8):
            pose.position.x = 0.5 * field.width + self.between(-60.0, 60.0)
            pose.position.y = self.between(0.0, 70.0)
        pose.heading_deg = self.pick((90.0, -90.0, 180.0, self.between(-720.0, 720.0)))
        self.world.position_sd = self.pick((0.0, 3.0, 30.0, 300.0))
        self.world.heading_sd_deg = self.pick((0.0, 2.0, 15.0, 180.0))
        self.world.seconds_since_landmark = self.pick((0.0, 1.0, 100.0))
        self.world.covariance = [self.between(-50.0, 500.0) for _ in range(9)]

    def place_ball(self):
        """Near or far in the robot frame and, mostly, at the same place of the field."""
        ball, pose = self.world.ball, self.world.pose
        reach = self.pick((3.0, 14.0, 14.0, 30.0, 120.0, FAR))
        x, y = self.between(-reach, reach), self.pick((1.0, 1.0, -1.0)) * self.between(0.0, reach)
        if self.often(0.3):  # straight ahead
            x = self.between(-3.0, 3.0)
        if self.often(0.05):
            x = y = 0.0
        ball.relative.x, ball.relative.y, ball.distance = x, y, math.hypot(x, y)
        ball.heading_deg = math.degrees(math.atan2(-x, y))
        angle = math.radians(pose.heading_deg)
        ball.position.x = pose.position.x + x * math.sin(angle) + y * math.cos(angle)
        ball.position.y = pose.position.y - x * math.cos(angle) + y * math.sin(angle)
        if self.often(0.2):
            ball.position.x, ball.position.y = self.between(-30, 400), self.between(-30, 600)
        ball.covariance = [self.pick((0.0, 9.0, 1e5)) for _ in range(4)]
        self.see_ball()

    def see_ball(self):
        ball, percept = self.world.ball, self.world.percepts.ball
        ball.present, percept.present = self.pick(LOOKS)
        if percept.present:
            ball.seconds_since_seen = 0.0
        percept.distance = max(0.0, ball.distance * self.between(0.8, 1.2))
        percept.heading_deg = ball.heading_deg + self.between(-5.0, 5.0)
        percept.centre.x, percept.centre.y = self.between(0.0, 208.0), self.between(-20.0, 160.0)
        percept.radius = self.between(0.0, 80.0)

    def roll_ball(self):
        ball = self.world.ball
        fast = self.pick((0.0, 20.0, 300.0))
        ball.velocity.x, ball.velocity.y = self.between(-fast, fast), self.between(-fast, fast)
        ball.stopping_point.x = ball.position.x + ball.velocity.x
        ball.stopping_point.y = ball.position.y + ball.velocity.y

    def see_landmarks(self):
        kinds = range(6)
        self.world.percepts.landmarks = [
            kelpie.LandmarkPercept(kind=self.pick(kinds), distance=self.between(0.0, FAR),
                                   heading_deg=self.between(-120.0, 120.0))
            for _ in range(self.pick((0, 1, 2)))]
        edges = [self.between(-90.0, 90.0) for _ in range(3)]
        self.world.percepts.gaps = [
            kelpie.GoalGap(goal=self.pick((kelpie.GOAL_BLUE, kelpie.GOAL_YELLOW)),
                           left_deg=edge, right_deg=edge - self.pick((0.0, 8.0, 40.0)))
            for edge in edges[:self.pick((0, 1, 2, 3))]]

    def see_others(self):
        self.world.percepts.robots = [
            kelpie.RobotPercept(distance=self.between(0.0, 300.0),
                                heading_deg=self.between(-90.0, 90.0))
            for _ in range(self.pick((0, 0, 1, 3)))]
        self.world.percepts.obstacles_ahead = self.pick((0, 0, 5, 50))
        self.world.opponents = [kelpie.OpponentEstimate(position=self.point())
                                for _ in range(self.pick((0, 1, 2)))]
        self.world.teammates = [kelpie.TeammateEstimate()] * self.pick((0, 0, 1))
        self.world.obstacles = [
            kelpie.ObstacleCell(position=self.point(), own=self.between(0.0, 30.0))
            for _ in range(self.pick((0, 0, 6)))]

    # Mates come and go and say what they like; chances of their own, so that the rest of a world
    # does not depend on them.

    def team(self):
        self.chance, kept = self.team_chance, self.chance
        if self.often(0.03):
            self.see_mates()
        if self.often(0.002):
            self.kick_off()
        self.chance = kept

    def see_mates(self):
        self.world.teammates = [
            kelpie.TeammateEstimate(
                player=number, note=self.note(), position_sd=self.between(0.0, 60.0),
                pose=kelpie.Pose2(position=self.point(), heading_deg=self.between(-180, 180)),
                seconds_since_heard=self.pick((0.0, 0.3, 1.4, 3.0)),
                seconds_since_ball=self.pick((0.0, 0.4, 3.0, 1000.0)))
            for number in range(1, 5)
            if self.often(self.mates) and number != self.world.game.player]
        ball = self.world.team_ball
        ball.present, ball.position = self.often(0.5), self.point()
        ball.seconds_since_seen = self.pick((0.0, 0.5, 5.0))

    def note(self):
        return kelpie.TeamNote(role=self.pick(range(6)), grabs=self.pick((0, 0, 0, 1, 2)),
                               time_to_ball=self.pick((0.0, 3.0, 1000.0, self.between(0, 10))),
                               wants=self.often(0.5), wanted=self.point(),
                               pass_to=self.pick(range(5)), possession=self.pick(range(3)))

    def kick_off(self):
        game = self.world.game
        game.state = self.pick((kelpie.READY, kelpie.SET, kelpie.INITIAL, kelpie.PLAYING))
        game.kick_off = self.often(0.5)
        game.own_score, game.opponent_score = self.pick((0, 1)), self.pick((0, 0, 6))

    def point(self):
        field = self.world.field
        return kelpie.Point2(x=self.between(0.0, field.width), y=self.between(0.0, field.length))

    def feel(self):
        feeling, sensors = self.world.motion.feeling, self.world.sensors
        feeling.ball_held = self.often(0.5)
        feeling.paw_blocked = [self.often(0.05), self.often(0.05)]
        sensors.head_near_distance = self.pick((50.0, 50.0, self.between(2.0, 50.0)))

    def fall(self):
        feeling = self.world.motion.feeling
        up = feeling.fallen == kelpie.NOT_FALLEN
        feeling.fallen = self.pick(FALLEN) if up and self.often(0.05) else kelpie.NOT_FALLEN

    def halt(self):
        game = self.world.game
        playing = game.state == kelpie.PLAYING and not game.penalised
        stop = playing and self.often(0.1)
        game.state = kelpie.SET if stop and self.often(0.5) else kelpie.PLAYING
        game.penalised = stop and self.often(0.5)

    def start_motion(self):
        self.world.motion.running = int(22 * self.chance.random())

    def change_modes(self):
        weights = self.pick(((), (1.0,), (0.7, 0.3)))
        self.world.modes = [kelpie.PoseMode(weight=weight) for weight in weights]

    def stand(self):
        stance, head = self.world.stance, self.world.head
        stance.shoulder_height = self.between(3.0, 14.0)
        stance.body_tilt_deg, stance.body_roll_deg = self.between(-90, 90), self.between(-90, 90)
        head.neck_tilt_deg, head.head_nod_deg = self.between(-75, 0), self.between(-15, 45)


# How large a share of the frames each change comes in.
R = RandomWorld
CHANGES = ((R.stand_still, 0.3), (R.place_robot, 0.01), (R.place_ball, 0.02), (R.see_ball, 0.05),
           (R.roll_ball, 0.03), (R.see_landmarks, 0.05), (R.see_others, 0.02), (R.feel, 0.03),
           (R.fall, 0.03), (R.halt, 0.03), (R.start_motion, 0.003), (R.change_modes, 0.01),
           (R.stand, 0.01))


# What a Command may be

WALK = ('forward', 'left', 'turn_deg', 'pivot')
HEAD = ('neck_tilt_deg', 'head_pan_deg', 'head_nod_deg', 'speed_deg', 'direction_deg',
        'elevation_deg')


def check(command):
    """That the host would take the Command as it is."""
    walk, head = command.walk, command.head
    check_numbers([getattr(walk, name) for name in WALK])
    check_numbers([getattr(head, name) for name in HEAD])
    check_numbers([head.target.x, head.target.y, head.target.z])
    assert walk.kind in range(7) and head.aim in range(3) and command.motion in range(23)
    check_note(command.team)
    check_trace(command.trace)


def check_note(note):
    assert note.role in range(6) and note.grabs in range(3) and note.pass_to in range(5) and \
        note.possession in range(3)
    assert 0.0 <= note.time_to_ball <= 1000.0 and type(note.wants) is bool
    check_numbers([note.time_to_ball, note.wanted.x, note.wanted.y])


def check_numbers(numbers):
    for number in numbers:
        assert type(number) in (int, float) and math.isfinite(number), numbers


def check_trace(trace):
    assert len(trace) <= 9, trace
    for step in trace:
        layer, module, branch, reason, *numbers = step
        assert layer in range(4) and 0 < len(module) <= 20 and len(branch) <= 24, step
        assert len(reason) <= 80 and reason.count('{}') == len(numbers) <= 3, step
        check_numbers(numbers)
