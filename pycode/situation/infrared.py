# SPDX-License-Identifier: Apache-2.0
# The head's infrared as a yes or no: is something nearer than the carpet that it reads in the
# stance with a held ball (thesis 2006 section 6.4.4)? The threshold is 0.8 of what it reads of the
# bare carpet; another robot's sensor is converted by a fitted straight line. Calibration keeps sums
# of its readings; nothing else is kept.

SHARE = 0.8        # of the mean over bare carpet
DEFAULT = 20.0     # cm, the threshold of the final of 2006 (carpet read as 25 cm)
MIN_READINGS = 15  # readings


def near(distance, threshold) -> bool:
    """The one word for all uses of infrared (checklist G35)."""
    return distance < threshold


class GroundCalibration:
    """Takes readings over bare carpet and tells the threshold."""

    def __init__(self):
        self.readings = 0
        self.sum = 0.0

    def add(self, distance) -> None:
        self.readings += 1
        self.sum += distance

    def threshold(self) -> float:
        if self.readings < MIN_READINGS:
            return DEFAULT
        return SHARE * self.sum / self.readings


def line_between(base, other) -> tuple[float, float]:
    """(coefficient, constant) with base = coefficient * other + constant by least squares, from
    readings of two sensors at the same places. Fewer than two different ones are a ValueError."""
    count = len(base)
    mean_base, mean_other = sum(base) / count, sum(other) / count
    spread = sum((value - mean_other) ** 2 for value in other)
    if spread == 0.0:
        raise ValueError('infrared: two different readings are needed')
    product = sum((a - mean_base) * (b - mean_other) for a, b in zip(base, other))
    coefficient = product / spread
    return coefficient, mean_base - coefficient * mean_other
