"""Reads the compiler's programs from their text form (codegen/src/ir/print.rs), as `nsv generate --emit ir` prints them."""

import re
from dataclasses import dataclass, field

STATEMENT = re.compile(r"%(\d+)(?: [\w./]+)?: (\S+) = (\w+) ?(.*?)(?: @\d+(?:   ; .*)?)?$")
TERM = re.compile(r"(\S*) ?\[([^]]*)\]")

Shape = tuple[int, int]
Exponents = list[int]


@dataclass
class Statement:
    """One value: its operation, the values it is computed from, and what else stands in its text."""

    op: str
    shape: Shape
    operands: list[int]
    words: list[str]


@dataclass
class Table:
    """A lookup table: breaks of each axis, degree, what is outside, and coefficients, those of the last axis side by side."""

    breaks: list[tuple[float, ...]]
    degree: int
    outside: str
    coefficients: list[float]


@dataclass
class Program:
    """One emitted function. A scalar or truth value has one row and one column, a vector has one column."""

    name: str
    inputs: dict[str, Shape] = field(default_factory=dict)
    statements: list[Statement] = field(default_factory=list)
    outputs: dict[str, int] = field(default_factory=dict)
    polynomials: dict[str, list[tuple[float, Exponents]]] = field(default_factory=dict)
    bases: dict[str, list[Exponents]] = field(default_factory=dict)
    tables: dict[str, Table] = field(default_factory=dict)


def shape_of(text: str) -> Shape:
    """Rows and columns of a type."""
    if text in ("real", "bool"):
        return 1, 1
    if text.startswith("ldlt"):
        return int(text[4:]), int(text[4:])
    rows, *columns = (int(size) for size in text[3:].split("x"))
    return rows, columns[0] if columns else 1


def integers(text: str) -> Exponents:
    """A list in brackets, without them."""
    return [int(word) for word in text.split(", ") if word]


def read_terms(rest: str) -> tuple[str, list[tuple[str, Exponents]]]:
    """Name and items of `name(a, b) = head [e, e], head [e, e]`."""
    signature, _, items = rest.partition(" =")
    found = [(head.strip(", "), integers(exponents)) for head, exponents in TERM.findall(items)]
    return signature.partition("(")[0], found


def read_table(rest: str) -> tuple[str, Table]:
    """`name(a, b) = breaks [x, x], breaks [x, x], cubic clamp [c, c, c, c]`"""
    lists = [[float(word) for word in numbers.split(", ")] for numbers in re.findall(r"\[([^]]*)\]", rest)]
    *breaks, coefficients = lists
    kind = re.search(r"(linear|cubic) (clamp|error) \[", rest)
    assert kind, f"not a table: {rest}"
    degree = {"linear": 1, "cubic": 3}[kind[1]]
    return rest.partition("(")[0], Table([tuple(axis) for axis in breaks], degree, kind[2], coefficients)


def read_statement(line: str) -> Statement:
    """`%12 e1: vec3 = sub %3, %4 @2   ; comment`"""
    match = STATEMENT.match(line)
    assert match, f"not a statement: {line}"
    _, kind, op, rest = match.groups()
    words = [word for word in rest.strip("[]").split(", ") if word]
    values = [int(word[1:]) for word in words if word.startswith("%")]
    return Statement(op, shape_of(kind), values, [word for word in words if not word.startswith("%")])


def read_programs(text: str) -> dict[str, Program]:
    """The programs of a text by name."""
    programs: dict[str, Program] = {}
    program = Program("")
    for line in text.splitlines():
        keyword, _, rest = line.partition(" ")
        if keyword == "program":
            program = programs[rest] = Program(rest)
        elif keyword == "input":
            name, _, kind = rest.partition(": ")
            program.inputs[name] = shape_of(kind)
        elif keyword == "polynomial":
            name, terms = read_terms(rest)
            program.polynomials[name] = [(float(head), exponents) for head, exponents in terms]
        elif keyword == "basis":
            name, terms = read_terms(rest)
            program.bases[name] = [exponents for _, exponents in terms]
        elif keyword == "table":
            name, table = read_table(rest)
            program.tables[name] = table
        elif keyword == "output":
            name, _, value = rest.partition(" = %")
            program.outputs[name] = int(value)
        elif keyword.startswith("%"):
            program.statements.append(read_statement(line))
        else:
            assert keyword in ("origin", "fused", ""), f"not a line of a program: {line}"
    return programs
