"""JAX on the CPU: the law by jit; ensembles by vmap over trajectories and scan over steps."""

from importlib.util import find_spec
from pathlib import Path

from build import Built, Missing
from workload import Workload


def law(work: Workload):
    """The step as a traceable function of one flat input."""
    import jax

    jax.config.update("jax_enable_x64", True)
    import jax.numpy as jnp

    names = {"ln": "log", "neg": "negative", "min": "minimum", "max": "maximum", "sub": "subtract", "mul": "multiply", "div": "divide"}
    names |= {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "atan2": "arctan2", "select": "where", "pow": "power"}
    names |= {"lt": "less", "le": "less_equal", "gt": "greater", "ge": "greater_equal", "eq": "equal", "ne": "not_equal"}
    names |= {name: f"logical_{name}" for name in ("and", "or", "not")}
    names |= {name: name for name in "add abs sign sqrt exp sin cos tan sinh cosh tanh".split()}
    functions = {name: getattr(jnp, theirs) for name, theirs in names.items()}

    def step(x):
        return jnp.stack(work.graph.evaluate(work.results, [x[i] for i in range(work.size)], functions))

    return step


def ensemble(work: Workload, runs: int, steps: int):
    """Final plant states of a start, a seed and a scale of the noise: vmap over runs, scan over steps."""
    step = law(work)
    import jax
    import jax.numpy as jnp

    carried, (noise, (channels, _)), states = work.outputs["u_sat"][0], work.inputs["dw"], work.inputs["x"][1][0]

    @jax.jit
    def simulate(start, seed, scale):
        key, constants = jax.random.key(seed), start[1 + carried : noise]

        def advance(carry, k):
            dw = scale * jax.random.normal(jax.random.fold_in(key, k), (runs, channels))
            one = lambda values, w: step(jnp.concatenate([jnp.array([k * work.dt]), values, constants, w]))[:carried]
            return jax.vmap(one)(carry, dw), None

        first = jnp.broadcast_to(start[1 : 1 + carried], (runs, carried))
        return jax.lax.scan(advance, first, jnp.arange(steps))[0][:, :states]

    return simulate


def build(work: Workload, folder: Path) -> Built:
    """It is compiled where it is measured."""
    if find_spec("jax") is None:
        raise Missing("jax is not installed")
    return Built(folder)
