"""Public ensemble benchmarks, written with nsv's runtime and with numpy, numba and JAX: see public/src/lib.rs for the equations."""

from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from build import cargo_at
from measure_public import GROWTH, PEERS, START, STEPS, VOLATILITY

HERE = Path(__file__).resolve().parent
RUNS = 8192
LORENZ_TOLERANCE = {"f64": 1e-10, "f32": 1e-4}


def brownian_error(finals: np.ndarray) -> float:
    """How far mean and deviation are from those of the scheme, in standard errors."""
    dt, samples = 1 / STEPS["brownian"], finals.size
    mean = START * (1 + GROWTH * dt) ** STEPS["brownian"]
    second = START**2 * ((1 + GROWTH * dt) ** 2 + VOLATILITY**2 * dt) ** STEPS["brownian"]
    deviation = np.sqrt(second - mean**2)
    of_mean = abs(finals.mean() - mean) / deviation * np.sqrt(samples)
    return float(max(of_mean, abs(finals.std() / deviation - 1) * np.sqrt(2 * samples)))


def measure_all(folder: Path, trials: Callable[..., dict[str, Any]], measured: Callable[..., dict[str, list[float]]]) -> dict[str, Any]:
    """Every case in both precisions."""
    library = cargo_at(HERE / "public", folder / "target", "libpublic_cases.so")
    kinds = {name: "jax" if name == "JAX" else "loop" for name in PEERS if name in ("nsv",) or find_spec(name.split()[0].lower())}
    reference: dict[str, np.ndarray] = {}
    values = folder / "values.npy"

    def case_of(case: str, precision: str) -> dict[str, Any]:
        def measure(name: str) -> tuple[dict[str, list[float]], float]:
            request = {"case": case, "single": precision == "f32", "peer": name, "runs": RUNS, "library": library, "values": values}
            figures, finals = measured("measure_public.py", request), np.load(values).astype(float)
            if case == "brownian":
                error = brownian_error(finals)
                assert error < 6, f"{name}: distribution of the final states is off by {error} standard errors"
                return figures, 0.0
            error = float(np.abs(finals - reference.setdefault(case, finals)).max())
            assert error < LORENZ_TOLERANCE[precision], f"{name}: final states are off by {error}"
            return figures, 0.0

        return {"runs": RUNS, "steps": STEPS[case], "missing": {}, "peers": trials(f"{case}, {precision}", kinds, measure)}

    return {f"{case}, {precision}": case_of(case, precision) for case in STEPS for precision in ("f64", "f32")}
