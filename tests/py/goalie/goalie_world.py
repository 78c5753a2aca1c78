# SPDX-License-Identifier: Apache-2.0
# A plane world for goalies: balls roll at the own goal, the goalie's commands are integrated. The
# field is the complex plane in cm, a heading is a unit number. Legs follow 0.1 s late and motions
# begin as late; a block covers what docs/physical-body.md says from when it says on; a ball in a
# kick's place goes where that table says. What the goalie knows of the ball is 0.07 s old, and
# wrong by `noise` times 2.5 % of its distance and 8 cm/s + 10 % of its speed.
import cmath
import math
import random

import kelpie
from decisions.guard_place import guard_place
from lib import kick_table
from lib.goalie_places import bisector_place, facing
from skills.head.point_scan import PointScan
from skills.walk.guard_goal import OF_2006, GuardGoal

FRAME_S = 1.0 / 30.0
LATE = 3            # frames from a command to the legs
REPORTED = 2        # frames from the ball to what is known of it
DRAG, BRAKE = 0.76, 6.0
# Motion: cover to the left and to the right (cm), from, to and end (s after its beginning).
BLOCKS = {kelpie.BLOCK: (21.4, 21.4, 0.12, 1.0, 1.7),
          kelpie.BLOCK_LEFT: (31.8, 12.7, 0.22, 0.95, 1.6),
          kelpie.BLOCK_RIGHT: (12.7, 31.8, 0.22, 0.95, 1.6)}
KICK_S = 0.7


def speed_to_go(distance):
    """cm/s at which a ball starts that rolls so far."""
    low, high = 0.0, 1000.0
    for _ in range(40):
        middle = 0.5 * (low + high)
        c = BRAKE / DRAG
        way = middle / DRAG - c * math.log1p(middle / c) / DRAG
        low, high = (middle, high) if way < distance else (low, middle)
    return low


