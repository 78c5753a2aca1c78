# SPDX-License-Identifier: Apache-2.0


def place_of(pixel, height, tilt_deg):
    """(cm to the right, cm ahead) of a ball whose middle is seen in a pixel of a camera that is
    `height` cm above the carpet and looks up by `tilt_deg`, so down if that is negative. The image
    is 208 pixels wide and 160 high, its focal length is 192 pixels, the ball's radius 4.2 cm."""
    ahead = 150.0 - pixel[1]
    return (pixel[0] - 104.0) / 192.0 * ahead, ahead
