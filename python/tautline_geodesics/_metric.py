"""Metrics, from texts, SymPy and Python functions."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt
from numpy.typing import NDArray

from ._convert import array, finite, number, whole
from ._image import Lattice, of_field, of_image
from ._sympy import is_sympy, of_sympy
from ._table import Table
from ._tautline import Constant, ProblemError, Program, Set, Spline, avoiding
from ._written import check_used, of_form, of_matrix, sign, words


class Metric:
    """A metric H(x) on R^D as one formula.

    `what` is one of

    - a text, such as "cost(2 - cos(x1))" or "[1 + x1^2, 0; 0, 1]", see below;
    - a function of an array x of shape (D,), which returns an array of shape (D, D). It is called
      once, with symbols that record what it computes, and may use NumPy;
    - a SymPy matrix, with the coordinates in `variables`;
    - a constant array of shape (D, D).

    In a text the coordinates are x1, …, xD. There are numbers, pi, + - * /, powers ^ with whole
    exponents, and the functions sqr, recip, sqrt, exp, ln, sin, cos, tan, atan, sinh, cosh and tanh.
    Definitions go before, as in "u = exp(-x1^2); [2 + u, 0; 0, 1]". `parameters` gives values to other
    names of a text or to symbols of SymPy, and `tables` are functions that a text may call: see `Table`,
    or arrays.

    Numbers, also parameters, are doubles: the nearest ones to decimals, and to pi, in a text. What stands
    for more digits is a step, which intervals enclose: ln 2 in `2**x` and `np.log2`, π/180 in
    `np.deg2rad`, and the fractions, roots, pi and E of a SymPy expression. A Float of SymPy that is no
    double is refused.

    For what is no formula, there is `Metric.black_box`.

    All of them become the same program, which computes H, its derivatives, and intervals that contain
    them.

    >>> import numpy as np
    >>> text = Metric("[1 + x1^2, 0; 0, 1]", dimension=2)
    >>> traced = Metric(lambda x: np.array([[1 + x[0] ** 2, 0], [0, 1]]), dimension=2)
    >>> text == traced
    True
    """

    lattice: Lattice | None = None
    """Nodes for `solve`, which also starts from a shortest path along them, with all of its chords: the
    first one, the corner at which they end, and their spacing. An image has its pixels, and a field its
    grid; a solve then visits all of them. For a landscape with many hills, give one to any metric in up to
    four dimensions; None leaves the path out."""

    _free: Metric | None = None
    """The metric without its obstacles, if it has some."""

    _crossing: float | None = None
    """The least length of a curve through a wall of an image, if it has some."""

    def __init__(
        self,
        what: Any,
        dimension: int | None = None,
        *,
        parameters: Mapping[str, float] | None = None,
        tables: Mapping[str, Table | npt.ArrayLike] | None = None,
        variables: Sequence[Any] | None = None,
    ) -> None:
        if dimension is None and not is_sympy(what) and not isinstance(what, str):
            if not callable(what) and array(what, "the matrix").ndim == 2:
                # A constant matrix.
                dimension = len(what)
        self._set(
            "", what, dimension, parameters=parameters, tables=tables, variables=variables
        )

    def _set(
        self,
        form: str,
        what: Any,
        dimension: int | None,
        *,
        parameters: Mapping[str, float] | None = None,
        tables: Mapping[str, Table | npt.ArrayLike] | None = None,
        variables: Sequence[Any] | None = None,
    ) -> None:
        values = {
            name: finite(value, f"the parameter {name}")
            for name, value in (parameters or {}).items()
        }
        if variables is not None:
            dimension = _of_variables(dimension, variables)
        if is_sympy(what):
            what, values = of_sympy(what, variables, values), {}
        elif variables is not None and (isinstance(what, str) or callable(what)):
            raise ProblemError("`variables` are the coordinates of a SymPy expression")
        if dimension is None:
            raise ProblemError("the dimension of a metric is needed: Metric(…, dimension=2)")
        size = whole(dimension, "the dimension")
        made = of_form(form, what, size) if form else of_matrix(what, size)
        check_used(values, words(made.text))
        check_used(tables or {}, words(made.text), "table")
        named = {
            name: table if isinstance(table, Table) else Table(table)
            for name, table in (tables or {}).items()
        }
        splines = {name: table.spline for name, table in (named | made.tables).items()}
        self._parts: tuple[Any, ...] = (
            made.text,
            size,
            values,
            splines,
            made.skipped,
            sign(made.text),
        )
        self.program = Program(*self._parts)

    @classmethod
    def image(
        cls,
        cost: npt.ArrayLike,
        *,
        spacing: npt.ArrayLike = 1.0,
        origin: npt.ArrayLike = 0.0,
        spline: str = "monotone",
        walls: bool = False,
    ) -> Metric:
        """The metric of a cost image: `cost[i, j]` is the cost of a unit of length at the point
        `origin + spacing * (i, j)`, and between these points that of a `Table` with this `spline`. Arrays may
        have one to three axes. A "cubic" spline is refused if it may not be positive between the costs; a
        "smoothing" one changes the costs at the pixels.

        With `walls` the cells that are masked, NaN or infinite are walls, which no curve crosses: `solve`
        raises `MetricError` if there is no way between them. A curve keeps to the pixels beside a wall, whose
        cost goes up towards it.

        `solve` also starts from a shortest path from pixel to pixel, see `Metric.lattice`: take chords that
        are shorter than its details.

        >>> import numpy as np
        >>> metric = Metric.image(np.array([[1.0, 1.0], [3.0, 3.0]]), spacing=0.5)
        >>> round(float(np.sqrt(metric([0.25, 0.1])[0, 0])), 6), metric.constants()["c1"].lower > 0.99
        (2.0, True)
        """
        f, lattice, crossing = of_image(cost, spacing, origin, spline, walls)
        metric = cls.cost(f, len(lattice[0]))  # type: ignore[arg-type]
        metric.lattice, metric._crossing = lattice, crossing
        return metric

    @classmethod
    def field(
        cls,
        h: npt.ArrayLike,
        *,
        spacing: npt.ArrayLike = 1.0,
        origin: npt.ArrayLike = 0.0,
        spline: str = "monotone",
    ) -> Metric:
        """The metric that was measured on a grid: `h[i, j]` is the matrix at the point
        `origin + spacing * (i, j)`, so `h` has the shape (n, m, 2, 2), (n, 1, 1) on the line or
        (n, m, l, 3, 3) in space. Between these points each entry is that of a `Table` with this `spline`.
        A "monotone" and a "smoothing" one keep the matrix positive definite; a "cubic" one may not. `solve`
        also starts from a shortest path along the grid.

        >>> import numpy as np
        >>> h = np.tile([[2.0, 0.5], [0.5, 1.0]], (4, 3, 1, 1))
        >>> Metric.field(h, spacing=0.1)([0.15, 0.1]).round(12).tolist()
        [[2.0, 0.5], [0.5, 1.0]]
        """
        f, lattice = of_field(h, spacing, origin, spline)
        metric = cls(f, len(lattice[0]))  # type: ignore[arg-type]
        metric.lattice = lattice
        return metric

    def avoiding(
        self,
        *obstacles: Set | str | Callable[..., Any] | Any,
        margin: float,
        variables: Sequence[Any] | None = None,
    ) -> Metric:
        """The metric with obstacles, which no curve enters: balls, half-spaces, boxes, unions of these, or what
        is positive outside of a region: a text, such as "x1^2 + x2^2 - 1", a function of an array x of shape
        (D,), or an expression of SymPy with `variables`. For masks there are the `walls` of `Metric.image`.

        They repel. With the distance δₖ from each, or the value of its function, the metric is
        (1 + Σₖ (margin/δₖ)²) H, and there is none in an obstacle. With a smaller margin curves run closer
        to them. So a length is somewhat more than that of the same curve by H. A box is rounded, and
        grows by a part of the margin.

        >>> import numpy as np, tautline_geodesics as tautline
        >>> free = tautline.Metric.phi("1", 2)
        >>> metric = free.avoiding(tautline.ball([0, 0], 1), margin=0.003)
        >>> curve = tautline.solve(metric, [-3, 0.1], [3, -0.1])
        >>> bool(np.all(np.hypot(*curve.points.T) > 1)), round(float(curve.length), 2)
        (True, 6.36)

        The shortest way round the disc is 6.34. Raises `MetricError` if an end is in an obstacle, or if
        every search runs into one: then a `lattice` or `starts` of `solve` name a way round.
        """

        def obstacle(what: Any) -> Any:
            if isinstance(what, (Set, str)):
                return what
            if not (callable(what) or is_sympy(what)):
                raise ProblemError(f"{what!r} is no obstacle; expected a set, a text or a function")
            metric = Metric.phi(what, self.dimension, variables=variables if is_sympy(what) else None)
            if metric.program.tables:
                raise ProblemError("an obstacle calls a table: use `walls` of Metric.image")
            return metric.program

        each = [obstacle(what) for what in obstacles]
        margin = number(margin, "the margin")
        text, tables, sign = avoiding(self.program, each, margin)
        parts: tuple[Any, ...] = (text, self.dimension, {}, dict(tables), 0, sign)
        free = self if self._free is None else self._free
        return _made(False, parts, self.lattice, free, self._crossing)

    @classmethod
    def black_box(
        cls,
        h: Callable[[Any], Any],
        dimension: int,
        *,
        first: Callable[[Any], Any] | None = None,
        second: Callable[[Any], Any] | None = None,
        first_along: Callable[[Any, Any], Any] | None = None,
        second_along: Callable[[Any, Any], Any] | None = None,
        step: float = 1e-3,
    ) -> Metric:
        """A metric by a function of many points: `h` maps an array of shape (m, D) to (m, D, D).

        Use it for what cannot be recorded, such as branches or a network. Curves are found as for any
        metric; certificates and constants need a formula, and are refused.

        `first` returns the derivatives, of shape (m, D, D, D) with the direction last, and `second`
        those of shape (m, D, D, D, D). With JAX they are `jax.vmap(jax.jacfwd(h1))` and
        `jax.vmap(jax.jacfwd(jax.jacfwd(h1)))` of a function `h1` of one point. Those that are not given
        are computed from differences of values at points whose coordinates differ by `step`: a thousandth
        of the length over which H changes is a good one. All return real numbers in double precision;
        complex ones and those of float16 and float32 are refused.

        From 33 dimensions on these arrays are too large. Then give the derivatives along a vector for each
        point, the rows of a second array v of shape (m, D): `first_along(x, v)` returns those of H v, of
        shape (m, D, D) with the direction last, and `second_along(x, v)` those of v·H v, of the same shape;
        without it they are differences. With JAX they are `jax.vmap(jax.jacfwd(lambda x, v: h1(x) @ v))` and
        `jax.vmap(jax.hessian(lambda x, v: v @ h1(x) @ v))`.

        >>> def h(x):
        ...     cost = np.where(x[:, 0] > 1, 2 + (x[:, 0] - 1) ** 4, 2)
        ...     return cost[:, None, None] ** 2 * np.eye(2)
        >>> import numpy as np, tautline_geodesics as tautline
        >>> curve = tautline.solve(Metric.black_box(h, 2), [0, 0], [2, 0])
        >>> round(float(curve.extrapolated), 6)
        4.2
        """
        if second_along is not None and first_along is None:
            raise ValueError("second_along without first_along")
        derivatives = (first, second, first_along, second_along)
        return _made(True, (dimension, h, derivatives, step))

    @classmethod
    def cost(cls, f: Any, dimension: int | None = None, **options: Any) -> Metric:
        """f² I: a curve has the length ∫ f |γ'| dt, so f is the cost of a unit of length.

        `f` is a text, a function of an array x of shape (D,), an expression of SymPy with `variables`, or
        a number, and takes the options of `Metric`, here and in the other forms. It must be positive along a curve: `solve` looks.
        """
        return cls._of_form("cost", f, dimension, **options)

    @classmethod
    def speed(cls, f: Any, dimension: int | None = None, **options: Any) -> Metric:
        """f⁻² I: the length of a curve is the time it takes at the speed f."""
        return cls._of_form("speed", f, dimension, **options)

    @classmethod
    def phi(cls, f: Any, dimension: int | None = None, **options: Any) -> Metric:
        """f I."""
        return cls._of_form("phi", f, dimension, **options)

    @classmethod
    def graph(cls, f: Any, dimension: int | None = None, **options: Any) -> Metric:
        """I + ∇f ∇fᵀ, which measures curves on the graph of f."""
        return cls._of_form("graph", f, dimension, **options)

    @classmethod
    def pullback(cls, f: Any, dimension: int | None = None, **options: Any) -> Metric:
        """JᵀJ with the derivative J of a map to R^m, m ≥ D, which measures the lengths of images."""
        return cls._of_form("pullback", f, dimension, **options)

    @classmethod
    def diag(cls, f: Any, dimension: int | None = None, **options: Any) -> Metric:
        """The diagonal matrix with these entries."""
        return cls._of_form("diag", f, dimension, **options)

    @classmethod
    def _of_form(cls, form: str, f: Any, dimension: int | None, **options: Any) -> Metric:
        metric = cls.__new__(cls)
        metric._set(form, f, dimension, **options)
        return metric

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
        out. `tolerance` is their relative accuracy, between 0 and 1, `boxes` the largest number of boxes
        for one.

        >>> constants = Metric.cost("2 - cos(x1)", 2).constants()
        >>> [round(constants[name].upper, 3) for name in ("c1", "c2", "L_H")]
        [1.0, 9.0, 4.407]

        Raises `NotCertified` if the formula does not show where its constants hold. A constant that
        is not proved to the tolerance says so: `Constant.proved`, `Constant.reason`.
        """
        most = None if boxes is None else whole(boxes, "boxes")
        found, _ = self.program.constants(within, tolerance, most)
        return {constant.name: constant for constant in found}

    def __call__(self, x: npt.ArrayLike) -> NDArray[np.float64]:
        """H at points: an array of shape (…, D, D) for one of shape (…, D)."""
        points = array(x, "an array of points")
        if points.ndim == 0:
            raise ProblemError("a point is an array of shape (D,), not a number")
        h = self.program.gram(points.reshape(-1, points.shape[-1]))
        return h.reshape(*points.shape, points.shape[-1])

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
        ) and _are_equal(self.program.tables, other.program.tables)

    def __hash__(self) -> int:
        return hash(self.program.text)

    def __reduce__(self) -> tuple[Callable[..., Metric], tuple[Any, ...]]:
        """Another process makes it again from its text and its tables. A black box goes there if its
        functions do."""
        return _made, (
            self.program.text is None,
            self._parts,
            self.lattice,
            self._free,
            self._crossing,
        )

    def __repr__(self) -> str:
        return f"<tautline.Metric in {self.dimension} dimensions>"


def _made(
    is_black_box: bool,
    parts: tuple[Any, ...],
    lattice: Lattice | None = None,
    free: Metric | None = None,
    crossing: float | None = None,
) -> Metric:
    metric = Metric.__new__(Metric)
    metric.lattice, metric._free, metric._crossing = lattice, free, crossing
    metric._parts = parts
    metric.program = Program.black_box(*parts) if is_black_box else Program(*parts)
    return metric


def _are_equal(tables: Sequence[Spline], others: Sequence[Spline]) -> bool:
    """Whether tables have the same coefficients, in the order in which programs call them."""
    return len(tables) == len(others) and all(
        np.array_equal(a.coefficients, b.coefficients) for a, b in zip(tables, others)
    )


def _of_variables(dimension: int | None, variables: Sequence[Any]) -> int:
    if not isinstance(variables, (list, tuple)):
        raise ProblemError(f"variables={variables!r}; expected a list such as (x, y)")
    if dimension is not None and dimension != len(variables):
        names = ", ".join(map(str, variables))
        raise ProblemError(f"{dimension} dimensions, but {len(variables)} variables ({names})")
    return len(variables)
