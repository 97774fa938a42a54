"""Compilers of peers: text to shared library, in a folder of its own; nothing is built again unless its text has changed."""

import os
import subprocess
from dataclasses import dataclass
from pathlib import Path


@dataclass
class Built:
    """A shared library with `step(in, out)`; and `in_size`, `out_size`, `pack`, `unpack` if its arrays are not the flat ones."""

    shared_object: Path


class Missing(Exception):
    """A peer that is not installed."""


def run(command: list[str], folder: Path, environment: dict[str, str] | None = None) -> None:
    """Runs a compiler."""
    try:
        done = subprocess.run(command, cwd=folder, env=os.environ | (environment or {}), capture_output=True, text=True)
    except FileNotFoundError as error:
        raise Missing(f"{command[0]} is not installed") from error
    if done.returncode:
        raise RuntimeError(f"{' '.join(command)}\n{done.stderr[-4000:]}")


def write(path: Path, text: str) -> bool:
    """Writes a file; whether it has changed."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if path.exists() and path.read_text() == text:
        return False
    path.write_text(text)
    return True


def compiled(folder: Path, source: str, name: str, command: list[str], libraries: list[str] | None = None) -> Path:
    """A library from one file of C or C++."""
    library = folder / "step.so"
    changed = write(folder / name, source)
    changed |= write(folder / "command", " ".join(command))
    if changed or not library.exists():
        run([*command, "-shared", "-fPIC", name, "-o", "step.so", *(libraries or []), "-lm"], folder)
    return library


def cargo(folder: Path, manifest: str, sources: dict[str, str], library: str) -> Path:
    """A library from a crate that is made here."""
    write(folder / "Cargo.toml", manifest)
    for name, text in sources.items():
        write(folder / "src" / name, text)
    return cargo_at(folder, folder / "target", library)


def cargo_at(crate: Path, target: Path, library: str) -> Path:
    """A library from a crate, for this processor."""
    run(["cargo", "build", "--quiet", "--release"], crate, {"RUSTFLAGS": "-C target-cpu=native", "CARGO_TARGET_DIR": str(target)})
    return target / "release" / library
