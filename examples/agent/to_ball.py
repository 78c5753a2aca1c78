#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""An agent for Kelpie's world with nothing but Python: it looks for orange in its camera image,
turns until there is some, and trots to it. It knows neither lines nor goals nor mates, and does not
get up when it falls. README.md beside it has the protocol.

    kelpie play --red-agent "python3 examples/agent/to_ball.py"
"""

import math
import os
import socket
import struct
import sys

MAGIC, HELLO, STEP, IMAGE, REPLY, GOODBYE = 0x4B4C5031, 0, 1, 2, 3, 4
WIDTH, PLANE = 208, 208 * 160  # pixels
PERIOD, LIFT = 48, 2.0         # of a double step: ticks of 8 ms, cm
LEAN = 0.18                    # the body's nose is so far down, in radians
JOINTS = (1 << 18) - 1
# Each leg's first joint, place of its shoulder (cm ahead of the body's middle, to the left), where
# its foot stands from there (cm ahead, out, below), its lower leg (cm), its share of the step.
LEGS = ((4, 6.5, 6.7, 3.8, 2.8, 9.7, 7.7, 0.0), (7, -6.5, 6.7, 2.1, 3.4, 12.4, 8.3, 0.5),
        (10, 6.5, -6.7, 3.8, 2.8, 9.7, 7.7, 0.5), (13, -6.5, -6.7, 2.1, 3.4, 12.4, 8.3, 0.0))


def receive(world, size):
    data = b""
    while len(data) < size:
        more = world.recv(size - len(data))
        if not more:
            sys.exit()  # the world is gone, so the match is over
        data += more
    return data


def message(world):
    _, kind, size = struct.unpack("<III", receive(world, 12))
    return kind, receive(world, size)


def ball_in(image):
    """Column and row in the middle of what is orange, or None; every third pixel is enough."""
    red, blue = image[PLANE:2 * PLANE:3], image[2 * PLANE::3]
    found = [3 * i for i, (cr, cb) in enumerate(zip(red, blue)) if cr > 160 and cb < 100]
    if len(found) < 4:
        return None
    columns = sorted(i % WIDTH for i in found)
    return columns[len(found) // 2], found[len(found) // 2] // WIDTH


def leg_angles(ahead, out, below, lower):
    """Degrees of rotator, shoulder and knee that bring the foot there. `ahead` is forward for a
    front leg and backward for a hind leg: in the robot's signs one is the other's mirror image."""
    upper, bend = math.hypot(6.95, 0.9), math.atan2(0.9, 6.95)
    below = math.hypot(below, out)
    cosine = (ahead ** 2 + below ** 2 - upper ** 2 - lower ** 2) / (2 * upper * lower)
    knee = math.acos(max(-1.0, min(1.0, cosine)))
    rotator = (math.atan2(ahead, below) - bend
               - math.atan2(lower * math.sin(knee), upper + lower * math.cos(knee)))
    return (math.degrees(rotator), math.degrees(math.atan2(out, below)),
            math.degrees(knee + bend))


class Walker:
    def __init__(self):
        self.tick = 0
        self.step, self.turn = 0.0, 0.4   # cm and radians that the body goes in a half step
        self.neck, self.pan = 0.0, 0.0    # degrees
        self.unseen = 0                   # images without a ball

    def see(self, image):
        ball = ball_in(image)
        self.unseen = 0 if ball else self.unseen + 1
        if ball:
            left = 57 * (0.5 - ball[0] / WIDTH)  # degrees; the image is 57 wide and 45 high
            self.neck = max(-50.0, min(0.0, self.neck - 0.1 * (ball[1] - 80)))
            self.turn = max(-0.4, min(0.4, 0.02 * left))
            self.step = 5.0 if abs(left) < 15 else 2.0
        elif self.unseen > 10:  # where it was seen last, it went out of sight
            self.step, self.neck = 0.0, 0.0
            self.turn = 0.4 if self.turn > 0 else -0.4

    def targets(self):
        """Of one tick, in microradians in the order of the joints."""
        self.tick += 1
        degrees = [self.neck, self.pan, 0.0, -3.0] + 12 * [0.0] + [30.0, 0.0]
        for first, x, y, ahead, out, below, lower, share in LEGS:
            phase = (self.tick / PERIOD + share) % 1.0
            way = 0.5 - 2 * phase if phase < 0.5 else 2 * phase - 1.5  # stance, then swing
            lift = LIFT * math.sin(2 * math.pi * (phase - 0.5)) if phase > 0.5 else 0.0
            forward = way * (self.step - self.turn * y)
            left = way * self.turn * x
            degrees[first:first + 3] = leg_angles((ahead + forward) * (1 if x > 0 else -1),
                                                  out + left * (1 if y > 0 else -1),
                                                  below - lift - LEAN * forward, lower)
        return [round(math.radians(d) * 1e6) for d in degrees]


def reply(vectors):
    """Motors on, every joint held at its usual gain, those vectors of four ticks, no radio."""
    body = struct.pack("<BIdI", 1, JOINTS, 1.0, len(vectors))
    for ticks in vectors:
        body += struct.pack("<II", len(ticks), JOINTS)
        body += struct.pack("<288i", *sum(ticks, []), *(288 - 18 * len(ticks)) * [0])
        body += struct.pack("<II", 0, 0)  # lights, ears
    return body + struct.pack("<I", 0)


def main():
    world = socket.socket(socket.AF_UNIX)
    world.connect(os.environ["KELPIE_SOCKET"])
    blue, player = os.environ["KELPIE_TEAM"] == "blue", int(os.environ["KELPIE_PLAYER"])
    hello = struct.pack("<BB", blue, player)
    world.sendall(struct.pack("<III", MAGIC, HELLO, len(hello)) + hello)
    walker, under_way = Walker(), 0
    while True:
        kind, step = message(world)
        if kind == GOODBYE:
            return
        under_way -= struct.unpack_from("<I", step, 829)[0]
        if step[833]:
            walker.see(message(world)[1])
        vectors = []
        while step[8] and under_way + len(vectors) < 2:  # one is played while the next waits
            vectors.append([walker.targets() for _ in range(4)])
        under_way += len(vectors)
        body = reply(vectors)
        world.sendall(struct.pack("<III", MAGIC, REPLY, len(body)) + body)


main()
