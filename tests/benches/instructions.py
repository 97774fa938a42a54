"""Guards the emitted code against regressions by its number of instructions, which does not depend on the load of the machine.

Also fails if an intrinsic of the lanes is a function of its own in that program. Then some part of a computation was not inlined where its
instructions are enabled, such as a closure with two calls, and every operation in it is a call.

Run: `python3 tests/benches/instructions.py` (a minute; needs cargo and valgrind). It fails if a sample of some closed loop has more
instructions than the committed baseline by more than three percent. After a change that is meant: `.. instructions.py --bless`.

Counted are one controller step and one plant step of the module's own scheme with noise, in scalars and in four lanes (AVX2), compiled
for the baseline of the architecture. Counts depend on the compiler, so another rustc than that of the baseline skips the comparison.
"""

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
CRATE = HERE / "instructions"
TARGET = HERE.parents[1] / "target/benches/instructions"
BASELINE = HERE / "instructions.json"
LIMIT = 0.03
LANES = {"scalar": 1, "four lanes": 4}
# The difference of two runs is that of their samples alone.
SHORT, LONG = 50, 250


def output(*command: object, **options: object) -> subprocess.CompletedProcess:
    """Of a command that must succeed."""
    return subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True, **options)


def build() -> Path:
    """The workload, with the flags of a release and none for this processor."""
    options = ["--quiet", "--release", "--config", "build.rustflags=[]", "--target-dir", TARGET]
    subprocess.run(["cargo", "build", *options], cwd=CRATE, check=True)
    return TARGET / "release/nsv-instructions"


def not_inlined(program: Path) -> list[str]:
    """Intrinsics of numbers in lanes that are functions."""
    if shutil.which("nm") is None:
        print("not checked whether everything in lanes is inlined: nm is not installed (apt-get install binutils)")
        return []
    return sorted(set(re.findall(r"core_arch\S*::(_mm\w+)", output("nm", "--demangle", program).stdout)))


def executed(program: Path, module: str, lanes: int, samples: int) -> int:
    """Instructions of a run."""
    counter = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null"]
    found = re.search(r"Collected : (\d+)", output(*counter, program, module, lanes, samples).stderr)
    assert found, "callgrind tells the number of instructions"
    return int(found[1])


def counts(program: Path) -> dict[str, dict[str, int]]:
    """Instructions per sample of every generated module."""

    def per_sample(module: str, lanes: int) -> int:
        return (executed(program, module, lanes, LONG) - executed(program, module, lanes, SHORT)) // (LONG - SHORT)

    modules = output(program).stdout.split()
    return {module: {name: per_sample(module, lanes) for name, lanes in LANES.items()} for module in modules}


def regressions(baseline: dict[str, dict[str, int]], found: dict[str, dict[str, int]]) -> list[str]:
    """Prints all changes; gives those that are too large, and modules without a baseline."""
    bad = []
    for module, kinds in found.items():
        for kind, count in kinds.items():
            before = baseline.get(module, {}).get(kind)
            change = "new" if before is None else f"{count / before - 1:+.1%}"
            line = f"{module}, {kind}: {count} instructions per sample, {change}"
            print(line)
            if before is None or count > before * (1 + LIMIT):
                bad.append(line)
    return bad


def main() -> int:
    """Exit status 1 on a regression."""
    rustc = output("rustc", "--version").stdout.strip()
    baseline = json.loads(BASELINE.read_text()) if BASELINE.exists() else {"rustc": rustc, "instructions": {}}
    bless = "--bless" in sys.argv[1:]
    if not bless and baseline["rustc"] != rustc:
        print(f"skipped: the baseline is that of {baseline['rustc']}, this is {rustc}")
        return 0
    if shutil.which("valgrind") is None:
        print("skipped: valgrind is not installed (apt-get install valgrind)")
        return 0
    program = build()
    if outside := not_inlined(program):
        print("functions instead of instructions:", ", ".join(outside))
        return 1
    found = counts(program)
    bad = regressions(baseline["instructions"], found)
    if bless:
        BASELINE.write_text(json.dumps({"rustc": rustc, "instructions": found}, indent=1) + "\n")
        return 0
    if bad:
        print(f"more than {LIMIT:.0%} above the baseline, or without one; `{sys.executable} {Path(__file__).name} --bless` accepts it:")
        print("\n".join(bad))
    return int(bool(bad))


if __name__ == "__main__":
    sys.exit(main())
