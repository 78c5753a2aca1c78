# SPDX-License-Identifier: Apache-2.0
# Locally weighted linear regression (thesis 2006 section 4.5.3, equations 4.2 to 4.11): from
# examples (inputs, outputs) the outputs for a query, each weighted by the Gaussian kernel of its
# distance. Keeps the examples in a k-d tree; inputs are divided by their scales first. Inputs count
# from the query, which changes nothing in equation 4.10 but makes its constant the answer: where
# the neighbours do not settle a slope, a ridge on slopes alone leaves the weighted mean (equation
# 4.3). It fails far from all examples: there the nearest one answers.
import math

from lib.kd_tree import KdTree

RADIUS = 3.0        # bandwidths; W(3) = 1.2e-4 counts no more (section 4.5.3, threshold)
# Share of the largest diagonal: a smaller pivot settles no slope, and slopes get a ridge. With 1e-9
# places jumped by 290 cm for 5 cm of the ball, now by 8 in 99 % of 12320 steps.
SINGULAR = 1e-2
RIDGE = 3e-2


def kernel(distance) -> float:
    """Equation 4.11."""
    return math.exp(-distance * distance)


class Regression:
    def __init__(self, examples, scales, bandwidth):
        self.scales = [scale * bandwidth for scale in scales]
        self.outputs = [tuple(outputs) for _, outputs in examples]
        self.tree = KdTree([self.scaled(inputs) for inputs, _ in examples])

    def scaled(self, inputs):
        return tuple([value / scale for value, scale in zip(inputs, self.scales)])

    def neighbours(self, query):
        """(weight, inputs from the query, outputs) of all examples that count."""
        near = self.tree.within(query, RADIUS)
        if not near:
            return [(1.0, (0.0,) * len(query), self.outputs[self.tree.nearest(query, 1)[0][1]])]
        return [(kernel(math.sqrt(away)),
                 tuple([x - q for x, q in zip(self.tree.points[i], query)]), self.outputs[i])
                for away, i in near]

    def mean(self, inputs) -> list:
        """Equation 4.3, the weighted mean."""
        near = self.neighbours(self.scaled(inputs))
        total = sum(weight for weight, _, _ in near)
        return [sum(weight * outputs[k] for weight, _, outputs in near) / total
                for k in range(len(near[0][2]))]

    def answer(self, inputs) -> list:
        """Equation 4.10."""
        matrix, right = normal_equations(self.neighbours(self.scaled(inputs)))
        solution = solve(matrix, right, SINGULAR)
        if solution is None:
            most = max(matrix[i][i] for i in range(len(matrix)))
            for i in range(1, len(matrix)):
                matrix[i][i] += RIDGE * most
            solution = solve(matrix, right, 0.0)
        return solution[0]


def normal_equations(near):
    """Z^T Z and Z^T V of equation 4.9; the constant 1 comes first. As both sides are multiplied by
    the weight, errors count with its square (checklist G24)."""
    size, outputs = len(near[0][1]) + 1, len(near[0][2])
    matrix = [[0.0] * size for _ in range(size)]
    right = [[0.0] * outputs for _ in range(size)]
    for weight, inputs, wanted in near:
        row = (1.0,) + inputs
        for i in range(size):
            share = weight * weight * row[i]
            for j in range(size):
                matrix[i][j] += share * row[j]
            for k in range(outputs):
                right[i][k] += share * wanted[k]
    return matrix, right


def solve(matrix, right, singular):
    """The rows x of matrix x = right, by elimination with pivots; None when one is no larger than
    that share of the largest diagonal."""
    rows = [list(left) + list(wanted) for left, wanted in zip(matrix, right)]
    size = len(matrix)
    least = singular * max(matrix[i][i] for i in range(size))
    for i in range(size):
        best = max(range(i, size), key=lambda j: abs(rows[j][i]))
        if abs(rows[best][i]) <= least:
            return None
        rows[i], rows[best] = rows[best], rows[i]
        for j in range(i + 1, size):
            share = rows[j][i] / rows[i][i]
            if share != 0.0:
                rows[j] = [a - share * b for a, b in zip(rows[j], rows[i])]
    for i in range(size - 1, -1, -1):
        done = [value / rows[i][i] for value in rows[i]]
        rows[i] = done
        for j in range(i):
            share = rows[j][i]
            rows[j] = [a - share * b for a, b in zip(rows[j], done)]
    return [row[size:] for row in rows]
