# SPDX-License-Identifier: Apache-2.0
# Where the team has a ball that this robot has lost, if that is to be gone by. Keeps nothing. A
# mate with a wrong pose tells of a ball that is not there.
import math

FRESH_S = 1.0   # s; of the team's ball
LATER_S = 0.4   # s by which a mate saw it later than the robot itself
OFF = 15.0      # cm beyond the lines; a ball farther off is one of a wrong pose: by one 38 cm
                # behind the goal a goalie went the wrong way


def heard_of(world):
    """Where the team has a ball on the field that this robot has not seen as lately; or None."""
    team, ball = world.team_ball, world.ball
    own_s = ball.seconds_since_seen if ball.present else math.inf
    if (len(world.teammates) == 0 or not team.present or team.seconds_since_seen > FRESH_S or
            own_s < team.seconds_since_seen + LATER_S):
        return None
    x, y, field = team.position.x, team.position.y, world.field
    on_field = -OFF < x < field.width + OFF and -OFF < y < field.length + OFF
    return (x, y) if on_field else None
