# SPDX-License-Identifier: Apache-2.0


def look(time_s):
    side, tilt = (90.0, -18.0), -18.0
    at = time_s % 6.6
    if at < 0.75:
        return 90.0, tilt
    if at < 2.25:
        return -90.0, tilt
    if at < 2.6:
        return -90.0, -50.0
    if at < 4.2:
        return side[0], -50.0
    return 0.0, tilt
