# SPDX-License-Identifier: Apache-2.0


def goes(own, robots, ball, told):
    # What was told is the same for all four, so that they agree.
    return min(range(4), key=lambda i: told[i]) == own
