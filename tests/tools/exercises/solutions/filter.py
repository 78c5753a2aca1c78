# SPDX-License-Identifier: Apache-2.0
DT = 1.0 / 30.0


class Ball:
    def __init__(self):
        self.x = None
        self.p = [[64.0, 0.0], [0.0, 10000.0]]

    def step(self, seen):
        if self.x is None:
            if seen is None:
                return 0.0
            self.x = [seen, 90.0]
            return seen
        x, (a, b), d = self.x, self.p[0], self.p[1][1]
        self.x = [x[0] + DT * x[1], max(0.0, x[1] - 25.0 * DT)]
        a, b, d = a + 2 * DT * b + DT * DT * d + 0.01, b + DT * d, d + 2.0
        if seen is not None:
            s = a + 64.0
            k, m, innovation = a / s, b / s, seen - self.x[0]
            self.x = [self.x[0] + k * innovation, self.x[1] + m * innovation]
            a, b, d = (1 - k) * a, (1 - k) * b, d - m * b
        self.p = [[a, b], [b, d]]
        return self.x[0]
