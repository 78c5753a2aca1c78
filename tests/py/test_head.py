# SPDX-License-Identifier: Apache-2.0
import math

import pytest
import kelpie
from ideal_world import IdealWorld
from lib import head


@pytest.mark.parametrize('distance', [14, 20, 30, 60, 120, 250])
@pytest.mark.parametrize('lateral', [-60, 0, 35])
def test_looking_at_the_ball_brings_it_into_the_image(distance, lateral):
    world = IdealWorld(1)
    x = -distance * math.sin(math.radians(lateral))
    y = distance * math.cos(math.radians(lateral))
    request = head.look_at(x, y, 4.2, world.world.stance)
    for name in ('neck_tilt_deg', 'head_pan_deg', 'head_nod_deg'):
        setattr(world.world.head, name, getattr(request, name))
    assert world.in_view(world.at + complex(y, -x) * world.facing, 4.2)


def test_shares_stay_inside_the_joints():
    for pitch in range(-120, 90):
        neck, nod = head.split(float(pitch))
        assert head.MIN_NECK <= neck <= 0 and head.MIN_NOD <= nod <= head.MAX_NOD
        if head.MIN_NECK + head.MIN_NOD <= pitch <= head.MAX_NOD:
            assert neck + nod == pytest.approx(pitch)


def test_nearer_is_farther_down():
    stance = kelpie.Stance(body_tilt_deg=14.25)
    pitches = [head.pitch_to(distance, 4.2, stance) for distance in (200, 100, 50, 25, 15)]
    assert pitches == sorted(pitches)
