# SPDX-License-Identifier: Apache-2.0
# The head's infrared as a yes or no: is something nearer than the carpet that it reads in the
# stance with a held ball (thesis 2006 section 6.4.4)? The threshold is 0.8 of what it reads of the
# bare carpet, and each robot's own. Keeps nothing. A robot that was not calibrated
# (kelpie calibrate infrared) has the 20 cm of the final of 2006.


def near(distance, threshold) -> bool:
    """The one word for all uses of infrared (checklist G35)."""
    return distance < threshold


def somebody_near(world) -> bool:
    """Whether the head's sensor reads something nearer than the carpet."""
    return near(world.sensors.head_near_distance, world.sensors.head_near_threshold)
