# SPDX-License-Identifier: Apache-2.0
# Three forwards on the plane who see the ball where their heads look, hear each other six times a
# second and 0.1 s late, and walk as they ask. The ball is pushed 30 cm ahead by who touches it, and
# moved now and then. Nobody is held by anybody. What it is for: who plays which role, and when.
import math
import random

import kelpie
from players.forward import Forward
from situations import put_ball, world

FRAME_S = 1.0 / 30.0
TELL_EVERY, LATE = 5, 3      # frames
VIEW, SIGHT = 28.0, 300.0    # deg to either side, cm
TOUCH, PUSH = 14.0, 30.0     # cm
BODY = 22.0                  # cm between two robots that touch


class TeamWorld:
    def __init__(self, seed, places=None, state=kelpie.PLAYING, **task):
        self.chance = random.Random(seed)
        self.ball = self.somewhere()
        places = places or [(*self.somewhere(), self.chance.uniform(-180, 180)) for _ in range(3)]
        self.worlds = [world(*place, self.ball) for place in places]
        self.players = [Forward() for _ in places]
        self.said = [[] for _ in places]
        self.frame = self.touched_by_others = 0
        self.nearest = math.inf
        for number, made in enumerate(self.worlds):
            made.game.player, made.game.state, made.game.kick_off = number + 2, state, True
            made.task = kelpie.Task(**task)

    def somewhere(self):
        return self.chance.uniform(40.0, 320.0), self.chance.uniform(60.0, 500.0)

    def step(self):
        """One frame; the answers of all."""
        self.frame += 1
        for made in self.worlds:
            self.see(made)
        for number, made in enumerate(self.worlds):
            self.hear(number, made)
        commands = [player.step(made) for player, made in zip(self.players, self.worlds)]
        for number, (made, command) in enumerate(zip(self.worlds, commands)):
            if (self.frame + number) % TELL_EVERY == 0:
                self.said[number].append((self.frame + LATE, mate_of(made, command.team)))
            move(made, command)
            self.push(made, command)
        self.nearest = min([self.nearest] + [apart(one, two) for one in self.worlds
                                             for two in self.worlds if one is not two])
        return commands

    def see(self, made):
        made.time_s, made.frame = made.time_s + FRAME_S, self.frame
        unseen = made.ball.seconds_since_seen + FRAME_S
        believed = made.ball.position.x, made.ball.position.y
        put_ball(made, *self.ball)
        off_deg = made.ball.heading_deg - made.head.head_pan_deg
        if abs(off_deg) > VIEW or made.ball.distance > SIGHT:
            put_ball(made, *believed, seen=False)
            made.ball.seconds_since_seen = unseen

    def hear(self, number, made):
        made.teammates = []
        for other, said in enumerate(self.said):
            heard = [mate for at, mate in said if at <= self.frame]
            if other != number and heard:
                made.teammates.append(heard[-1])
        seen = min(self.worlds, key=lambda one: one.ball.seconds_since_seen).ball
        made.team_ball = kelpie.TeamBall(present=seen.seconds_since_seen < 3.0, witnesses=1,
                                         position=kelpie.Point2(x=seen.position.x,
                                                                y=seen.position.y),
                                         seconds_since_seen=seen.seconds_since_seen)

    def push(self, made, command):
        place = made.pose.position
        if math.hypot(self.ball[0] - place.x, self.ball[1] - place.y) < TOUCH:
            self.touched_by_others += command.team.role != kelpie.ATTACKER
            angle = math.radians(made.pose.heading_deg)
            self.ball = (min(340.0, max(20.0, self.ball[0] + PUSH * math.cos(angle))),
                         min(520.0, max(20.0, self.ball[1] + PUSH * math.sin(angle))))


def mate_of(made, note):
    place = made.pose.position
    reported = kelpie.TeamNote(role=note.role, time_to_ball=note.time_to_ball, grabs=note.grabs,
                           wants=note.wants, wanted=note.wanted, pass_to=note.pass_to,
                           possession=note.possession)
    return kelpie.TeammateEstimate(
        player=made.game.player, note=reported, seconds_since_ball=made.ball.seconds_since_seen,
        pose=kelpie.Pose2(position=kelpie.Point2(x=place.x, y=place.y),
                          heading_deg=made.pose.heading_deg))


def apart(one, two):
    one, two = one.pose.position, two.pose.position
    return math.hypot(one.x - two.x, one.y - two.y)


def move(made, command):
    """Head and legs do what was asked, as fast as they can."""
    request, walk, pose = command.head, command.walk, made.pose
    pan = request.head_pan_deg
    if request.aim == kelpie.AIM_POINT:
        pan = math.degrees(math.atan2(-request.target.x, request.target.y))
    elif request.aim == kelpie.AIM_DIRECTION:
        pan = request.direction_deg
    step = max(-88.0, min(88.0, pan)) - made.head.head_pan_deg
    made.head.head_pan_deg += max(-12.0, min(12.0, step))
    ahead = max(-37.0, min(42.0, walk.forward)) * FRAME_S
    left = max(-35.0, min(35.0, walk.left)) * FRAME_S
    turn = max(-200.0, min(200.0, walk.turn_deg)) * FRAME_S
    angle = math.radians(pose.heading_deg)
    pose.position.x += ahead * math.cos(angle) - left * math.sin(angle)
    pose.position.y += ahead * math.sin(angle) + left * math.cos(angle)
    pose.heading_deg = (pose.heading_deg + turn + 180.0) % 360.0 - 180.0
    made.odometry = kelpie.Odometry(forward=ahead, left=left, turn_deg=turn)
    made.last_command = command
