"""Shortest curves between two closed sets, under a metric that you write as one formula.

>>> import tautline_geodesics as tautline
>>> valleys = tautline.Metric.cost("2 - cos(x1)", dimension=2)
>>> curve = tautline.solve(valleys, tautline.ball([0, 0], 0.5), tautline.half_space([1, 0], at_least=3))
>>> round(curve.extrapolated.value, 6)  # 5 - sin 3 + sin 1/2
5.338306

Lengths are in units of the metric, coordinates in units of their own. A metric is a text, a SymPy
matrix, or a Python function, which is called once with symbols; see `Metric`.
"""

from typing import TYPE_CHECKING

from ._audit import Audit, audit
from ._check import check
from ._metric import Metric
from ._plot import plot
from ._sets import (
    Set,
    affine_subspace,
    ball,
    box,
    half_space,
    point,
    points,
    segment,
    sphere,
    union,
)
from ._solve import UnresolvedWarning, distance_matrix, solve, solve_batch
from ._table import Table
from ._tautline import (
    RULES,
    Bounds,
    Certificate,
    Constant,
    Curve,
    Estimate,
    MetricError,
    NotCertified,
    ProblemError,
    Program,
    Verdict,
    __version__,
    theorem_1_1_excess,
    theorem_1_3_excess,
)
from ._trace import TraceError, Traced

__all__ = [
    "Audit",
    "Bounds",
    "Certificate",
    "Constant",
    "Curve",
    "Estimate",
    "Metric",
    "MetricError",
    "NotCertified",
    "ProblemError",
    "Program",
    "RULES",
    "Set",
    "Table",
    "TraceError",
    "Traced",
    "UnresolvedWarning",
    "Verdict",
    "__version__",
    "affine_subspace",
    "audit",
    "ball",
    "box",
    "check",
    "distance_matrix",
    "half_space",
    "plot",
    "point",
    "points",
    "segment",
    "solve",
    "solve_batch",
    "sphere",
    "theorem_1_1_excess",
    "theorem_1_3_excess",
    "union",
]

if TYPE_CHECKING:
    from . import sweep as sweep
else:

    def __getattr__(name):
        """`tautline.sweep`, which is imported once it is used."""
        if name == "sweep":
            import importlib

            return importlib.import_module(".sweep", __name__)
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return [*__all__, "sweep"]
