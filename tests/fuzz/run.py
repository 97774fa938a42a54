"""Fuzzes every target for a share of a time, one process at a time, and prints a table of what was done.

    cargo install cargo-fuzz
    python3 tests/fuzz/run.py --seconds 3600            # fails at the first crash, hang above a second, or 1 GB of memory
    python3 tests/fuzz/run.py --seconds 0 --minimise    # writes what the runs found, made small, to the committed corpus

Found inputs collect in target/fuzz-corpus; a crash lies in tests/fuzz/artifacts. Put it into corpus/<target> with a name once it is mended:
`cargo test -p nsv-codegen --test corpus` replays that folder.
"""
import argparse
import os
import re
import resource
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
# Share of the time, longest input in bytes.
TARGETS = {
    "yaml": (15, 4096), "spec": (30, 12288), "expression": (20, 512), "unit": (5, 128), "table": (12, 4096), "export": (13, 8192),
    "program": (5, 4096),
}
# A second on a busy machine need not be a second of work: what took long is judged again by its processor time.
LIMITS = ["-timeout=60", "-report_slow_units=1", "-rss_limit_mb=1024", "-malloc_limit_mb=512"]
# Most committed inputs of one target, and their largest size in bytes.
FILES, LARGEST = 150, 6000


def build():
    command = ["cargo", "fuzz", "build", "--sanitizer", "none", "--fuzz-dir", str(HERE)]
    subprocess.run(command, cwd=HERE, check=True)


def binary(target):
    folder = Path(os.environ.get("CARGO_TARGET_DIR", HERE / "target"))
    return next(folder.glob(f"*/release/{target}"))


def found(target):
    folder = ROOT / "target/fuzz-corpus" / target
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def fuzz(target, seconds, longest):
    artifacts = HERE / "artifacts" / target
    artifacts.mkdir(parents=True, exist_ok=True)
    command = ["nice", "-n", "19", str(binary(target)), str(found(target)), str(HERE / "corpus" / target), f"-max_total_time={seconds}",
               f"-max_len={longest}", f"-dict={HERE / 'words.dict'}", f"-artifact_prefix={artifacts}/", "-print_final_stats=1", *LIMITS]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    processor = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    stat = lambda name: int((re.findall(rf"stat::{name}:\s*(\d+)", result.stdout) or [0])[-1])
    edges, features = (re.findall(r"cov: (\d+) ft: (\d+)", result.stdout) or [("0", "0")])[-1]
    print(f"| {target} | {processor:.0f} | {stat('number_of_executed_units')} | {edges} | {features} | {stat('slowest_unit_time_sec')} | "
          f"{stat('peak_rss_mb')} |", flush=True)
    slow = [path for path in artifacts.glob("slow-unit-*") if not is_quick(target, path)]
    for path in slow:
        print(f"more than a second of processor time: {path}")
    if result.returncode:
        print(result.stdout[-4000:])
    return result.returncode or len(slow)


def is_quick(target, path):
    """Whether one input takes less than a second of processor time; if so, it is no finding."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([str(binary(target)), str(path)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if after.ru_utime - before.ru_utime < 1:
        path.unlink()
        return True
    return False


def minimise(target):
    """The smallest inputs that cover what all of them cover, as many as may be committed; files with a name are past faults and stay."""
    corpus, kept = HERE / "corpus" / target, ROOT / "target/fuzz-corpus" / f"{target}-small"
    shutil.rmtree(kept, ignore_errors=True)
    kept.mkdir(parents=True)
    command = [str(binary(target)), "-set_cover_merge=1", str(kept), str(corpus), str(found(target)), "-timeout=5"]
    subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
    for path in corpus.iterdir():
        if not path.name.startswith("fault"):
            path.unlink()
    small = sorted((path for path in kept.iterdir() if path.stat().st_size <= LARGEST), key=lambda path: (path.stat().st_size, path.name))
    # Evenly over all sizes where there are more than may be committed.
    for at in range(min(FILES, len(small))):
        path = small[at * len(small) // min(FILES, len(small))]
        shutil.copy(path, corpus / path.name[:16])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--seconds", type=int, required=True, help="in all; shared among the targets")
    parser.add_argument("--only", nargs="*", default=list(TARGETS))
    parser.add_argument("--minimise", action="store_true")
    arguments = parser.parse_args()
    build()
    print("| target | processor s | executions | edges | features | slowest s | peak MB |\n|---|---|---|---|---|---|---|")
    shares = sum(TARGETS[target][0] for target in arguments.only)
    failed = 0
    for target in arguments.only:
        share, longest = TARGETS[target]
        seconds = arguments.seconds * share // shares
        failed |= fuzz(target, seconds, longest) if seconds else 0
        if arguments.minimise:
            minimise(target)
    sys.exit(bool(failed))


if __name__ == "__main__":
    main()
