"""The workload of a specification: one step of its closed loop as one function of flat arrays.

    in  = [t, x, controller states, design parameters, true parameters, dw]
    out = [next x, next controller states, saturated control]

The controller is the program `control`; the plant is one Euler-Maruyama step x + f dt + G dw of the program `plant` over one sample time.
Both come from the compiler's text form and nothing else.
"""

import re
import subprocess
from dataclasses import dataclass
from pathlib import Path

from graph import Graph, Node
from ir import Program, Shape, read_programs
from scalarise import scalarise

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = ["initial", "control", "plant"]

# Where values lie in a flat array.
Layout = dict[str, tuple[int, Shape]]


@dataclass
class Workload:
    """A closed loop's step as a graph, and where its parts lie in the flat arrays; `noisy` are the channels of each plant state."""

    spec: str
    graph: Graph
    inputs: Layout
    outputs: Layout
    results: list[Node]
    size: int
    dt: float
    sampled_noise: bool
    blocks: int
    initial: Program
    noisy: list[list[int]]

    def slice(self, name: str) -> slice:
        """Where an input lies."""
        at, (rows, columns) = self.inputs[name]
        return slice(at, at + rows * columns)


def compiler(*arguments: str) -> str:
    """What the compiler prints, run at the repository's root."""
    command = ["cargo", "run", "--quiet", "--locked", "--release", "--package", "nsv-codegen", "--bin", "nsv", "--", *arguments]
    return subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True).stdout


def exported(spec: str) -> str:
    """The programs that the compiler makes of a specification before it optimises, as text."""
    shown = ["generate", f"specs/{spec}.yaml", "--emit", "ir", "--stage", "lowered", "--program"]
    return "".join(compiler(*shown, name) for name in PROGRAMS)


def sample_time(spec: str) -> float:
    """Seconds between samples, from the emitted code."""
    text = (ROOT / f"generated/src/{spec}/controller.rs").read_text()
    found = re.search(r"SAMPLE_TIME: f64 = ([^;]*);", text)
    assert found, "the emitted controller has a sample time"
    return float(found[1])


def shape_of(program: Program, output: str) -> Shape:
    """Of an output."""
    return program.statements[program.outputs[output]].shape


def place(names: list[tuple[str, Shape]]) -> tuple[Layout, int]:
    """Where each value lies if one follows another, and the end."""
    layout: Layout = {}
    end = 0
    for name, shape in names:
        layout[name] = (end, shape)
        end += shape[0] * shape[1]
    return layout, end


def workload(spec: str, text: str) -> Workload:
    """The closed loop of a specification, from its programs."""
    found = read_programs(text)
    control, plant = found["control"], found["plant"]
    noise = shape_of(plant, "diffusion")[1] if "diffusion" in plant.outputs else 0
    names = [("t", (1, 1)), ("x", plant.inputs["x"])]
    names += [(name, shape) for name, shape in control.inputs.items() if re.match(r"state\.|params\.", name)]
    names += [(name.replace("params.", "plant."), shape) for name, shape in plant.inputs.items() if name.startswith("params.")]
    inputs, size = place([*names, ("dw", (noise, 1))])
    states = [(name, shape_of(control, name)) for name in control.outputs if name.startswith("next.")]
    outputs, _ = place([("x", plant.inputs["x"]), *states, ("u_sat", shape_of(control, "u_sat"))])

    graph, dt = Graph(), sample_time(spec)
    given = {name: [graph.node("input", at + i) for i in range(rows * cols)] for name, (at, (rows, cols)) in inputs.items()}
    width = control.inputs["x1"][0]
    blocks = {name: given["x"][(int(name[1:]) - 1) * width :][:width] for name in control.inputs if re.fullmatch(r"x\d+", name)}
    law = scalarise(control, graph, given | blocks)
    truth = {name.replace("plant.", "params."): value for name, value in given.items() if name.startswith("plant.")}
    rate = scalarise(plant, graph, truth | {"t": given["t"], "x": given["x"], "u_sat": law["u_sat"]})
    zero, noisy = graph.const(0.0), []
    results = []
    for i, (x, f) in enumerate(zip(given["x"], rate["drift"], strict=True)):
        x = graph.binary("add", x, graph.binary("mul", f, graph.const(dt)))
        row = rate.get("diffusion", [])[i * noise :][:noise]
        noisy.append([j for j, g in enumerate(row) if g != zero])
        for g, w in zip(row, given["dw"], strict=True):
            x = graph.binary("add", x, graph.binary("mul", g, w))
        results.append(x)
    for name, _ in states:
        results += law[name]
    sampled = "noise: wiener" not in (ROOT / f"specs/{spec}.yaml").read_text()
    return Workload(spec, graph, inputs, outputs, results + law["u_sat"], size, dt, sampled, len(blocks), found["initial"], noisy)
