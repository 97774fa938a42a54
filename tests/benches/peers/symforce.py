"""SymForce: C++ of one function with common subexpressions shared, compiled by g++ or by clang++ with -ffast-math. Needs Eigen."""

import tempfile
from pathlib import Path

from build import Built, Missing, compiled
from workload import Workload

FLAGS = {
    "g++ -O3": ["g++", "-O3", "-march=native"],
    "clang++ fast-math": ["clang++", "-O3", "-ffast-math", "-march=native"],
}
EIGEN = Path("/usr/include/eigen3")

WRAPPER = """
extern "C" void step(const double *in, double *out) {{
  const Eigen::Map<const Eigen::Matrix<double, {inputs}, 1>> given(in);
  Eigen::Map<Eigen::Matrix<double, {results}, 1>> result(out);
  result = sym::Law<double>(given);
}}
"""


def source(work: Workload) -> str:
    """What SymForce generates for the law."""
    try:
        import symforce

        symforce.set_symbolic_api("symengine")
        symforce.set_epsilon_to_number(0.0)
        import symforce.symbolic as sf
        from symforce import codegen
    except ImportError as error:
        raise Missing("symforce is not installed") from error
    names = "sqrt exp sin cos tan asin acos atan sinh cosh tanh atan2".split()
    functions = {name: getattr(sf, name) for name in names}
    functions |= {"ln": sf.log, "abs": sf.Abs, "sign": sf.sign, "min": sf.Min, "max": sf.Max, "neg": lambda a: -a, "pow": lambda a, b: a**b}
    functions |= {"add": lambda a, b: a + b, "sub": lambda a, b: a - b, "mul": lambda a, b: a * b, "div": lambda a, b: a / b}
    functions |= {"lt": sf.less, "le": sf.less_equal, "gt": sf.greater, "ge": sf.greater_equal}
    functions |= {"and": sf.logical_and, "or": sf.logical_or, "not": lambda a: 1 - a}
    functions |= {"eq": lambda a, b: 1 - sf.sign((a - b) ** 2), "ne": lambda a, b: sf.sign((a - b) ** 2)}
    # SymForce has no selection: the arms are weighted by 1 and 0, which is its own idiom.
    functions |= {"select": lambda c, a, b: c * a + (1 - c) * b}
    symbol = sf.Matrix(work.size, 1).symbolic("x")
    results = sf.Matrix(work.graph.evaluate(work.results, [symbol[i] for i in range(work.size)], functions))

    def law(given: sf.Matrix) -> sf.Matrix:
        return results.subs(dict(zip(symbol, given, strict=True)))

    law.__annotations__["given"] = law.__annotations__["return"] = None
    generator = codegen.Codegen(
        inputs=codegen.codegen.Values(given=symbol), outputs=codegen.codegen.Values(result=results),
        config=codegen.CppConfig(), name="law", return_key="result",
    )  # fmt: skip
    with tempfile.TemporaryDirectory() as folder:
        files = generator.generate_function(output_dir=folder, skip_directory_nesting=True).generated_files
        header = next(path for path in files if path.suffix == ".h")
        return header.read_text()


def build(work: Workload, folder: Path, flags: str) -> Built:
    """Generates and compiles."""
    if not EIGEN.exists():
        raise Missing("Eigen is not installed")
    text = source(work) + WRAPPER.format(inputs=work.size, results=len(work.results))
    return Built(compiled(folder, text, "step.cpp", [*FLAGS[flags], f"-I{EIGEN}"]))
