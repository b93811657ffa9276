"""Symbols that record the operations of a Python function."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TYPE_CHECKING, Any

import numpy as np

from ._convert import plain

if TYPE_CHECKING:
    from ._table import Table

Number = (int, float, np.integer, np.floating)


class TraceError(TypeError):
    """A function cannot be recorded: it branches on a coordinate, or uses an unknown operation."""


# The order in which numbers are computed.
ORDER = itertools.count()

# The branches that were refused while a function was recorded.
REFUSED: ContextVar[list[TraceError] | None] = ContextVar("refused", default=None)


@contextmanager
def no_branches() -> Iterator[None]:
    """Raises the refusal of a branch again, if somebody caught it: before 1.25, NumPy makes an answer of an
    exception in `array == v`, and what follows would be recorded for all points."""
    refused: list[TraceError] = []
    token = REFUSED.set(refused)
    try:
        yield
    finally:
        REFUSED.reset(token)
    if refused:
        raise refused[0]


class Traced:
    """A number that depends on the coordinates, known by how it is computed.

    It takes part in arithmetic and in NumPy's elementary functions. It has no value, so it cannot be
    compared, converted to a float, or decide an `if`.
    """

    __slots__ = ("text", "arguments", "order", "table", "value", "is_constant")

    def __init__(
        self,
        text: str,
        arguments: tuple[Traced, ...] = (),
        table: Table | None = None,
        value: float | None = None,
    ) -> None:
        # The text has a {} for each argument; that of a table begins with the arguments.
        self.text, self.arguments, self.order = text, arguments, next(ORDER)
        self.table = table
        # A number that is a step.
        self.value = value
        self.is_constant: bool = value is not None or (
            bool(arguments) and table is None and all(x.is_constant for x in arguments)
        )

    @classmethod
    def called(cls, table: Table, x: Sequence[Any]) -> Traced:
        """A table at traced numbers."""
        parts, arguments = [], []
        for u in map(plain, x):
            if isinstance(u, Traced):
                parts.append("{}")
                arguments.append(u)
            elif isinstance(u, Number) and math.isfinite(u):
                parts.append(repr(float(u)))
            else:
                raise TraceError(f"{u!r} as an argument of a table")
        return cls(f"({', '.join(parts)})", tuple(arguments), table)

    def __add__(self, other: Any) -> Any:
        return binary("{} + {}", self, other)

    def __radd__(self, other: Any) -> Any:
        return binary("{} + {}", other, self)

    def __sub__(self, other: Any) -> Any:
        return binary("{} - {}", self, other)

    def __rsub__(self, other: Any) -> Any:
        return binary("{} - {}", other, self)

    def __mul__(self, other: Any) -> Any:
        return binary("{} * {}", self, other)

    def __rmul__(self, other: Any) -> Any:
        return binary("{} * {}", other, self)

    def __truediv__(self, other: Any) -> Any:
        return binary("{} / {}", self, other)

    def __rtruediv__(self, other: Any) -> Any:
        return binary("{} / {}", other, self)

    def __neg__(self) -> Traced:
        return Traced("-{}", (self,))

    def __pos__(self) -> Traced:
        return self

    def __pow__(self, exponent: Any) -> Any:
        exponent = plain(exponent)
        if isinstance(exponent, Traced) and self.is_constant:
            if self.value is not None and self.value <= 0:
                return exponent.__rpow__(self.value)
            return (exponent * self.log()).exp()
        if isinstance(exponent, (int, np.integer)):
            return Traced(f"{{}}^{int(exponent)}", (self,))
        if isinstance(exponent, Number) and float(exponent) == 0.5:
            return self.sqrt()
        if isinstance(exponent, Number) and float(exponent) == -0.5:
            return Traced("recip({})", (self.sqrt(),))
        if isinstance(exponent, Number) and float(exponent).is_integer():
            return Traced(f"{{}}^{int(exponent)}", (self,))
        if isinstance(exponent, Number) and float(2 * exponent).is_integer():
            # x^1.5 = x √x.
            power = int(abs(float(exponent)))
            found = (self if power == 1 else self**power) * self.sqrt()
            return found if exponent > 0 else Traced("recip({})", (found,))
        if isinstance(exponent, Number) and self.is_constant:
            return self ** constant(exponent)
        raise TraceError(
            f"the power {exponent!r}: exponents are integers or halves of them; where x is positive, use "
            "exp(p*log(x))"
        )

    def __rpow__(self, base: Any) -> Any:
        if isinstance(base, Number) and base > 0:
            return (self * constant(base).log()).exp()
        raise TraceError(f"a power of {base!r} with an exponent that depends on the coordinates")

    # NumPy calls these for each entry of an array of objects.
    def sqrt(self) -> Traced:
        return Traced("sqrt({})", (self,))

    def exp(self) -> Traced:
        return Traced("exp({})", (self,))

    def log(self) -> Traced:
        return Traced("ln({})", (self,))

    def sin(self) -> Traced:
        return Traced("sin({})", (self,))

    def cos(self) -> Traced:
        return Traced("cos({})", (self,))

    def tan(self) -> Traced:
        return Traced("tan({})", (self,))

    def arctan(self) -> Traced:
        return Traced("atan({})", (self,))

    def sinh(self) -> Traced:
        return Traced("sinh({})", (self,))

    def cosh(self) -> Traced:
        return Traced("cosh({})", (self,))

    def tanh(self) -> Traced:
        return Traced("tanh({})", (self,))

    def square(self) -> Traced:
        return Traced("sqr({})", (self,))

    def reciprocal(self) -> Traced:
        return Traced("recip({})", (self,))

    # Compositions that are exact: of numbers that are doubles, and of steps, which intervals enclose.
    def exp2(self) -> Any:
        return (self * constant(2).log()).exp()

    def expm1(self) -> Any:
        return self.exp() - 1

    def log2(self) -> Any:
        return self.log() / constant(2).log()

    def log10(self) -> Any:
        return self.log() / constant(10).log()

    def log1p(self) -> Any:
        return (1 + self).log()

    def arcsin(self) -> Any:
        return (self / (1 - self * self).sqrt()).arctan()

    def arccos(self) -> Any:
        return 2 * constant(1).arctan() - self.arcsin()

    def arccosh(self) -> Any:
        return (self + (self * self - 1).sqrt()).log()

    def arctanh(self) -> Any:
        return ((1 + self) / (1 - self)).log() / 2

    # π/180 is arctan(1)/45.
    def radians(self) -> Any:
        return self * (constant(1).arctan() / 45)

    def degrees(self) -> Any:
        return self * (45 / constant(1).arctan())

    deg2rad, rad2deg = radians, degrees

    def conjugate(self) -> Traced:
        return self

    def hypot(self, other: Any) -> Any:
        return (self * self + other * other) ** 0.5

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **options: Any) -> Any:
        if options.get("out") is not None:
            raise TraceError(
                f"np.{ufunc.__name__} into an array of floats, as by `a += x`: write `a = a + x`, or "
                "make the array with dtype=object"
            )
        if method != "__call__" or options:
            raise TraceError(f"np.{ufunc.__name__}.{method} of a traced number")
        if any(isinstance(x, np.ndarray) and x.ndim > 0 for x in inputs):
            # Entry by entry.
            return ufunc(*(np.asarray(x, object) for x in inputs))
        rule = UFUNCS.get(ufunc.__name__)
        if rule is None:
            hint = SMOOTH.get(ufunc.__name__)
            instead = f"a smooth replacement is {hint}; " if hint else ""
            raise TraceError(
                f"np.{ufunc.__name__} cannot be recorded: {instead}`Metric.black_box` takes any "
                f"function. There are {', '.join(sorted(UFUNCS))}"
            )
        # A scalar of NumPy to the left of a symbol would call this function again.
        return rule(*(plain(x) for x in inputs))

    def _is_no_number(self, what: str) -> TraceError:
        return TraceError(
            f"a metric is recorded once, for all points: {what} would follow one of the branches. "
            "Write the metric as one smooth formula, for example with tanh or exp in place of the "
            f"branch, {SMOOTH['absolute']} in place of abs(u), or {SMOOTH['maximum']} in place of "
            "max(u, v), or give a black box to `Metric.black_box`"
        )

    def _is_no_branch(self, what: str) -> TraceError:
        error = self._is_no_number(what)
        if (refused := REFUSED.get()) is not None:
            refused.append(error)
        return error

    def __bool__(self) -> bool:
        raise self._is_no_branch("an `if`, `and`, `min` or `max` of a traced number")

    def __float__(self) -> float:
        raise TraceError(
            "a metric is recorded once, for all points: a traced number has no value. Use np.sin in "
            "place of math.sin; to put it into an array, make a list, or the array with dtype=object"
        )

    def _compared(self, other: Any) -> bool:
        raise self._is_no_branch("a comparison of a traced number")

    __lt__ = __le__ = __gt__ = __ge__ = __eq__ = __ne__ = _compared
    __hash__ = object.__hash__

    def __abs__(self) -> Traced:
        raise self._is_no_number("`abs` of a traced number")

    def _jumps(self, *_: Any) -> Traced:
        raise self._is_no_number("`%`, `//` or `round` of a traced number")

    __mod__ = __rmod__ = __divmod__ = __rdivmod__ = __floordiv__ = __rfloordiv__ = _jumps
    __round__ = __floor__ = __ceil__ = __trunc__ = _jumps

    def __repr__(self) -> str:
        return f"<traced {self.text.format(*['…'] * len(self.arguments))}>"


# What to write in place of functions with kinks, where 1e-4 rounds them off.
SMOOTH = {
    "absolute": "np.sqrt(u**2 + 1e-4)",
    "fabs": "np.sqrt(u**2 + 1e-4)",
    "maximum": "(u + v + np.sqrt((u - v)**2 + 1e-4))/2",
    "fmax": "(u + v + np.sqrt((u - v)**2 + 1e-4))/2",
    "minimum": "(u + v - np.sqrt((u - v)**2 + 1e-4))/2",
    "fmin": "(u + v - np.sqrt((u - v)**2 + 1e-4))/2",
    "sign": "np.tanh(u/0.01)",
    "heaviside": "(1 + np.tanh(u/0.01))/2",
}

UFUNCS: dict[str, Callable[..., Any]] = {
    "add": lambda a, b: a + b,
    "subtract": lambda a, b: a - b,
    "multiply": lambda a, b: a * b,
    "divide": lambda a, b: a / b,
    "power": lambda a, b: a**b,
    "float_power": lambda a, b: a**b,
    "hypot": lambda a, b: a.hypot(b) if isinstance(a, Traced) else b.hypot(a),
    "negative": lambda a: -a,
    "positive": lambda a: a,
    **{
        name: lambda a, name=name: getattr(a, name)()
        for name in (
            "sqrt exp log sin cos tan arctan sinh cosh tanh square reciprocal conjugate "
            "exp2 expm1 log2 log10 log1p arcsin arccos arccosh arctanh "
            "radians degrees deg2rad rad2deg".split()
        )
    },
}


def constant(x: Any) -> Traced:
    """A number as a step, so that intervals enclose what is computed from it."""
    found = numeral(x)
    if isinstance(found, Traced):
        return found
    return Traced(f"number({number(found)})", value=found)


def numeral(x: Any) -> float | Traced:
    """A number as a double, or the sum of doubles that it is."""
    if isinstance(x, (int, np.integer)):
        whole = int(x)
        try:
            high = float(whole)
        except OverflowError:
            raise TraceError(f"a whole number of {whole.bit_length()} bits in a formula") from None
        rest = whole - int(high)
        return constant(high) + numeral(rest) if rest else high
    found = float(x)
    if not math.isfinite(found):
        raise TraceError(f"the number {x!r} in a formula")
    return found


def binary(text: str, a: Any, b: Any) -> Any:
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        return NotImplemented
    if not all(isinstance(x, (Traced, *Number)) for x in (a, b)):
        return NotImplemented
    operands = [x if isinstance(x, Traced) else numeral(x) for x in (a, b)]
    # Beside what depends on the coordinates a number needs no step.
    if any(isinstance(x, Traced) and not x.is_constant for x in operands):
        operands = [
            x.value if isinstance(x, Traced) and x.value is not None else x for x in operands
        ]
    parts = ["{}" if isinstance(x, Traced) else number(x) for x in operands]
    arguments = tuple(x for x in operands if isinstance(x, Traced))
    return Traced(text.format(*parts), arguments)


def number(x: float) -> str:
    # A sign needs parentheses after an operator.
    return repr(x) if not math.copysign(1.0, x) < 0 else f"({x!r})"
