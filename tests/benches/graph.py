"""A law as a graph of scalar operations, each made once: the one form from which every peer gets the law.

Constants are folded and neutral elements removed, as each of the peers would do itself. `x * 0` is `0` here, which the compiler's own
arithmetic does not allow itself.
"""

import math
import operator
from collections.abc import Callable, Mapping, Sequence
from typing import Any

Node = int
Entry = tuple[Any, ...]


def quotient(a: float, b: float) -> float:
    """a / b as a processor has it: the law chooses another value where this is no number."""
    return a / b if b else a * math.copysign(math.inf, b)


UNARY: dict[str, Callable[[float], float]] = {
    "neg": operator.neg, "abs": abs, "sqrt": math.sqrt, "exp": math.exp, "ln": math.log, "sin": math.sin, "cos": math.cos,
    "tan": math.tan, "asin": math.asin, "acos": math.acos, "atan": math.atan, "sinh": math.sinh, "cosh": math.cosh, "tanh": math.tanh,
    "sign": lambda x: math.copysign(1.0, x) if x else x, "not": lambda x: float(not x),
}  # fmt: skip
BINARY: dict[str, Callable[[float, float], float]] = {
    "add": operator.add, "sub": operator.sub, "mul": operator.mul, "div": quotient, "pow": math.pow, "atan2": math.atan2,
    "min": lambda a, b: a if a < b else b, "max": lambda a, b: a if a > b else b,
    "lt": lambda a, b: float(a < b), "le": lambda a, b: float(a <= b), "gt": lambda a, b: float(a > b),
    "ge": lambda a, b: float(a >= b), "eq": lambda a, b: float(a == b), "ne": lambda a, b: float(a != b),
    "and": lambda a, b: float(a and b), "or": lambda a, b: float(a or b),
}  # fmt: skip
COMMUTATIVE = {"add", "mul", "and", "or", "eq", "ne"}


class Graph:
    """Operations in an order in which each comes after its operands: `("const", 2.0)`, `("input", 3)`, `("add", a, b)`, .."""

    def __init__(self) -> None:
        self.entries: list[Entry] = []
        self.known: dict[Entry, Node] = {}

    def node(self, *entry: Any) -> Node:
        """The node of an operation, made if it is new."""
        if entry[0] in COMMUTATIVE:
            entry = (entry[0], *sorted(entry[1:]))
        if entry not in self.known:
            self.known[entry] = len(self.entries)
            self.entries.append(entry)
        return self.known[entry]

    def const(self, value: float) -> Node:
        """A number."""
        return self.node("const", float(value) + 0.0)

    def value(self, node: Node) -> float | None:
        """The number that a node is known to be."""
        entry = self.entries[node]
        return entry[1] if entry[0] == "const" else None

    def unary(self, op: str, a: Node) -> Node:
        """A function of one value."""
        x = self.value(a)
        if x is not None:
            return self.const(UNARY[op](x))
        if op == "neg" and self.entries[a][0] == "neg":
            return self.entries[a][1]
        return self.node(op, a)

    def binary(self, op: str, a: Node, b: Node) -> Node:
        """A function of two values."""
        x, y = self.value(a), self.value(b)
        if x is not None and y is not None:
            return self.const(BINARY[op](x, y))
        if (op == "add" and x == 0) or (op == "mul" and x == 1):
            return b
        if (op in ("add", "sub") and y == 0) or (op in ("mul", "div") and y == 1):
            return a
        if (op == "mul" and 0 in (x, y)) or (op == "div" and x == 0):
            return self.const(0.0)
        if (op == "sub" and x == 0) or (op == "mul" and x == -1):
            return self.unary("neg", b)
        if op == "mul" and y == -1:
            return self.unary("neg", a)
        return self.node(op, a, b)

    def select(self, condition: Node, a: Node, b: Node) -> Node:
        """One of two values."""
        known = self.value(condition)
        if known is not None:
            return a if known else b
        return a if a == b else self.node("select", condition, a, b)

    def live(self, outputs: Sequence[Node]) -> list[Node]:
        """What the outputs need, in order."""
        needed = set(outputs)
        for node in range(len(self.entries) - 1, -1, -1):
            if node in needed and self.entries[node][0] not in ("const", "input"):
                needed.update(self.entries[node][1:])
        return sorted(needed)

    def evaluate(self, outputs: Sequence[Node], inputs: Sequence[Any], functions: Mapping[str, Callable[..., Any]]) -> list[Any]:
        """The outputs, each operation done by `functions`: on numbers, arrays or symbols of a peer."""
        values: dict[Node, Any] = {}
        for node in self.live(outputs):
            op, *operands = self.entries[node]
            if op == "const":
                values[node] = functions["const"](operands[0]) if "const" in functions else operands[0]
            elif op == "input":
                values[node] = inputs[operands[0]]
            else:
                values[node] = functions[op](*(values[operand] for operand in operands))
        return [values[node] for node in outputs]

    def operations(self, outputs: Sequence[Node]) -> dict[str, int]:
        """How many there are of each kind."""
        counts: dict[str, int] = {}
        for node in self.live(outputs):
            op = self.entries[node][0]
            if op not in ("const", "input"):
                counts[op] = counts.get(op, 0) + 1
        return dict(sorted(counts.items(), key=lambda item: -item[1]))
