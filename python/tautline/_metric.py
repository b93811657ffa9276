"""Metrics, from texts, SymPy and Python functions."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from ._table import Table

from ._tautline import Constant, ProblemError, Program, Set, Spline
from ._trace import coordinates, written


class Metric:
    """A metric H(x) on R^D as one formula.

    `what` is one of

    - a text, such as "cost(2 - cos(x1))" or "[1 + x1^2, 0; 0, 1]"; coordinates are x1, …, xD, and
      `parameters` gives values to other names, and `tables` are functions that it may call, see `Table`;
    - a function of an array x of shape (D,), which returns an array of shape (D, D). It is called
      once, with symbols that record what it computes, and may use NumPy;
    - a SymPy matrix, with the coordinates in `variables`.

    For what is no formula, there is `Metric.black_box`.

    All of them become the same program, which computes H, its derivatives, and intervals that contain
    them.

    >>> import numpy as np
    >>> text = Metric("[1 + x1^2, 0; 0, 1]", dimension=2)
    >>> traced = Metric(lambda x: np.array([[1 + x[0] ** 2, 0], [0, 1]]), dimension=2)
    >>> text == traced
    True
    """

    def __init__(
        self,
        what: str | Callable[[np.ndarray], Any] | Any,
        dimension: int | None = None,
        *,
        parameters: Mapping[str, float] | None = None,
        tables: Mapping[str, Table] | None = None,
        variables: Sequence[Any] | None = None,
    ) -> None:
        if variables is not None:
            what, dimension = _from_sympy(what, variables), len(variables)
        if dimension is None:
            raise ProblemError("the dimension of a metric is needed: Metric(…, dimension=2)")
        named = dict(tables or {})
        if callable(what):
            what, found = _traced(what, dimension)
            named.update(found)
        elif isinstance(what, _Written):
            named.update(what.tables)
            what = what.text
        if not isinstance(what, str):
            raise ProblemError(f"a metric is a text or a function, not {what!r}")
        splines = {name: table.spline for name, table in named.items()}
        self._parts: tuple[Any, ...] = (what, dimension, dict(parameters or {}), splines)
        self.program = Program(*self._parts)

    @classmethod
    def image(
        cls,
        cost: Any,
        *,
        spacing: float | Sequence[float] = 1.0,
        origin: float | Sequence[float] = 0.0,
        interpolate: bool = False,
    ) -> Metric:
        """The metric of a cost image: `cost[i, j]` is the cost of a unit of length at the point
        `origin + spacing * (i, j)`, smoothed as by `Table`. Arrays may have one to three axes.
        An obstacle is a high cost: a way round it is taken where it is cheaper.

        >>> import numpy as np
        >>> metric = Metric.image(np.array([[1.0, 1.0], [3.0, 3.0]]), spacing=0.5)
        >>> round(float(np.sqrt(metric([0.25, 0.1])[0, 0])), 6), metric.constants()["c1"].lower > 0.99
        (2.0, True)
        """
        cost = np.asarray(cost, float)
        if not np.all(cost > 0):
            index = tuple(int(i) for i in np.argwhere(~(cost > 0))[0])
            raise ProblemError(f"the cost at {index} is {cost[index]}; it must be positive")
        table = Table(cost, interpolate=interpolate)
        axes = len(table.shape)
        step, start = (np.broadcast_to(np.asarray(x, float), axes) for x in (spacing, origin))
        if not np.all(step > 0):
            raise ProblemError(f"the spacing {step.tolist()}; it must be positive")
        return cls.cost(lambda x: table(*((x - start) / step)), axes)

    @classmethod
    def black_box(
        cls,
        h: Callable[[np.ndarray], Any],
        dimension: int,
        *,
        first: Callable[[np.ndarray], Any] | None = None,
        second: Callable[[np.ndarray], Any] | None = None,
        step: float = 1e-3,
    ) -> Metric:
        """A metric by a function of many points: `h` maps an array of shape (m, D) to (m, D, D).

        Use it for what cannot be recorded, such as branches or a network. Curves are found as for any
        metric; certificates and constants need a formula, and are refused.

        `first` returns the derivatives, of shape (m, D, D, D) with the direction last, and `second`
        those of shape (m, D, D, D, D). With JAX they are `jax.vmap(jax.jacfwd(h1))` and
        `jax.vmap(jax.jacfwd(jax.jacfwd(h1)))` of a function `h1` of one point, in double precision.
        Those that are not given are computed from differences of values at points whose coordinates
        differ by `step`: a thousandth of the length over which H changes is a good one.

        >>> def h(x):
        ...     cost = np.where(x[:, 0] > 1, 2 + (x[:, 0] - 1) ** 4, 2)
        ...     return cost[:, None, None] ** 2 * np.eye(2)
        >>> import numpy as np, tautline
        >>> curve = tautline.solve(Metric.black_box(h, 2), [0, 0], [2, 0])
        >>> round(float(curve.extrapolated), 6)
        4.2
        """
        metric = cls.__new__(cls)
        metric._parts = (dimension, h, first, second, step)
        metric.program = Program.black_box(*metric._parts)
        return metric

    @classmethod
    def cost(cls, f: Any, dimension: int, **options: Any) -> Metric:
        """f² I: a curve has the length ∫ f |γ'| dt, so f is the cost of a unit of length."""
        return cls(_form("cost", f, dimension), dimension, **options)

    @classmethod
    def speed(cls, f: Any, dimension: int, **options: Any) -> Metric:
        """f⁻² I: the length of a curve is the time it takes at the speed f."""
        return cls(_form("speed", f, dimension), dimension, **options)

    @classmethod
    def phi(cls, f: Any, dimension: int, **options: Any) -> Metric:
        """f I."""
        return cls(_form("phi", f, dimension), dimension, **options)

    @classmethod
    def graph(cls, f: Any, dimension: int, **options: Any) -> Metric:
        """I + ∇f ∇fᵀ, which measures curves on the graph of f."""
        return cls(_form("graph", f, dimension), dimension, **options)

    @classmethod
    def pullback(cls, f: Any, dimension: int, **options: Any) -> Metric:
        """JᵀJ with the derivative J of a map to R^m, m ≥ D, which measures the lengths of images."""
        return cls(_form("pullback", f, dimension), dimension, **options)

    @classmethod
    def diag(cls, f: Any, dimension: int, **options: Any) -> Metric:
        """The diagonal matrix with these entries."""
        return cls(_form("diag", f, dimension), dimension, **options)

    @property
    def dimension(self) -> int:
        """The dimension D."""
        return self.program.dimension

    def constants(
        self, within: Set | None = None, *, tolerance: float = 1e-3, boxes: int | None = None
    ) -> dict[str, Constant]:
        """The constants of the theorems, proved from the formula: c1 ≤ H ≤ c2, L_H and M_H bound the
        first and second derivatives.

        They hold `within` a ball or a box, or on all of space if the formula shows what happens far
        out. `tolerance` is their relative accuracy, `boxes` the largest number of boxes for one.

        >>> constants = Metric.cost("2 - cos(x1)", 2).constants()
        >>> [round(constants[name].upper, 3) for name in ("c1", "c2", "L_H")]
        [1.0, 9.0, 4.407]

        Raises `NotCertified` if the formula does not show where its constants hold. A constant that
        is not proved to the tolerance says so: `Constant.proved`, `Constant.reason`.
        """
        found, _ = self.program.constants(within, tolerance, boxes)
        return {constant.name: constant for constant in found}

    def __call__(self, x: Any) -> np.ndarray:
        """H at points: an array of shape (…, D, D) for one of shape (…, D)."""
        x = np.ascontiguousarray(x, float)
        if x.ndim == 0:
            raise ProblemError("a point is an array of shape (D,), not a number")
        h = self.program.gram(x.reshape(-1, x.shape[-1]))
        return h.reshape(*x.shape, x.shape[-1])

    def __eq__(self, other: object) -> bool:
        """Whether two metrics are the same program: the same operations in the same order.

        Black boxes are equal if their functions are.
        """
        if not isinstance(other, Metric):
            return NotImplemented
        if self.program.text is None or other.program.text is None:
            return self._parts == other._parts
        return (self.dimension, self.program.text) == (
            other.dimension,
            other.program.text,
        ) and _are_equal(self._parts[3], other._parts[3])

    def __hash__(self) -> int:
        return hash(self.program.text)

    def __reduce__(self) -> tuple[Callable[..., Metric], tuple[Any, ...]]:
        """Another process makes it again from its text and its tables. A black box goes there if its
        functions do."""
        return _made, (self.program.text is None, self._parts)

    def __repr__(self) -> str:
        return f"<tautline.Metric in {self.dimension} dimensions>"