class GoalieWorld:
    def __init__(self, seed=1, noise=0.0, field='2006'):
        self.chance, self.noise = random.Random(seed), noise
        self.field = kelpie.FIELDS[field]
        self.goal = complex(0.5 * self.field.width, 0.0)
        self.at, self.facing = self.goal + 20j, 1j
        self.ball, self.velocity = self.goal + 200j, 0j
        self.world = kelpie.WorldFrame(field=self.field)
        self.world.stance.body_tilt_deg = 14.25
        self.commands, self.balls = [], []
        self.running, self.ran_s, self.kicks = kelpie.NO_MOTION, 0.0, 0
        self.conceded = self.own_goal = False
        self.outside = self.frames = 0
        self.cleared = None   # the direction of the last kick that met the ball, deg
        self.see()

    # The ball

    def shoot(self, start, end, speed):
        self.ball = start
        self.velocity = speed * (end - start) / abs(end - start)
        self.cleared = None
        self.balls = []

    def roll(self):
        before = self.ball
        speed = abs(self.velocity)
        if speed > 0.0:
            slower = max(0.0, speed - (DRAG * speed + BRAKE) * FRAME_S)
            self.velocity *= slower / speed
        self.ball += self.velocity * FRAME_S
        self.stop_at_body(before)
        if self.ball.imag < -4.2 and abs(self.ball.real - self.goal.real) < 40.0:
            self.conceded = True
            self.own_goal = self.cleared is not None
            self.velocity = 0j

    def in_robot(self, point):
        """(left, ahead) of a point in the robot frame."""
        ahead = (point - self.at) / self.facing
        return ahead.imag, ahead.real

    def stop_at_body(self, before):
        left, right, ahead, behind = 7.5, 7.5, 4.0, -20.0
        covers = self.covering()
        if covers is not None:
            left, right = covers
        was, now = self.in_robot(before), self.in_robot(self.ball)
        crossed = was[1] > ahead >= now[1] and -right < now[0] < left
        inside = -7.5 < now[0] < 7.5 and behind < now[1] < ahead
        if crossed or inside:
            self.velocity = 0j
            if inside:   # it is pushed out by the body, the shorter way
                way = ahead - now[1] if now[1] > -8.0 else 0.0
                self.ball += way * self.facing
                if way == 0.0:
                    self.ball += math.copysign(7.5, now[0]) * 1j * self.facing - \
                        now[0] * 1j * self.facing
            else:
                self.ball = before

    def covering(self):
        if self.running in BLOCKS:
            left, right, start, end, _ = BLOCKS[self.running]
            if start < self.ran_s < end:
                return left, right
        return None

    # The robot

    def step(self, command):
        self.frames += 1
        self.commands.append(command)
        late = self.commands[-LATE] if len(self.commands) >= LATE else kelpie.Command()
        self.move_head(command.head)
        self.motion(late.motion)
        self.world.odometry = kelpie.Odometry()
        if self.running == kelpie.NO_MOTION:
            self.walk(late.walk)
        self.roll()
        self.see()
        half, x = 0.5 * self.field.box_width, self.at.real - self.goal.real
        self.outside += not (abs(x) <= half and 0.0 <= self.at.imag <= self.field.box_depth)

    def move_head(self, request):
        head = self.world.head
        for name in ('neck_tilt_deg', 'head_pan_deg', 'head_nod_deg'):
            step = getattr(request, name) - getattr(head, name)
            setattr(head, name, getattr(head, name) + max(-12.0, min(12.0, step)))

    def motion(self, wanted):
        if self.running != kelpie.NO_MOTION:
            self.ran_s += FRAME_S
            length = BLOCKS[self.running][4] if self.running in BLOCKS else KICK_S
            if self.ran_s > length:
                self.running = kelpie.NO_MOTION
        elif wanted in BLOCKS or wanted in kick_table.kicks(False):
            self.running, self.ran_s = wanted, 0.0
            if wanted not in BLOCKS:
                self.kick(wanted)

    def kick(self, which):
        left, ahead = self.in_robot(self.ball)
        outcome = kick_table.outcome(which, -left, ahead)
        self.kicks += 1
        if outcome is None or self.chance.random() > outcome[0]:
            return
        _, direction, sd, distance, far_sd = outcome
        angle = math.radians(self.chance.gauss(direction, sd))
        towards = self.facing * cmath.rect(1.0, angle)
        self.velocity = speed_to_go(max(10.0, self.chance.gauss(distance, far_sd))) * towards
        self.cleared = math.degrees(cmath.phase(towards))

    def walk(self, request):
        step = complex(max(-37.0, min(36.0, request.forward)),
                       max(-35.0, min(35.0, request.left))) * FRAME_S
        turn = math.radians(max(-214.0, min(214.0, request.turn_deg))) * FRAME_S
        self.at += step * self.facing
        self.facing *= cmath.rect(1.0, turn)
        odometry = self.world.odometry
        odometry.forward, odometry.left = step.real, step.imag
        odometry.turn_deg = math.degrees(turn)

    # What the goalie knows

    def see(self):
        world = self.world
        world.frame += 1
        world.time_s += FRAME_S
        world.elapsed_s = FRAME_S
        world.pose.position.x, world.pose.position.y = self.at.real, self.at.imag
        world.pose.heading_deg = math.degrees(cmath.phase(self.facing))
        world.position_sd, world.heading_sd_deg = 3.0, 1.5
        world.motion.running = self.running
        self.balls.append((self.ball, self.velocity))
        self.tell_ball(*self.balls[max(0, len(self.balls) - 1 - REPORTED)])

    def tell_ball(self, ball, velocity):
        reported = self.world.ball
        wrong = self.noise * 0.025 * abs(ball - self.at)
        ball += complex(self.chance.gauss(0.0, wrong), self.chance.gauss(0.0, wrong))
        wrong = self.noise * (8.0 + 0.1 * abs(velocity)) if abs(velocity) > 0.0 else 0.0
        velocity += complex(self.chance.gauss(0.0, wrong), self.chance.gauss(0.0, wrong))
        reported.present, reported.seconds_since_seen = True, 0.0
        reported.position.x, reported.position.y = ball.real, ball.imag
        reported.velocity.x, reported.velocity.y = velocity.real, velocity.imag
        left, ahead = self.in_robot(ball)
        reported.relative.x, reported.relative.y = -left, ahead
        reported.distance = abs(ball - self.at)
        reported.heading_deg = math.degrees(math.atan2(left, ahead))
        speed = abs(velocity)
        c = BRAKE / DRAG
        way = speed / DRAG - c * math.log1p(speed / c) / DRAG
        end = ball + (way * velocity / speed if speed > 0.0 else 0.0)
        reported.stopping_point.x, reported.stopping_point.y = end.real, end.imag
        percept = self.world.percepts.ball
        percept.present, percept.distance = True, reported.distance
        percept.heading_deg = reported.heading_deg


