"""The figures as JSON, as Markdown tables, and as a plot."""

import json
import re
from collections.abc import Callable
from pathlib import Path
from statistics import median
from typing import Any

from peers import BASELINE, PEERS, SUBJECT, SUBJECTS, WIDTHS


STEP_TEXT = [
    "Core cycles per call: medians over processes in shuffled order, each the median of 60 batches of 400 calls on 16 states of a real",
    "closed loop. Before every 80 calls the inputs are restored, for every peer alike and outside the timed part. Cold calls come after an",
    "eviction of the first two levels of cache. Differences are from the law in Python.",
    "",
    "nsv's step is what a user runs: it advances the states in place, and what depends on parameters alone was computed once, before the",
    "calls, as its controller does when it is made. The peers' functions are as their tools emit them: parameters are inputs that they",
    "compute with in every call, and results go to separate arrays. What depends on time is computed in every call by all.",
]


def summary(trials: list[dict[str, list[float]]]) -> dict[str, Any]:
    """Of each figure: median and range over processes, each by the median of its samples; and the samples of each process."""
    found: dict[str, Any] = {"processes": len(trials)}
    for name in trials[0]:
        samples = [trial[name] for trial in trials]
        values = sorted(map(median, samples))
        found[name] = {"median": median(values), "least": values[0], "most": values[-1], "samples": samples}
    return found


def number(value: float) -> str:
    """Three digits that count."""
    return f"{value:.3g}" if value < 1000 else f"{value:,.0f}"


def table(heads: list[str], rows: list[list[str]]) -> list[str]:
    """A table in Markdown, and an empty line."""
    lines = [heads, ["---"] * len(heads), *rows]
    return ["| " + " | ".join(line) + " |" for line in lines] + [""]


def step_table(found: dict[str, Any]) -> list[str]:
    """One table of single steps."""
    peers = found["peers"]
    subjects = [name for name in SUBJECTS if name in peers]
    lines = [f"{found['inputs']} inputs, {found['results']} results, {sum(found['operations'].values())} scalar operations.", ""]
    rows = []
    for name, figures in sorted(peers.items(), key=lambda item: item[1]["warm"]["median"]):
        warm = figures["warm"]
        factors = [f"{warm['median'] / peers[subject]['warm']['median']:.2f}" for subject in subjects]
        cold = number(figures["cold"]["median"]) if "cold" in figures else ""
        rows.append(
            [name, number(warm["median"]), f"{number(warm['least'])} to {number(warm['most'])}", *factors, cold, f"{figures['error']:.0e}"]
        )
    heads = ["", "cycles", "range", *(f"time, {subject} = 1" for subject in subjects), "cold call, cycles", "largest difference"]
    return lines + table(heads, rows) + missing(found)


def ensemble_table(found: dict[str, Any]) -> list[str]:
    """One table of ensembles; of the emitted code the fastest width of each arithmetic is compared."""
    peers = found["peers"]
    rate_of: Callable[[str], float] = lambda label: peers[label]["rate"]["median"]
    widths = [[f"{name}, {width}" for width in WIDTHS if f"{name}, {width}" in peers] for name in SUBJECTS]
    subjects = [max(labels, key=rate_of) for labels in widths if labels]
    rows = []
    for name in sorted(peers, key=rate_of, reverse=True):
        rate = peers[name]["rate"]
        factors = [f"{rate_of(subject) / rate['median']:.2f}" for subject in subjects]
        spread = f"{number(rate['least'] / 1e6)} to {number(rate['most'] / 1e6)}"
        rows.append([name, number(rate["median"] / 1e6), spread, *factors, f"{peers[name]['error']:.0e}"])
    heads = ["", "million steps per second", "range", *(f"time, {subject} = 1" for subject in subjects), "largest difference"]
    return table(heads, rows) + missing(found)


def missing(found: dict[str, Any]) -> list[str]:
    """What is not compared, and why."""
    return [line for name, reason in found["missing"].items() for line in (f"{name} is skipped: {reason}.", "")]


