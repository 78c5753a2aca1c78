# SPDX-License-Identifier: Apache-2.0
# An ideal world in the plane: the robot moves as requested, sees what its head looks at without
# noise, a kick sends a ball in its strike zone to where the motion's table says, at once, and a
# grab catches a ball between the paws. Its geometry is its own, not that of lib/: the field is the
# complex plane in cm, a heading is a unit number. With `noise` 1 the ball is seen with standard
# deviations of 4 % and 1 deg, the goal with 2 deg, the pose is off by up to 15 cm and 6 deg, and
# the legs do 10 % less than was requested and than odometry reports.
import cmath
import math
import random

import kelpie

FRAME_S = 1.0 / 30.0
HALF_WIDTH, HALF_HEIGHT = 28.0, 22.5  # of the image, degrees
HELD_AHEAD = 8.0                      # cm from the neck base to a held ball
# Each motion's seconds; what it does not do ends it at once.
GRABS = {kelpie.GRAB: 0.4, kelpie.GRAB_LIFT: 0.4, kelpie.GRAB_QUICK: 0.2}
LASTS = {**GRABS, kelpie.RELEASE: 0.5, kelpie.KICK_FORWARD: 1.0,
         kelpie.HARD_FORWARD: 0.5, kelpie.WEDGE: 0.5, kelpie.HEAD_SWIPE_LEFT: 0.4,
         kelpie.HEAD_SWIPE_RIGHT: 0.4, kelpie.UPENN_LEFT: 0.5, kelpie.UPENN_RIGHT: 0.5,
         kelpie.GET_UP_FRONT: 1.5, kelpie.GET_UP_BACK: 1.5, kelpie.GET_UP_LEFT: 1.5,
         kelpie.GET_UP_RIGHT: 1.5}
# Where a free ball must lie (cm right, ahead, and how far off that at most) and where it goes (cm,
# deg to the left).
FREE = {kelpie.KICK_FORWARD: (0.0, 14.0, 2.5, 150.0, 0.0),
        kelpie.HEAD_SWIPE_LEFT: (3.0, 13.0, 3.5, 200.0, 37.0),
        kelpie.HEAD_SWIPE_RIGHT: (-3.0, 13.0, 3.5, 200.0, -37.0),
        kelpie.UPENN_LEFT: (6.0, 12.0, 3.5, 205.0, 42.0),
        kelpie.UPENN_RIGHT: (-6.0, 12.0, 3.5, 205.0, -42.0)}
# A kick that is new goes where its own file says.
FREE = {**{kick: (-reported.place[1], reported.place[0], 3.5, reported.distance, 0.0)
           for kick, reported in kelpie.KICKS.items() if reported.leaf}, **FREE}
LASTS = {**{kick: 0.5 for kick in kelpie.KICKS}, **LASTS}
HELD = {kelpie.HARD_FORWARD: (170.0, 0.0), kelpie.WEDGE: (125.0, 0.0),
        kelpie.HEAD_SWIPE_LEFT: (200.0, 75.0), kelpie.HEAD_SWIPE_RIGHT: (200.0, -75.0),
        kelpie.UPENN_LEFT: (205.0, 75.0), kelpie.UPENN_RIGHT: (205.0, -75.0)}


