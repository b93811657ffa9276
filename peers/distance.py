"""The time for the square of the distance to ten digits, on whatever grid is enough.

Tautline extrapolates the discrete minima of its grids; solve_bvp, of order four, has a mesh of its
own.  Each has its loosest setting that is accurate enough: the least ``N`` of 96, 128, 192, 256,
and so on, or the largest tolerance.  Where that is does not count as time of the solve.
"""

from __future__ import annotations

import math
import sys
import tempfile
from pathlib import Path

from problems import PROBLEMS, Problem
from programs import PEERS, Programs, number, run
from table import write_csv, written

# The allowed relative error of the square of the distance.
ERROR = 1e-10

# Problems with a reference of more digits, and points at both ends.
PROBLEM_NAMES = ("P2", "P3", "P5", "P6")

# Tautline goes first, since the others are divided by it.
PEER_NAMES = ("tautline", "scipy_bvp")

COLUMNS = (
    "problem",
    "peer",
    "version",
    "seconds",
    "setup_seconds",
    "distance_squared",
    "relative_error",
    "reached",
    "ratio_to_tautline",
)


def solve(peer: str, problem: Problem, programs: Programs, limit: int) -> tuple[dict, str]:
    """Runs one peer; returns what it printed, and why it failed."""
    reference = problem.distance_squared
    if peer == "tautline":
        command = [programs.tautline, problem.name, "distance", repr(reference), repr(ERROR)]
        return run(command, limit)
    # solve_bvp searches for the tolerance that is as accurate as a grid of N chords.
    n = math.ceil(math.sqrt(abs(problem.discretisation) / (ERROR * reference)))
    with tempfile.TemporaryDirectory() as folder:
        file = str(Path(folder) / "points")
        return run(programs.command(peer, problem.name, n, 0.0, limit, file), limit)


def compare(
    problems: list[str], peers: list[str], programs: Programs, limit: int, file: Path, machine: str
) -> None:
    """Writes the table."""
    rows: list[list[str]] = []
    for name in problems:
        reference_seconds = None
        for peer in peers:
            said, reason = solve(peer, PROBLEMS[name], programs, limit)
            seconds, found = number(said, "seconds"), number(said, "energy")
            if peer == "tautline":
                reference_seconds = seconds
            error = found and found / PROBLEMS[name].distance_squared - 1.0
            reached = verdict(said, error) or reason
            compared = seconds and reference_seconds and reached.startswith("yes")
            ratio = seconds / reference_seconds if compared else None
            rows.append(
                [
                    name,
                    PEERS[peer],
                    said.get("version", ""),
                    written(seconds, ".2e"),
                    written(number(said, "set_up"), ".2f"),
                    written(found, ".13g"),
                    written(error, ".1e"),
                    reached,
                    written(ratio, ".3g"),
                ]
            )
            print(",".join(rows[-1]), file=sys.stderr, flush=True)
    shows = (
        "the cost of the square of the distance to a relative 1e-10; reached: whether the error is that"
        " small, and the setting; another geodesic: off by more than a tenth"
    )
    write_csv(file, shows, machine, limit, COLUMNS, rows)


def verdict(said: dict[str, str], error: float | None) -> str:
    """Whether a peer reached the accuracy, and with which setting."""
    if error is None:
        return ""
    if abs(error) > 0.1:
        return f"no: another geodesic; {said.get('stop', '')}"
    reached = "yes" if abs(error) <= ERROR else "no"
    return f"{reached}: {said.get('stop', '')}"
