# SPDX-License-Identifier: Apache-2.0


def place(ball):
    """Where a goalkeeper stands, for a ball at (x, y): cm from the middle of its goal to the right
    and up the field. The goal is 80 cm wide; it must keep within 65 cm to either side and from 8 to
    50 cm before the line."""
    return max(-40.0, min(40.0, ball[0])), 8.0
