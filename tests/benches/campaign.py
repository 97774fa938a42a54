"""All measurements: each peer in several fresh processes, in shuffled order, on one core, after its results were found equal."""

import argparse
import ctypes
import json
import os
import platform
import random
import re
import shlex
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from datetime import date
from functools import partial
from importlib.metadata import distributions
from pathlib import Path
from typing import Any

import numpy as np

import public_cases
import reference
import report
from build import Missing, compiled
from peers import BASELINE, PEERS, SUBJECT, SUBJECTS
from workload import ROOT, Layout, Workload, exported, workload

HERE = Path(__file__).resolve().parent
BUILD = ROOT / "target/benches"
INPUTS = 16
RUNS, STEPS = 1056, 250
PACKAGES = [line.partition("==")[0] for line in (HERE / "requirements.txt").read_text().split()]
# Each figure's samples in one process.
Samples = dict[str, list[float]]
# Results agree to this, relative to the largest entry of their vector, or to TINY where the whole vector is smaller.
TOLERANCE, TINY = 1e-9, 1e-6


def say(text: str) -> None:
    """Progress goes to standard error."""
    print(text, file=sys.stderr, flush=True)


@dataclass
class Subject:
    """A specification with what its peers built."""

    work: Workload
    folder: Path
    paths: dict[str, Path] = field(default_factory=dict)
    missing: dict[str, str] = field(default_factory=dict)

    def request(self, **more: Any) -> dict[str, Any]:
        """What every measurement is told."""
        shared = {"spec": self.work.spec, "programs": self.folder / "programs.txt", "inputs": self.folder / "inputs.npy"}
        shared |= {"start": self.folder / "start.npy", "results": len(self.work.results), "states": self.work.inputs["x"][1][0]}
        return shared | {"loop": BUILD / "loop/step.so", "harness": BUILD / "ensemble/step.so"} | more


def prepared(spec: str, names: list[str] | None) -> Subject:
    """Exports the law and builds the peers, or those whose names begin with some of `names`; nsv and the baseline always."""
    folder = BUILD / spec
    folder.mkdir(parents=True, exist_ok=True)
    text = exported(spec)
    (folder / "programs.txt").write_text(text)
    subject = Subject(workload(spec, text), folder)
    wanted = (*SUBJECTS, BASELINE, *(names if names is not None else [""]))
    for peer in [peer for peer in PEERS if peer.name.startswith(wanted)]:
        say(f"{spec}: building {peer.name}")
        try:
            built = peer.build(subject.work, folder / re.sub(r"\W+", "_", peer.name))
            subject.paths[peer.name] = built.shared_object
        except Missing as reason:
            subject.missing[peer.name] = str(reason)
            say(f"  skipped: {reason}")
    return subject


def difference(layout: Layout, values: np.ndarray, expected: np.ndarray) -> float:
    """The largest difference of results, relative to the largest entry of their vector."""
    worst = 0.0
    for at, (rows, columns) in layout.values():
        part = slice(at, at + rows * columns)
        scale = max(np.abs(expected[:, part]).max(), TINY)
        worst = max(worst, float(np.abs(values - expected)[:, part].max() / scale))
    return worst


def measured(script: str, request: dict[str, Any]) -> Samples:
    """One measurement in a fresh process on the last core."""
    core = max(os.sched_getaffinity(0))
    command = [sys.executable, HERE / script, json.dumps(request, default=str)]
    done = subprocess.run(command, capture_output=True, text=True, preexec_fn=lambda: os.sched_setaffinity(0, {core}))
    if done.returncode:
        raise RuntimeError(f"{request}\n{done.stderr[-3000:]}")
    return json.loads(done.stdout.splitlines()[-1])


Measure = Callable[[str], tuple[Samples, float]]


def trials(title: str, kinds: dict[str, str], measure: Measure, processes: int) -> dict[str, Any]:
    """Figures and largest difference of each label, from several processes in shuffled order; JAX has three, since it compiles in each."""
    found: dict[str, list[Samples]] = {label: [] for label in kinds}
    worst = dict.fromkeys(kinds, 0.0)
    for trial in range(processes):
        say(f"{title}: process {trial + 1} of {processes} of each peer")
        for label in random.sample(sorted(kinds), len(kinds)):
            if kinds[label] == "jax" and trial >= 3:
                continue
            figures, error = measure(label)
            assert error < TOLERANCE, f"{label} differs from the reference by {error}"
            worst[label] = max(worst[label], error)
            found[label].append(figures)
    return {label: report.summary(figures) | {"error": worst[label]} for label, figures in found.items()}


def steps(subject: Subject, processes: int) -> dict[str, Any]:
    """Single steps of a closed loop."""
    work = subject.work
    inputs, expected = reference.record(work, subject.paths[SUBJECT], INPUTS)
    np.save(subject.folder / "inputs.npy", inputs)
    kinds = {peer.name: peer.step for peer in PEERS if peer.step and peer.name in subject.paths}
    values = subject.folder / "values.npy"

    def measure(name: str) -> tuple[Samples, float]:
        figures = measured("measure.py", subject.request(kind=kinds[name], path=subject.paths[name], values=values))
        return figures, difference(work.outputs, np.load(values), expected)

    return {
        "operations": work.graph.operations(work.results),
        "inputs": work.size,
        "results": len(work.results),
        "missing": subject.missing,
        "peers": trials(f"{work.spec}, steps", kinds, measure, processes),
    }


