# SPDX-License-Identifier: Apache-2.0


def choose(x, y, looks_deg):
    """The kick of a robot at x, y (cm) that looks there: 90 deg is up the field. There are "hard"
    (251 cm ahead, spread 10 deg), "push" (140 cm ahead, 5 deg), "head_left" and "head_right" (198
    cm, 60 deg to a side, 12 deg). The goal is at x = 180, y = 540 and 72 cm wide for a ball."""
    return "hard"
