"""Lookup tables as scalar operations: splines piece by piece, chosen by comparisons, since a graph of scalars has no tables.

A table is a sum of coefficients under products of B-splines, one factor for each axis. On an interval between two breaks only some splines
are not zero, and there they are polynomials in the distance from its lower end. Axes are summed one after another: those of known
arguments first, then those of fewer intervals, so that as much as possible is a number here.
"""

from collections.abc import Sequence
from functools import cache, reduce
from itertools import product

from graph import Graph, Node
from ir import Table

# Coefficients from the constant up.
Polynomial = tuple[float, ...]


def by_line(a: Polynomial, constant: float, slope: float) -> Polynomial:
    """a(s) (constant + slope s)"""
    return tuple(constant * x + slope * lower for x, lower in zip((*a, 0.0), (0.0, *a), strict=True))


def spline(knots: Sequence[float], i: int, degree: int, interval: int) -> Polynomial:
    """B-spline i from knot `interval` to the next, by the recursion of Cox and de Boor."""
    if degree == 0:
        return (float(i == interval),)
    start, total = knots[interval], (0.0,) * (degree + 1)
    for j, end, other in ((i, knots[i], knots[i + degree]), (i + 1, knots[i + degree + 1], knots[i + 1])):
        if end != other:  # a line that is 0 at one end of the lower spline's support and 1 at the other
            share = by_line(spline(knots, j, degree - 1, interval), (start - end) / (other - end), 1 / (other - end))
            total = tuple(map(sum, zip(total, share, strict=True)))
    return total


def derivative(a: Polynomial) -> Polynomial:
    """a'(s)"""
    return tuple(power * x for power, x in enumerate(a))[1:] or (0.0,)


@cache
def pieces(breaks: tuple[float, ...], degree: int, order: int) -> list[list[Polynomial]]:
    """Of each interval the splines that are not zero there, differentiated so many times."""
    knots = (breaks[0],) * degree + breaks + (breaks[-1],) * degree
    found = [[spline(knots, i + k, degree, i + degree) for k in range(degree + 1)] for i in range(len(breaks) - 1)]
    return [[reduce(lambda a, _: derivative(a), range(order), a) for a in splines] for splines in found]


class Axis:
    """One argument of a table."""

    def __init__(self, graph: Graph, breaks: tuple[float, ...], splines: list[list[Polynomial]], x: Node) -> None:
        self.graph, self.breaks, self.splines, self.x = graph, breaks, splines, x
        held = graph.binary("max", graph.const(breaks[0]), graph.binary("min", graph.const(breaks[-1]), x))
        self.s = graph.binary("sub", held, self.chosen([graph.const(start) for start in breaks[:-1]]))

    def chosen(self, options: list[Node], first: int = 0) -> Node:
        """That of the interval of x, of options for the intervals from `first` on; a break belongs to the interval above it."""
        if len(options) == 1:
            return options[0]
        half = len(options) // 2
        below = self.graph.binary("lt", self.x, self.graph.const(self.breaks[first + half]))
        return self.graph.select(below, self.chosen(options[:half], first), self.chosen(options[half:], first + half))

    def polynomial(self, options: list[Polynomial]) -> Node:
        """The polynomial of the interval, by Horner's scheme."""
        graph = self.graph
        coefficients = [self.chosen([graph.const(value) for value in values]) for values in zip(*options, strict=True)]
        return reduce(lambda r, c: graph.binary("add", graph.binary("mul", r, self.s), c), reversed(coefficients))

    def sum(self, coefficients: list[Node]) -> Node:
        """The sum over the axis."""
        numbers = [self.graph.value(node) for node in coefficients]
        if None not in numbers:
            return self.polynomial([self.weighted(splines, numbers[i:]) for i, splines in enumerate(self.splines)])
        terms = []
        for k in range(len(self.splines[0])):
            weight = self.polynomial([splines[k] for splines in self.splines])
            here = self.chosen(coefficients[k : k + len(self.splines)])
            terms.append(self.graph.binary("mul", weight, here))
        return reduce(lambda a, b: self.graph.binary("add", a, b), terms)

    @staticmethod
    def weighted(splines: list[Polynomial], numbers: list[float]) -> Polynomial:
        """The splines of an interval times their coefficients."""
        return tuple(sum(c * p for c, p in zip(numbers, powers)) for powers in zip(*splines, strict=True))

    def outside(self) -> Node:
        """Whether x is held."""
        low, high = self.graph.const(self.breaks[0]), self.graph.const(self.breaks[-1])
        return self.graph.binary("or", self.graph.binary("lt", self.x, low), self.graph.binary("gt", self.x, high))


def looked_up(graph: Graph, table: Table, orders: list[int], arguments: list[Node]) -> Node:
    """A table, differentiated so many times by each argument."""
    assert table.outside == "clamp", "elsewhere a table is no number"
    axes = [Axis(graph, b, pieces(b, table.degree, n), x) for b, n, x in zip(table.breaks, orders, arguments, strict=True)]
    sizes = [len(breaks) - 1 + table.degree for breaks in table.breaks]
    places = product(*map(range, sizes))
    values = {place: graph.const(value) for place, value in zip(places, table.coefficients, strict=True)}
    for at in sorted(range(len(axes)), key=lambda i: (graph.value(arguments[i]) is None, len(table.breaks[i]))):
        rest = {(*place[:at], 0, *place[at + 1 :]) for place in values}
        along = lambda place: [values[*place[:at], k, *place[at + 1 :]] for k in range(sizes[at])]
        values = {place: axes[at].sum(along(place)) for place in sorted(rest)}
    (value,) = values.values()
    for axis, order in zip(axes, orders, strict=True):
        if order:
            value = graph.select(axis.outside(), graph.const(0.0), value)
    return value
