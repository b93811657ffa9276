"""Runs every peer on every problem and writes ``peers.csv``, and the same in short as Markdown.

Called by ``cargo xtask peers``, which installs and compiles before.  Each solve has a process of
its own, on one processor, that is ended when it takes too long; a peer that is missing, or that
does not converge, is a row that says so.
"""

from __future__ import annotations

import argparse
import os
import platform
import sys
import tempfile
import warnings
from pathlib import Path

import numpy as np

import distance
from problems import PROBLEMS, Problem, energy, is_minimum, residual, tolerance
from programs import PEERS, Programs, number, run
from table import Row, write


def judge(problem: Problem, n: int, said: dict[str, str], points: np.ndarray | None) -> tuple:
    """Energy, residual and convergence, by the same code for all peers."""
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


def machine() -> str:
    """The machine: the model of its processor, and the number of processors."""
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
    parser.add_argument("--distance", action="store_true", help="only the table of distances")
    parser.add_argument("--limit", type=int, default=30, help="seconds for a solve (30)")
    chosen = parser.parse_args()
    programs = Programs(chosen.python, chosen.geomstats, chosen.tautline, chosen.argmin)
    distance.compare(
        [name for name in distance.PROBLEM_NAMES if name in (chosen.problem or PROBLEMS)],
        [peer for peer in distance.PEER_NAMES if peer in (chosen.peer or PEERS)],
        programs,
        chosen.limit,
        chosen.output.with_name("distance.csv"),
        machine(),
    )
    if chosen.distance:
        return
    rows: list[Row] = []
    # A peer that did not finish does not finish on a finer grid either.
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
