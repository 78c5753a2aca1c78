# SPDX-License-Identifier: Apache-2.0


def classify(colour, place):
    """"ball", "carpet", "line" or "yellow" for a pixel's Y, Cr, Cb (0 to 255); its place in the
    image is counted in pixels from the middle."""
    brightness, red, blue = colour
    if red > 170:
        return "ball"
    return "line" if brightness > 150 else "carpet"
