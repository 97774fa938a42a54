"""What a good engineer could make of CasADi's list of operations for ensembles: the same list in C with vectors of eight doubles
(GCC's vector extension, AVX-512) and the vector functions of glibc's libmvec, and random numbers in lanes."""

from pathlib import Path

from build import Built, Missing, compiled
from graph import Graph
from reference import INFIX
from workload import Workload

SOURCE = """
#include <immintrin.h>
#include <math.h>
#include <stdint.h>
#include <string.h>
typedef double lanes __attribute__((vector_size(64)));
typedef uint64_t words __attribute__((vector_size(64)));
typedef long truths __attribute__((vector_size(64)));
extern "C" {{
lanes _ZGVeN8v_sin(lanes); lanes _ZGVeN8v_cos(lanes); lanes _ZGVeN8v_tan(lanes); lanes _ZGVeN8v_exp(lanes); lanes _ZGVeN8v_log(lanes);
lanes _ZGVeN8v_tanh(lanes); lanes _ZGVeN8v_sinh(lanes); lanes _ZGVeN8v_cosh(lanes); lanes _ZGVeN8v_asin(lanes); lanes _ZGVeN8v_acos(lanes);
lanes _ZGVeN8v_atan(lanes); lanes _ZGVeN8vv_atan2(lanes, lanes); lanes _ZGVeN8vv_pow(lanes, lanes);
}}
static inline lanes number(double x) {{ return (lanes){{x, x, x, x, x, x, x, x}}; }}
static inline lanes square_root(lanes x) {{ return (lanes)_mm512_sqrt_pd((__m512d)x); }}
static inline lanes magnitude(lanes x) {{ return x < 0.0 ? -x : x; }}
static inline words rotate(words x, int k) {{ return x << k | x >> (64 - k); }}

static words word[4];
static inline words next_words() {{
    words result = rotate(word[0] + word[3], 23) + word[0], shifted = word[1] << 17;
    word[2] ^= word[0]; word[3] ^= word[1]; word[1] ^= word[2]; word[0] ^= word[3];
    word[2] ^= shifted; word[3] = rotate(word[3], 45);
    return result;
}}
static inline lanes unit() {{ return __builtin_convertvector(next_words() >> 11, lanes) * 0x1p-53 + 0x1p-54; }}
static void seed_words(uint64_t seed) {{
    for (int i = 0; i < 4; i++)
        for (int lane = 0; lane < 8; lane++) {{
            uint64_t z = seed += 0x9e3779b97f4a7c15;
            z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9; z = (z ^ z >> 27) * 0x94d049bb133111eb;
            word[i][lane] = z ^ z >> 31;
        }}
}}

static void step(const lanes *x, lanes *y) {{
    {body}
}}

/* Final plant states of all runs, eight at a time; normal draws by Box and Muller. */
extern "C" void ensemble(const double *start, size_t runs, size_t steps, uint64_t seed, double scale, double *finals) {{
    static lanes x[{inputs}], y[{results}];
    seed_words(seed);
    for (size_t run = 0; run < runs; run += 8) {{
        for (int i = 0; i < {inputs}; i++) x[i] = number(start[i]);
        for (size_t k = 0; k < steps; k++) {{
            x[0] = number(k * {dt!r});
            if (k) memcpy(x + 1, y, {carried} * sizeof(lanes));
            for (int j = 0; j < {channels}; j += 2) {{
                lanes radius = square_root(-2.0 * _ZGVeN8v_log(unit())) * scale, angle = 6.283185307179586 * unit();
                x[{noise} + j] = radius * _ZGVeN8v_cos(angle);
                if (j + 1 < {channels}) x[{noise} + j + 1] = radius * _ZGVeN8v_sin(angle);
            }}
            step(x, y);
        }}
        for (int lane = 0; lane < 8 && run + lane < runs; lane++)
            for (int i = 0; i < {states}; i++) finals[(run + lane) * {states} + i] = y[i][lane];
    }}
}}
"""


def statements(graph: Graph, results: list[int]) -> list[str]:
    """Straight-line statements from `x[i]` to `y[i]`."""
    name, lines = {}, []
    for node in graph.live(results):
        op, *operands = graph.entries[node]
        if op == "const":
            name[node] = f"({operands[0]!r})"
            continue
        name[node] = f"v{node}"
        kind, a = "lanes", [name[operand] for operand in operands] if op != "input" else []
        if op == "input":
            text = f"x[{operands[0]}]"
        elif op in ("lt", "le", "gt", "ge", "eq", "ne", "and", "or"):
            kind = "truths"
            text = f"(truths)({a[0]} {INFIX[op].replace('and', '&').replace('or', '|')} {a[1]})"
        elif op in INFIX:
            text = f"{a[0]} {INFIX[op]} {a[1]}"
        elif op == "select":
            text = f"{a[0]} ? number(0.0) + {a[1]} : number(0.0) + {a[2]}"
        elif op in ("min", "max"):
            text = f"{a[0]} {'<' if op == 'min' else '>'} {a[1]} ? number(0.0) + {a[0]} : number(0.0) + {a[1]}"
        elif op in ("neg", "not", "sqrt", "abs"):
            text = {"neg": "-{}", "not": "~{}", "sqrt": "square_root({})", "abs": "magnitude({})"}[op].format(a[0])
        else:
            text = f"_ZGVeN8{'v' * len(a)}_{'log' if op == 'ln' else op}({', '.join(a)})"
        lines.append(f"const {kind} v{node} = {text};")
    return lines + [f"y[{i}] = number(0.0) + {name[node]};" for i, node in enumerate(results)]


def build(work: Workload, folder: Path) -> Built:
    """Compiles with g++, whose vectors can be selected."""
    if "avx512dq" not in Path("/proc/cpuinfo").read_text():
        raise Missing("the processor has no AVX-512")
    noise, (channels, _) = work.inputs["dw"]
    text = SOURCE.format(
        body="\n    ".join(statements(work.graph, work.results)), inputs=work.size + 1, results=len(work.results), dt=work.dt,
        carried=work.outputs["u_sat"][0], channels=channels, noise=noise, states=work.inputs["x"][1][0],
    )  # fmt: skip
    return Built(compiled(folder, text, "step.cpp", ["g++", "-O3", "-march=native", "-fno-signed-zeros"], ["-lmvec"]))
