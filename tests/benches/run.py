"""Compares the emitted code with its peers on the same law: `python3 tests/benches/run.py` (about fifteen minutes).

Everything that is needed besides cargo and a C compiler is installed into a virtual environment of its own; clang, g++ and Eigen are used
if they are there. What is missing is named and skipped.
"""

import argparse
import hashlib
import os
import subprocess
import sys
import venv
from pathlib import Path

HERE = Path(__file__).resolve().parent
REQUIREMENTS = HERE / "requirements.txt"
CACHE = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache")) / "nsv"
STAGES = ["step", "ensemble", "public"]
SPECS = ["nsv_attitude", "flexible_joint", "underwater_vehicle"]


def environment() -> Path:
    """The interpreter of the virtual environment for these requirements, which is made if it is not there."""
    digest = hashlib.sha256(REQUIREMENTS.read_bytes()).hexdigest()[:12]
    folder = CACHE / f"benches-{digest}"
    python = folder / "bin/python"
    if not (folder / "complete").exists():
        print(f"installing the peers into {folder}", file=sys.stderr)
        venv.create(folder, with_pip=True)
        for requirement in REQUIREMENTS.read_text().split():
            if subprocess.run([python, "-m", "pip", "install", "--quiet", requirement]).returncode:
                print(f"{requirement} cannot be installed, so it is skipped", file=sys.stderr)
        (folder / "complete").touch()
    return python


def arguments() -> argparse.Namespace:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--specs", nargs="+", default=SPECS, help="specifications under specs/ with a module under generated/")
    parser.add_argument("--stages", nargs="+", default=STAGES, choices=STAGES, help="what to measure")
    parser.add_argument("--peers", nargs="+", help="beginnings of the names of peers; default: all")
    parser.add_argument("--processes", type=int, default=7, help="processes per peer and measurement")
    parser.add_argument("--out", type=Path, default=HERE.parents[1] / "target/benches/results", help="folder of the report")
    return parser.parse_args()


def main() -> None:
    """Runs in the virtual environment."""
    python = environment()
    if Path(sys.prefix) != python.parents[1]:
        os.execv(python, [str(python), __file__, *sys.argv[1:]])
    chosen = arguments()
    import campaign

    campaign.run(chosen)


if __name__ == "__main__":
    main()
