# SPDX-License-Identifier: Apache-2.0
"""Facts of main.py, without a match: python3 test/test_main.py. kelpie.py beside this stands in for
the module that a robot has; main.py decides the same with both."""

import math
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path[:0] = [str(HERE), str(HERE.parent)]

import kelpie  # noqa: E402
import main  # noqa: E402


def world_with_ball(distance, heading_deg):
    """A ball that is seen now, so many cm away and degrees left of ahead."""
    world, angle = kelpie.WorldFrame(), math.radians(heading_deg)
    world.ball.present = True
    world.ball.distance, world.ball.heading_deg = distance, heading_deg
    world.ball.relative.x = -distance * math.sin(angle)
    world.ball.relative.y = distance * math.cos(angle)
    return world


class Facts(unittest.TestCase):
    def test_a_ball_ahead_is_walked_to(self):
        self.assertGreater(main.decide(world_with_ball(100.0, 0.0)).walk.forward, 20.0)

    def test_a_ball_to_the_left_is_turned_to(self):
        self.assertGreater(main.decide(world_with_ball(100.0, 40.0)).walk.turn_deg, 30.0)

    def test_a_ball_before_the_paws_is_kicked(self):
        command = main.decide(world_with_ball(14.0, 0.0))
        self.assertEqual(command.motion, kelpie.KICK_FORWARD)

    def test_without_a_ball_it_looks_all_round(self):
        self.assertNotEqual(main.decide(kelpie.WorldFrame()).walk.turn_deg, 0.0)


if __name__ == "__main__":
    unittest.main()
