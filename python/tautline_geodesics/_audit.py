"""The audit of a metric by the program `tautline-audit`, a package of its own."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from ._convert import number, whole
from ._metric import Metric
from ._sets import SetLike, as_set
from ._tautline import Constant, ProblemError, Set, problem_file

PROGRAM = "tautline-audit"

# How often signals are looked for, in seconds: another thread may receive them.
PERIOD = 0.05


class Law(NamedTuple):
    """The result of a law."""

    id: str
    """Its name."""
    says: str
    """What it says."""
    status: str
    """"holds", "fails", "false_hypothesis", "does_not_apply" or "not_tried"."""
    why: str | None
    """Why it fails, is not tried or does not apply."""


class Lie(NamedTuple):
    """A false claim, with the place that refutes it."""

    about: str
    """The constant, such as "L_H", or "H" if the formula is no metric."""
    claim: str
    """What is claimed."""
    claimed: float | None
    """The number that is claimed."""
    found: float | None
    """The number that was found, None if it is not finite."""
    formula: str
    """What was found, as a formula in the point x, the direction w and the other point y."""
    point: list[float] | None
    """The point x; None if only bounds over the region refute the claim."""
    direction: list[float] | None
    """The direction w, of length 1."""
    other: list[float] | None
    """The other point y of a difference."""


@dataclass(frozen=True, repr=False)
class Audit:
    """What an audit found. `print` shows the whole report."""

    verdict: str
    """"holds": all laws do; "lies": a claim is false; "fails": a law does, although no claim is known to
    be false; "incomplete": no law fails, but some were not tried."""
    lies: list[Lie]
    """The false claims."""
    laws: list[Law]
    """All laws."""
    constants: tuple[float, float, float, float | None] | None
    """c1, c2, L_H, and M_H or None, which the laws use; None if no constants are known."""
    constants_proved: bool
    """Whether the constants are proved from the formula, not claimed."""
    text: str
    """The report for a person."""
    document: dict[str, Any] = field(compare=False)
    """All of the report, as `tautline-audit --schema` describes it."""

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        verdict_and_lies, *_ = self.text.split("\n\n")
        return f"<tautline.Audit: {verdict_and_lies.strip()}>"


def audit(
    metric: Metric,
    *,
    start: SetLike | None = None,
    goal: SetLike | None = None,
    region: Set | None = None,
    claimed: tuple[float, float, float, float | None] | dict[str, Constant] | None = None,
    cases: int | None = None,
    seed: int | None = None,
    time_limit: float = 20.0,
) -> Audit:
    """Tests a metric, and the constants that are `claimed` for it, against every law of the kit.

    `claimed` is (c1, c2, L_H, M_H), where M_H may be None, or what `Metric.constants` returns. Without it
    the constants are proved from the formula. Samples are drawn in `region`, a box; or else in one
    period of the formula, in a box around `start` and `goal`, or in [-1, 1]^D. `cases` is their number
    for each law. What is not done within `time_limit` seconds is not tried.

    It needs the program `tautline-audit`, beside the interpreter or on the path: `pip install
    ./python/audit` in a clone compiles it.

    >>> import tautline_geodesics as tautline
    >>> valleys = tautline.Metric.cost("2 - cos(x1)", dimension=2)
    >>> found = tautline.audit(valleys, claimed=(1, 9, 4, None), cases=16)
    >>> found.verdict, [(lie.about, lie.claimed, round(lie.found, 4)) for lie in found.lies]
    ('lies', [('L_H', 4.0, 4.4037)])

    Raises `NotCertified` for a black box, `ProblemError` if the input is wrong, `FileNotFoundError`
    without the program, `RuntimeError` if it says nothing within the limit.
    """
    if (start is None) != (goal is None):
        raise ProblemError("start and goal are given both or neither")
    a = None if start is None else as_set(start, "the start")
    b = None if goal is None else as_set(goal, "the goal")
    file = problem_file(metric.program, a, b, region, claimed)
    arguments = ["--json", f"--time-limit={number(time_limit, 'the time limit')!r}"]
    if cases is not None:
        arguments.append(f"--cases={whole(cases, 'the number of cases')}")
    if seed is not None:
        arguments.append(f"--seed={seed}")
    return _audit(_said(file, arguments))


def _program() -> str:
    """The path of the program."""
    beside = os.path.dirname(sys.executable or "")
    found = (beside and shutil.which(PROGRAM, path=beside)) or shutil.which(PROGRAM)
    if not found:
        raise FileNotFoundError(
            f"the program {PROGRAM} is neither beside {sys.executable} nor on the path: "
            "pip install ./python/audit in a clone compiles it"
        )
    return found


def _said(file: str, arguments: Sequence[str]) -> dict[str, Any]:
    """The document that the program prints of a problem file."""
    pipe = subprocess.PIPE
    command = [_program(), "-", *arguments]
    with subprocess.Popen(command, stdin=pipe, stdout=pipe, stderr=pipe, encoding="utf-8") as run:
        left: str | None = file
        try:
            while True:
                try:
                    out, error = run.communicate(left, PERIOD)
                    break
                except subprocess.TimeoutExpired:
                    # The rest is sent by the next call.
                    left = None
        except BaseException:
            # Such as Ctrl-C.
            run.kill()
            run.wait()
            raise
    # 0 if all laws hold, 1 if not or if there is no report, 2 for bad input.
    if run.returncode == 2:
        raise ProblemError(error.strip())
    if not out:
        raise RuntimeError(error.strip() or f"{PROGRAM} ended with {run.returncode}")
    document: dict[str, Any] = json.loads(out)
    return document


def _audit(document: dict[str, Any]) -> Audit:
    """The report of a document."""
    try:
        return _read(document)
    except KeyError as error:
        raise RuntimeError(
            f"the report of {PROGRAM} has no {error}: it is of another version than tautline"
        ) from None


def _read(document: dict[str, Any]) -> Audit:
    used = document["constants"]
    return Audit(
        verdict=document["verdict"],
        lies=[Lie(*(lie[name] for name in Lie._fields)) for lie in document["lies"]],
        laws=[
            Law(law["law"], law["says"], law["status"], law["reason"]) for law in document["laws"]
        ],
        constants=used and (used["c1"], used["c2"], used["l_h"], used["m_h"]),
        constants_proved=bool(used and used["proved"]),
        text=document["text"],
        document=document,
    )
