"""Values of every program by CasADi's own evaluation, written to tests/casadi_values: the arithmetic of the evaluator and of the emitted
code is checked against CasADi's virtual machine and linear algebra, not against another program of the same author.

Run: python tests/reference/casadi_values.py [SPEC ..] (half a minute besides the build; needs cargo and casadi).

A program is built from its text, operation by operation, as a CasADi function. What has a closed form is written in that form, not as
the compiler evaluates it: polynomials and networks are plain sums of powers, their derivatives and those of the barrier's kernels are
taken by CasADi, systems are solved by its QR factorisation, a singular vector is that of the angle of a 2 x 2 matrix. A lookup table
is CasADi's own B-spline of the table's coefficients on the knots of its breaks, and its derivatives are CasADi's of that.
"""

import json
import random
import re
import subprocess
import sys
from pathlib import Path

import casadi as ca
import numpy as np

from casadi_forms import kernel, product, singular_vector, spline

ROOT = Path(__file__).resolve().parents[2]
SPECS = sorted(path.stem for path in (ROOT / "specs").glob("*.yaml"))
RANDOM_POINTS = 15
# Relative sizes of the changes of a point of the reference that make a random one.
SPREADS = [0.3, 0.02, 1e-3, 1e-6]
# Trials of the last bits of inputs and constants that measure what rounding can do.
TRIALS = 6
STATEMENT = re.compile(r"%(\d+)(?: [\w./]+)?: (\S+) = (\w+) ?(.*?)(?: @\d+(?:   ; .*)?)?$")

ELEMENTWISE = {name: getattr(ca, name) for name in "sign sqrt exp sin cos tan asin acos atan sinh cosh tanh atan2".split()} | {
    "neg": lambda a: -a, "abs": ca.fabs, "ln": ca.log, "add": lambda a, b: a + b, "sub": lambda a, b: a - b,
    "mul": lambda a, b: a * b, "div": lambda a, b: a / b, "pow": lambda a, b: a**b, "min": ca.fmin, "max": ca.fmax,
    "lt": lambda a, b: a < b, "le": lambda a, b: a <= b, "gt": lambda a, b: a > b, "ge": lambda a, b: a >= b,
    "eq": lambda a, b: a == b, "ne": lambda a, b: a != b, "and": ca.logic_and, "or": ca.logic_or, "not": ca.logic_not,
    "select": ca.if_else, "matmul": ca.mtimes, "transpose": lambda a: a.T, "dot": ca.dot, "outer": lambda a, b: ca.mtimes(a, b.T),
    "sum_squares": ca.sumsqr, "solve": ca.solve, "ldlt": lambda a: a, "array": ca.vertcat,
}  # fmt: skip


def shape_of(text):
    """Rows and columns of a type; a truth value is a scalar."""
    if text in ("real", "bool"):
        return 1, 1
    if text.startswith("ldlt"):
        return int(text[4:]), int(text[4:])
    sizes = [int(size) for size in text[3:].split("x")]
    return sizes[0], (sizes + [1])[1]


def shaped(entries, shape):
    """Entries given row by row."""
    return ca.reshape(entries, shape[1], shape[0]).T


