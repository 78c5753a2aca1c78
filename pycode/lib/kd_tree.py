# SPDX-License-Identifier: Apache-2.0
# A k-d tree (thesis 2006 section 4.5.4): points split at the median of one coordinate after the
# other. Built once from a list of points (tuples of one length); answers with indices into it and
# keeps nothing else. Nearest points take O(log n) on average, against O(n) of looking at all;
# below about 50 points the difference is small. Equal distances: the smaller index comes first.
LEAF = 4   # points that are not split any more


class KdTree:
    def __init__(self, points):
        self.points = points
        self.root = self._split(list(range(len(points))), 0) if points else ()

    def _split(self, indices, depth):
        """A leaf is a list of indices, a node (axis, value, below, above)."""
        if len(indices) <= LEAF:
            return indices
        axis = depth % len(self.points[0])
        indices = sorted(indices, key=lambda i: self.points[i][axis])
        middle = len(indices) // 2
        return (axis, self.points[indices[middle]][axis],
                self._split(indices[:middle], depth + 1), self._split(indices[middle:], depth + 1))

    def nearest(self, query, count) -> list:
        """The `count` nearest points, the nearest first: (squared distance, index) each."""
        best = []

        def visit(node):
            if isinstance(node, list):
                for i in node:
                    best.append((squared(self.points[i], query), i))
                best.sort()
                del best[count:]
                return
            axis, value, below, above = node
            off = query[axis] - value
            first, second = (below, above) if off < 0.0 else (above, below)
            visit(first)
            if len(best) < count or off * off <= best[-1][0]:
                visit(second)
        visit(self.root if self.points else [])
        return best

    def within(self, query, radius) -> list:
        """All points no farther than the radius, the nearest first."""
        found, maximum, left = [], radius * radius, [self.root if self.points else []]
        while left:
            node = left.pop()
            if isinstance(node, list):
                found += [(squared(self.points[i], query), i) for i in node]
                continue
            axis, value, below, above = node
            if query[axis] - radius <= value:
                left.append(below)
            if query[axis] + radius >= value:
                left.append(above)
        return sorted(pair for pair in found if pair[0] <= maximum)


def squared(a, b) -> float:
    return sum([(x - y) * (x - y) for x, y in zip(a, b)])