def ensembles(subject: Subject, processes: int) -> dict[str, Any]:
    """Ensembles of a closed loop with noise."""
    work = subject.work
    start = reference.start(work, subject.paths[SUBJECT])
    np.save(subject.folder / "start.npy", start)
    quiet = np.array([reference.simulate(work, start, STEPS)])
    paths = {label: subject.paths[peer.name] for peer in PEERS if peer.name in subject.paths for label in peer.ensembles}
    kinds = {label: kind for peer in PEERS for label, kind in peer.ensembles.items() if label in paths}
    kinds = {label: kind for label, kind in kinds.items() if not kind.startswith("nsv") or int(kind.split()[1]) <= lanes()}
    values, scale = subject.folder / "values.npz", reference.noise_scale(work)
    shape = {"x": (0, work.inputs["x"][1])}
    spread: dict[str, np.ndarray] = {}

    def measure(label: str) -> tuple[Samples, float]:
        request = subject.request(kind=kinds[label], path=paths[label], values=values, runs=RUNS, steps=STEPS, scale=scale)
        figures, found = measured("measure_ensemble.py", request), np.load(values)
        spread[label] = np.array([found["noisy"].mean(axis=0), found["noisy"].std(axis=0)])
        return figures, difference(shape, found["quiet"], np.broadcast_to(quiet, found["quiet"].shape))

    peers = trials(f"{work.spec}, ensembles", kinds, measure, processes)
    check_spread(spread)
    return {"runs": RUNS, "steps": STEPS, "missing": subject.missing, "peers": peers}


def check_spread(spread: dict[str, np.ndarray]) -> None:
    """Means and deviations of the final states agree between peers to what chance allows: six standard errors."""
    expected = spread[BASELINE]
    for label, (mean, deviation) in spread.items():
        error = 6.0 * expected[1] / np.sqrt(RUNS) + 1e-9
        assert (np.abs(mean - expected[0]) < 1.5 * error).all(), f"{label}: means of final states"
        assert (np.abs(deviation - expected[1]) < error).all(), f"{label}: deviations of final states"


def lanes() -> int:
    """Lanes of f64 of this processor."""
    flags = Path("/proc/cpuinfo").read_text()
    return 8 if "avx512dq" in flags else 4 if "avx2" in flags else 2


def peak(library: Path) -> str:
    """The most arithmetic of each width that this processor does, by the loop of measure.c."""
    code = ctypes.CDLL(str(library))
    code.peak.restype = ctypes.c_double
    widths = [width for width in (2, 4, 8) if width <= lanes()]
    return ", ".join(f"{code.peak(width):.2f} in {64 * width} bits" for width in widths)


def version(*command: str) -> str:
    """First line of what a tool says of itself."""
    try:
        return subprocess.run(command, capture_output=True, text=True).stdout.splitlines()[0]
    except (FileNotFoundError, IndexError):
        return "not installed"


def origin(loop: Path) -> dict[str, str]:
    """What the figures depend on, and the command that gives them."""
    model = [line.partition(": ")[2] for line in Path("/proc/cpuinfo").read_text().splitlines() if line.startswith("model name")]
    tools = {tool: version(tool, "--version") for tool in ("rustc", "gcc", "g++", "clang")}
    packages = [f"{found.metadata['Name']} {found.version}" for found in distributions() if found.metadata["Name"] in PACKAGES]
    return {
        "date": str(date.today()),
        "command": shlex.join(["python3", "tests/benches/run.py", *sys.argv[1:]]),
        "revision": version("git", "-C", str(ROOT), "describe", "--always", "--dirty"),
        "processor": model[0],
        "cores": f"{os.cpu_count()}; {os.getloadavg()[0]:.1f} processes ran in the minute before the measurements",
        "sums and products a cycle": peak(loop),
        "system": f"{platform.system()} {platform.release()}",
        **tools,
        "Python": ", ".join([platform.python_version(), *sorted(packages)]),
    }


def run(chosen: argparse.Namespace) -> None:
    """Measures and reports."""
    loop = compiled(BUILD / "loop", (HERE / "measure.c").read_text(), "step.c", ["gcc", "-O2"])
    compiled(BUILD / "ensemble", (HERE / "ensemble.c").read_text(), "step.c", ["gcc", "-O3", "-march=native"])
    laws = {"step", "ensemble"} & set(chosen.stages)
    subjects = {spec: prepared(spec, chosen.peers) for spec in chosen.specs if laws}
    result: dict[str, Any] = {"origin": origin(loop)}
    if "step" in chosen.stages:
        result["step"] = {spec: steps(subject, chosen.processes) for spec, subject in subjects.items()}
    if "ensemble" in chosen.stages:
        result["ensemble"] = {spec: ensembles(subject, chosen.processes) for spec, subject in subjects.items()}
    if "public" in chosen.stages:
        count = partial(trials, processes=chosen.processes)
        result["public"] = public_cases.measure_all(BUILD / "public", count, measured)
    chosen.out.mkdir(parents=True, exist_ok=True)
    report.write(result, chosen.out)
    say(f"written to {chosen.out}")
