"""Takes the partial derivatives that nsv asks for, with CasADi.

Reads JSON requests, one a line, on standard input and answers each with a line on standard output; needs the standard library and casadi.
The request is data: it is looked up in tables, never evaluated as code. The answer depends on the request and on casadi's version
only: not on hash order, the environment or earlier runs.

CasADi sees scalars (SX) only. Polynomial data, barrier kernels, integer powers and solutions of linear equations are *calls*: fresh
symbols to CasADi, whose derivatives are further calls, so that coefficients stay with the compiler, a power stays a power, and no inverse
is written out.
"""

import json
import math
import sys

SCHEMA = "nsv-partials/1"
MAX_ENTRIES = 1_000_000
MAX_ORDER = 4
KERNEL_ORDERS = 3  # derivatives of sin(E) cos(E) / E that the runtime has


class Refusal(Exception):
    """A request that cannot be answered: a code for the compiler, and words."""

    def __init__(self, code, message):
        super().__init__(message)
        self.code = code


def require(condition, message):
    if not condition:
        raise Refusal("request", message)


# Formulas ---------------------------------------------------------------------------------------------------------------------


class Array:
    """Scalar expressions in row-major order; a vector is a column."""

    def __init__(self, shape, entries):
        self.rows, self.columns = (list(shape) + [1, 1])[:2]
        require(len(entries) == self.rows * self.columns, "entries do not fill their shape")
        self.shape, self.entries = list(shape), entries

    def entry(self, row, column):
        require(0 <= row < self.rows and 0 <= column < self.columns, "entry outside its array")
        return self.entries[row * self.columns + column]

    def scalar(self):
        require(self.shape == [], "a scalar is expected")
        return self.entries[0]


def total(items):
    """Sum from the left, starting from the first item."""
    result = items[0]
    for item in items[1:]:
        result = result + item
    return result


def elementwise(function, *arrays):
    """Entry by entry; scalars are broadcast."""
    shape = max((a.shape for a in arrays), key=len)
    require(all(a.shape in ([], shape) for a in arrays), "shapes do not agree")
    count = max(len(a.entries) for a in arrays)
    columns = [a.entries if a.shape == shape else a.entries * count for a in arrays]
    return Array(shape, [function(*entries) for entries in zip(*columns)])


def matmul(a, b):
    require(a.columns == b.rows, "inner sizes do not agree")
    entry = lambda i, j: total([a.entry(i, k) * b.entry(k, j) for k in range(a.columns)])
    shape = [a.rows] if len(b.shape) == 1 else [a.rows, b.columns]
    return Array(shape, [entry(i, j) for i in range(a.rows) for j in range(b.columns)])


def solve(calls, a, b):
    """Solution of A X = B, a call for each entry: A, one right side; rows and the entry's."""
    require(len(a.shape) == 2 and a.rows == a.columns == b.rows, "equations do not fit their right side")
    entry = lambda i, j: calls.symbol("solve", a.entries + [b.entry(k, j) for k in range(b.rows)], [a.rows, i])
    return Array(b.shape, [entry(i, j) for i in range(b.rows) for j in range(b.columns)])


