"""Runs every peer on every problem and writes ``peers.csv``, and the same in short as Markdown.

Called by ``cargo xtask peers``, which installs and compiles before.  Each solve has a process of
its own, on one processor, that is ended when it takes too long; a peer that is missing, or that
does not converge, is a row that says so.
"""

from __future__ import annotations

import argparse
import os
import platform
import resource
import signal
import subprocess
import sys
import tempfile
import warnings
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from problems import PROBLEMS, Problem, energy, is_minimum, residual, tolerance
from table import Row, write

HERE = Path(__file__).resolve().parent

# Nobody is faster for having more than one thread.
ONE_THREAD = {
    "OMP_NUM_THREADS": "1",
    "OPENBLAS_NUM_THREADS": "1",
    "MKL_NUM_THREADS": "1",
    "RAYON_NUM_THREADS": "1",
    "XLA_FLAGS": "--xla_cpu_multi_thread_eigen=false intra_op_parallelism_threads=1",
    "JAX_PLATFORMS": "cpu",
}

# Tautline goes first, since the others are divided by it.
RUST = {"tautline": "Tautline", "argmin": "argmin, trust region"}
PYTHON = {
    "jax_newton": "JAX + banded solver",
    "casadi_ipopt": "CasADi + IPOPT",
    "casadi_fatrop": "CasADi + FATROP",
    "scipy_bvp": "SciPy solve_bvp",
    "scipy_lbfgs": "SciPy L-BFGS-B",
    "geomstats_paths": "geomstats, path straightening",
}
PEERS = {"tautline": RUST["tautline"], **PYTHON, "argmin": RUST["argmin"]}


@dataclass(frozen=True)
class Programs:
    """Where the programs are that xtask has made."""

    python: str
    geomstats: str
    tautline: str
    argmin: str

    def command(self, peer: str, problem: str, n: int, stop: float, limit: int, file: str) -> list:
        """What solves one problem by one peer."""
        if peer == "tautline":
            return [self.tautline, problem, str(n), file]
        if peer == "argmin":
            return [self.argmin, problem, str(n), repr(stop), file]
        python = self.geomstats if peer == "geomstats_paths" else self.python
        script = str(HERE / "solve_one.py")
        return [python, script, peer, problem, str(n), repr(stop), str(limit), file]


def on_one_processor(seconds: int, hard: int) -> None:
    """Confines the process that is about to start: to one processor, and to so many seconds."""
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, hard))


def run(command: list[str], limit: int) -> tuple[dict[str, str], str]:
    """Runs a peer; returns what it printed, and why it did not end well."""
    try:
        # A peer in Python sets the softer limit by itself, for each solve.
        done = subprocess.run(
            command,
            capture_output=True,
            text=True,
            env={**os.environ, **ONE_THREAD},
            preexec_fn=lambda: on_one_processor(limit, 20 * limit),
            timeout=40 * limit,
        )
    except FileNotFoundError:
        return {}, "not installed"
    except subprocess.TimeoutExpired as expired:
        printed = expired.stdout or b""
        return parse(printed.decode() if isinstance(printed, bytes) else printed), "did not finish"
    said = parse(done.stdout)
    if "unavailable" in said:
        return said, said["unavailable"]
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        phase = "set-up " if said.get("phase") == "set-up" else ""
        return said, f"{phase}did not finish in {limit} s"
    if done.returncode != 0:
        last = (done.stderr.strip() or f"exit code {done.returncode}").splitlines()[-1]
        return said, f"failed: {last}"
    return said, ""


def parse(printed: str) -> dict[str, str]:
    """Lines of ``key=value``; the last one of a key counts."""
    pairs = (line.partition("=") for line in printed.splitlines())
    return {key: value for key, separator, value in pairs if separator}


def judge(problem: Problem, n: int, said: dict[str, str], points: np.ndarray | None) -> tuple:
    """Energy, residual and whether it has converged, by one code for all peers."""
    stop = said.get("stop", "")
    if points is None:
        value = float(said["energy"])
        if said.get("success") != "1":
            return value, None, f"no: it says {stop}"
        return value, None, "yes" if is_minimum(problem, n, value, False) else "another geodesic"
    if points.shape != (n + 1, problem.dimension) or not np.isfinite(points).all():
        return None, None, f"no: not finite; it says {stop}"
    value, left = energy(problem, points), residual(problem, points)
    if not left <= tolerance(problem, n):
        return value, left, f"no: residual above {tolerance(problem, n):.1e}; it says {stop}"
    return value, left, "yes" if is_minimum(problem, n, value, True) else "another geodesic"


def compare(peer: str, problem: Problem, n: int, programs: Programs, limit: int) -> Row:
    """One row of the table, without its last column."""
    stop = tolerance(problem, n)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "points"
        said, reason = run(programs.command(peer, problem.name, n, stop, limit, str(file)), limit)
        points = None
        if file.exists():
            points = np.fromfile(file).reshape(-1, problem.dimension)
    row = Row(problem.name, n, PEERS[peer], said.get("version", ""))
    row.set_up_seconds = number(said, "set_up")
    row.seconds = number(said, "seconds")
    if "iterations" in said:
        row.iterations = int(said["iterations"])
        row.energy, row.residual, row.converged = judge(problem, n, said, points)
    if row.seconds is None:
        row.converged = reason or "failed: no report"
    return row


def number(said: dict[str, str], key: str) -> float | None:
    """A number that was printed, if it was."""
    return float(said[key]) if key in said else None


def machine() -> str:
    """The class of the machine: the model of its processor, and how many there are."""
    model = platform.processor() or platform.machine()
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
        model = next(line.split(":")[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        pass
    return f"{model}, {os.cpu_count()} cores, {platform.system()}"


def main() -> None:
    """Reads the arguments, runs everything and writes the table as it grows."""
    warnings.simplefilter("ignore", RuntimeWarning)
    parser = argparse.ArgumentParser(prog="cargo xtask peers", description=__doc__)
    for program in ("python", "geomstats", "tautline", "argmin"):
        parser.add_argument(f"--{program}", required=True, help=argparse.SUPPRESS)
    parser.add_argument("--output", required=True, type=Path, help=argparse.SUPPRESS)
    parser.add_argument("--peer", action="append", choices=PEERS, help="only these peers")
    parser.add_argument("--problem", action="append", choices=PROBLEMS, help="only these problems")
    parser.add_argument("--n", action="append", type=int, help="only these N")
    parser.add_argument("--limit", type=int, default=30, help="seconds for a solve (30)")
    chosen = parser.parse_args()
    programs = Programs(chosen.python, chosen.geomstats, chosen.tautline, chosen.argmin)
    rows: list[Row] = []
    # Who did not finish does not finish on a finer grid either.
    late: set[tuple[str, str]] = set()
    for n in sorted(chosen.n or (100, 1000, 10_000, 100_000)):
        for name in chosen.problem or PROBLEMS:
            reference = None
            for peer in chosen.peer or PEERS:
                if (name, peer) in late:
                    row = Row(name, n, PEERS[peer], "")
                    row.converged = "not run: did not finish for smaller N"
                else:
                    row = compare(peer, PROBLEMS[name], n, programs, chosen.limit)
                if "did not finish in" in row.converged:
                    late.add((name, peer))
                if peer == "tautline":
                    reference = row.seconds
                if reference and row.seconds:
                    row.ratio_to_tautline = row.seconds / reference
                rows.append(row)
                print(",".join(row.cells()), file=sys.stderr, flush=True)
            rows.sort(key=lambda row: (row.problem, row.n))
            write(rows, chosen.output, machine(), chosen.limit)


if __name__ == "__main__":
    main()
