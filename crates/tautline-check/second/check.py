"""Checks a certificate of a distance: python3 check.py FILE.

A second checker, written from the theorems and from `../FORMAT.md`, on other intervals: doubles of
numpy rounded outward, and arb for elementary functions (pip install -r requirements.txt). It prints
what is proved. If the file proves nothing, it says why and exits with 1.
"""

import itertools
import sys
from decimal import ROUND_CEILING, ROUND_FLOOR, Context, Decimal

import numpy as np

from certificate import Certificate
from curve import length_above
from refused import Refused, require
from region import prove_exit, prove_tubes, required_cubes
from sets import contains
from sweep import Sweep


def check(certificate, report=lambda line: None):
    """The lower and the upper bound, which is None without a curve."""
    c = certificate
    require(c.hi > 0, f"the bound hi is {c.hi}")
    require(c.levels, "the certificate has no levels")
    if c.region[0] == "tubes":
        prove_tubes(c.formula, c.sets, c.hi, *c.region[1:])
    upper_bound = None
    if c.curve is not None:
        require(len(c.curve), "the curve has no points")
        for name, pieces, x in (("first", c.sets[0], c.curve[0]), ("last", c.sets[1], c.curve[-1])):
            require(
                contains(pieces, x),
                f"the {name} point of the curve is not proved to lie in its set",
            )
        upper_bound = float(length_above(c.formula, c.curve))
        require(upper_bound < c.hi, f"the curve has length at most {upper_bound}, not below {c.hi}")
    lower, kept = 0.0, None
    for number, level in enumerate(c.levels):
        if number == 0:
            required = required_cubes(c.region, c.sets, c.hi, level.exponent, c.dimension)
        else:
            required = following(kept, c.levels[number - 1].exponent - level.exponent)
        missing = required[~level.holds(required)]
        lacks = f"level {number} lacks {len(missing)} cubes, as at {missing[:1].tolist()}"
        require(not len(missing), lacks)
        sweep = Sweep(c.formula, c.sets, level)
        if number == 0:
            prove_exit(c.region, c.sets, c.hi, sweep)
        found, left = sweep.shorter_than(c.hi)
        lower, kept = max(lower, found), level.cubes[left]
        cubes = f"{len(level.cubes)} cubes, {len(kept)} kept"
        report(f"level {number}: {cubes}, lower bound {rounded(lower, ROUND_FLOOR)}")
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


def main(path):
    try:
        test_rounding()
        with open(path, encoding="ascii", newline="") as file:
            certificate = Certificate(file.read())
        print("\n".join(certificate.statement))
        for name, pieces in zip(("from", "to"), certificate.sets):
            for kind, numbers in pieces:
                print(name, kind, *map(float, numbers))
        print(
            "curves shorter than",
            float(certificate.hi),
            "stay in the cubes:",
            *map(str, certificate.region),
        )
        if certificate.region[0] == "declared":
            print("c1 is declared, not proved: a hypothesis")
        lower, upper_bound = check(certificate, print)
    except (Refused, OSError, ValueError) as reason:
        print(f"refused: {reason}", file=sys.stderr)
        return 1
    print("lower", rounded(lower, ROUND_FLOOR))
    if upper_bound is not None:
        print("upper", rounded(upper_bound, ROUND_CEILING))
        print("gap  ", f"{(upper_bound - lower) / upper_bound if upper_bound else 0.0:.6e}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]) if len(sys.argv) == 2 else "usage: python3 check.py FILE")