def operations(ca, calls):
    """What each operation of a request means: operands and immediate integers to an array."""
    each = lambda function: lambda operands, _: elementwise(function, *operands)
    choose = lambda condition, a, b: ca.if_else(condition, a, b)
    call = lambda name: lambda operands, data: Array([], [calls.symbol(name, [a.scalar() for a in operands], data)])
    unary = {"neg": lambda a: -a, "abs": ca.fabs, "sign": ca.sign, "sqrt": ca.sqrt, "exp": ca.exp, "ln": ca.log}
    for name in "sin cos tan asin acos atan sinh cosh tanh".split():
        unary[name] = getattr(ca, name)
    binary = {
        "add": lambda a, b: a + b,
        "sub": lambda a, b: a - b,
        "mul": lambda a, b: a * b,
        "div": lambda a, b: a / b,
        "pow": ca.power,
        # As choices, because CasADi's derivative of fmin multiplies by truth values, and 0 * inf is NaN.
        "min": lambda a, b: choose(a < b, a, b),
        "max": lambda a, b: choose(a > b, a, b),
        "atan2": ca.atan2,
    }
    logic = {
        "lt": lambda a, b: a < b,
        "le": lambda a, b: a <= b,
        "gt": lambda a, b: a > b,
        "ge": lambda a, b: a >= b,
        "eq": ca.eq,
        "ne": ca.ne,
        "and": ca.logic_and,
        "or": ca.logic_or,
        "not": ca.logic_not,
    }
    table = {name: each(function) for name, function in {**unary, **binary, **logic}.items()}
    table.update(
        {
            "const": lambda _, data: Array([], [ca.SX(data[0])]),
            "powi": lambda a, data: elementwise(lambda x: calls.power(x, data[0]), *a),
            "select": lambda a, _: elementwise(lambda x, y: choose(a[0].scalar(), x, y), *a[1:]),
            "array": lambda a, data: Array(data, [item.scalar() for item in a]),
            "element": lambda a, data: Array([], [a[0].entry(*data)]),
            "matmul": lambda a, _: matmul(*a),
            "transpose": lambda a, _: Array(
                [a[0].columns, a[0].rows], [a[0].entry(i, j) for j in range(a[0].columns) for i in range(a[0].rows)]
            ),
            "dot": lambda a, _: Array([], [total([x * y for x, y in zip(a[0].entries, a[1].entries)])]),
            "outer": lambda a, _: Array([a[0].rows, a[1].rows], [x * y for x in a[0].entries for y in a[1].entries]),
            "sum_squares": lambda a, _: Array([], [total([x * x for x in a[0].entries])]),
            "solve": lambda a, _: solve(calls, *a),
            "polynomial": lambda a, data: call("polynomial")(a, [data[0]] + [0] * len(a)),
            "sin_cos_over": call("sin_cos_over"),
            "tan_over": call("tan_over"),
        }
    )
    return table


# Calls ------------------------------------------------------------------------------------------------------------------------


class Calls:
    """Functions that CasADi does not look into: each call is a fresh symbol, and so are its partial derivatives."""

    def __init__(self, ca):
        self.ca, self.calls, self.index = ca, [], {}

    def symbol(self, name, arguments, data):
        """The symbol of `name` with integer `data` at `arguments`; one symbol for equal calls."""
        key = (name, tuple(data), tuple(a.element_hash() for a in arguments))
        if key not in self.index:
            self.index[key] = len(self.calls)
            self.calls.append((self.ca.SX.sym(f"c{len(self.calls)}"), name, arguments, list(data)))
        return self.calls[self.index[key]][0]

    def power(self, x, n):
        if n < 3:
            return (self.ca.SX(1), x, x * x)[n]
        return self.symbol("powi", [x], [n])

    def partial(self, number, j):
        """Partial derivative of call `number` by its argument j."""
        _, name, arguments, data = self.calls[number]
        x = arguments[0]
        if name == "polynomial":
            return self.symbol(name, arguments, [d + (k == j + 1) for k, d in enumerate(data)])
        if name == "powi":
            return data[0] * self.power(x, data[0] - 1)
        if name == "sin_cos_over":
            require(data[0] < KERNEL_ORDERS, "a derivative of sin(E) cos(E)/E beyond the third is needed")
            return self.symbol(name, arguments, [data[0] + 1])
        # tan(E)/E = S(E) / cos^2(E) with S = sin(E) cos(E) / E, smooth at 0.
        value, slope = (self.symbol("sin_cos_over", arguments, [order]) for order in (0, 1))
        return (slope + 2 * value * self.ca.tan(x)) / (self.ca.cos(x) * self.ca.cos(x))


