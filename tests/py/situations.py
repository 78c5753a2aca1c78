# SPDX-License-Identifier: Apache-2.0
# Worlds for table tests: a robot somewhere on the field and a ball at a place, with all that
# follows from these two filled in as gps would.
import math

import kelpie


def world(x=180.0, y=200.0, heading=90.0, ball=(180.0, 260.0), field='2006'):
    """The robot at (x, y) cm looking along `heading` deg (90 is up-field), the ball seen now."""
    made = kelpie.WorldFrame(field=kelpie.FIELDS[field], elapsed_s=1.0 / 30.0)
    made.pose.position.x, made.pose.position.y, made.pose.heading_deg = x, y, heading
    made.heading_sd_deg, made.position_sd = 1.5, 3.0
    made.stance.body_tilt_deg = 14.25
    put_ball(made, *ball)
    return made


def put_ball(made, x, y, seen=True):
    ball, pose = made.ball, made.pose
    ball.present, ball.seconds_since_seen = True, 0.0 if seen else 1.0
    ball.position.x, ball.position.y = x, y
    ball.stopping_point.x, ball.stopping_point.y = x, y
    angle = math.radians(pose.heading_deg)
    dx, dy = x - pose.position.x, y - pose.position.y
    ball.relative.x = dx * math.sin(angle) - dy * math.cos(angle)
    ball.relative.y = dx * math.cos(angle) + dy * math.sin(angle)
    ball.distance = math.hypot(dx, dy)
    ball.heading_deg = math.degrees(math.atan2(-ball.relative.x, ball.relative.y))
    made.percepts.ball.present = seen
    made.percepts.ball.distance, made.percepts.ball.heading_deg = ball.distance, ball.heading_deg


def facing_up_point(degrees, ball=(180.0, 150.0), away=30.0, offset=60.0):
    """A robot `away` cm below a ball that lies straight ahead of the middle, turned so that the
    point `offset` cm up-field of the ball is that many degrees to its left."""
    made = world(ball[0], ball[1] - away, 90.0 - degrees, ball)
    assert offset > 0.0
    return made


def opponent(x, y, seen_s=0.0):
    """One that was seen so long ago, at a place of the field."""
    one = kelpie.OpponentEstimate()
    one.position.x, one.position.y, one.seconds_since_seen = x, y, seen_s
    return one
