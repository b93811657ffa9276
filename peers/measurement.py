"""The time of a solve, and the report for the comparison: one process, one solve."""

from __future__ import annotations

import math
import resource
import statistics
import time
from dataclasses import dataclass
from typing import Callable, Protocol

import numpy as np

from problems import Problem

# The least time of a sample, in seconds, over which a solve is repeated, as in the peers in Rust.
SAMPLE = 0.2

# A solve that takes longer than this, in seconds, is not repeated.
PATIENCE = 5.0


class NotApplicable(Exception):
    """The peer cannot pose the problem."""


@dataclass
class Solution:
    """The result of a peer: points if they are on the grid, otherwise its own energy."""

    iterations: int
    stop: str
    points: np.ndarray | None = None
    energy: float | None = None
    # Whether a peer off the grid reports convergence.
    success: bool = True


class Peer(Protocol):
    """A solver: a module of `solvers`."""

    def version(self) -> str:
        """The name and version of the program."""

    def prepare(self, problem: Problem, n: int, tolerance: float) -> Callable[[], Solution]:
        """Poses the problem, compiles what needs compiling, and returns the solve."""


def limit(seconds: float) -> None:
    """Lets the system end this process after this many more seconds on a processor."""
    _, hard = resource.getrlimit(resource.RLIMIT_CPU)
    resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(time.process_time() + seconds), hard))


def measure(
    peer: Peer, problem: Problem, n: int, tolerance: float, seconds: float, file: str
) -> None:
    """Prepares, solves and reports, each with this limit in seconds on the processor."""
    print("phase=set-up", flush=True)
    limit(seconds)
    print(f"version={peer.version()}", flush=True)
    solve = peer.prepare(problem, n, tolerance)
    print(f"set_up={time.process_time()}\nphase=solve", flush=True)
    limit(seconds)
    start = time.process_time()
    solution = solve()
    first = time.process_time() - start
    if solution.points is not None:
        np.ascontiguousarray(solution.points).tofile(file)
    if solution.energy is not None:
        print(f"energy={solution.energy!r}\nsuccess={int(solution.success)}")
    print(f"iterations={solution.iterations}\nstop={solution.stop}", flush=True)
    print(f"seconds={first if first > PATIENCE else samples(solve, first, seconds)}")


def samples(solve: Callable[[], Solution], first: float, seconds: float) -> float:
    """The median of three samples of the time of one solve."""

    def taken(count: int) -> float:
        limit(seconds)
        start = time.process_time()
        for _ in range(count):
            solve()
        return time.process_time() - start

    # Some clocks of processes tick in hundredths of a second, longer than a short solve.
    count = 1
    while first < SAMPLE and taken(count) < SAMPLE:
        count *= 2
    return statistics.median(taken(count) / count for _ in range(3))