class IdealWorld:
    def __init__(self, seed, noise=0.0, field='2006'):
        chance = random.Random(seed)
        self.field = kelpie.FIELDS[field]
        self.goal = complex(0.5 * self.field.width, self.field.length)
        self.noise, self.chance = noise, chance
        wide, long = self.field.width / 360, self.field.length / 540
        self.at = complex(wide * chance.uniform(40, 320), long * chance.uniform(60, 400))
        self.ball = complex(wide * chance.uniform(60, 300), long * chance.uniform(100, 440))
        self.facing = cmath.rect(1, chance.uniform(0, 2 * math.pi))
        self.world = kelpie.WorldFrame(field=self.field)
        self.world.stance.body_tilt_deg = 14.25
        self.world.ball.seconds_since_seen = 0.0
        self.world.heading_sd_deg, self.world.position_sd = 5.0, 10.0
        self.left_s = 0.0    # of the motion that runs
        self.asked = False   # for a motion in the frame before
        self.held = False
        self.held_s, self.held_at = 0.0, 0j
        self.longest, self.farthest = 0.0, 0.0  # s and cm of all holds
        self.scored = False
        self.hidden = False  # nobody sees the ball any more
        self.kicks = self.grabs = 0

    def robot_frame(self, point):
        """(x right, y forward) in cm of a field point."""
        ahead = (point - self.at) / self.facing
        return -ahead.imag, ahead.real

    def in_view(self, point, height):
        """Whether the image shows a point that high (cm) above a place of the field. The head's
        chain: facts-2005 section 2.2."""
        x, y = self.robot_frame(point)
        head = self.world.head
        off_deg = math.degrees(math.atan2(-x, y)) - head.head_pan_deg
        lean = math.radians(14.25 - head.neck_tilt_deg)
        down = math.radians(14.25 - head.neck_tilt_deg - head.head_nod_deg)
        ahead = 8.0 * math.sin(lean) + 8.1 * math.cos(down) - 1.46 * math.sin(down)
        above = 11.95 + 8.0 * math.cos(lean) - 8.1 * math.sin(down) - 1.46 * math.cos(down)
        along = math.hypot(x, y) - ahead
        pitch = math.degrees(math.atan2(above - height, along) - down)
        return abs(off_deg) < HALF_WIDTH and abs(pitch) < HALF_HEIGHT

    def step(self, command):
        self.move_head(command.head)
        self.perform(command.motion)
        if self.left_s <= 0.0:
            self.walk(command.walk)
        self.roll()
        self.see()

    def joints(self, request):
        """The neck, pan and nod that a request asks for, whatever it aims at."""
        if request.aim == kelpie.AIM_JOINTS:
            return request.neck_tilt_deg, request.head_pan_deg, request.head_nod_deg
        if request.aim == kelpie.AIM_DIRECTION:
            pan, pitch = request.direction_deg, 14.25 + request.elevation_deg
        else:
            x, y, z = request.target.x, request.target.y, request.target.z
            pan = math.degrees(math.atan2(-x, y))
            pitch = 14.25 - math.degrees(math.atan2(16.0 - z, max(1.0, math.hypot(x, y) - 9.0)))
        neck = max(-32.0, min(0.0, pitch))
        return neck, max(-88.0, min(88.0, pan)), max(-5.0, min(45.0, pitch - neck))

    def move_head(self, request):
        head = self.world.head
        wanted = self.joints(request)
        for name, angle in zip(('neck_tilt_deg', 'head_pan_deg', 'head_nod_deg'), wanted):
            step = angle - getattr(head, name)
            step = max(-12.0, min(12.0, step))  # 360 deg/s
            setattr(head, name, getattr(head, name) + step)

    def walk(self, request):
        turn = math.radians(max(-218.0, min(218.0, request.turn_deg))) * FRAME_S
        step = complex(max(-30.0, min(42.0, request.forward)), max(-20.0, min(20.0, request.left)))
        step *= FRAME_S
        self.at += (1 - 0.1 * self.noise) * step * self.facing * cmath.rect(1, turn / 2)
        self.facing *= cmath.rect(1, (1 - 0.1 * self.noise) * turn)
        odometry = self.world.odometry
        odometry.forward, odometry.left = step.real, step.imag
        odometry.turn_deg = math.degrees(turn)
        x, y = self.robot_frame(self.ball)
        if not self.held and abs(x) < 7.0 and -5.0 < y < 5.0:  # the chest pushes the ball
            self.ball += (5.0 - y) * self.facing

    def perform(self, motion):
        """One frame of the motion that runs; another begins only when one frame asked for none."""
        odometry, status = self.world.odometry, self.world.motion
        odometry.forward = odometry.left = odometry.turn_deg = 0.0
        if self.left_s > 0.0:
            hurried = status.running in GRABS and motion == kelpie.GRAB_QUICK != status.running
            self.left_s -= 2.0 * FRAME_S if hurried else FRAME_S
            if self.left_s <= 0.0:
                self.finish(status.running)
        elif motion in LASTS and not self.asked:
            self.left_s, status.running = LASTS[motion], motion
            self.kick(motion)
        self.asked = motion != kelpie.NO_MOTION
        status.running = status.running if self.left_s > 0.0 else kelpie.NO_MOTION

    def finish(self, motion):
        if motion in GRABS:
            self.grabs += 1
            x, y = self.robot_frame(self.ball)
            self.held = abs(x) < 4.0 and 4.0 < y < 14.0
            self.held_s, self.held_at = 0.0, self.at
        elif motion == kelpie.RELEASE:
            self.held = False
        elif motion >= kelpie.GET_UP_FRONT:
            self.world.motion.feeling.fallen = kelpie.NOT_FALLEN

    def kick(self, motion):
        """Kicks strike as they begin."""
        x, y = self.robot_frame(self.ball)
        way = None
        if self.held:
            way = HELD.get(motion)
        elif motion in FREE:
            right, ahead, maximum, *where = FREE[motion]
            way = where if abs(x - right) < maximum and abs(y - ahead) < maximum else None
        self.kicks += motion in FREE or motion in HELD
        if way is not None:
            self.held = False
            self.shoot(self.ball + cmath.rect(way[0], math.radians(way[1])) * self.facing)

    def shoot(self, end):
        start, self.ball = self.ball, end
        line = self.goal.imag
        if start.imag < line <= end.imag:
            crossing = start + (end - start) * (line - start.imag) / (end.imag - start.imag)
            self.scored = abs(crossing.real - self.goal.real) < 0.5 * self.field.goal_width

    def roll(self):
        self.world.motion.feeling.ball_held = self.held
        if self.held:
            self.ball = self.at + HELD_AHEAD * self.facing
            self.held_s += FRAME_S
            self.longest = max(self.longest, self.held_s)
            self.farthest = max(self.farthest, abs(self.at - self.held_at))
        elif not self.scored:  # the referee puts a ball that left the field back inside
            self.ball = complex(max(30.0, min(self.field.width - 30.0, self.ball.real)),
                                max(40.0, min(self.field.length - 40.0, self.ball.imag)))

    def see(self):
        world = self.world
        world.frame += 1
        world.time_s += FRAME_S
        world.elapsed_s = FRAME_S
        drift = self.noise * math.sin(world.time_s)
        world.pose.position.x = self.at.real + 15.0 * drift
        world.pose.position.y = self.at.imag
        world.pose.heading_deg = math.degrees(cmath.phase(self.facing)) + 6.0 * drift
        self.see_ball()
        goal = self.goal
        world.percepts.landmarks, world.percepts.gaps = [], []
        if self.in_view(goal, 15.0) and abs(goal - self.at) < 400.0:
            x, y = self.robot_frame(goal)
            world.percepts.landmarks.append(kelpie.LandmarkPercept(
                kind=kelpie.GOAL_BLUE, distance=abs(goal - self.at),
                heading_deg=math.degrees(math.atan2(-x, y)) + self.wrong(2.0)))
            world.percepts.gaps.append(self.gap())

    def gap(self):
        """The goal is free from post to post."""
        half, wrong = 0.5 * self.field.goal_width, self.wrong(2.0)
        left, right = (math.degrees(math.atan2(-x, y)) + wrong for x, y in
                       map(self.robot_frame, (self.goal - half, self.goal + half)))
        return kelpie.GoalGap(goal=kelpie.GOAL_BLUE, left_deg=left, right_deg=right)

    def wrong(self, sd):
        return self.noise * self.chance.gauss(0.0, sd)

    def see_ball(self):
        ball = self.world.ball
        x, y = self.robot_frame(self.ball)
        # Nearer than 6 cm the chin is in the way.
        near = abs(self.ball - self.at) < 250.0 and y > 6.0
        seen = near and not self.hidden and self.in_view(self.ball, 4.2)
        ball.seconds_since_seen += FRAME_S
        self.world.percepts.ball.present = seen
        if seen:
            ball.present, ball.seconds_since_seen = True, 0.0
            seen_at = (self.ball - self.at) * (1.0 + self.wrong(0.04))
            self.believed = self.at + seen_at * cmath.rect(1, math.radians(self.wrong(1.0)))
            self.perceive(self.robot_frame(self.believed))
        if self.held:  # gps believes a ball that is felt in the hold
            ball.present, self.believed = True, self.ball
        elif ball.seconds_since_seen > 5.0:
            ball.present = False
        if not ball.present:
            return
        x, y = self.robot_frame(self.believed)
        ball.relative.x, ball.relative.y = x, y
        ball.distance = math.hypot(x, y)
        ball.heading_deg = math.degrees(math.atan2(-x, y))
        ball.position.x, ball.position.y = self.believed.real, self.believed.imag

    def perceive(self, place):
        """The percept of a ball in the robot frame, without its place in the image: its top is
        said to be out of it."""
        ball = self.world.percepts.ball
        ball.distance = math.hypot(*place)
        ball.heading_deg = math.degrees(math.atan2(-place[0], place[1]))
        ball.centre.y, ball.radius = 0.0, 1.0


def play(decide, seed, seconds, noise=0.0, field='2006', task=None):
    """The world after that many seconds or the first goal."""
    ideal = IdealWorld(seed, noise, field)
    ideal.world.task = task or kelpie.Task()
    ideal.see()
    while ideal.world.time_s < seconds and not ideal.scored:
        ideal.step(decide(ideal.world))
    return ideal