# Derivatives ------------------------------------------------------------------------------------------------------------------


class Derivation:
    """A derivation d, given on the inputs: its value at an expression is a row, one directional derivative per column."""

    def __init__(self, ca, calls, columns, images, forward):
        self.ca, self.calls, self.columns, self.forward = ca, calls, columns, forward
        self.images = dict(images)  # symbol name -> row; symbols without one are constant

    def image(self, symbol):
        name = symbol.name()
        if name not in self.images:
            number = int(name[1:]) if name.startswith("c") else None
            self.images[name] = self.ca.SX(1, self.columns) if number is None else self.chain(number)
        return self.images[name]

    def chain(self, number):
        """Chain rule: sum over the arguments of partial derivative times d(argument)."""
        rows = [self.of([argument]) for argument in self.calls.calls[number][2]]
        if self.calls.calls[number][1] == "solve":
            return self.solution(number, rows)
        terms = [self.calls.partial(number, j) * row for j, row in enumerate(rows) if not row.is_zero()]
        return total(terms) if terms else self.ca.SX(1, self.columns)

    def solution(self, number, rows):
        """A x = b gives A dx = db - dA x: an entry of dx, with d of the entries of A and b."""
        _, name, arguments, (n, place) = self.calls.calls[number]
        x = [self.calls.symbol(name, arguments, [n, j]) for j in range(n)]
        right = [rows[n * n + i] - total([rows[i * n + j] * x[j] for j in range(n)]) for i in range(n)]
        entries = []
        for column in range(self.columns):
            side = [self.ca.SX(0) if row[0, column].is_zero() else row[0, column] for row in right]
            none = all(entry.is_zero() for entry in side)
            entries.append(self.ca.SX(1, 1) if none else self.calls.symbol(name, arguments[: n * n] + side, [n, place]))
        return self.ca.horzcat(*entries)

    def of(self, expressions):
        """d of each expression, one row each."""
        ca, column = self.ca, self.ca.vertcat(*expressions)
        moving = [(s, self.image(s)) for s in ca.symvar(column)]
        moving = [(s, row) for s, row in moving if not row.is_zero()]
        if not moving:
            return ca.SX(len(expressions), self.columns)
        symbols, rows = (ca.vertcat(*items) for items in zip(*moving))
        if self.columns == 1 or self.forward:
            return ca.jtimes(column, symbols, ca.densify(rows))
        return ca.sparsify(ca.jacobian(column, symbols)) @ ca.sparsify(rows)


