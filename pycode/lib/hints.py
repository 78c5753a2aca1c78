# SPDX-License-Identifier: Apache-2.0
# Where a ball comes out that a skill has lost: table 6.1 of thesis 2006, and one of ours, as
# (distance cm, heading deg), for Memory.set_hint. Left is positive. Keeps nothing. A kick that
# missed leaves the ball elsewhere: a hint holds for half a second only. What a kick leaves, its
# motion's file says (kelpie.KICKS).
GRAB = (30.0, 0.0)           # lost while approaching to grab: ahead
LEFT_LYING = (25.0, 0.0)     # let go, or kicked at somebody: where it lay, a step back
DRIBBLE = (35.0, 120.0)      # lost while turning with it: it stays behind the turn


def of_dribble(turn_side) -> tuple[float, float]:
    """`turn_side`: +1 while turning left with the ball, which is then lost to the right."""
    return DRIBBLE[0], -DRIBBLE[1] * turn_side
