"""Flies every specification of the library 100 times and writes the table of README.md and the figures in this folder.

Run from anywhere: `python3 docs/library/regenerate.py [SPEC ..]` (two minutes; needs cargo, a release build of nsv is made). The same
specifications give the same bytes: `--check` writes nothing and fails if a file would change. The table is always of all.
"""

import html
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
README = HERE / "README.md"
RUNS = 100
TABLE = re.compile(r"(?<=<!-- table -->\n).*?(?=<!-- end -->)", re.DOTALL)
# Plots of the report that make a specification's figure, by their figure there: tracking, errors, inputs, and all runs together.
FIGURES = {5: 6, 6: 2, 7: 6, 10: 6, 9: 1}
WIDTH, HEIGHT, GAP = 480, 250, 10


def nsv(*arguments: object) -> str:
    """Standard output of the compiler."""
    command = ["cargo", "run", "--quiet", "--release", "--package", "nsv-codegen", "--bin", "nsv", "--", *map(str, arguments)]
    return subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True).stdout


def number(value: float) -> str:
    """Three digits."""
    return f"{value:.3g}"


def row(name: str, result: dict) -> str:
    """One line of the table."""
    if result["ratio"] is None:
        held = ["no constraint"] + ["-"] * 4
    else:
        ratio = result["ratio"]
        low, high = (100 * limit for limit in result["violated_interval95"])
        held = [f"{result['violations']} of {result['runs']} ({number(low)} to {number(high)} %)"]
        largest = [ratio["median"], ratio["p99"], ratio["max"], result["settled_ratio"]["max"]]
        held += ["lost" if value is None else number(value) for value in largest]
    rms = ", ".join(f"{state} {number(value)}" for state, value in result["rms_tracking"].items())
    most = max(result["saturated_fraction"].values())
    cells = [f"[{name}]({name}.md)", *held, str(result["nonfinite"]), rms, f"{number(100 * most)} %"]
    return "| " + " | ".join(cells) + " |\n"


def table(results: dict[str, dict]) -> str:
    """Statistics of all specifications."""
    head = ["specification", "violated (95 % interval)", "median", "99 %", "max", "settled", "lost", "rms error", "at the limit"]
    lines = ["| " + " | ".join(head) + " |\n", "|" + "---|" * len(head) + "\n"]
    return "".join(lines + [row(name, result) for name, result in results.items()])


def plots(report: str) -> list[str]:
    """The chosen plots of a report, each an `svg` element with none of the entities that HTML alone has."""
    chosen = []
    for figure, most in FIGURES.items():
        found = re.search(rf'<figure id="figure-{figure}">.*?</figure>', report, re.DOTALL)
        chosen += re.findall(r"<svg.*?</svg>", found[0], re.DOTALL)[:most] if found else []
    return [re.sub(r"&(?!(?:amp|lt|gt|quot|#\d+);)\w+;", lambda entity: html.unescape(entity[0]), plot) for plot in chosen]


def figure(report: str) -> str:
    """The chosen plots in two columns, with the report's colours."""
    style = re.search(r"<style>(.*?)</style>", report, re.DOTALL)[1]
    colours = style[style.index(":root") : style.index("* { box-sizing")]
    marks = style[style.index("svg text") :]
    placed = []
    for index, plot in enumerate(plots(report)):
        x, y = index % 2 * (WIDTH + GAP), index // 2 * (HEIGHT + GAP)
        place = f'<svg x="{x}" y="{y}" width="{WIDTH}" height="{HEIGHT}" '
        placed.append(plot.replace("<svg ", place, 1))
    rows = (len(placed) + 1) // 2
    size = (2 * WIDTH + GAP, rows * (HEIGHT + GAP) - GAP)
    head = f'<svg xmlns="http://www.w3.org/2000/svg" width="{size[0]}" height="{size[1]}" viewBox="0 0 {size[0]} {size[1]}">\n'
    ground = '<rect width="100%" height="100%" style="fill: var(--card)"/>\n'
    return head + f"<style>{colours}{marks}</style>\n" + ground + "\n".join(placed) + "\n</svg>\n"


def fly(spec: Path) -> tuple[dict, str]:
    """Statistics and report."""
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.html"
        result = nsv("simulate", spec, "--runs", RUNS, "--seed", 1, "--format", "json", "--report", report)
        return json.loads(result), report.read_text()


def main() -> int:
    """Writes or compares; gives the exit code."""
    check, named = "--check" in sys.argv, [name for name in sys.argv[1:] if name != "--check"]
    results, files = {}, {}
    for spec in sorted((ROOT / "specs").glob("*.yaml")):
        results[spec.stem], report = fly(spec)
        if not named or spec.stem in named:
            files[HERE / f"{spec.stem}.svg"] = figure(report)
    files[README] = TABLE.sub(lambda _: table(results), README.read_text())
    stale = [path for path, text in files.items() if not path.exists() or path.read_text() != text]
    for path in stale:
        print(("stale: " if check else "written: ") + str(path.relative_to(ROOT)))
        if not check:
            path.write_text(files[path])
    return 1 if check and stale else 0


if __name__ == "__main__":
    sys.exit(main())