class Formula:
    """The expressions of a request, and their symbols."""

    def __init__(self, ca, request):
        self.ca, self.calls = ca, Calls(ca)
        self.inputs, self.places = {}, []  # input name -> symbols; (input, entry) and symbol, in order
        for name, shape in request["inputs"]:
            self.add_input(name, shape)
        table, values = operations(ca, self.calls), []
        shapes, symbols = [shape for _, shape in request["inputs"]], list(self.inputs.values())
        for name, operands, data in request["nodes"]:
            require(all(0 <= i < len(values) for i in operands), "an operand does not come earlier")
            require(name == "input" or name in table, f"unknown operation {name}")
            if name == "input":
                values.append(Array(shapes[data[0]], symbols[data[0]]))
            else:
                values.append(table[name]([values[i] for i in operands], data))
        self.outputs = [(name, values[i]) for name, i in request["outputs"]]
        # Only a seed that passes through the choice is masked: a product with the derivative of an arm not taken is 0 * inf, NaN.
        self.forward = any(name in ("select", "min", "max") for name, _, _ in request["nodes"])

    def add_input(self, name, shape):
        size, number = math.prod(shape), len(self.inputs)
        require(len(self.places) + size <= MAX_ENTRIES, "too many inputs")
        symbols = [self.ca.SX.sym(f"x{number}_{entry}") for entry in range(size)]
        self.places += [(number, entry, symbol) for entry, symbol in enumerate(symbols)]
        self.inputs[name] = symbols

    def rates(self, order, varying, shapes):
        """Total derivatives of the outputs along the jets of the varying inputs."""
        require(1 <= order <= MAX_ORDER, "order of the rates out of range")
        images = {}
        for name in varying:
            jet = [self.inputs[name]]
            for k in range(1, order + 1):
                self.add_input(f"{name}.rate{k}", shapes[name])
                jet.append(self.inputs[f"{name}.rate{k}"])
            images.update({x.name(): dx for lower, upper in zip(jet, jet[1:]) for x, dx in zip(lower, upper)})
        d = Derivation(self.ca, self.calls, 1, images, self.forward)
        results = []
        for name, value in self.outputs:
            entries = value.entries
            for k in range(1, order + 1):
                column = d.of(entries)
                entries = [column[i, 0] for i in range(len(entries))]
                results.append((f"{name}.rate{k}", entries))
        return results

    def gradient(self, wrt):
        """The derivation whose columns are the entries of the inputs `wrt`, and the columns of each input."""
        symbols = [symbol for name in wrt for symbol in self.inputs[name]]
        unit = self.ca.SX.eye(len(symbols))
        images = {symbol.name(): unit[i, :] for i, symbol in enumerate(symbols)}
        columns, end = {}, 0
        for name in wrt:
            columns[name] = range(end, end + len(self.inputs[name]))
            end += len(self.inputs[name])
        return Derivation(self.ca, self.calls, len(symbols), images, self.forward), columns

    def jacobian(self, wrt):
        """Partial derivatives of each output by each input, row-major."""
        d, columns = self.gradient(wrt)
        results = []
        for name, value in self.outputs:
            rows = d.of(value.entries)
            for x in wrt:
                entries = [rows[i, j] for i in range(len(value.entries)) for j in columns[x]]
                results.append((f"{name}/{x}", entries))
        return results

    def hessian(self, wrt):
        """First and second partial derivatives of scalar outputs; the upper triangle is mirrored."""
        d, columns = self.gradient(wrt)
        results = []
        for name, value in self.outputs:
            first = d.of([value.scalar()])
            gradient = [first[0, i] for i in range(d.columns)]
            second = d.of(gradient)
            results += [(f"{name}/{x}", [gradient[i] for i in columns[x]]) for x in wrt]
            for x in wrt:
                for y in wrt:
                    entries = [second[min(i, j), max(i, j)] for i in columns[x] for j in columns[y]]
                    results.append((f"{name}/{x}/{y}", entries))
        return results

    def answer(self, request):
        (kind, job), = request["job"].items()
        if kind == "rates":
            return self.rates(job["order"], job["varying"], dict(request["inputs"]))
        require(kind in ("jacobian", "hessian"), "unknown job")
        return self.jacobian(job["wrt"]) if kind == "jacobian" else self.hessian(job["wrt"])


# Tape -------------------------------------------------------------------------------------------------------------------------


