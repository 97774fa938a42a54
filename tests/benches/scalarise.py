"""Turns a program with arrays into a graph of scalar operations, by the meaning that codegen/src/ir/eval gives to each operation.

Two things are left to the peers' advantage, since no compiler but nsv has to keep bits: an integer power is made of shared squares, and a
system of more than three equations is eliminated without exchanging rows. The results are checked against the emitted code.
"""

from collections.abc import Callable, Mapping
from functools import reduce

from graph import BINARY, UNARY, Graph, Node
from ir import Exponents, Program, Statement
from tables import looked_up

Array = list[Node]

# Taylor coefficients of S'(z)/z, S''(z) and S'''(z)/z in powers of z^2, with S(z) = sin z / z; the kernels are their values at 2E.
SERIES_BELOW = 2.0
FACTORIALS = [float(reduce(lambda a, b: a * b, range(1, n + 1), 1)) for n in range(30)]
SERIES = {
    1: [(-1) ** n * 2 * n / FACTORIALS[2 * n + 1] for n in range(1, 13)],
    2: [(-1) ** n * 2 * n * (2 * n - 1) / FACTORIALS[2 * n + 1] for n in range(1, 13)],
    3: [(-1) ** n * 2 * n * (2 * n - 1) * (2 * n - 2) / FACTORIALS[2 * n + 1] for n in range(2, 14)],
}


