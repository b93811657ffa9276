"""Pictures of curves, with matplotlib."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np

from ._metric import Metric
from ._tautline import Curve, ProblemError

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# The number of points of the background in each direction.
PIXELS = 200


def plot(
    metric: Metric | None,
    curves: Curve | Iterable[Curve],
    *,
    ax: Axes | None = None,
    coordinates: tuple[int, int] = (0, 1),
    margin: float = 0.25,
    **style: Any,
) -> Axes:
    """Draws curves over the size of the metric in the plane of two coordinates, and returns the axes.

    The background is det(H)^(1/2D), the mean cost of a unit of length, in shades of grey, with the
    other coordinates as in the middle of the first curve; without a metric it is empty. `margin` is
    the part of the width by which the picture is wider than the curves; `style` goes to `Axes.plot`.
    Needs matplotlib: `pip install tautline-geodesics[plot]`.
    """
    import matplotlib.pyplot as plt

    curves = [curves] if isinstance(curves, Curve) else list(curves)
    if not curves:
        raise ProblemError("no curve to draw")
    if ax is None:
        _, ax = plt.subplots()
    i, j = coordinates
    points = [curve.points for curve in curves]
    if max(i, j) >= points[0].shape[1] or min(i, j) < 0 or i == j:
        dimension = points[0].shape[1]
        raise ProblemError(f"coordinates {coordinates} of curves in {dimension} dimensions")
    if metric is not None:
        drawn = np.concatenate(points)
        low, high = drawn.min(0), drawn.max(0)
        room = margin * (high - low)[[i, j]].max() + 1e-9
        u, v = (np.linspace(low[k] - room, high[k] + room, PIXELS) for k in (i, j))
        x = np.tile(curves[0].at(0.5), (PIXELS, PIXELS, 1))
        x[..., i], x[..., j] = np.meshgrid(u, v)
        size = np.linalg.det(metric(x)) ** (0.5 / x.shape[-1])
        image = ax.pcolormesh(u, v, size, cmap="Greys", shading="gouraud")
        ax.figure.colorbar(image, ax=ax, label="cost of a unit of length")
    for polygon in points:
        ax.plot(polygon[:, i], polygon[:, j], **style)
    ax.set_xlabel(f"$x_{i + 1}$")
    ax.set_ylabel(f"$x_{j + 1}$")
    ax.set_aspect("equal")
    return ax