class Tape:
    """Instructions of the results in static single assignment: operands come earlier, equal instructions are one."""

    def __init__(self, ca, formula, results):
        self.formula, self.nodes, self.index, self.constants = formula, [], {}, {}
        self.names = {getattr(ca, name): name[3:] for name in sorted(dir(ca)) if name.startswith("OP_")}
        needed = [entry for _, entries in results for entry in entries if not entry.is_zero()]
        arguments, self.starts = [], []
        for _, _, items, _ in formula.calls.calls:
            self.starts.append(len(arguments))
            arguments += items
        self.load(ca, ca.cse([ca.densify(ca.vertcat(*needed)), ca.densify(ca.vertcat(*arguments))]))
        self.numbers = {}  # CasADi's work index -> node
        numbers = iter([self.place(self.results[i]) for i in range(len(needed))])
        self.outputs = [[name, [None if e.is_zero() else next(numbers) for e in entries]] for name, entries in results]

    def load(self, ca, expressions):
        """Reads CasADi's instructions into `work` (operation, operands, data), `results` and `arguments` (work indices)."""
        inputs = [ca.vertcat(*[s for _, _, s in self.formula.places]), ca.vertcat(*[c[0] for c in self.formula.calls.calls])]
        function = ca.Function("tape", inputs, expressions, {"live_variables": False})
        require(function.n_instructions() <= MAX_ENTRIES, "the derivatives are too large")
        self.work, self.results, self.arguments = {}, {}, {}
        for k in range(function.n_instructions()):
            name = self.names.get(function.instruction_id(k), "UNKNOWN")
            operands, target = function.instruction_input(k), function.instruction_output(k)
            if name == "OUTPUT":
                (self.results, self.arguments)[target[0]][target[1]] = operands[0]
            elif name == "INPUT":
                self.work[target[0]] = self.leaf(*operands)
            elif name == "CONST":
                self.work[target[0]] = ("const", [], [self.constant(function.instruction_constant(k))])
            else:
                self.work[target[0]] = (name, list(operands), [])

    def leaf(self, argument, entry):
        if argument == 0:
            return "input", [], list(self.formula.places[entry][:2])
        return "call", [], [entry]

    def constant(self, value):
        require(math.isfinite(value), "a constant of the derivatives is not finite")
        return self.constants.setdefault(value.hex(), len(self.constants))

    def resolve(self, index):
        """An instruction with its operands as work indices; those of a call are its arguments'."""
        name, operands, data = self.work[index]
        if name != "call":
            return name, operands, data
        start, (_, name, arguments, data) = self.starts[data[0]], self.formula.calls.calls[data[0]]
        return name, [self.arguments[start + j] for j in range(len(arguments))], data

    def place(self, root):
        """Appends what `root` needs, operands first, and `root`; the number of its node. No recursion: chains can be long."""
        stack = [root]
        while stack:
            index = stack[-1]
            name, operands, data = self.resolve(index)
            missing = [i for i in operands if i not in self.numbers]
            if missing and index not in self.numbers:
                stack += reversed(missing)
                continue
            stack.pop()
            if index not in self.numbers:
                node = [name, [self.numbers[i] for i in operands], data]
                self.numbers[index] = self.index.setdefault(json.dumps(node), len(self.nodes))
                if self.numbers[index] == len(self.nodes):
                    self.nodes.append(node)
        return self.numbers[root]

    def document(self):
        return {"constants": list(self.constants), "nodes": self.nodes, "outputs": self.outputs}


def casadi_of(version):
    """The casadi module, of the version asked for."""
    try:
        import casadi
    except ImportError as error:
        raise Refusal("casadi-missing", str(error)) from None
    if casadi.__version__ != version:
        raise Refusal("casadi-version", casadi.__version__)
    return casadi


def answer(document):
    require(document.get("schema") == SCHEMA, "unknown schema")
    ca = casadi_of(document["casadi"])
    request = document["request"]
    if request is None:
        return {"python": sys.version.split()[0]}
    require(len(request["nodes"]) <= MAX_ENTRIES, "the formula is too large")
    formula = Formula(ca, request)
    return {"tape": Tape(ca, formula, formula.answer(request)).document()}


def reply(question):
    try:
        body = answer(json.loads(question))
    except Refusal as refusal:
        body = {"error": {"code": refusal.code, "message": str(refusal)}}
    except Exception as error:  # a report, not a traceback, is what the compiler can show
        lines = str(error).strip().splitlines() or [""]
        body = {"error": {"code": "failed", "message": f"{type(error).__name__}: {lines[-1]}"}}
    return json.dumps({"schema": SCHEMA, **body}, allow_nan=False, sort_keys=True, separators=(",", ":"))


def main():
    for question in sys.stdin:
        print(reply(question), flush=True)


main()