class Program:
    """A program as a CasADi function of its inputs and its constants."""

    def __init__(self, text, data):
        """`data` are the lines of all polynomials and bases of the specification, by name."""
        lines = text.splitlines()
        self.name, self.data = lines[0], data
        self.constants, self.inputs, self.outputs, values = {}, {}, {}, {}
        for line in lines[1:]:
            if line.startswith("input "):
                name, kind = line[6:].split(": ")
                self.inputs[name] = ca.SX.sym(name, *shape_of(kind))
            elif line.startswith("%"):
                at, kind, op, operands = STATEMENT.match(line).groups()
                values[at] = self.value(op, operands, shape_of(kind), values)
                assert values[at].shape == shape_of(kind), line
            elif line.startswith("output "):
                name, at = line[7:].split(" = %")
                self.outputs[name] = ca.densify(values[at])
        constants = ca.vertcat(ca.SX(0, 1), *self.constants.values())
        self.function = ca.Function(self.name, [*self.inputs.values(), constants], list(self.outputs.values()))

    def constant(self, text):
        """A whole number as it is, another as a further input: nothing is folded, and its rounding can be varied."""
        value = float(text)
        if value == int(value):
            return ca.SX(value)
        return self.constants.setdefault(value, ca.SX.sym("c"))

    def value(self, op, operands, shape, values):
        """The value of a statement."""
        if op == "input":
            return self.inputs[operands]
        if op == "const":
            return shaped(ca.vertcat(*map(self.constant, operands.strip("[]").split(", "))), shape)
        words = operands.split(", ")
        arguments = [values[word[1:]] for word in words if word.startswith("%")]
        rest = [word for word in words if not word.startswith("%")]
        if op == "powi":
            return arguments[0] ** int(rest[0])
        if op == "element":
            return arguments[0][int(rest[0]), int(rest[1])]
        if op.startswith("sin_cos_over"):
            return kernel(int(op[14:] or 0))(arguments[0])
        if op == "tan_over":
            return ca.if_else(arguments[0] == 0, 1, ca.tan(arguments[0]) / arguments[0])
        if op == "singular_vector":
            return singular_vector(arguments[0])
        if op == "polynomial":
            z = ca.SX.sym("z", len(arguments))
            return ca.substitute(self.polynomial(rest[0], z), z, ca.vertcat(*arguments))
        if op.startswith("basis"):
            return self.basis(rest[0], *arguments)
        if op == "table":
            name, *orders = words[0].split()
            function, coefficients = spline(self.data[name], tuple(map(int, orders)))
            return function(ca.vertcat(*arguments), ca.vertcat(*map(self.constant, coefficients)))
        result = ELEMENTWISE[op](*arguments)
        return shaped(result, shape) if op == "array" else result

    def polynomial(self, name, z):
        """The sum of its terms; a derivative is CasADi's of the polynomial it is named for."""
        derivative = re.fullmatch(r"(\w+)_d(\d+)", name)
        if derivative and derivative[1] in self.data:
            return ca.jacobian(self.polynomial(derivative[1], z), z)[int(derivative[2]) - 1]
        terms = re.findall(r"(\S+) \[([^]]*)\]", self.data[name])
        return sum(self.constant(c) * product(zip(ca.vertsplit(z), map(int, powers.split(", ")))) for c, powers in terms)

    def basis(self, name, at, *rates):
        """The monomials of a network, or their first or second rate along a motion, by CasADi."""
        z, v, a = (ca.SX.sym(letter, at.shape[0]) for letter in "zva")
        exponents = [map(int, powers.split(", ")) for powers in re.findall(r"\[([^]]*)\]", self.data[name])]
        monomials = ca.vertcat(*[product(zip(ca.vertsplit(z), powers)) for powers in exponents])
        if rates:
            monomials = ca.jtimes(monomials, z, v)
        if len(rates) == 2:
            monomials = ca.jtimes(monomials, z, v) + ca.jtimes(monomials, v, a)
        motion = [*rates, ca.SX.zeros(at.shape), ca.SX.zeros(at.shape)][:2]
        return ca.densify(ca.substitute(monomials, ca.vertcat(z, v, a), ca.vertcat(at, *motion)))

    def evaluate(self, given, moved=lambda value: value):
        """Outputs by name, row by row."""
        arguments = [ca.DM(np.reshape([moved(v) for v in given[name]], symbol.shape)) for name, symbol in self.inputs.items()]
        found = self.function.call([*arguments, ca.DM([moved(c) for c in self.constants])])
        return {name: np.array(value).ravel().tolist() for name, value in zip(self.outputs, found)}

    def point(self, given, draw):
        """Outputs, and what the last bits of inputs and constants do to each output where that is more than a few last bits."""
        outputs = self.evaluate(given)
        assert all(np.isfinite(value).all() for value in outputs.values()), self.name
        trials = [self.evaluate(given, lambda value: value * (1 + draw.choice([-1, 1]) * 2.0**-52)) for _ in range(TRIALS)]
        rounding = {}
        for name, value in outputs.items():
            change = max(np.max(np.abs(np.subtract(trial[name], value))) for trial in trials)
            if change > 1e-14 * np.max(np.abs(value)):
                rounding[name] = float(f"{change:.2g}")
        return outputs, rounding


def programs(spec):
    """All programs of a specification."""
    command = ["cargo", "run", "--quiet", "--locked", "--package", "nsv-tests", "--example", "programs", f"specs/{spec}.yaml"]
    text = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout
    data = dict(re.findall(r"^(?:polynomial|basis|table) (\w+)\([^)]*\) = (.*)$", text, flags=re.M))
    return [Program(part, data) for part in re.split(r"^program ", text, flags=re.M)[1:]]


def states(spec, draw):
    """Label and values of states of the closed loop: those of the reference that are special, and the surroundings of its random ones."""
    points = json.loads((ROOT / f"tests/points/{spec}.json").read_text())["points"]
    for index, point in enumerate(points):
        at = {name: np.ravel(value).tolist() for name, value in point["inputs"].items()}
        at["u_sat"] = point["expected"]["u_sat"]
        at |= {f"plant.{name}": [value] for name, value in point["plant"]["params"].items()}
        if point["label"].startswith("random"):
            if index >= RANDOM_POINTS:
                continue
            spread = SPREADS[index % len(SPREADS)]
            at = {name: [float(f"{v * (1 + spread * draw.uniform(-1, 1)):.9g}") for v in value] for name, value in at.items()}
        yield point["label"], at


def given(program, at):
    """The inputs of a program at a state: an emitted function has controller states under `state.`, the plant its own parameters."""
    names = [*(f"x{i}" for i in range(1, 10)), "truth", *(f"w{i}" for i in range(1, 10))]
    values = at | {f"state.{name}": value for name, value in at.items()}
    values["x"] = [v for name in names for v in at.get(name, [])]
    if program == "plant":
        values |= {name.replace("plant.", "params."): value for name, value in at.items() if name.startswith("plant.")}
    return values


def main():
    """Writes one file per specification, one point per line; of those named on the command line, or of all."""
    folder = ROOT / "tests/casadi_values"
    folder.mkdir(exist_ok=True)
    for spec in sys.argv[1:] or SPECS:
        draw, functions, lines = random.Random(spec), programs(spec), []
        for label, at in states(spec, draw):
            found = {program.name: program.point(given(program.name, at), draw) for program in functions}
            outputs, rounding = ({name: pair[part] for name, pair in found.items()} for part in (0, 1))
            point = {"label": label, "inputs": at, "outputs": outputs, "rounding": rounding}
            lines.append(json.dumps(point, separators=(",", ":")))
        (folder / f"{spec}.json").write_text('{"points": [\n' + ",\n".join(lines) + "\n]}\n")


if __name__ == "__main__":
    main()