def _made(is_black_box: bool, parts: tuple[Any, ...]) -> Metric:
    metric = Metric.__new__(Metric)
    metric._parts = parts
    metric.program = Program.black_box(*parts) if is_black_box else Program(*parts)
    return metric


def _are_equal(tables: Mapping[str, Spline], others: Mapping[str, Spline]) -> bool:
    """Whether tables have the same coefficients, in the order of their names."""
    pairs = zip(*([named[name] for name in sorted(named)] for named in (tables, others)))
    return len(tables) == len(others) and all(
        a is b or np.array_equal(a.coefficients, b.coefficients) for a, b in pairs
    )


class _Written(NamedTuple):
    text: str
    tables: dict[str, Table]


def _traced(
    function: Callable[[np.ndarray], Any], dimension: int
) -> tuple[str, dict[str, Table]]:
    h = np.asarray(function(coordinates(dimension)), object)
    if h.shape != (dimension, dimension):
        hint = "; for f² I use Metric.cost, for a diagonal Metric.diag" if h.ndim < 2 else ""
        raise ProblemError(f"H has the shape {h.shape}, not {(dimension, dimension)}{hint}")
    lines, names, tables = written(h.ravel().tolist())
    rows = [", ".join(names[i : i + dimension]) for i in range(0, len(names), dimension)]
    return "\n".join([*lines, f"[{'; '.join(rows)}]"]), tables


def _form(form: str, f: Any, dimension: int) -> str | _Written:
    if isinstance(f, str):
        return f"{form}({f})"
    if not callable(f):
        return f"{form}({', '.join(f)})"
    numbers = np.asarray(f(coordinates(dimension)), object).ravel().tolist()
    lines, names, tables = written(numbers)
    return _Written("\n".join([*lines, f"{form}({', '.join(names)})"]), tables)


def _from_sympy(matrix: Any, variables: Sequence[Any]) -> Callable[[np.ndarray], Any]:
    import sympy  # type: ignore[import-untyped, import-not-found, unused-ignore]

    function = sympy.lambdify(list(variables), sympy.Matrix(matrix).tolist(), "numpy", cse=True)
    return lambda x: function(*x)
