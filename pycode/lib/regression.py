# SPDX-License-Identifier: Apache-2.0
# Locally weighted linear regression (thesis 2006 section 4.5.3, equations 4.2 to 4.11): from
# examples (inputs, outputs) the outputs for a query, each weighted by the Gaussian kernel of its
# distance. Keeps the examples in a k-d tree; inputs are divided by their scales first. Inputs count
# from the query, which changes nothing in equation 4.10 but makes its constant the answer: where
# the neighbours do not settle a slope, a ridge on slopes alone leaves the weighted mean (equation
# 4.3). It fails far from all examples: there the nearest ones answer.
import math

from lib.kd_tree import KdTree

RADIUS = 2.4        # bandwidths; W(2.4) = 0.003 counts no more (section 4.5.3, threshold)
MINIMUM = 4   # examples,
MAXIMUM = 10  # examples that answer: each costs 400 operations of the interpreter
# Share of the largest diagonal: a smaller pivot settles no slope, and slopes get a ridge. With 1e-9
# places jumped by 290 cm for 5 cm of the ball, now by 8 in 99 % of 12320 steps.
SINGULAR = 1e-2
RIDGE = 3e-2  # of the normal equations


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
        """(weight, inputs from the query, outputs) of all examples that count. Where they are few
        the kernel is stretched to the fourth."""
        near, stretch = self.tree.within(query, RADIUS), 1.0
        if len(near) < MINIMUM:
            near = self.tree.nearest(query, MINIMUM)
            stretch = max(1.0, math.sqrt(near[-1][0]) / RADIUS)
        return [(kernel(math.sqrt(away) / stretch),
                 tuple([x - q for x, q in zip(self.tree.points[i], query)]), self.outputs[i])
                for away, i in near[:MAXIMUM]]

    def answer(self, inputs, first=0, end=None) -> list:
        """Equation 4.10; of all outputs, or of those from `first` to `end`."""
        rows = normal_equations(self.neighbours(self.scaled(inputs)), first, end)
        size = len(inputs) + 1
        answer = constant(rows, size, SINGULAR)
        if answer is None:
            maximum = max(rows[i][i] for i in range(size))
            for i in range(size - 1):
                rows[i][i] += RIDGE * maximum
            answer = constant(rows, size, 0.0)
        return answer


def normal_equations(near, first, end):
    """Z^T Z and beside it Z^T V of equation 4.9; the constant 1 comes last. As both sides are
    multiplied by the weight, errors count with its square (checklist G24)."""
    size, outputs = len(near[0][1]) + 1, len(near[0][2][first:end])
    rows = [[0.0] * (size + outputs) for _ in range(size)]
    for weight, inputs, wanted in near:
        example = (*inputs, 1.0, *wanted[first:end])
        for i in range(size):
            share = weight * weight * example[i]
            if share != 0.0:
                rows[i] = [a + share * b for a, b in zip(rows[i], example)]
    return rows


def constant(rows, size, singular):
    """The last unknown of rows that stand beside their right sides, by elimination with pivots,
    which leaves it alone in the last row; None when a pivot is no larger than that share of the
    largest diagonal."""
    rows = list(rows)
    minimum = singular * max(rows[i][i] for i in range(size))
    for i in range(size):
        best = max(range(i, size), key=lambda j: abs(rows[j][i]))
        if abs(rows[best][i]) <= minimum:
            return None
        rows[i], rows[best] = rows[best], rows[i]
        for j in range(i + 1, size):
            share = rows[j][i] / rows[i][i]
            if share != 0.0:
                rows[j] = [a - share * b for a, b in zip(rows[j], rows[i])]
    pivot = rows[-1][size - 1]
    return [value / pivot for value in rows[-1][size:]]
