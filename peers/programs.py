"""The programs of the comparison: how each is called, confined and read."""

from __future__ import annotations

import os
import resource
import signal
import subprocess
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent

# No peer is faster with more than one thread.
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
    "tautline_python": "Tautline, from Python",
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
    """The paths of the programs that xtask has built."""

    python: str
    geomstats: str
    tautline: str
    argmin: str

    def command(self, peer: str, problem: str, n: int, stop: float, limit: int, file: str) -> list:
        """The command that solves one problem by one peer."""
        if peer == "tautline":
            return [self.tautline, problem, str(n), file]
        if peer == "argmin":
            return [self.argmin, problem, str(n), repr(stop), file]
        python = self.geomstats if peer == "geomstats_paths" else self.python
        script = str(HERE / "solve_one.py")
        return [python, script, peer, problem, str(n), repr(stop), str(limit), file]


def on_one_processor(seconds: int, hard: int) -> None:
    """Confines the process that is about to start: to one processor, and to a time limit."""
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, hard))


def run(command: list[str], limit: int) -> tuple[dict[str, str], str]:
    """Runs a peer; returns what it printed, and why it failed."""
    try:
        # A peer in Python sets the soft limit itself, for each solve.
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
    """Lines of ``key=value``; the last value of a key counts."""
    pairs = (line.partition("=") for line in printed.splitlines())
    return {key: value for key, separator, value in pairs if separator}


def number(said: dict[str, str], key: str) -> float | None:
    """A number, if it was printed."""
    return float(said[key]) if key in said else None
