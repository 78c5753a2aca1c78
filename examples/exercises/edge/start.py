# SPDX-License-Identifier: Apache-2.0


def edge_of(row):
    """The place (a pixel's number, may be broken) where 40 values of brightness go from carpet to
    a painted line."""
    for i, brightness in enumerate(row):
        if brightness > 128:
            return float(i)
    return 20.0
