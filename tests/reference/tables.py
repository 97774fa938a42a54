"""Lookup tables by hand: straight lines, and not-a-knot cubic splines by their second derivatives at the points."""

import csv
from bisect import bisect_right

import mpmath
import numpy as np


class Line:
    """Straight between the points."""

    def __init__(self, points):
        self.points = [mpmath.mpf(x) for x in points]

    def interval(self, x):
        """The interval of x; a point belongs to the one above it."""
        return min(max(bisect_right(self.points, x) - 1, 0), len(self.points) - 2)

    def at(self, x, values):
        """The value at x, held outside."""
        x = min(max(x, self.points[0]), self.points[-1])
        i = self.interval(x)
        width = self.points[i + 1] - self.points[i]
        return (values[i] * (self.points[i + 1] - x) + values[i + 1] * (x - self.points[i])) / width


class Cubic(Line):
    """C2, with a continuous third derivative at the second and the last but one point."""

    def __init__(self, points):
        super().__init__(points)
        n, h = len(points), np.diff(self.points)
        left, right = mpmath.zeros(n, n), mpmath.zeros(n, n)
        for i in range(1, n - 1):
            left[i, i - 1], left[i, i], left[i, i + 1] = h[i - 1] / 6, (h[i - 1] + h[i]) / 3, h[i] / 6
            right[i, i - 1], right[i, i], right[i, i + 1] = 1 / h[i - 1], -1 / h[i - 1] - 1 / h[i], 1 / h[i]
        for row, i in ((0, 0), (n - 1, n - 3)):
            left[row, i], left[row, i + 1], left[row, i + 2] = 1 / h[i], -1 / h[i] - 1 / h[i + 1], 1 / h[i + 1]
        self.bend = (left**-1) * right  # second derivatives from values

    def at(self, x, values):
        x = min(max(x, self.points[0]), self.points[-1])
        i = self.interval(x)
        second = [sum(self.bend[j, k] * v for k, v in enumerate(values)) for j in (i, i + 1)]
        h = self.points[i + 1] - self.points[i]
        a, b = (self.points[i + 1] - x) / h, (x - self.points[i]) / h
        line = a * values[i] + b * values[i + 1]
        return line + ((a**3 - a) * second[0] + (b**3 - b) * second[1]) * h**2 / 6


class Table:
    """A table of several arguments: along the last axis first."""

    def __init__(self, kind, axes, values):
        self.axes = [kind(points) for points in axes]
        self.values = np.vectorize(mpmath.mpf, otypes=[object])(np.asarray(values))

    def __call__(self, *arguments):
        numbers = all(isinstance(x, (float, int)) for x in arguments)
        value = self._along(0, self.values, arguments)
        return float(value) if numbers else value

    def _along(self, axis, values, arguments):
        if axis < len(self.axes) - 1:
            values = [self._along(axis + 1, row, arguments) for row in values]
        return self.axes[axis].at(arguments[axis], list(values))


def grid(file, axes, column):
    """Axes and values of a column of a file that has a row for every combination of two axes."""
    rows = list(csv.DictReader(line for line in file.read_text().splitlines() if not line.startswith("#")))
    points = [sorted({float(row[name]) for row in rows}) for name in axes]
    values = {tuple(float(row[name]) for name in axes): float(row[column]) for row in rows}
    return points, [[values[u, v] for v in points[1]] for u in points[0]]
