"""Arrays of intervals.

An interval has two arrays of doubles, its ends. NaN ends mean "undefined", and no comparison with
NaN holds. The processor rounds + - * / sqrt to nearest, so the next double outward is a bound. An
exact sum is kept: Knuth's two-sum has the exact error. Elementary functions are enclosed at ends
by arb (python-flint); between the ends they are monotone, or reach 1 or -1.
"""

import numpy as np
from flint import arb, ctx

ctx.prec = 80
# An overflow is infinite or the largest double, and what is undefined is NaN: no errors.
np.seterr(all="ignore")
INF = np.inf


def down(x):
    return np.nextafter(x, -INF)


def up(x):
    return np.nextafter(x, INF)


def add_down(a, b):
    s = a + b
    t = s - a
    error = (a - (s - t)) + (b - t)
    return np.where(error >= 0, s, down(s))  # an overflow has no error and is rounded down


def add_up(a, b):
    return -add_down(-a, -b)


class Interval:
    __slots__ = ("lo", "hi")

    def __init__(self, lo, hi=None):
        self.lo = np.asarray(lo, float)
        self.hi = self.lo if hi is None else np.asarray(hi, float)

    def __neg__(self):
        return Interval(-self.hi, -self.lo)

    def __add__(self, other):
        other = of(other)
        return Interval(add_down(self.lo, other.lo), add_up(self.hi, other.hi))

    def __sub__(self, other):
        return self + -of(other)

    def __mul__(self, other):
        a, b = self, of(other)
        lo, hi = extremes(np.multiply, a, b)
        # A product of numbers of known signs has a known sign, also where it underflows.
        same = (a.lo >= 0) & (b.lo >= 0) | (a.hi <= 0) & (b.hi <= 0)
        opposite = (a.lo >= 0) & (b.hi <= 0) | (a.hi <= 0) & (b.lo >= 0)
        return Interval(
            np.where(same, np.maximum(lo, 0), lo), np.where(opposite, np.minimum(hi, 0), hi)
        )

    def __truediv__(self, other):
        other = of(other)
        return Interval(*extremes(np.divide, self, other)).where(other.excludes_zero())

    def excludes_zero(self):
        return (self.lo > 0) | (self.hi < 0)

    def where(self, mask, other=np.nan):
        """These intervals where the mask is true, and others elsewhere."""
        other = of(other)
        return Interval(np.where(mask, self.lo, other.lo), np.where(mask, self.hi, other.hi))

    def __getitem__(self, at):
        return Interval(self.lo[at], self.hi[at])

    def within(self, lo, hi):
        """The part between two numbers; NaN stays."""
        return Interval(np.maximum(self.lo, lo), np.minimum(self.hi, hi))

    def scaled(self, factor):
        """The product with a power of two, which rounds only if it underflows or overflows."""

        def exact(x, outward):
            y = x * factor
            return np.where(y / factor == x, y, outward(y))

        return Interval(exact(self.lo, down), exact(self.hi, up))

    def magnitude(self):
        return np.maximum(np.abs(self.lo), np.abs(self.hi))

    def mignitude(self):
        return np.maximum(0, np.maximum(self.lo, -self.hi))

    def sqr(self):
        near, far = self.mignitude(), self.magnitude()
        return Interval(np.maximum(down(near * near), 0), np.where(far == 0, 0.0, up(far * far)))

    def sqrt(self):
        hi = np.sqrt(self.hi)
        lo, hi = np.maximum(down(np.sqrt(self.lo)), 0), np.where(hi == 0, 0.0, up(hi))
        return Interval(lo, hi).where(self.lo >= 0)

    def recip(self):
        return of(1.0) / self

    def powi(self, n):
        if n < 0:
            return self.recip().powi(-n)
        if n == 0:
            return self * 0.0 + 1.0
        if n == 1:
            return self
        if n % 2 == 0:
            return self.sqr().power_of_positive(n // 2)
        # An odd power increases.
        ends = [Interval(end) for end in (self.lo, self.hi)]
        low, high = [end * end.sqr().power_of_positive(n // 2) for end in ends]
        return Interval(low.lo, high.hi)

    def power_of_positive(self, n):
        """The power n > 0 of numbers that are not negative."""
        power, square = None, self
        while n:
            if n % 2:
                power = square if power is None else power * square
            n //= 2
            square = square.sqr() if n else square
        return power

    def positive(self):
        """The positive part."""
        return Interval(np.maximum(self.lo, 0), np.maximum(self.hi, 0))

    def exp(self):
        return self.increasing("exp")

    def ln(self):
        return self.increasing("log").where(self.lo > 0)

    def atan(self):
        return self.increasing("atan")

    def sinh(self):
        return self.increasing("sinh")

    def tanh(self):
        return self.increasing("tanh")

    def cosh(self):
        return Interval(self.mignitude(), self.magnitude()).increasing("cosh")

    def tan(self):
        turns = self / PI - 0.5
        pole = np.floor(turns.hi) >= turns.lo
        return self.increasing("tan").where(~pole & np.isfinite(turns.lo + turns.hi))

    def cos(self):
        return self.wave("cos", self / PI)

    def sin(self):
        return self.wave("sin", self / PI - 0.5)

    def wave(self, name, turns):
        """A sine or cosine that is 1 where `turns` is an even integer, and -1 where it is odd."""
        (a, b), (c, d) = at_doubles(name, self.lo), at_doubles(name, self.hi)
        half = turns.scaled(0.5)
        top = np.floor(half.hi) >= half.lo
        bottom = np.floor((half - 0.5).hi) >= (half - 0.5).lo
        wave = Interval(np.where(bottom, -1, np.minimum(a, c)), np.where(top, 1, np.maximum(b, d)))
        return wave.where(np.isfinite(self.lo + self.hi))

    def increasing(self, name):
        lo, hi = at_doubles(name, self.lo)[0], at_doubles(name, self.hi)[1]
        return Interval(lo, hi).where(~(np.isnan(lo) | np.isnan(hi)))


def of(x):
    return x if isinstance(x, Interval) else Interval(x)


def extremes(operation, a, b):
    """Bounds on a product or quotient, which has its extremes at ends; 0 times infinity is NaN."""
    p, q, r, s = (operation(x, y) for x in (a.lo, a.hi) for y in (b.lo, b.hi))
    lo = np.minimum(np.minimum(p, q), np.minimum(r, s))
    hi = np.maximum(np.maximum(p, q), np.maximum(r, s))
    return down(lo), up(hi)


def at_doubles(name, x):
    """Bounds on a function at doubles, NaN where it has none."""
    x, inverse = np.unique(x, return_inverse=True)
    lo, hi = np.empty_like(x), np.empty_like(x)
    for n, value in enumerate(x):
        ball = getattr(arb(float(value)), name)()
        lo[n], hi[n] = (
            (float(ball.lower()), float(ball.upper())) if ball.is_finite() else (np.nan,) * 2
        )
    # Conversion to a double has an error below one unit.
    return down(lo)[inverse], up(hi)[inverse]


PI = Interval(down(float(arb.pi().lower())), up(float(arb.pi().upper())))
