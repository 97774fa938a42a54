"""One measurement of a public case in a fresh process: `python measure_public.py REQUEST`, a JSON object; prints the samples as one JSON line.

The final states of one ensemble are written for the comparison. The time is the process's own on one core.
"""

import ctypes
import json
import sys
import time
from collections.abc import Callable
from typing import Any

import numpy as np

SECONDS = 1.0
STEPS = {"brownian": 256, "lorenz": 1000}
GROWTH, VOLATILITY, START = 1.5, 0.01, 0.1
# Final states [runs, 3] of a seed.
Ensemble = Callable[[int], np.ndarray]


def by_nsv(case: str, runs: int, single: bool, library: str) -> Ensemble:
    """nsv's runtime in the widest lanes."""
    code = ctypes.CDLL(library)

    def ensemble(seed: int) -> np.ndarray:
        finals = np.empty((runs, 3))
        arguments = (ctypes.c_bool(single), ctypes.c_uint64(seed), ctypes.c_size_t(runs), ctypes.c_void_p(finals.ctypes.data))
        getattr(code, case)(*arguments)
        return finals

    return ensemble


def lorenz_rate(u: Any, rayleigh: Any, stack: Callable[[list], Any]) -> Any:
    """The Lorenz equations on arrays [3, runs]."""
    x, y, z = u
    return stack([10 * (y - x), x * (rayleigh - z) - y, x * y - (8 / 3) * z])


def by_numpy(case: str, runs: int, single: bool, _: str) -> Ensemble:
    """Arrays over all runs; in blocks that fit the cache."""
    kind, block = np.float32 if single else np.float64, 4096

    def brownian(seed: int) -> np.ndarray:
        draw, dt = np.random.default_rng(seed), 1 / STEPS[case]
        growth, volatility = kind(1 + GROWTH * dt), kind(VOLATILITY * np.sqrt(dt))
        u = np.full((runs, 3), START, dtype=kind)
        factor = np.empty((block, 3), dtype=kind)
        for part in (u[at : at + block] for at in range(0, runs, block)):
            for _ in range(STEPS[case]):
                view = factor[: len(part)]
                draw.standard_normal(out=view, dtype=kind)
                view *= volatility
                view += growth
                part *= view
        return u

    def lorenz(_: int) -> np.ndarray:
        h = kind(1 / STEPS[case])
        sweep = np.linspace(0, 21, runs).astype(kind)
        finals = np.empty((runs, 3), dtype=kind)
        for at in range(0, runs, block):
            rayleigh = sweep[at : at + block]
            u = np.zeros((3, len(rayleigh)), dtype=kind)
            u[0] = 1
            for _ in range(STEPS[case]):
                k1 = lorenz_rate(u, rayleigh, np.array)
                k2 = lorenz_rate(u + h / 2 * k1, rayleigh, np.array)
                k3 = lorenz_rate(u + h / 2 * k2, rayleigh, np.array)
                k4 = lorenz_rate(u + h * k3, rayleigh, np.array)
                u = u + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
            finals[at : at + block] = u.T
        return finals

    return brownian if case == "brownian" else lorenz


def by_numba(case: str, runs: int, single: bool, _: str) -> Ensemble:
    """Loops over runs, with fastmath."""
    from numba import njit

    kind, steps = np.float32 if single else np.float64, STEPS[case]

    @njit(fastmath=True)
    def brownian(draw, u, growth, volatility):
        for run in range(u.shape[0]):
            x, y, z = u[run, 0], u[run, 1], u[run, 2]
            for _ in range(steps):
                x += x * growth + x * volatility * kind(draw.standard_normal())
                y += y * growth + y * volatility * kind(draw.standard_normal())
                z += z * growth + z * volatility * kind(draw.standard_normal())
            u[run, 0], u[run, 1], u[run, 2] = x, y, z

    @njit(fastmath=True, inline="always")
    def rate(x, y, z, r):
        return kind(10) * (y - x), x * (r - z) - y, x * y - kind(8 / 3) * z

    @njit(fastmath=True)
    def lorenz(u, sweep, h):
        half, sixth, two = h / kind(2), h / kind(6), kind(2)
        for run in range(u.shape[0]):
            x, y, z, r = kind(1), kind(0), kind(0), sweep[run]
            for _ in range(steps):
                a1, b1, c1 = rate(x, y, z, r)
                a2, b2, c2 = rate(x + half * a1, y + half * b1, z + half * c1, r)
                a3, b3, c3 = rate(x + half * a2, y + half * b2, z + half * c2, r)
                a4, b4, c4 = rate(x + h * a3, y + h * b3, z + h * c3, r)
                x += sixth * (a1 + two * a2 + two * a3 + a4)
                y += sixth * (b1 + two * b2 + two * b3 + b4)
                z += sixth * (c1 + two * c2 + two * c3 + c4)
            u[run, 0], u[run, 1], u[run, 2] = x, y, z

    def ensemble(seed: int) -> np.ndarray:
        u = np.full((runs, 3), START, dtype=kind)
        if case == "brownian":
            brownian(np.random.default_rng(seed), u, kind(GROWTH / steps), kind(VOLATILITY / np.sqrt(steps)))
        else:
            lorenz(u, np.linspace(0, 21, runs).astype(kind), kind(1 / steps))
        return u

    return ensemble


def by_jax(case: str, runs: int, single: bool, _: str) -> Ensemble:
    """All runs in one array, loops over steps by fori_loop."""
    import jax

    jax.config.update("jax_enable_x64", not single)
    import jax.numpy as jnp

    kind, steps = jnp.float32 if single else jnp.float64, STEPS[case]
    h = kind(1 / steps)

    @jax.jit
    def brownian(seed):
        key = jax.random.key(seed)

        def step(k, u):
            dw = jnp.sqrt(h) * jax.random.normal(jax.random.fold_in(key, k), (3, runs), dtype=kind)
            return u + kind(GROWTH) * u * h + kind(VOLATILITY) * u * dw

        return jax.lax.fori_loop(0, steps, step, jnp.full((3, runs), START, dtype=kind)).T

    @jax.jit
    def lorenz(_):
        rayleigh = jnp.linspace(0, 21, runs, dtype=kind)

        def step(_, u):
            k1 = lorenz_rate(u, rayleigh, jnp.stack)
            k2 = lorenz_rate(u + h / 2 * k1, rayleigh, jnp.stack)
            k3 = lorenz_rate(u + h / 2 * k2, rayleigh, jnp.stack)
            k4 = lorenz_rate(u + h * k3, rayleigh, jnp.stack)
            return u + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)

        return jax.lax.fori_loop(0, steps, step, jnp.zeros((3, runs), dtype=kind).at[0].set(1)).T

    simulate = brownian if case == "brownian" else lorenz
    return lambda seed: np.asarray(simulate(seed))


PEERS = {"nsv": by_nsv, "numpy": by_numpy, "numba fastmath": by_numba, "JAX": by_jax}


def main() -> None:
    """Measures what the request names."""
    request = json.loads(sys.argv[1])
    case, runs = request["case"], request["runs"]
    ensemble = PEERS[request["peer"]](case, runs, request["single"], request["library"])
    np.save(request["values"], ensemble(1))
    rates: list[float] = []
    begin = time.process_time()
    while time.process_time() - begin < SECONDS or len(rates) < 3:
        before = time.process_time()
        ensemble(2 + len(rates))
        rates.append(runs * STEPS[case] / (time.process_time() - before))
    print(json.dumps({"rate": [round(rate) for rate in rates]}))


if __name__ == "__main__":
    main()
