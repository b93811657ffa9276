"""Solves one problem by one peer: ``solve_one.py PEER PROBLEM N TOLERANCE SECONDS FILE``.

Prints what the comparison wants to know, line by line, so that it is known how far a solve came
that is ended; the points go to the file.
"""

from __future__ import annotations

import importlib
import sys

import measurement
from problems import PROBLEMS


def main() -> None:
    """Reads the arguments and measures."""
    name, problem, n, tolerance, seconds, file = sys.argv[1:]
    try:
        peer = importlib.import_module(f"solvers.{name}")
        measurement.measure(
            peer, PROBLEMS[problem], int(n), float(tolerance), float(seconds), file
        )
    except ImportError as error:
        print(f"unavailable=not installed: {error}")
    except measurement.NotApplicable as reason:
        print(f"unavailable=not applicable: {reason}")


if __name__ == "__main__":
    main()