class Scalariser:
    """One program on its way into a graph."""

    def __init__(self, program: Program, graph: Graph, inputs: Mapping[str, Array]) -> None:
        self.program, self.graph, self.inputs = program, graph, inputs
        self.values: list[Array] = []

    def outputs(self) -> dict[str, Array]:
        """The program's outputs, entries row by row."""
        for statement in self.program.statements:
            value = self.apply(statement)
            assert len(value) == statement.shape[0] * statement.shape[1], statement
            self.values.append(value)
        return {name: self.values[value] for name, value in self.program.outputs.items()}

    def apply(self, statement: Statement) -> Array:
        """The entries of a value."""
        op, arguments = statement.op, [self.values[operand] for operand in statement.operands]
        if op == "const":
            return [self.graph.const(float(word)) for word in statement.words]
        if op == "input":
            return self.inputs[statement.words[0]]
        if op in UNARY:
            return [self.graph.unary(op, entry) for entry in arguments[0]]
        if op in BINARY:
            return self.elementwise(op, *arguments)
        if op == "powi":
            return [self.powi(entry, int(statement.words[0])) for entry in arguments[0]]
        if op == "select":
            return [self.graph.select(arguments[0][0], a, b) for a, b in zip(*arguments[1:], strict=True)]
        if op == "mul_add":
            return self.elementwise("add", self.elementwise("mul", *arguments[:2]), arguments[2])
        if op == "array":
            return [entry for argument in arguments for entry in argument]
        if op == "polynomial":
            terms = self.program.polynomials[statement.words[0]]
            return [self.polynomial(terms, [entry for argument in arguments for entry in argument])]
        if op == "table":
            name, *orders = statement.words[0].split()
            return [looked_up(self.graph, self.program.tables[name], [int(n) for n in orders], [a[0] for a in arguments])]
        if op.startswith("basis"):
            return self.basis(self.program.bases[statement.words[0]], arguments)
        if op.startswith("sin_cos_over") or op == "tan_over":
            return [self.kernel(op, arguments[0][0])]
        return self.linear(statement, arguments)

    def linear(self, statement: Statement, arguments: list[Array]) -> Array:
        """Operations on vectors and matrices."""
        op, (rows, columns), first = statement.op, statement.shape, arguments[0]
        width = self.program.statements[statement.operands[0]].shape[1]
        if op == "element":
            return [first[int(statement.words[0]) * width + int(statement.words[1])]]
        if op == "transpose":
            return [first[j * width + i] for i in range(rows) for j in range(columns)]
        if op == "sum_squares":
            return [self.dot(first, first)]
        if op == "singular_vector":
            return self.singular_vector(first, width)
        if op == "ldlt":
            return first
        second = arguments[1]
        if op == "dot":
            return [self.dot(first, second)]
        if op == "outer":
            return [self.mul(a, b) for a in first for b in second]
        if op == "matmul":
            lines = [first[i * width : (i + 1) * width] for i in range(rows)]
            return [self.dot(line, second[j::columns]) for line in lines for j in range(columns)]
        assert op == "solve", f"unknown operation {op}"
        solutions = [self.solve(first, second[j::columns]) for j in range(columns)]
        return [entry for row in zip(*solutions, strict=True) for entry in row]

    def add(self, a: Node, b: Node) -> Node:
        """a + b"""
        return self.graph.binary("add", a, b)

    def sub(self, a: Node, b: Node) -> Node:
        """a - b"""
        return self.graph.binary("sub", a, b)

    def mul(self, a: Node, b: Node) -> Node:
        """a b"""
        return self.graph.binary("mul", a, b)

    def div(self, a: Node, b: Node) -> Node:
        """a / b"""
        return self.graph.binary("div", a, b)

    def dot(self, a: Array, b: Array) -> Node:
        """Sum of products, left to right."""
        return reduce(self.add, map(self.mul, a, b))

    def elementwise(self, op: str, a: Array, b: Array) -> Array:
        """A scalar operand is broadcast."""
        size = max(len(a), len(b))
        return [self.graph.binary(op, *pair) for pair in zip(a * (size // len(a)), b * (size // len(b)), strict=True)]

    def powi(self, a: Node, n: int) -> Node:
        """a^n by products."""
        if n == 1:
            return a
        half = self.powi(a, n // 2)
        square = self.mul(half, half)
        return self.mul(square, a) if n % 2 else square

    def horner(self, coefficients: Array, z: Node) -> Node:
        """From the constant up."""
        return reduce(lambda r, c: self.add(self.mul(r, z), c), reversed(coefficients[:-1]), coefficients[-1])

    def polynomial(self, terms: list[tuple[float, Exponents]], z: Array) -> Node:
        """Horner's scheme in the first argument, whose coefficients are such schemes in the second, .."""
        if not z:
            return self.graph.const(sum(coefficient for coefficient, _ in terms))
        degree = max((exponents[0] for _, exponents in terms), default=0)
        parts = [[(c, e[1:]) for c, e in terms if e[0] == power] for power in range(degree + 1)]
        return self.horner([self.polynomial(part, z[1:]) for part in parts], z[0])

    def basis(self, exponents: list[Exponents], motion: list[Array]) -> Array:
        """Monomials or their first or second rate: each is an earlier one times an input."""
        made: dict[tuple[int, ...], Array] = {}
        zero, two = self.graph.const(0.0), self.graph.const(2.0)
        for powers in exponents:
            factors = [i for i, power in enumerate(powers) if power]
            if not factors:
                made[tuple(powers)] = [self.graph.const(1.0), zero, zero][: len(motion)]
                continue
            i, earlier = factors[-1], list(powers)
            earlier[i] -= 1
            p, z = made[tuple(earlier)], [rate[i] for rate in motion]
            rates = [self.mul(p[0], z[0])]
            if len(motion) > 1:
                rates.append(self.add(self.mul(p[1], z[0]), self.mul(p[0], z[1])))
            if len(motion) > 2:
                cross = self.mul(self.mul(two, p[1]), z[1])
                rates.append(self.add(self.add(self.mul(p[2], z[0]), cross), self.mul(p[0], z[2])))
            made[tuple(powers)] = rates
        return [made[tuple(powers)][-1] for powers in exponents]

    def kernel(self, op: str, e: Node) -> Node:
        """sin E cos E / E and its derivatives, tan E / E: quotients away from 0, elsewhere their limit or series."""
        graph, one, two = self.graph, self.graph.const(1.0), self.graph.const(2.0)
        z = e if op == "tan_over" else self.mul(two, e)
        if op in ("tan_over", "sin_cos_over"):
            function = op.partition("_")[0]
            zero = graph.binary("eq", z, graph.const(0.0))
            return graph.select(zero, one, self.div(graph.unary(function, z), z))
        order = int(op[-1])
        s: Array = [self.div(graph.unary("sin", z), z)]
        s.append(self.div(self.sub(graph.unary("cos", z), s[0]), z))
        for k in (2, 3):
            inner = s[1] if k == 2 else self.sub(s[2], self.div(s[1], z))
            s.append(graph.unary("neg", self.add(s[k - 2], self.div(self.mul(two, inner), z))))
        series = self.horner([graph.const(c) for c in SERIES[order]], self.mul(z, z))
        if order != 2:
            series = self.mul(z, series)
        near = graph.binary("lt", graph.unary("abs", z), graph.const(SERIES_BELOW))
        return self.mul(graph.const(2.0**order), graph.select(near, series, s[order]))

    def solve(self, a: Array, b: Array) -> Array:
        """A^-1 b: adjugate times the determinant's reciprocal for up to three rows, else elimination without exchanging rows."""
        n = len(b)
        rows = [a[i * n : (i + 1) * n] for i in range(n)]
        if n > 3:
            return self.eliminate([[*row, entry] for row, entry in zip(rows, b, strict=True)])
        if n == 1:
            return [self.div(b[0], a[0])]
        adjugate = self.adjugate2(rows) if n == 2 else self.adjugate3(rows)
        determinant = self.dot(rows[0], [row[0] for row in adjugate])
        scale = self.div(self.graph.const(1.0), determinant)
        return [self.mul(self.dot(row, b), scale) for row in adjugate]

    def adjugate2(self, a: list[Array]) -> list[Array]:
        """The transposed cofactors of two rows."""
        negative: Callable[[Node], Node] = lambda entry: self.graph.unary("neg", entry)
        return [[a[1][1], negative(a[0][1])], [negative(a[1][0]), a[0][0]]]

    def adjugate3(self, a: list[Array]) -> list[Array]:
        """The transposed cofactors of three rows, by cyclic indices."""
        minor = lambda i, j, k, l: self.sub(self.mul(a[i][j], a[k][l]), self.mul(a[i][l], a[k][j]))
        cofactor = lambda i, j: minor((i + 1) % 3, (j + 1) % 3, (i + 2) % 3, (j + 2) % 3)
        return [[cofactor(j, i) for j in range(3)] for i in range(3)]

    def eliminate(self, rows: list[Array]) -> Array:
        """Gaussian elimination of [A b]."""
        n = len(rows)
        for k in range(n):
            for i in range(k + 1, n):
                factor = self.div(rows[i][k], rows[k][k])
                rows[i] = [self.sub(x, self.mul(factor, y)) if j > k else x for j, (x, y) in enumerate(zip(rows[i], rows[k], strict=True))]
        x: Array = [0] * n
        for i in reversed(range(n)):
            rest = reduce(self.sub, (self.mul(rows[i][j], x[j]) for j in range(i + 1, n)), rows[i][n])
            x[i] = self.div(rest, rows[i][i])
        return x

    def singular_vector(self, a: Array, width: int) -> Array:
        """Of the largest singular value of two columns or two rows, by the angle of A^T A or A A^T; its largest entry is positive."""
        graph, rows = self.graph, [a[i : i + width] for i in range(0, len(a), width)]
        pair = [a[::2], a[1::2]] if width == 2 else rows
        assert len(pair) == 2, "the closed form is that of an angle"
        off, difference = self.dot(*pair), self.sub(self.dot(pair[0], pair[0]), self.dot(pair[1], pair[1]))
        half = self.mul(graph.const(0.5), graph.binary("atan2", self.mul(graph.const(2.0), off), difference))
        vector = [graph.unary("cos", half), graph.unary("sin", half)]
        if width != 2:
            vector = [self.dot(list(column), vector) for column in zip(*rows, strict=True)]
            length = graph.unary("sqrt", self.dot(vector, vector))
            vector = [self.div(entry, length) for entry in vector]
        lead = vector[0]
        for entry in vector[1:]:
            lead = graph.select(graph.binary("gt", graph.unary("abs", entry), graph.unary("abs", lead)), entry, lead)
        negative = graph.binary("lt", lead, graph.const(0.0))
        return [graph.select(negative, graph.unary("neg", entry), entry) for entry in vector]


def scalarise(program: Program, graph: Graph, inputs: Mapping[str, Array]) -> dict[str, Array]:
    """The outputs of a program of the given inputs."""
    return Scalariser(program, graph, inputs).outputs()
