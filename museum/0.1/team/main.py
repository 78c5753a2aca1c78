# SPDX-License-Identifier: Apache-2.0
# Walks to the ball and kicks it ahead. decide(world) is asked thirty times a second what to do.
import kelpie


def decide(world):
    ball, command = world.ball, kelpie.Command()
    if not ball.present or ball.seconds_since_seen > 1.0:
        command.walk.turn_deg = 90.0                           # deg/s to the left: looks all round
        return command
    place = kelpie.Point3(x=ball.relative.x, y=ball.relative.y, z=4.2)                  # cm
    command.head = kelpie.HeadRequest(aim=kelpie.AIM_POINT, target=place)
    command.walk.turn_deg = 3.0 * ball.heading_deg
    command.walk.forward = 35.0 if abs(ball.heading_deg) < 30.0 else 0.0                # cm/s
    if ball.distance < 16.0 and abs(ball.heading_deg) < 15.0:
        command.motion = kelpie.KICK_FORWARD
    return command