def public_table(found: dict[str, Any]) -> list[str]:
    """One table of a public case."""
    peers = found["peers"]
    subject = peers[SUBJECT]["rate"]["median"]
    rows = []
    for name, figures in sorted(peers.items(), key=lambda item: -item[1]["rate"]["median"]):
        rate = figures["rate"]
        spread = f"{number(rate['least'] / 1e6)} to {number(rate['most'] / 1e6)}"
        rows.append([name, number(rate["median"] / 1e6), spread, f"{subject / rate['median']:.2f}"])
    return table(["", "million steps per second", "range", "time, nsv = 1"], rows)


def markdown(result: dict[str, Any]) -> str:
    """All tables."""
    lines = ["# nsv and its peers on the same law", ""]
    lines += table(["", ""], [[name, f"`{value}`" if name == "command" else value] for name, value in result["origin"].items()])
    if "step" in result:
        lines += [
            "## One closed-loop step: controller and one Euler-Maruyama step of the plant, f64, one core",
            "",
            *STEP_TEXT,
            "",
        ]
        for spec, found in result["step"].items():
            lines += [f"### {spec}", "", *step_table(found)]
    if "ensemble" in result:
        lines += [
            "## Ensembles of closed loops with noise, f64, one core",
            "",
            "Millions of steps (controller and plant) per second of the process's own time. Each peer draws its own normal noise.",
            "Differences are those of runs without noise from the law in Python; with noise, means and deviations agree within chance.",
            "nsv computes what depends on parameters alone once for a controller and once for a plant, and what depends on time alone for as",
            "many steps at once as there are lanes, as its simulator does.",
            "",
        ]
        for spec, found in result["ensemble"].items():
            lines += [f"### {spec}: {found['runs']} runs of {found['steps']} steps", "", *ensemble_table(found)]
    if "public" in result:
        lines += [
            "## Public cases: ensembles by nsv's runtime and by numpy, numba and JAX, one core",
            "",
            "Millions of steps per second of the process's own time. Geometric Brownian motion of three states in 256 Euler-Maruyama steps",
            "(DiffEqGPU's SDE ensemble); the Lorenz equations in 1000 fourth-order Runge-Kutta steps. Final states agree: as distributions",
            "within chance, or as numbers.",
            "",
        ]
        for case, found in result["public"].items():
            lines += [f"### {case}: {found['runs']} runs", "", *public_table(found)]
    lines += ["## Peers", ""] + [f"- {peer.name}: {peer.note}." for peer in PEERS if peer.note] + [""]
    return "\n".join(lines)


def plot(result: dict[str, Any], path: Path) -> None:
    """Bars of speed against the baseline, one panel per specification."""
    try:
        import matplotlib
    except ImportError:
        return
    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "nsv"
    from matplotlib import pyplot

    panels = [(f"{spec}: one step", found["peers"], "warm", 1) for spec, found in result.get("step", {}).items()]
    panels += [(f"{spec}: ensemble", found["peers"], "rate", -1) for spec, found in result.get("ensemble", {}).items()]
    if not panels:
        return
    columns = min(3, len(panels))
    rows = -(-len(panels) // columns)
    figure, axes = pyplot.subplots(rows, columns, figsize=(5 * columns, 3.4 * rows), squeeze=False, layout="constrained")
    for axis, (title, peers, key, sign) in zip(axes.flat, panels, strict=False):
        base = peers[BASELINE][key]["median"]
        bars = sorted((name, (base / figures[key]["median"]) ** sign) for name, figures in peers.items())
        bars.sort(key=lambda bar: bar[1])
        names, speeds = zip(*bars, strict=True)
        axis.barh(names, speeds, color=["tab:red" if name.startswith(SUBJECT) else "tab:gray" for name in names])
        axis.set_title(title)
        axis.set_xlabel(f"speed, {BASELINE} = 1")
    figure.savefig(path, metadata={"Date": None})


def write(result: dict[str, Any], folder: Path) -> None:
    """All three."""
    text = re.sub(r"\[[-+\d.e,\s]*\]", lambda found: re.sub(r"\s+", " ", found[0]), json.dumps(result, indent=1))
    (folder / "benchmarks.json").write_text(text + "\n")
    (folder / "benchmarks.md").write_text(markdown(result))
    plot(result, folder / "benchmarks.svg")
