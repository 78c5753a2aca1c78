# SPDX-License-Identifier: Apache-2.0
MIDDLE = {"ball": (130, 190, 90), "carpet": (95, 105, 115), "line": (200, 122, 134),
          "yellow": (160, 150, 60)}


def classify(colour, place):
    ring = (place[0] ** 2 + place[1] ** 2) / (104.0 ** 2 + 80.0 ** 2)
    y, cr, cb = colour[0] / (1.0 - 0.45 * ring), colour[1], colour[2] - 18.0 * ring

    def off(name):
        middle = MIDDLE[name]
        return ((y - middle[0]) / 22) ** 2 + ((cr - middle[1]) / 8) ** 2 + (
            (cb - middle[2]) / 8) ** 2

    return min(MIDDLE, key=off)
