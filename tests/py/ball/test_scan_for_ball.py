# SPDX-License-Identifier: Apache-2.0
"""Rows of the head in search of a ball: their pans, tilts and speeds, and where a row ends."""
import kelpie
import pytest
from skills.head.scan_for_ball import ScanForBall, head_params


def step(scan, pan=0.0, time_s=0.0, limits=None):
    made = kelpie.WorldFrame(time_s=time_s)
    made.head.head_pan_deg = pan
    return scan.step(made, limits)


def test_without_limits_the_first_three_frames_look_at_the_feet_then_20_deg_down():
    scan = ScanForBall()
    feet = [step(scan) for _ in range(3)]
    for look in feet:
        assert (look.head_pan_deg, look.neck_tilt_deg, look.head_nod_deg) == (88.0, -30.0, -5.0)
        assert look.speed_deg == 360.0
    level = step(scan)
    assert level.aim == kelpie.AIM_DIRECTION
    assert (level.direction_deg, level.elevation_deg, level.speed_deg) == (88.0, -20.0, 360.0)


@pytest.mark.parametrize('side', [1.0, -1.0])
@pytest.mark.parametrize('pan, turns', [(39.0, False), (41.0, True)])
def test_a_level_row_turns_when_the_late_head_is_four_frames_of_12_deg_from_its_end(side, pan,
                                                                                   turns):
    scan = ScanForBall(side)
    for _ in range(4):
        look = step(scan, side * pan)
    assert (look.direction_deg == -side * 88.0) is turns and scan.rows == (1 if turns else 0)


@pytest.mark.parametrize('low, crane, speed', [(True, -10.0, 240.0), (False, 10.0, 270.0)])
def test_rows_are_low_at_8_deg_a_frame_and_high_at_9(low, crane, speed):
    scan = ScanForBall()
    scan.low = low
    look = step(scan, 0.0, 0.0, (-60.0, 60.0, False))
    assert look.head_pan_deg == 60.0 and look.speed_deg == speed
    assert look.neck_tilt_deg + look.head_nod_deg == crane


@pytest.mark.parametrize('pan, low, tilt', [(39.0, True, -30.0), (-39.0, True, -30.0),
                                            (41.0, True, 0.0), (-41.0, True, 0.0),
                                            (0.0, False, 0.0)])
def test_a_low_row_looks_30_deg_down_where_a_ball_may_be_at_the_feet(pan, low, tilt):
    """Within 40 deg of straight ahead, when that is asked for."""
    scan = ScanForBall()
    scan.low = low
    crane = -10.0 if low else 10.0
    for look_down in (True, False):
        look = step(scan, pan, 0.0, (-88.0, 88.0, look_down))
        wanted = (tilt if look_down else 0.0) + crane
        assert look.neck_tilt_deg + look.head_nod_deg == wanted


@pytest.mark.parametrize('side', [1.0, -1.0])
@pytest.mark.parametrize('pan, turns', [(27.0, False), (29.0, True)])
def test_a_low_row_turns_32_deg_before_its_end(side, pan, turns):
    scan = ScanForBall(side)
    look = step(scan, side * pan, 0.0, (-60.0, 60.0, False))
    assert (look.head_pan_deg == -side * 60.0) is turns
    assert scan.low is not turns and scan.side == (-side if turns else side)


@pytest.mark.parametrize('pan, turns', [(52.0, False), (54.0, True)])
def test_a_narrow_row_turns_in_its_middle(pan, turns):
    """From 40 to 66 deg: within 13 of the end."""
    look = step(ScanForBall(), pan, 0.0, (40.0, 66.0, False))
    assert (look.head_pan_deg == 40.0) is turns


@pytest.mark.parametrize('time_s, turns', [(5.79, False), (5.81, True)])
def test_a_row_that_does_not_get_there_turns_0_3_s_after_its_time(time_s, turns):
    """120 deg at 240 deg/s, from 5.0 s on."""
    scan = ScanForBall()
    step(scan, -60.0, 5.0, (-60.0, 60.0, False))
    assert (step(scan, -60.0, time_s, (-60.0, 60.0, False)).head_pan_deg == -60.0) is turns


@pytest.mark.parametrize('pan, tilt, crane, joints', [
    (95.0, 0.0, 10.0, (88.0, 0.0, 10.0)), (-95.0, 0.0, 10.0, (-88.0, 0.0, 10.0)),
    (30.0, -10.0, -20.0, (30.0, -25.0, -5.0)), (30.0, -10.0, -4.0, (30.0, -10.0, -4.0))])
def test_the_head_reaches_88_deg_aside_and_the_nod_5_down(pan, tilt, crane, joints):
    look = head_params(pan, tilt, crane, 99.0)
    assert (look.head_pan_deg, look.neck_tilt_deg, look.head_nod_deg) == joints
    assert look.speed_deg == 99.0
