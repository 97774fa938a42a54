"""All measurements: each peer in several fresh processes, in shuffled order, on one core, after its results were found equal."""

import argparse
import json
import os
import platform
import random
import subprocess
import sys
from datetime import date
from pathlib import Path
from typing import Any

import numpy as np

import reference
import report
from build import Missing, compiled
from peers import STEP, Peer
from workload import ROOT, Workload, exported, workload

HERE = Path(__file__).resolve().parent
BUILD = ROOT / "target/benches"
INPUTS = 16
# Results agree to this, relative to the largest entry of their vector, or to TINY where the whole vector is smaller.
TOLERANCE, TINY = 1e-9, 1e-6


def say(text: str) -> None:
    """Progress goes to standard error."""
    print(text, file=sys.stderr, flush=True)


def build(peers: list[Peer], work: Workload, folder: Path) -> tuple[dict[str, Path], dict[str, str]]:
    """What each peer built, and why others are missing."""
    paths, missing = {}, {}
    for peer in peers:
        say(f"{work.spec}: building {peer.name}")
        try:
            paths[peer.name] = peer.build(work, folder / peer.name.replace(" ", "_").replace(",", "")).library
        except Missing as reason:
            missing[peer.name] = str(reason)
            say(f"  skipped: {reason}")
    return paths, missing


def difference(work: Workload, values: np.ndarray, expected: np.ndarray) -> float:
    """The largest difference of results, relative to the largest entry of their vector."""
    worst = 0.0
    for at, (rows, columns) in work.outputs.values():
        part = slice(at, at + rows * columns)
        scale = max(np.abs(expected[:, part]).max(), TINY)
        worst = max(worst, float(np.abs(values - expected)[:, part].max() / scale))
    return worst


def measured(request: dict[str, Any]) -> dict[str, float]:
    """One measurement in a fresh process on the last core."""
    core = max(os.sched_getaffinity(0))
    command = [sys.executable, HERE / "measure.py", json.dumps(request, default=str)]
    done = subprocess.run(command, capture_output=True, text=True, preexec_fn=lambda: os.sched_setaffinity(0, {core}))
    if done.returncode:
        raise RuntimeError(f"{request}\n{done.stderr[-3000:]}")
    return json.loads(done.stdout.splitlines()[-1])


def steps(spec: str, processes: int) -> dict[str, Any]:
    """Single steps of a specification's closed loop."""
    folder = BUILD / spec
    folder.mkdir(parents=True, exist_ok=True)
    text = exported(spec)
    (folder / "programs.txt").write_text(text)
    work = workload(spec, text)
    paths, missing = build(STEP, work, folder)
    inputs, expected = reference.record(work, paths["nsv"], INPUTS)
    np.save(folder / "inputs.npy", inputs)
    request = {"spec": spec, "inputs": folder / "inputs.npy", "values": folder / "values.npy", "results": len(work.results)}
    request |= {"programs": folder / "programs.txt", "loop": BUILD / "loop/step.so"}
    kinds = {peer.name: peer.loop for peer in STEP}
    found: dict[str, list[dict[str, float]]] = {name: [] for name in paths}
    worst: dict[str, float] = {}
    for trial in range(processes):
        for name in random.sample(sorted(paths), len(paths)):
            say(f"{spec}: process {trial + 1} of {processes}: {name}")
            if kinds[name] == "jax" and trial > 2:
                continue
            figures = measured(request | {"kind": kinds[name], "path": paths[name]})
            error = difference(work, np.load(folder / "values.npy"), expected)
            assert error < TOLERANCE, f"{name} differs from the reference by {error}"
            worst[name] = max(worst.get(name, 0.0), error)
            found[name].append(figures)
    return {
        "operations": work.graph.operations(work.results),
        "inputs": work.size,
        "results": len(work.results),
        "missing": missing,
        "peers": {name: report.summary(trials) | {"error": worst[name]} for name, trials in found.items()},
    }


def version(*command: str) -> str:
    """First line of what a tool says of itself."""
    try:
        return subprocess.run(command, capture_output=True, text=True).stdout.splitlines()[0]
    except (FileNotFoundError, IndexError):
        return "not installed"


def machine() -> dict[str, str]:
    """What the figures depend on."""
    model = [line.partition(": ")[2] for line in Path("/proc/cpuinfo").read_text().splitlines() if line.startswith("model name")]
    tools = {tool: version(tool, "--version") for tool in ("gcc", "clang", "rustc")}
    return {"processor": model[0], "cores": str(os.cpu_count()), "python": platform.python_version(), "date": str(date.today())} | tools


def run(chosen: argparse.Namespace) -> None:
    """Measures and reports."""
    compiled(BUILD / "loop", (HERE / "measure.c").read_text(), "step.c", ["gcc", "-O2"])
    result: dict[str, Any] = {"machine": machine()}
    if "step" in chosen.stages:
        result["step"] = {spec: steps(spec, chosen.processes) for spec in chosen.specs}
    chosen.out.mkdir(parents=True, exist_ok=True)
    report.write(result, chosen.out)
    say(f"written to {chosen.out}")
