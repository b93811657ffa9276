"""Checks a certificate of a distance: python3 check.py [--time-limit SECONDS] FILE.

A second checker, written from the theorems and from `../FORMAT.md`, on other intervals: doubles of
numpy rounded outward, and arb for elementary functions (pip install -r requirements.txt). It prints
what is proved, and exits with 0. If the file proves nothing, it says why and exits with 1; if it was
not read, or not checked in the time, with 2.
"""

import itertools
import math
import os
import signal
import sys
from decimal import ROUND_CEILING, ROUND_FLOOR, Context, Decimal

import numpy as np

from certificate import Certificate
from curve import length_above
from refused import Refused, require
from region import prove_exit, prove_tubes, required_cubes
from sets import contains
from sweep import Sweep
from work import Work

# The units of work that any certificate may cost, and those for each number in it.
ALWAYS, FOR_A_NUMBER = 1 << 24, 1 << 16

USAGE = "usage: python3 check.py [--time-limit SECONDS] FILE"


class OutOfTime(Exception):
    """The time is over, and the certificate neither proved nor refused."""


def check(certificate, report=lambda line: None):
    """The lower and the upper bound, which is None without a curve."""
    c, work = certificate, Work(ALWAYS + FOR_A_NUMBER * certificate.size)
    require(c.hi > 0, f"the bound hi is {c.hi}")
    require(c.levels, "the certificate has no levels")
    if c.region[0] == "tubes":
        prove_tubes(c.formula, c.sets, c.hi, *c.region[1:], work)
        report("the constant of the tubes")
    upper_bound = None
    if c.curve is not None:
        require(len(c.curve), "the curve has no points")
        for name, pieces, x in (("first", c.sets[0], c.curve[0]), ("last", c.sets[1], c.curve[-1])):
            require(
                contains(pieces, x),
                f"the {name} point of the curve does not lie in its set",
            )
        upper_bound = length_above(c.formula, c.curve, work)
        require(upper_bound < c.hi, f"the curve has length at most {upper_bound}, not below {c.hi}")
        report("the curve")
    lower, kept = 0.0, None
    for number, level in enumerate(c.levels):
        if number == 0:
            required = required_cubes(c.region, c.sets, c.hi, level.exponent, c.dimension, work)
        else:
            required = [following(kept, c.levels[number - 1].exponent - level.exponent)]
        for places in required:
            missing = places[~level.holds(places)]
            require(not len(missing), f"level {number} lacks the cube at {missing[:1].tolist()}")
        sweep = Sweep(c.formula, c.sets, level, work)
        if number == 0:
            prove_exit(c.region, c.sets, c.hi, sweep)
        found, left = sweep.shorter_than(c.hi)
        lower, kept = max(lower, found), level.cubes[left]
        cubes = f"{len(level.cubes)} cubes, {len(kept)} kept"
        report(
            f"level {number} of {len(c.levels)}: {cubes}, lower bound {rounded(lower, ROUND_FLOOR)}"
        )
        if not len(kept):
            break
    if upper_bound is not None:
        contradiction = f"a contradiction: {lower} and a curve of length {upper_bound}"
        require(len(kept) and lower <= upper_bound, contradiction)
    return lower, upper_bound


def following(kept, halvings):
    """The cubes that the next level has to contain."""
    require(halvings in (0, 1), "a level has cubes neither as large as before nor half as large")
    if halvings == 0:
        return kept
    halves = np.array(list(itertools.product(range(2), repeat=kept.shape[1])))
    return (2 * kept[:, None] + halves).reshape(-1, kept.shape[1])


def rounded(x, rounding):
    return Context(prec=17, rounding=rounding).create_decimal(Decimal(float(x)))


def test_rounding():
    """Refuses a processor in another rounding mode, or without subnormal numbers."""
    one, half = np.array([1.0, -1.0]), np.array([1.0, -1.0]) * 2.0**-53
    nearest = (one + half == one).all() and (one + 1.5 * half == one * (1 + 2.0**-52)).all()
    require(
        nearest and (np.array([2.0**-1022]) / 2 > 0).all(), "doubles are not rounded to nearest"
    )


def main(arguments):
    if len(arguments) == 3 and "--time-limit" in arguments[:2]:
        at = arguments.index("--time-limit")
        limit, arguments = arguments[at + 1], arguments[:at] + arguments[at + 2 :]
    else:
        limit = None
    if len(arguments) != 1 or arguments[0].startswith("-"):
        return ended(2, USAGE)
    checked = []
    try:
        if limit is not None:
            start_clock(limit)
        code, said = attempt(*arguments, checked)
        # What is proved is printed even if the time is over now.
        signal.setitimer(signal.ITIMER_REAL, 0)
    except ValueError as reason:
        return ended(2, str(reason))
    except OutOfTime:
        done = "".join(f"\nchecked: {line}" for line in checked)
        code = 2
        said = f"not checked in the time: what follows is neither proved nor refused{done}"
    if code != 0:
        return ended(code, said)
    try:
        print(said, flush=True)
    except BrokenPipeError:
        # A reader that has seen enough closes the pipe.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except OSError as reason:
        return ended(2, f"proved, but not written: {reason}")
    return 0


def attempt(path, checked):
    """The exit code, and what is proved or why nothing is. All but OutOfTime is caught."""
    try:
        with open(path, encoding="utf-8", newline="") as file:
            text = file.read()
    except (OSError, ValueError) as reason:
        return 2, f"{path}: {reason}"
    try:
        test_rounding()
        certificate = Certificate(text)
        bounds = check(certificate, checked.append)
        return 0, "\n".join([*checked, *statement(certificate, *bounds)])
    except OutOfTime:
        raise
    except MemoryError:
        return 2, "not checked: there is not enough memory"
    except Refused as reason:
        return 1, f"refused: {reason}"
    except Exception as error:
        # A mistake of this program proves nothing.
        return 1, f"refused: an error in the checker: {type(error).__name__}: {error}"


def start_clock(limit):
    """Raises OutOfTime after so many seconds."""

    def stop(*_):
        raise OutOfTime

    try:
        seconds = float(limit)
    except ValueError:
        seconds = math.nan
    if not 0 < seconds < math.inf:
        raise ValueError(f"{limit!r} is no number of seconds")
    signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, seconds)


def statement(certificate, lower, upper_bound):
    """What is proved, in lines."""
    c = certificate
    lines = [*c.statement]
    for name, pieces in zip(("from", "to"), c.sets):
        lines += [" ".join([name, kind, *map(str, numbers.tolist())]) for kind, numbers in pieces]
    lines.append(f"region {' '.join(map(str, c.region))}, for curves shorter than {c.hi}")
    if c.region[0] == "declared":
        lines.append("c1 is declared, not proved: a hypothesis")
    lines.append(f"lower {rounded(lower, ROUND_FLOOR)}")
    if upper_bound is not None:
        lines.append(f"upper {rounded(upper_bound, ROUND_CEILING)}")
        lines.append(f"gap   {gap_above(lower, upper_bound)}")
    return lines


def gap_above(lower, upper_bound):
    context = Context(prec=7, rounding=ROUND_CEILING)
    difference = context.subtract(Decimal(upper_bound), Decimal(lower))
    return context.divide(difference, Decimal(upper_bound)) if upper_bound else 0


def ended(code, why):
    """Tells why, if anybody listens."""
    try:
        print(why, file=sys.stderr, flush=True)
    except OSError:
        pass
    return code


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
