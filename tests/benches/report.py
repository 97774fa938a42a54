"""The figures as JSON, as Markdown tables, and as a plot."""

import json
from pathlib import Path
from statistics import median
from typing import Any

from peers import BASELINE, FASTEST, PEERS, SUBJECT


def summary(trials: list[dict[str, float]]) -> dict[str, Any]:
    """Median and range over processes of each figure."""
    names = [name for name in trials[0] if name != "cycles_per_tick"]
    found: dict[str, Any] = {"processes": len(trials)}
    for name in names:
        values = sorted(trial[name] for trial in trials)
        found[name] = {"median": median(values), "least": values[0], "most": values[-1]}
    return found


def number(value: float) -> str:
    """Three digits that count."""
    return f"{value:.3g}" if value < 1000 else f"{value:,.0f}"


def step_table(found: dict[str, Any]) -> list[str]:
    """One table of single steps."""
    peers = found["peers"]
    base = peers.get(BASELINE)
    lines = [
        f"{found['inputs']} inputs, {found['results']} results, {sum(found['operations'].values())} scalar operations.",
        "",
        f"| | cycles | range | speed against {BASELINE} | nsv is faster by | cold call, cycles | largest difference |",
        "|---|---|---|---|---|---|---|",
    ]
    for name, figures in sorted(peers.items(), key=lambda item: item[1]["warm"]["median"]):
        warm = figures["warm"]
        speed = f"{base['warm']['median'] / warm['median']:.2f}" if base else ""
        factor = f"{warm['median'] / peers[SUBJECT]['warm']['median']:.2f}"
        cold = number(figures["cold"]["median"]) if "cold" in figures else ""
        spread = f"{number(warm['least'])} to {number(warm['most'])}"
        lines.append(f"| {name} | {number(warm['median'])} | {spread} | {speed} | {factor} | {cold} | {figures['error']:.0e} |")
    return lines + [""] + [f"{name} is skipped: {reason}." for name, reason in found["missing"].items()] + [""]


def ensemble_table(found: dict[str, Any]) -> list[str]:
    """One table of ensembles."""
    peers = found["peers"]
    base, best = (peers[label]["rate"]["median"] if label in peers else None for label in (BASELINE, FASTEST))
    lines = [
        f"| | million steps per second | range | speed against {BASELINE} | {FASTEST}, is faster by | largest difference |",
        "|---|---|---|---|---|---|",
    ]
    for name, figures in sorted(peers.items(), key=lambda item: -item[1]["rate"]["median"]):
        rate = figures["rate"]
        speed = f"{rate['median'] / base:.2f}" if base else ""
        factor = f"{best / rate['median']:.2f}" if best else ""
        spread = f"{number(rate['least'] / 1e6)} to {number(rate['most'] / 1e6)}"
        lines.append(f"| {name} | {number(rate['median'] / 1e6)} | {spread} | {speed} | {factor} | {figures['error']:.0e} |")
    return lines + [""]


def public_table(found: dict[str, Any]) -> list[str]:
    """One table of a public case."""
    peers = found["peers"]
    subject = peers[SUBJECT]["rate"]["median"]
    lines = ["| | million steps per second | range | nsv is faster by |", "|---|---|---|---|"]
    for name, figures in sorted(peers.items(), key=lambda item: -item[1]["rate"]["median"]):
        rate = figures["rate"]
        spread = f"{number(rate['least'] / 1e6)} to {number(rate['most'] / 1e6)}"
        lines.append(f"| {name} | {number(rate['median'] / 1e6)} | {spread} | {subject / rate['median']:.2f} |")
    return lines + [""]


def markdown(result: dict[str, Any]) -> str:
    """All tables."""
    lines = ["# nsv and its peers on the same law", "", ", ".join(f"{name} {value}" for name, value in result["machine"].items()), ""]
    if "step" in result:
        lines += [
            "## One closed-loop step: controller and one Euler-Maruyama step of the plant, f64, one core",
            "",
            "Core cycles per call: medians over processes in shuffled order, each the median of 60 batches of 400 calls on 16 states of a",
            "real closed loop. Cold calls come after an eviction of the first two levels of cache. Differences are from the law in Python.",
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
    (folder / "benchmarks.json").write_text(json.dumps(result, indent=1) + "\n")
    (folder / "benchmarks.md").write_text(markdown(result))
    plot(result, folder / "benchmarks.svg")