def shot(decide, seed, noise=1.0, field='2006', near=60.0, far=160.0, speeds=(80.0, 170.0)):
    """The world after one shot that would go in: 2.5 s to take up a place, then 4 s of the ball."""
    scene = GoalieWorld(seed, noise, field)
    chance = random.Random(seed + 1000)
    towards = cmath.rect(chance.uniform(near, far), math.radians(chance.uniform(35.0, 145.0)))
    start = scene.goal + towards
    end = scene.goal + complex(chance.uniform(-34.0, 34.0), -8.0)
    fast = max(chance.uniform(*speeds), speed_to_go(abs(end - start)) + 15.0)
    scene.ball = start
    run(scene, decide, 2.5)
    scene.shoot(start, end, fast)
    return run(scene, decide, 4.0)


def run(scene, decide, seconds):
    end = scene.world.time_s + seconds
    while scene.world.time_s < end and not scene.conceded:
        scene.step(decide(scene.world))
    return scene


def scene(ball=180 + 200j, velocity=0j, at=180 + 20j, facing=1j, seed=1, noise=0.0):
    """A goalie world in which all stand somewhere for some frames."""
    world = GoalieWorld(seed, noise)
    world.at, world.facing, world.ball, world.velocity = at, facing, ball, velocity
    world.balls.clear()
    for _ in range(3):
        world.see()
    return world


def blind_after(scenery, player, kicked, seconds):
    """The walk of a goalie that has not seen the ball since its motion ended so long ago."""
    world = scenery.world
    world.time_s = 100.0
    world.ball.seconds_since_seen = seconds + 0.1
    player.now.moved_s, player.now.kicked = world.time_s - seconds, kicked
    player.enter(world, player.guard, GuardGoal(OF_2006))
    player.eyes.enter(world, player.eyes.search, PointScan(world, 1.0))
    player.eyes.skill.start_s = world.time_s - seconds
    player.eyes.skill.branch, player.eyes.skill.at = 'near', 3    # the look at which it turns
    walk = guards(player, world)
    return walk.forward, walk.left, walk.turn_deg


def guards(player, world):
    """The walk of a goalie that guards in this frame."""
    player.now.update(world)
    return player.guard(world).walk


def place_of(player, world):
    """Where it guards, or None."""
    player.now.update(world)
    return guard_place(player.now, player.eyes, player.rule or bisector_place)


def reported(world, ball, seconds, sd=3.0):
    """Mates see the ball there, so long ago, sure to so many cm."""
    world.teammates = [kelpie.TeammateEstimate(player=2, seconds_since_heard=0.1)]
    world.team_ball = kelpie.TeamBall(present=True, seconds_since_seen=seconds,
                                      position=kelpie.Point2(x=ball.real, y=ball.imag),
                                      covariance=[sd * sd, 0.0, 0.0, sd * sd])


def anywhere(seed, chance):
    """A noisy scene: the goalie in its box, the ball rolling somewhere in its half."""
    return scene(complex(chance.uniform(0, 360), chance.uniform(5, 250)),
                 complex(chance.gauss(0, 30), chance.gauss(0, 30)),
                 complex(chance.uniform(125, 235), chance.uniform(8, 55)),
                 cmath.rect(1.0, seed), seed, 1.0)


def world_at(x=180.0, y=20.0, heading=90.0):
    """A goalie that stands there and believes a ball 150 cm ahead."""
    world = kelpie.WorldFrame(field=kelpie.FIELDS['2006'])
    world.stance.body_tilt_deg = 14.25
    world.pose = kelpie.Pose2(position=kelpie.Point2(x=x, y=y), heading_deg=heading)
    world.position_sd, world.heading_sd_deg = 3.0, 2.0
    world.ball = kelpie.BallEstimate(present=True, distance=150.0)
    world.ball.relative.y = 150.0
    return world


CIRCLE = 10.0, 45.0    # cm, the least and the greatest radius,
BALL = 60.0, 250.0     # cm, for a ball that near to the goal's middle, and that far


def circle_place(field, ball):
    """The rule that older teams had (thesis 2006 section 4.3.1): on a circle about the goal's
    middle, farther out for a farther ball."""
    dx, dy = ball[0] - 0.5 * field.width, max(ball[1], 0.0)
    away = max(math.hypot(dx, dy), 1e-6)
    share = min(1.0, max(0.0, (away - BALL[0]) / (BALL[1] - BALL[0])))
    radius = CIRCLE[0] + share * (CIRCLE[1] - CIRCLE[0])
    return facing((0.5 * field.width + radius * dx / away, radius * dy / away), ball)


def nobody(world):
    """The empty goal: a player that stands by and does nothing."""
    return kelpie.Command()
